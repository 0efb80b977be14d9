// SPDX-License-Identifier: Apache-2.0
// What lamina compare does, for commands that measure as it does.
#pragma once

#include <string>
#include <vector>

#include "harness/cli/devices.h"
#include "harness/cli/watch.h"
#include "harness/plan/plan.h"

namespace lamina {

// Below it people see another picture at a glance; no built-in variant that is meant to be used is.
inline constexpr const char* default_limit = "ssim=0.7";

// Of --quick, where nothing else is said: of a backend's rounds, s, and of ratios.
inline constexpr double quick_budget_s = 4, quick_precision = 0.05;

struct CompareOptions : WatchOptions {                // the rounds are of a backend, shared by its effects
  std::vector<std::string> limits = {default_limit};  // METRIC=NUMBER, against the baseline
  bool quick = false;
  bool first_backend = false;  // of the backends only the first that opens
  bool times = true;
  bool watch = false;
  bool against_all = false;  // the frame of what is called for, against the frame of everything
};

// What is measured: these effects of a scene's plan.
struct Compared {
  const Library& library;
  const Scene& scene;
  const Plan& plan;
  std::vector<const EffectManifest*> effects;
};

// What compare runs on, of which one opens. Throws Error where none does, and for a frame too large for them.
std::vector<ProbedBackend> usable_backends(const CompareOptions& options);

// Measures, and leaves the record and the report in options.out. Returns the exit status.
int run_compare(const CompareOptions& options);

// Measures counts and times alone and leaves them in a record in options.out: no picture, error, report or table. Returns the
// signal that stopped it, or 0.
int measure_costs(const Compared& compared, const CompareOptions& options);

}  // namespace lamina
