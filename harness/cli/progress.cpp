// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace lamina {
namespace {

constexpr const char* erase_line = "\r\033[K";

}  // namespace

Progress::Progress(std::string title) : title_(std::move(title)), watched_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (watched_) fmt::print(stderr, "{}", erase_line);
}

void Progress::show(double fraction, const std::string& what) {
  if (!watched_) return;
  const double done = std::clamp(fraction, 0.0, 1.0), elapsed_s = watch_.elapsed_s();
  std::string left;
  if (done > 0.02) left = fmt::format(", {:.0f} s left", elapsed_s / done - elapsed_s);
  fmt::print(stderr, "{}{}: {:.0f}%{} {}", erase_line, title_, done * 100, left, what);
  std::fflush(stderr);
}

}  // namespace lamina
