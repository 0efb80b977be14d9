// SPDX-License-Identifier: Apache-2.0
// What reads files that somebody else wrote. Each target takes one file and may refuse it by lamina::Error, in words about the
// file; any other exception, a crash, a hang or an unbounded allocation is a fault. tests/fuzz/README.md says how they are run.
#pragma once

#include <filesystem>
#include <span>

namespace lamina {

struct FuzzTarget {
  const char* name;
  const char* file;  // what the input is called while it is read; some readers go by the ending
  void (*read)(const std::filesystem::path& file);
};
std::span<const FuzzTarget> fuzz_targets();

// Throws std::logic_error where the target refuses the file in words that speak of the parser in place of the file.
void run_target(const FuzzTarget& target, const std::filesystem::path& file);

}  // namespace lamina
