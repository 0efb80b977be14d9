// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/child.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include "harness/core/error.h"

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

}  // namespace
}  // namespace lamina
