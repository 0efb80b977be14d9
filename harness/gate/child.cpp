// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <utility>

#include "harness/core/error.h"
#include "harness/core/stop_signals.h"

namespace lamina {
namespace {

constexpr const char* failure_key = "failure";

[[noreturn]] void throw_errno(const char* call) { throw Error(ErrorKind::failed, "gate", call, std::strerror(errno)); }

bool write_line(int to, const nlohmann::ordered_json& line) {
  const std::string text = line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  for (size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(to, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    done += static_cast<size_t>(count);
  }
  return true;
}

void* map_untouched(size_t bytes) {
  void* at = ::mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (at == MAP_FAILED) throw_errno("mmap");
  return at;
}

// A forked process would place libraries, code and memory where its siblings do, and times depend on the place by a percent or
// two. So each child first reserves some pages and some heap, which it never touches: the pages move what is mapped later, the
// heap moves what is allocated later. Small mappings would still go into holes that all children inherit from the parent, so
// the holes are filled.
void lay_out_anew() {
  std::random_device random;
  const auto page = static_cast<size_t>(::sysconf(_SC_PAGESIZE));
  constexpr size_t max_pages = 1 << 20;  // 4 GiB of addresses: large mappings begin at huge pages, so of 2048 places
  const size_t pages = 1 + random() % max_pages, heap_bytes = 16 * (1 + random() % 4096);
  [[maybe_unused]] static void* volatile kept;  // or a compiler leaves the allocation out
  kept = std::malloc(heap_bytes);
  // The kernel maps downwards, but into a hole where one is large enough; this is the first address below all smaller holes.
  auto* const free = static_cast<std::byte*>(map_untouched(max_pages * page));
  for (size_t hole = max_pages / 2; hole >= 1; hole /= 2)
    for (;;) {
      auto* const in_hole = static_cast<std::byte*>(map_untouched(hole * page));
      if (in_hole > free) continue;
      ::munmap(in_hole, hole * page);
      break;
    }
  if (pages < max_pages) ::munmap(free, (max_pages - pages) * page);
}

[[noreturn]] void be_child(int to, const std::function<void(const EmitLine&)>& work) {
  int status = 0;
  StopSignals::be_silent();
  try {
    lay_out_anew();
    work([to](const nlohmann::ordered_json& line) {
      if (!write_line(to, line)) ::_exit(1);  // nobody reads any more
    });
  } catch (const std::exception& error) {
    write_line(to, {{failure_key, error.what()}});
    status = 1;
  }
  std::fflush(nullptr);
  ::_exit(status);  // what the parent would tear down is not the child's to tear down
}

struct Child {
  pid_t id = 0;
  int from = -1;  // its lines; -1: it has closed them
  std::string text;
};

Child fork_child(const std::function<void(const EmitLine&)>& work) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw_errno("pipe");
  std::fflush(nullptr);
  const pid_t id = ::fork();
  if (id < 0) throw_errno("fork");
  if (id == 0) {
    ::close(ends[0]);
    be_child(ends[1], work);
  }
  ::close(ends[1]);
  return {id, ends[0], ""};
}

// From all at once: a child whose pipe is full waits. Where this process is asked to stop, its children are asked too: a signal
// from a terminal reaches all of them, one from `kill` this process alone. By another signal than Ctrl-C's, of which a second
// ends a process at once.
void read_all(std::vector<Child>& children) {
  char buffer[1 << 16];
  bool asked = false;
  for (;;) {
    std::vector<pollfd> open;
    std::vector<Child*> whose;
    for (Child& child : children)
      if (child.from >= 0) open.push_back({child.from, POLLIN, 0}), whose.push_back(&child);
    if (open.empty()) return;
    if (StopSignals::stopped_by() != 0 && !std::exchange(asked, true))
      for (const Child& child : children) ::kill(child.id, SIGTERM);
    constexpr int look_again_ms = 200;  // a signal may come just before the call that it would interrupt
    if (::poll(open.data(), open.size(), look_again_ms) < 0) {
      if (errno == EINTR) continue;
      throw_errno("poll");
    }
    for (size_t i = 0; i < open.size(); ++i) {
      if (open[i].revents == 0) continue;
      const ssize_t count = ::read(open[i].fd, buffer, sizeof buffer);
      if (count < 0 && errno == EINTR) continue;
      if (count > 0) {
        whose[i]->text.append(buffer, static_cast<size_t>(count));
        continue;
      }
      ::close(open[i].fd);
      whose[i]->from = -1;
    }
  }
}

ChildResult result_of(const Child& child) {
  int status = 0;
  while (::waitpid(child.id, &status, 0) < 0)
    if (errno != EINTR) throw_errno("waitpid");
  ChildResult result;
  for (size_t begin = 0; begin < child.text.size();) {
    const size_t newline = child.text.find('\n', begin);
    if (newline == std::string::npos) break;
    nlohmann::json line = nlohmann::json::parse(child.text.begin() + static_cast<std::ptrdiff_t>(begin),
                                                child.text.begin() + static_cast<std::ptrdiff_t>(newline));
    begin = newline + 1;
    if (line.contains(failure_key))
      result.failure = line[failure_key];
    else
      result.lines.push_back(std::move(line));
  }
  if (WIFSIGNALED(status))
    result.failure = fmt::format("its process was ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  else if (WEXITSTATUS(status) != 0 && result.failure.empty())
    result.failure = fmt::format("its process ended with status {}", WEXITSTATUS(status));
  return result;
}

}  // namespace

std::vector<ChildResult> run_in_children(const std::vector<std::function<void(const EmitLine&)>>& works) {
  std::vector<Child> children;
  for (const auto& work : works) children.push_back(fork_child(work));
  read_all(children);
  std::vector<ChildResult> results;
  for (const Child& child : children) results.push_back(result_of(child));
  return results;
}

ChildResult run_in_child(const std::function<void(const EmitLine&)>& work) { return run_in_children({work}).front(); }

}  // namespace lamina
