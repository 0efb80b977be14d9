// SPDX-License-Identifier: Apache-2.0
#include "harness/choose/search.h"

#include <algorithm>
#include <cmath>

namespace lamina {

std::vector<Choice> all_choices(const ChoiceSpace& space, const std::string& metric) {
  constexpr uint64_t max_choices = 1000000;
  std::vector<std::vector<size_t>> options;  // by effect
  for (const ChoiceEffect& effect : space.effects) {
    std::vector<size_t>& kept = options.emplace_back();
    if (space.choices() > max_choices) {
      std::vector<Outcome> singles;
      for (const ChoiceOption& option : effect.options) singles.push_back(option.single);
      kept = frontier_of(singles, metric);
    } else {
      for (size_t i = 0; i < effect.options.size(); ++i) kept.push_back(i);
    }
  }
  std::vector<Choice> all = {Choice{}};
  for (const std::vector<size_t>& of_effect : options) {
    std::vector<Choice> longer;
    for (const Choice& choice : all)
      for (const size_t option : of_effect) longer.push_back(choice), longer.back().push_back(option);
    all = std::move(longer);
  }
  return all;
}

uint64_t measured_at_most(uint64_t exist) { return std::max<uint64_t>(2, exist / (exist > 100 ? 10 : 3)); }

ChoiceSearch search_choices(const ChoiceSpace& space, const ChoiceGoal& goal, double doubt,
                            const std::function<std::vector<Outcome>(const std::vector<Choice>&)>& measure) {
  ChoiceSearch known(space, goal, measured_at_most(space.choices()), doubt);
  known.tell(Choice(space.effects.size(), 0), space.baseline);
  for (std::vector<Choice> next = known.next(choice_batch); !next.empty(); next = known.next(choice_batch)) {
    const std::vector<Outcome> outcomes = measure(next);
    for (size_t i = 0; i < next.size(); ++i) known.tell(next[i], outcomes.at(i));
  }
  return known;
}

std::optional<Price> next_price(const ChoiceSearch& known, const ChoiceSpace& space, const Choice& choice, size_t effect) {
  constexpr double min_gain = 1e-5;  // of SSIM: less is rounding
  const Outcome now = known.outcome_of(choice);
  std::optional<Price> cheapest;
  Choice other = choice;
  for (other[effect] = 0; other[effect] < space.effects[effect].options.size(); ++other[effect]) {
    const Outcome then = known.outcome_of(other);
    const double gain = worst_error(then, "ssim") - worst_error(now, "ssim");
    if (gain <= min_gain) continue;
    const double ms = 0.01 * (worst_ms(then) - worst_ms(now)) / gain;
    if (!cheapest || ms < cheapest->ms) cheapest = Price{other[effect], ms, gain};
  }
  return cheapest;
}

ChoiceSearch::ChoiceSearch(const ChoiceSpace& space, const ChoiceGoal& goal, size_t max_measured, double doubt)
    : space_(space), goal_(goal), max_measured_(max_measured), doubt_(doubt), all_(all_choices(space, goal.metric)) {}

void ChoiceSearch::tell(const Choice& choice, const Outcome& measured) { measured_[choice] = measured; }

// A measured choice that shares all options but one says more of a prediction's error than one that shares none.
Outcome ChoiceSearch::outcome_of(const Choice& choice) const {
  if (const auto known = measured_.find(choice); known != measured_.end()) return known->second;
  Outcome outcome = predicted(space_, choice);
  std::vector<double> log_ms(outcome.size(), 0), ssim(outcome.size(), 0), flip(outcome.size(), 0);
  double weights = 0;
  for (const auto& [other, real] : measured_) {
    size_t shared = 0;
    for (size_t i = 0; i < choice.size(); ++i) shared += choice[i] == other[i];
    const double weight = std::pow(4.0, static_cast<double>(shared));
    const Outcome told = predicted(space_, other);
    for (size_t view = 0; view < outcome.size(); ++view) {
      if (told[view].ms > 0 && real[view].ms > 0) log_ms[view] += weight * std::log(real[view].ms / told[view].ms);
      ssim[view] += weight * (real[view].error.ssim - told[view].error.ssim);
      flip[view] += weight * (real[view].error.flip - told[view].error.flip);
    }
    weights += weight;
  }
  for (size_t view = 0; weights > 0 && view < outcome.size(); ++view) {
    outcome[view].ms *= std::exp(log_ms[view] / weights);
    outcome[view].error.ssim = std::min(1.0, outcome[view].error.ssim + ssim[view] / weights);
    outcome[view].error.flip = std::clamp(outcome[view].error.flip + flip[view] / weights, 0.0, 1.0);
  }
  return outcome;
}

std::optional<Choice> ChoiceSearch::best() const {
  std::optional<Choice> best;
  for (const auto& [choice, outcome] : measured_)
    if (!best || is_better(outcome, measured_.at(*best), goal_)) best = choice;
  return best;
}

std::vector<Choice> ChoiceSearch::next(size_t count) const {
  if (measured_.size() >= max_measured_) return {};
  const std::optional<Choice> leader = best();
  std::vector<std::pair<Outcome, Choice>> open;
  for (const Choice& choice : all_) {
    if (measured_.contains(choice)) continue;
    Outcome hoped = outcome_of(choice);
    for (ViewOutcome& view : hoped) view.ms *= 1 - doubt_;
    if (!leader || is_better(hoped, measured_.at(*leader), goal_)) open.emplace_back(std::move(hoped), choice);
  }
  const size_t kept = std::min({count, open.size(), max_measured_ - measured_.size()});
  std::partial_sort(open.begin(), open.begin() + static_cast<ptrdiff_t>(kept), open.end(),
                    [&](const auto& a, const auto& b) { return is_better(a.first, b.first, goal_); });
  std::vector<Choice> next;
  for (size_t i = 0; i < kept; ++i) next.push_back(open[i].second);
  return next;
}

}  // namespace lamina
