// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/child.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <set>

#include "harness/core/error.h"
#include "harness/core/stop_signals.h"

namespace lamina {
namespace {

TEST(Child, LinesComeInOrderAndWhole) {
  const std::string long_text(300000, 'x');  // more than a pipe holds
  const ChildResult result = run_in_child([&](const EmitLine& emit) {
    for (int i = 0; i < 5; ++i) emit({{"i", i}, {"text", long_text}, {"pid", ::getpid()}});
  });
  EXPECT_EQ(result.failure, "");
  ASSERT_EQ(result.lines.size(), 5u);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(result.lines[size_t(i)]["i"], i);
  EXPECT_EQ(result.lines[4]["text"], long_text);
  EXPECT_NE(result.lines[0]["pid"], ::getpid());
}

TEST(Child, ErrorsAndSignalsBecomeWordsAndWhatCameBeforeIsKept) {
  const ChildResult thrown = run_in_child([](const EmitLine& emit) {
    emit({{"before", true}});
    throw Error(ErrorKind::failed, "vulkan", "device", "is lost");
  });
  EXPECT_EQ(thrown.lines.size(), 1u);
  EXPECT_NE(thrown.failure.find("is lost"), std::string::npos);
  const ChildResult killed = run_in_child([](const EmitLine& emit) {
    emit({{"before", true}});
    ::raise(SIGKILL);
  });
  EXPECT_EQ(killed.lines.size(), 1u);
  EXPECT_NE(killed.failure.find("signal 9"), std::string::npos);
  EXPECT_NE(run_in_child([](const EmitLine&) { ::_exit(7); }).failure.find("status 7"), std::string::npos);
}

// Forked processes that mapped alike would all measure one layout.
// Also where the parent's mappings have holes, which the kernel would fill in every child alike.
TEST(Child, EachLaysOutItsMemoryAnew) {
  constexpr size_t hole_bytes = 4 << 20;
  auto* const around = static_cast<std::byte*>(::mmap(nullptr, 3 * hole_bytes, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  ASSERT_NE(around, MAP_FAILED);
  ASSERT_EQ(::munmap(around + hole_bytes, hole_bytes), 0);
  for (const size_t bytes : {4096ul, 1ul << 20, 1ul << 25}) {
    std::set<uint64_t> places;
    for (int i = 0; i < 8; ++i) {
      const ChildResult result = run_in_child([bytes](const EmitLine& emit) {
        void* mapped = ::mmap(nullptr, bytes, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        emit({{"at", reinterpret_cast<uint64_t>(mapped)}});
      });
      places.insert(result.lines.at(0).at("at").get<uint64_t>());
    }
    EXPECT_GE(places.size(), 6u) << bytes;  // of at least 2048 places: three of eight fall together once in a million runs
  }
  ::munmap(around, hole_bytes);
  ::munmap(around + 2 * hole_bytes, hole_bytes);
}

// Each waits for the other's byte, which would never come if they ran one after the other; both hand over more than a pipe
// holds.
TEST(Child, SeveralRunAtTheSameTime) {
  const std::string long_text(300000, 'x');
  int to_first[2], to_second[2];
  ASSERT_EQ(::pipe(to_first), 0);
  ASSERT_EQ(::pipe(to_second), 0);
  const auto meet = [&](int send, int receive) {
    return [&long_text, send, receive](const EmitLine& emit) {
      pollfd other{receive, POLLIN, 0};
      const bool sent = ::write(send, "x", 1) == 1;
      emit({{"met", sent && ::poll(&other, 1, 20000) == 1}, {"text", long_text}});
    };
  };
  const std::vector<ChildResult> results =
      run_in_children({meet(to_second[1], to_first[0]), meet(to_first[1], to_second[0]),
                       [](const EmitLine&) { throw Error(ErrorKind::failed, "a", "b", "c"); }});
  ASSERT_EQ(results.size(), 3u);
  for (const size_t i : {0u, 1u}) {
    ASSERT_EQ(results[i].lines.size(), 1u);
    EXPECT_TRUE(results[i].lines[0]["met"]) << i;
    EXPECT_EQ(results[i].lines[0]["text"], long_text);
    EXPECT_EQ(results[i].failure, "");
  }
  EXPECT_NE(results[2].failure.find('c'), std::string::npos) << "in the order of the works";
  for (const int end : {to_first[0], to_first[1], to_second[0], to_second[1]}) ::close(end);
}

// `kill` reaches one process: what asks the parent to stop must reach its children.
TEST(Child, IsAskedToStopWithItsParent) {
  const StopSignals signals("");
  const ChildResult result = run_in_child([](const EmitLine& emit) {
    ::alarm(20);  // ends it where nobody asks
    emit({{"began", true}});
    ::kill(::getppid(), SIGINT);
    while (StopSignals::stopped_by() == 0) ::usleep(1000);
    emit({{"stopped_by", StopSignals::stopped_by()}});
  });
  EXPECT_EQ(result.failure, "");
  ASSERT_EQ(result.lines.size(), 2u);
  EXPECT_EQ(result.lines[1]["stopped_by"], SIGTERM);
  EXPECT_EQ(StopSignals::stopped_by(), SIGINT);
}

}  // namespace
}  // namespace lamina
