// SPDX-License-Identifier: Apache-2.0
// The shaders' cap intersections themselves, run on a device over sets of inputs, and what they err by.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/measure/rounds.h"
#include "harness/stress/cap_sets.h"

namespace lamina {

// Names of the functions in shaders/cap_intersection: files NAME_cap.glsl, each with a function of that name. exact_cap comes
// first.
std::vector<std::string> cap_variants(const std::filesystem::path& shaders);

// One variant on a backend.
class CapRunner {
 public:
  // Throws as compile_shader() and create_pipeline() do.
  CapRunner(Backend& backend, const std::filesystem::path& shaders, const std::string& variant);
  ~CapRunner();
  CapRunner(const CapRunner&) = delete;
  CapRunner& operator=(const CapRunner&) = delete;

  // The function's value for each input.
  std::vector<float> areas(std::span<const CapInput> inputs);
  // Device time in ms of `calls` calls for each of the inputs last given to areas().
  double time_ms(int calls);
  size_t inputs() const { return count_; }

 private:
  RunTimes run(int calls, Timing timing);

  Backend& backend_;
  PipelineId pipeline_;
  TextureId table_;  // of a function that reads one
  BufferId inputs_, areas_, work_;
  size_t count_ = 0;
};

// What the areas are held to, beside a set's inputs: the area that a file gives, else cap_intersection_area(), and
// cap_intersection_condition().
struct CapTruth {
  std::vector<double> areas, conditions;
};
CapTruth truth_of(const CapSet& set);

// Errors are (area - truth) / area of the smaller cap, unless they say otherwise.
struct CapErrors {
  double max_over = 0, max_under = 0;  // greatest and least, so 0 or more and 0 or less
  double mean_absolute = 0, rms = 0;
  CapInput worst_over, worst_under;
  double most_eps = 0;        // greatest |error| in units of 2^-23
  double most_eps_kappa = 0;  // greatest |area - truth| / truth in units of 2^-23 max(1, kappa), over caps that overlap
  size_t negative = 0, nonfinite = 0;
  size_t not_zero = 0;                  // caps that are apart, but area is not 0
  std::optional<CapInput> first_fault;  // the first input of these three
};
// Inputs, areas and truth beside each other. What is not finite is counted and in no other figure.
CapErrors judge_caps(std::span<const CapInput> inputs, std::span<const float> areas, const CapTruth& truth);

// Nanoseconds of one call in each of `runners` in each of `rounds` shuffled rounds, as the difference of a long and a short
// run.
std::vector<std::vector<double>> nanoseconds_per_call(std::span<CapRunner* const> runners, size_t rounds, uint64_t seed);

}  // namespace lamina
