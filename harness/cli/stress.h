// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "harness/cli/options.h"

namespace lamina {

struct StressOptions : DeviceOptions {
  std::string family;            // by name, or a family.toml; empty: all
  std::filesystem::path points;  // a file of inputs
  size_t grid_steps = 0;         // of make_grid(); 0 and no file: the sets of the family
  size_t count = 100000;         // inputs a set
  std::vector<std::string> variants;
  std::filesystem::path out = "lamina-out";
  uint64_t seed = 1;
  std::string command;  // as the user typed it
};

}  // namespace lamina
