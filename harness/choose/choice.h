// SPDX-License-Identifier: Apache-2.0
// What `lamina choose` chooses from: for each effect of a scene one of its options, each drawn once while all other effects
// stood at their baselines. From these singles every other choice is predicted.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/quality/quality.h"

namespace lamina {

// A frame in one view: its time, and its error to the reference.
struct ViewOutcome {
  double ms = 0;
  ErrorFigures error;
};
using Outcome = std::vector<ViewOutcome>;  // by view

struct ChoiceOption {
  std::string name;  // of the variant
  Outcome single;
};
struct ChoiceEffect {
  std::string name;
  std::vector<ChoiceOption> options;  // the baseline first
};
struct ChoiceSpace {
  std::vector<ChoiceEffect> effects;
  Outcome baseline;          // of all effects at their baselines
  uint64_t choices() const;  // how many there are
};

// By effect: which of its options.
using Choice = std::vector<size_t>;

// What is known of a choice from the singles. Times add up: the baseline's, and what each option takes more or less. So do
// squared errors of linear light (RMSE), what PSNR makes of squared errors of display values, 1 - SSIM, and FLIP: exact where
// options change other pixels, and a guess where they change the same ones. The greatest difference is the greatest of all.
// Errors are those to the reference; a baseline that is itself off the truth is counted once.
Outcome predicted(const ChoiceSpace& space, const Choice& choice);

// What is wanted. A limit holds in every view, and the budget too.
struct ErrorLimit {
  std::string metric;  // a name of quality/error_metrics.h
  double value = 0;
};
struct ChoiceGoal {
  std::optional<double> budget_ms;
  std::vector<ErrorLimit> limits;
  std::string metric = "ssim";  // by which errors are ordered
};

// The worst view's.
double worst_ms(const Outcome& outcome);
double worst_error(const Outcome& outcome, const std::string& metric);
// SSIM and PSNR are better where they are greater.
bool greater_is_better(const std::string& metric);

// By how much an outcome misses what is wanted: 0 where it fits; else the sum of what it is beyond, each as a share of its
// bound (of SSIM: of 1 - bound).
double miss(const Outcome& outcome, const ChoiceGoal& goal);

// Whether `a` is the better choice. What fits is better than what does not, and of those that do not the one that misses by
// less. Of two that fit: with a budget the one of less error, then of less time; without one the one of less time, then of less
// error.
bool is_better(const Outcome& a, const Outcome& b, const ChoiceGoal& goal);

// Which of the outcomes no other beats in time and error both, by index, cheapest first; worst views.
std::vector<size_t> frontier_of(std::span<const Outcome> outcomes, const std::string& metric);

}  // namespace lamina
