// SPDX-License-Identifier: Apache-2.0
// Which choices to measure next, and when to stop.
#pragma once

#include <functional>
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

// How many choices may be measured of so many that exist: a third, a tenth of more than a hundred; two at least.
uint64_t measured_at_most(uint64_t exist);

inline constexpr size_t choice_batch = 3;  // choices that are timed beside each other, and beside the baseline

// Measures choices, the best predicted first, until no other can be the best or as many are measured as may be. `measure`
// times and judges at most choice_batch choices; it says one outcome for each. The space must outlive the search.
ChoiceSearch search_choices(const ChoiceSpace& space, const ChoiceGoal& goal, double doubt,
                            const std::function<std::vector<Outcome>(const std::vector<Choice>&)>& measure);

// What the next 0.01 of SSIM costs by another option of one effect, as far as is known: the cheapest of those that have less
// error in the worst view. None where no option has.
struct Price {
  size_t option = 0;
  double ms = 0;    // below 0 where the better option takes less time
  double gain = 0;  // of SSIM, by that option; the last 0.01 before 1 cannot be bought whole
};
std::optional<Price> next_price(const ChoiceSearch& known, const ChoiceSpace& space, const Choice& choice, size_t effect);

// All choices; of spaces with more than a million, without options that another option of the same effect beats in time and in
// error, in the worst view.
std::vector<Choice> all_choices(const ChoiceSpace& space, const std::string& metric);

}  // namespace lamina
