// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/child.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "harness/core/error.h"

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

[[noreturn]] void be_child(int to, const std::function<void(const EmitLine&)>& work) {
  int status = 0;
  try {
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

std::string read_all(int from) {
  std::string text;
  char buffer[1 << 16];
  for (;;) {
    const ssize_t count = ::read(from, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer, static_cast<size_t>(count));
  }
}

}  // namespace

ChildResult run_in_child(const std::function<void(const EmitLine&)>& work) {
  int ends[2];
  if (::pipe(ends) != 0) throw_errno("pipe");
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child < 0) throw_errno("fork");
  if (child == 0) {
    ::close(ends[0]);
    be_child(ends[1], work);
  }
  ::close(ends[1]);
  const std::string text = read_all(ends[0]);
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw_errno("waitpid");

  ChildResult result;
  for (size_t begin = 0; begin < text.size();) {
    const size_t newline = text.find('\n', begin);
    if (newline == std::string::npos) break;
    nlohmann::json line = nlohmann::json::parse(text.begin() + static_cast<std::ptrdiff_t>(begin),
                                                text.begin() + static_cast<std::ptrdiff_t>(newline));
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

}  // namespace lamina
