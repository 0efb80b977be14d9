// SPDX-License-Identifier: Apache-2.0
// Which choices to measure next, and when to stop.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "harness/choose/choice.h"

namespace lamina {

class ChoiceSearch {
 public:
  // `max_measured`: choices that may be measured, the baseline counted. `doubt`: by what share of its time a prediction may be
  // wrong; a choice is given up only where even a time that much shorter would not make it the best.
  ChoiceSearch(const ChoiceSpace& space, const ChoiceGoal& goal, size_t max_measured, double doubt);

  // The best predicted ones that are not measured, at most `count`; none where no other can be the best, or as many are
  // measured as may be.
  std::vector<Choice> next(size_t count) const;
  void tell(const Choice& choice, const Outcome& measured);

  // Of the measured ones.
  std::optional<Choice> best() const;
  const std::map<Choice, Outcome>& measured() const { return measured_; }
  // As far as is known: what was measured, or the prediction, corrected by what was measured of its like.
  Outcome outcome_of(const Choice& choice) const;

 private:
  const ChoiceSpace& space_;
  ChoiceGoal goal_;
  size_t max_measured_;
  double doubt_;
  std::vector<Choice> all_;
  std::map<Choice, Outcome> measured_;
};

// All choices; of spaces with more than a million, without options that another option of the same effect beats in time and in
// error, in the worst view.
std::vector<Choice> all_choices(const ChoiceSpace& space, const std::string& metric);

}  // namespace lamina
