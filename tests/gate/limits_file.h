// SPDX-License-Identifier: Apache-2.0
// Limits from the text of a gate file.
#pragma once

#include <filesystem>
#include <string>

#include "harness/core/text.h"
#include "harness/gate/limits.h"
#include "tests/folder.h"

namespace lamina {

inline LimitsFile limits_of(const std::string& text, const GateNames& names = {}) {
  return {Folder().write("limits.toml", text), names};
}

}  // namespace lamina
