// SPDX-License-Identifier: Apache-2.0
// What a frame will take, told from what it executes: a weight for each kind of work, fitted to measured passes of one device.
//
// A pass takes what it does (pass_work.h), each kind of work times its weight. Weights are at least 0, so that no work makes a
// frame faster. They make the sum of absolute relative errors least, of frames and of their passes: a frame's time says how its
// passes add up, a pass's time which work it was. Two models are tried, of what is executed and of what is issued
// (shader/block_work.h); the device decides which of them holds.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "harness/cost/pass_work.h"

namespace lamina {

// A pass of a frame that was timed.
struct TimedPass {
  PassWork executed, issued;
  double ms = 0;  // median
  const PassWork& of(CountedWork counted) const { return counted == CountedWork::issued ? issued : executed; }
};
struct TimedFrame {
  std::string variant;  // with its effect's name; what is left out of a fit is left out by variant
  std::vector<TimedPass> passes;
  double ms() const;
};
// Of the cells that were timed and counted, passes done once left out. A cell with a pass that no counts tell of is left out.
std::vector<TimedFrame> timed_frames(std::span<const CellRow> cells);

struct CostWeight {
  double ns = 0, low = 0, high = 0;  // of one; the 95% interval, by drawing variants again (bootstrap)
};

// How well frames of variants that the fit has not seen are told: ten fits, each without a tenth of the variants.
struct CostJudgement {
  double rank_correlation = 0;  // Spearman's, of predicted and measured frame times
  double mean_error = 0;        // of |predicted / measured - 1|
  double median_error = 0;
  size_t frames = 0, variants = 0;
};

struct CostModel {
  std::string backend, device;
  CountedWork counted = CountedWork::executed;
  std::map<std::string, CostWeight> weights;
  CostJudgement judged;
};

// The better of both models by its judgement's mean error. Throws Error(bad_input) for frames of fewer than ten variants.
CostModel fit_cost_model(std::span<const TimedFrame> frames);
CostJudgement judge_cost_model(std::span<const TimedFrame> frames, CountedWork counted);

// ms. PassWork that the model has no weight for (a format that no fit has seen) counts nothing and is named in `unknown`, where
// it is given.
double predicted_ms(const CostModel& model, std::span<const PassRow> passes, std::vector<std::string>* unknown = nullptr);

nlohmann::ordered_json to_json(const CostModel& model);
// Throws Error(bad_input, "cost model", `object`, ...) for what is no such model.
CostModel cost_model_from_json(const nlohmann::json& json, const std::string& object);

// Spearman's rank correlation, ties at their mean rank; 0 where either side is constant. Of equally many numbers, at least two.
double rank_correlation(std::span<const double> a, std::span<const double> b);

}  // namespace lamina
