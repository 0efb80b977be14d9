// SPDX-License-Identifier: Apache-2.0
// The search against all choices measured, on made spaces whose truth is known.
#include "harness/choose/search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "harness/core/error.h"

namespace lamina {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

ViewOutcome view(double ms, double ssim, double rmse = 0) {
  ViewOutcome outcome;
  outcome.ms = ms;
  outcome.error = {.psnr_db = rmse > 0 ? -20 * std::log10(rmse) : infinity,
                   .ssim = ssim,
                   .flip = 1 - ssim,
                   .rmse_linear = rmse,
                   .max_linear = rmse};
  return outcome;
}

ChoiceSpace two_effects() {
  ChoiceSpace space;
  space.baseline = {view(10, 1)};
  space.effects = {{"a", {{"full", {view(10, 1)}}, {"half", {view(7, 0.99, 0.03)}}, {"none", {view(6, 0.9, 0.1)}}}},
                   {"b", {{"full", {view(10, 1)}}, {"fast", {view(8, 0.98, 0.04)}}}}};
  return space;
}

TEST(PredictedChoice, AddsUpTimesAndErrors) {
  const ChoiceSpace space = two_effects();
  EXPECT_EQ(space.choices(), 6u);
  const Outcome both = predicted(space, {1, 1});
  EXPECT_DOUBLE_EQ(both[0].ms, 5) << "10 - 3 - 2";
  EXPECT_NEAR(both[0].error.ssim, 0.97, 1e-12);
  EXPECT_NEAR(both[0].error.rmse_linear, 0.05, 1e-12) << "3, 4, 5";
  EXPECT_NEAR(both[0].error.psnr_db, -20 * std::log10(0.05), 1e-9);
  EXPECT_DOUBLE_EQ(both[0].error.max_linear, 0.04);
  EXPECT_EQ(predicted(space, {0, 0})[0].error.psnr_db, infinity);
}

TEST(ChoiceGoals, WithinTheBudgetTheLeastErrorElseTheLeastTime) {
  const ChoiceSpace space = two_effects();
  const auto best = [&](const ChoiceGoal& goal) {
    Choice leader;
    for (const Choice& choice : all_choices(space, "ssim"))
      if (leader.empty() || is_better(predicted(space, choice), predicted(space, leader), goal)) leader = choice;
    return leader;
  };
  EXPECT_EQ(best({.budget_ms = 7.5, .limits = {}}), (Choice{1, 0})) << "SSIM .99 at 7 ms";
  EXPECT_EQ(best({.budget_ms = 100, .limits = {}}), (Choice{0, 0}));
  EXPECT_EQ(best({.budget_ms = {}, .limits = {{"ssim", 0.96}}}), (Choice{1, 1})) << "5 ms";
  EXPECT_EQ(best({.budget_ms = {}, .limits = {{"flip", 0.015}}}), (Choice{1, 0}));
  EXPECT_EQ(best({.budget_ms = 1, .limits = {}}), (Choice{2, 1})) << "nothing fits: the nearest";
  EXPECT_GT(miss(predicted(space, {2, 1}), {.budget_ms = 1, .limits = {}}), 0);
  EXPECT_EQ(miss(predicted(space, {1, 0}), {.budget_ms = 7.5, .limits = {{"ssim", 0.99}}}), 0);
  EXPECT_THROW(worst_error(space.baseline, "beauty"), Error);
}

TEST(ChoiceGoals, TheWorstViewDecides) {
  const Outcome outcome = {view(3, 0.9), view(5, 0.99)};
  EXPECT_EQ(worst_ms(outcome), 5);
  EXPECT_EQ(worst_error(outcome, "ssim"), 0.9);
  EXPECT_NEAR(worst_error(outcome, "flip"), 0.1, 1e-12);
}

TEST(Frontier, HoldsWhatNothingBeats) {
  const std::vector<Outcome> outcomes = {{view(10, 1)}, {view(7, 0.99)}, {view(8, 0.98)}, {view(5, 0.9)}, {view(7, 0.99)}};
  const std::vector<size_t> frontier = frontier_of(outcomes, "ssim");
  EXPECT_EQ(frontier, (std::vector<size_t>{3, 1, 0}));
}

// A made scene: what is measured is what is predicted, but for interplay of options and for errors of the cost model.
struct Made {
  ChoiceSpace space;
  std::map<Choice, Outcome> truth;
};
Made made(uint64_t seed, double interplay, double cost_error) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  Made made;
  made.space.baseline = {view(20, 1), view(16, 1)};
  ChoiceSpace real = made.space;
  for (int effect = 0; effect < 3; ++effect) {
    ChoiceEffect& told = made.space.effects.emplace_back(ChoiceEffect{"e" + std::to_string(effect), {}});
    ChoiceEffect& is = real.effects.emplace_back(told);
    told.options.push_back({"full", made.space.baseline});
    is.options.push_back({"full", made.space.baseline});
    for (int option = 1; option < 6; ++option) {
      const double saved = uniform(0.5, 5), lost = std::pow(10, uniform(-4, -1.5));
      const Outcome single = {view(20 - saved, 1 - lost, lost),
                              view(16 - saved * uniform(0.5, 1), 1 - lost * uniform(0.5, 1), lost)};
      is.options.push_back({"o" + std::to_string(option), single});
      Outcome guess = single;
      for (ViewOutcome& view : guess) view.ms *= 1 + uniform(-cost_error, cost_error);
      told.options.push_back({"o" + std::to_string(option), guess});
    }
  }
  for (const Choice& choice : all_choices(real, "ssim")) {
    Outcome outcome = predicted(real, choice);
    for (ViewOutcome& view : outcome) {
      view.ms *= 1 + uniform(-interplay, interplay);
      view.error.ssim = 1 - (1 - view.error.ssim) * (1 + uniform(-interplay, interplay));
    }
    made.truth[choice] = outcome;
  }
  return made;
}

// As `choose` does, but with up to a third of the choices: the baseline first, then the best predicted, four at a time.
ChoiceSearch searched(const Made& made, const ChoiceGoal& goal, double doubt) {
  ChoiceSearch search(made.space, goal, made.truth.size() / 3, doubt);
  search.tell({0, 0, 0}, made.truth.at({0, 0, 0}));
  for (std::vector<Choice> next = search.next(4); !next.empty(); next = search.next(4))
    for (const Choice& choice : next) search.tell(choice, made.truth.at(choice));
  return search;
}

TEST(ChoiceSearch, FindsWhatMeasuringAllFinds) {
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    const Made scene = made(seed, 0, 0);
    for (const ChoiceGoal& goal :
         {ChoiceGoal{.budget_ms = 12.0, .limits = {}}, ChoiceGoal{.budget_ms = {}, .limits = {{"ssim", 0.97}}}}) {
      const ChoiceSearch search = searched(scene, goal, 0);
      Choice best;
      for (const auto& [choice, outcome] : scene.truth)
        if (best.empty() || is_better(outcome, scene.truth.at(best), goal)) best = choice;
      EXPECT_EQ(*search.best(), best) << "seed " << seed;
      EXPECT_LE(search.measured().size(), 5u) << "predictions are exact: seed " << seed;
    }
  }
}

// With costs told within 5% and options that play together, the choice is within 2% of the best time, measuring a third at
// most.
TEST(ChoiceSearch, IsNearTheBestWherePredictionsErr) {
  int found = 0, all = 0;
  size_t measured = 0;
  for (uint64_t seed = 1; seed <= 60; ++seed, ++all) {
    const Made scene = made(seed, 0.02, 0.05);
    const ChoiceGoal goal{.budget_ms = {}, .limits = {{"ssim", 0.97}}};
    const ChoiceSearch search = searched(scene, goal, 0.05);
    Choice best;
    for (const auto& [choice, outcome] : scene.truth)
      if (best.empty() || is_better(outcome, scene.truth.at(best), goal)) best = choice;
    const Outcome& chosen = scene.truth.at(*search.best());
    EXPECT_EQ(miss(chosen, goal), 0);
    EXPECT_LE(search.measured().size(), scene.truth.size() / 3);
    found += worst_ms(chosen) <= 1.02 * worst_ms(scene.truth.at(best));
    measured += search.measured().size();
  }
  EXPECT_GE(found, 57) << "of " << all;
  EXPECT_LT(static_cast<double>(measured) / all, 216.0 / 4);
}

// The search whole, on a fake of the device: what it times it asks in batches, and no choice twice.
TEST(SearchedChoices, AreTimedInBatchesAndOnce) {
  EXPECT_EQ(measured_at_most(3), 2u);
  EXPECT_EQ(measured_at_most(30), 10u);
  EXPECT_EQ(measured_at_most(216), 21u);
  int near_best = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    const Made scene = made(seed, 0.02, 0.05);
    const ChoiceGoal goal{.budget_ms = {}, .limits = {{"ssim", 0.97}}};
    std::map<Choice, int> asked;
    const ChoiceSearch search = search_choices(scene.space, goal, 0.05, [&](const std::vector<Choice>& next) {
      EXPECT_LE(next.size(), choice_batch);
      std::vector<Outcome> outcomes;
      for (const Choice& choice : next) ++asked[choice], outcomes.push_back(scene.truth.at(choice));
      return outcomes;
    });
    for (const auto& [choice, times] : asked) EXPECT_EQ(times, 1);
    EXPECT_FALSE(asked.contains(Choice{0, 0, 0})) << "the baseline is timed beside every batch already";
    EXPECT_LE(search.measured().size(), scene.truth.size() / 10) << "a tenth, the baseline counted";
    EXPECT_EQ(search.measured().size(), asked.size() + 1);
    double best = infinity;
    for (const auto& [choice, outcome] : scene.truth)
      if (miss(outcome, goal) == 0) best = std::min(best, worst_ms(outcome));
    near_best += worst_ms(scene.truth.at(*search.best())) <= 1.02 * best;
  }
  EXPECT_GE(near_best, 27) << "of 30";
}

// 0.01 of SSIM by `half` in place of `none` of effect a costs 1 ms for 0.09; by `full` 4 ms for 0.1.
TEST(NextPrice, IsThatOfTheCheapestBetterOption) {
  const ChoiceSpace space = two_effects();
  const ChoiceSearch known(space, {.budget_ms = 100.0, .limits = {}}, 2, 0);
  const std::optional<Price> price = next_price(known, space, {2, 0}, 0);
  ASSERT_TRUE(price);
  EXPECT_EQ(price->option, 1u);
  EXPECT_NEAR(price->ms, 0.01 * 1 / 0.09, 1e-12);
  EXPECT_NEAR(price->gain, 0.09, 1e-12);
  EXPECT_FALSE(next_price(known, space, {0, 0}, 1)) << "the baseline has no error";
  EXPECT_NEAR(next_price(known, space, {2, 1}, 1)->ms, 0.01 * 2 / 0.02, 1e-9);
}

TEST(ChoiceSearch, OneEffectOfOneOptionNeedsNothingMore) {
  ChoiceSpace space;
  space.baseline = {view(3, 1)};
  space.effects = {{"a", {{"full", space.baseline}}}};
  ChoiceSearch search(space, {.budget_ms = 10.0, .limits = {}}, 3, 0.1);
  EXPECT_EQ(search.next(4), std::vector<Choice>{{0}});
  search.tell({0}, space.baseline);
  EXPECT_TRUE(search.next(4).empty());
  EXPECT_EQ(*search.best(), Choice{0});
}

TEST(AllChoices, ManyAreThinnedToWhatNothingBeats) {
  ChoiceSpace space;
  space.baseline = {view(10, 1)};
  for (int effect = 0; effect < 8; ++effect) {
    ChoiceEffect& made = space.effects.emplace_back(ChoiceEffect{"e", {}});
    made.options.push_back({"full", space.baseline});
    for (int option = 1; option < 8; ++option)
      made.options.push_back({"o", {option == 3 ? view(9, 0.99) : view(9.5, 0.98 - 0.001 * option)}});
  }
  EXPECT_GT(space.choices(), 1000000u);
  EXPECT_EQ(all_choices(space, "ssim").size(), 256u) << "full and the third of each";
}

}  // namespace
}  // namespace lamina
