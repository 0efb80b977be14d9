// SPDX-License-Identifier: Apache-2.0
// The caps' family, as `lamina stress caps` takes it.
#pragma once

#include <filesystem>

#include "harness/stress/function_runner.h"
#include "harness/stress/judge.h"
#include "harness/stress/point_sets.h"

namespace lamina {

inline std::filesystem::path shaders_folder() { return std::filesystem::path(LAMINA_SOURCE_DIR) / "shaders"; }

inline const Family& caps() {
  static const Family family = load_family(shaders_folder() / "cap_intersection/family.toml", effect_code());
  return family;
}

inline PointTruth truth_of_caps(const PointSet& set) { return truth_of(*caps().oracle, set); }

}  // namespace lamina
