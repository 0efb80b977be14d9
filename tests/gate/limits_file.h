// SPDX-License-Identifier: Apache-2.0
// Limits from the text of a gate file.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

#include "harness/core/text.h"
#include "harness/gate/limits.h"

namespace lamina {

inline LimitsFile limits_of(const std::string& text, const GateNames& names = {}) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("lamina_limits_of_" + std::to_string(::getpid()) + ".toml");
  write_file_atomically(file, text);
  const LimitsFile limits(file, names);
  std::filesystem::remove(file);
  return limits;
}

}  // namespace lamina
