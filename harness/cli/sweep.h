// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "harness/cli/options.h"
#include "harness/sweep/points.h"

namespace lamina {

struct SweepOptions {
  CellOptions compare;
  RoundOptions rounds{.budget_s = 4, .precision = 0.05};  // of a timed point
  std::vector<std::string> sets;                          // PATH=VALUES
  bool zip = false;
  std::vector<std::string> views;                   // by name; empty: all
  std::vector<std::string> limits = {"ssim=0.98"};  // METRIC=NUMBER
  Shard shard;
  Schedule time{0}, fetches{8}, pictures{8};  // which points get rounds, counts, pictures
};

}  // namespace lamina
