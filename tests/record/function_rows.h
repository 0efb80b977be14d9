// SPDX-License-Identifier: Apache-2.0
// Function rows made by hand.
#pragma once

#include "harness/record/function_rows.h"

namespace lamina {

inline FunctionSubject example_subject(std::string variant = "smoothstep_cap", std::string backend = "vulkan") {
  return {.function = "cap_intersection",
          .title = "the area that two spherical caps share",
          .variant = variant,
          .backend = std::move(backend),
          .device = "llvmpipe",
          .baseline = variant == "exact_cap"};
}

// Errs by `over` and -`over` / 2.
inline FunctionRow example_function(FunctionSubject subject, double over, std::string set = "overlaps") {
  return {.subject = std::move(subject),
          .scale = "the smaller cap's area",
          .set = std::move(set),
          .what = "a grid",
          .points = 1000,
          .max_over = over,
          .max_under = -over / 2,
          .mean_absolute = over / 4,
          .rms = over / 3,
          .max_eps = over * 0x1p23,
          .max_eps_kappa = 7,
          .not_zero = 3,
          .worst_over = {0.5, 0.25, 0.125},
          .worst_under = {1, 2, 3}};
}

// The same, claiming to err by up to a quarter, and with a fault.
inline FunctionRow with_bounds(FunctionRow row) {
  row.negative = 2;
  row.first_fault = {3, 2, 1};
  row.bounds = FunctionBounds{.over = 0.25, .under = -0.25, .eps_kappa = {}};
  return row;
}

inline FunctionTimeRow example_time(FunctionSubject subject, double ns) {
  return {.subject = std::move(subject),
          .ns_per_call = Interval{.median = ns, .low = ns * 0.9, .high = ns * 1.1, .rounds = 12, .coverage = 0.96},
          .commit = "abc1234",
          .build = "release"};
}

// The same with its rounds: one of twelve is far off, whose digits are more than a record keeps.
inline FunctionTimeRow with_samples(FunctionTimeRow row) {
  const double ns = row.ns_per_call->median;
  for (int round = 0; round < 11; ++round) row.ns.push_back(ns * (0.9 + 0.02 * round));
  row.ns.push_back(ns * 1.23456789);
  return row;
}

inline FunctionPictureRow example_picture(FunctionSubject subject) {
  return {.subject = std::move(subject),
          .slice = "r1 = 0.5",
          .axes = "r0 right, d up",
          .image = "images/slice.png",
          .full_error = 0.16};
}

}  // namespace lamina
