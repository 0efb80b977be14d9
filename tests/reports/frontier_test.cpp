// SPDX-License-Identifier: Apache-2.0
// What is worth having, on figures small enough to weigh by hand.
#include "reports/frontier.h"

#include <gtest/gtest.h>

#include "reports/words.h"
#include "tests/reports/example_record.h"

namespace lamina {
namespace {

Contender at(double low, double high, double error) {
  return {.cost = Interval{.median = (low + high) / 2, .low = low, .high = high, .rounds = 9, .coverage = 0.96},
          .error = error};
}

Standing standing_of(const Contender& one, const Contender& beside) {
  const Contender both[] = {one, beside};
  return places_of(both, as_fast)[0].standing;
}

TEST(Frontier, ByIntervalsThereAreThreeAnswers) {
  EXPECT_EQ(standing_of(at(3, 4, 0.2), at(1, 2, 0.1)), Standing::dominated) << "the other is closer and faster";
  EXPECT_EQ(standing_of(at(2, 2.9, 0.2), at(3, 5, 0.1)), Standing::on_frontier) << "the other is closer, but slower";
  EXPECT_EQ(standing_of(at(2, 3, 0.2), at(3, 5, 0.1)), Standing::not_told_apart) << "the intervals touch";
  EXPECT_EQ(standing_of(at(3, 4, 0.1), at(1, 2, 0.2)), Standing::on_frontier) << "nothing is closer";
}

TEST(Frontier, OfWhatErrsAlikeTheMeasurablyCheaperDominates) {
  EXPECT_EQ(standing_of(at(3, 4, 0.1), at(1, 2, 0.1)), Standing::dominated);
  EXPECT_EQ(standing_of(at(3, 4, 0.1), at(1, 3, 0.1)), Standing::on_frontier);
  EXPECT_EQ(standing_of(at(1, 2, 0.1), at(3, 4, 0.1)), Standing::on_frontier);
}

// Ten rounds in which both slow down and speed up together by a factor of 3: the intervals overlap almost whole, and yet one
// was the faster in every round.
std::vector<double> rounds_of(double ms) {
  std::vector<double> all;
  for (const double load : {1.0, 1.9, 1.2, 3.0, 1.1, 2.2, 1.0, 1.6, 2.8, 1.3}) all.push_back(ms * load);
  return all;
}
Contender timed(std::vector<double> rounds, double error) {
  const Interval interval = widest_interval(rounds, 0.95);
  return {.cost = interval, .error = error, .rounds = std::move(rounds)};
}

TEST(Frontier, PairsOfRoundsTellApartWhatIntervalsDoNot) {
  const Contender slow = timed(rounds_of(53), 0.1), fast = timed(rounds_of(46), 0.2);
  ASSERT_GT(fast.cost->high, slow.cost->low) << "by intervals they overlap";
  EXPECT_EQ(standing_of(fast, slow), Standing::on_frontier);
  EXPECT_EQ(standing_of(timed(rounds_of(60), 0.2), slow), Standing::dominated);
  EXPECT_EQ(standing_of(timed(rounds_of(52.5), 0.2), timed(rounds_of(53), 0.1)), Standing::on_frontier);
  EXPECT_EQ(standing_of(timed(rounds_of(53), 0.2), slow), Standing::dominated) << "no slower within 2%, and closer";
}

TEST(Frontier, WhatWasFasterInSevenOfTenRoundsIsNotToldApart) {
  std::vector<double> rounds = rounds_of(46);
  const std::vector<double> others = rounds_of(53);
  for (const size_t lost : {0u, 4u, 7u}) rounds[lost] = others[lost] * 1.2;
  EXPECT_EQ(standing_of(timed(rounds, 0.2), timed(others, 0.1)), Standing::not_told_apart);
}

// With one error rate over the chart, what ten rounds tell of one pair they do not tell of 66: one lost round of ten is enough.
TEST(Frontier, ManyPairsNeedMoreRounds) {
  std::vector<Contender> all;
  for (int i = 0; i < 12; ++i) {
    std::vector<double> rounds = rounds_of(46 - i);
    rounds[size_t(i) % 10] *= 1.1;
    all.push_back(timed(std::move(rounds), 0.1 + 0.1 * i));
  }
  EXPECT_EQ(places_of(std::span(all).first(2), as_fast)[1].standing, Standing::on_frontier);
  EXPECT_EQ(places_of(all, as_fast)[1].standing, Standing::not_told_apart);
  EXPECT_EQ(places_of(all, as_fast)[1].by, 0u);
}

TEST(Frontier, FewRoundsTellApartWhereTheyAgree) {
  const auto rounds = [](double ms, std::vector<double> noise) {
    for (double& one : noise) one *= ms;
    return noise;
  };
  const Contender closer = timed(rounds(10, {1, 1.01, 0.99, 1, 1.02}), 0.1);
  EXPECT_EQ(standing_of(timed(rounds(5, {1.01, 1, 0.99, 1, 1}), 0.2), closer), Standing::on_frontier);
  EXPECT_EQ(standing_of(timed(rounds(5, {1.9, 1, 0.8, 2.1, 1}), 0.2), closer), Standing::not_told_apart);
  EXPECT_EQ(standing_of(timed({5, 5, 5}, 0.2), closer), Standing::not_told_apart) << "three rounds are too few to agree";
}

TEST(Frontier, WhatIsNotKnownNeitherBeatsNorIsBeaten) {
  EXPECT_EQ(standing_of({.cost = std::nullopt, .error = 0.0}, at(3, 4, 1)), Standing::unknown);
  EXPECT_EQ(standing_of(at(3, 4, 1), {.cost = std::nullopt, .error = 0.0}), Standing::on_frontier);
  EXPECT_EQ(standing_of({.cost = at(3, 4, 1).cost, .error = std::nullopt}, at(1, 2, 0)), Standing::unknown);
  const std::vector<CostAndErrors> group = {{.frame_ms = at(1, 2, 0).cost, .to_baseline = no_error}, {}};
  EXPECT_EQ(frontier_bits(group)[1].on_frontier, 0u);
}

TEST(Frontier, TheClosestOfSeveralIsNamed) {
  const Contender all[] = {at(1, 2, 0.3), at(1, 1, 0.1), at(3, 4, 0.4), at(0.1, 0.2, 0.9)};
  const std::vector<Place> places = places_of(all, as_fast);
  EXPECT_EQ(places[0].by, 1u);
  EXPECT_EQ(places[1].by, 1u);
  EXPECT_EQ(places[2].by, 1u);
  EXPECT_EQ(places[3].standing, Standing::on_frontier);
}

TEST(Frontier, BeyondALimitNothingIsWorthHaving) {
  Contender far = at(1, 2, 0.9);
  far.acceptable = false;
  EXPECT_EQ(standing_of(far, at(3, 4, 0.1)), Standing::beyond_limit);
  // Against the truth, what is closer than the baseline may be far from the baseline.
  const ErrorFigures near{.psnr_db = 30, .ssim = 0.9, .flip = 0.1, .rmse_linear = 0.1, .max_linear = 0.1};
  ErrorFigures bad = near;
  bad.ssim = 0.6;
  CostAndErrors baseline{.frame_ms = at(3, 4, 0).cost, .to_baseline = no_error, .to_truth = bad, .baseline = true};
  CostAndErrors other{.frame_ms = at(1, 2, 0).cost, .to_baseline = bad, .to_truth = near, .beyond_limit = true};
  const CostAndErrors group[] = {baseline, other};
  EXPECT_EQ(places_of(group, Cost::time, error_metrics[0], Reference::baseline)[1].standing, Standing::beyond_limit);
  EXPECT_EQ(places_of(group, Cost::time, error_metrics[0], Reference::truth)[1].standing, Standing::on_frontier);
}

TEST(Frontier, BitsFollowTheOrderOfMetricsReferencesAndCosts) {
  // The second is slower and fetches more; it is closer by SSIM to the baseline and by FLIP to the truth alone.
  const ErrorFigures one = {.psnr_db = 30, .ssim = 0.9, .flip = 0.1, .rmse_linear = 0.1, .max_linear = 0.1};
  ErrorFigures other = {.psnr_db = 20, .ssim = 0.95, .flip = 0.2, .rmse_linear = 0.2, .max_linear = 0.2};
  std::vector<CostAndErrors> group(2);
  group[0] = {.frame_ms = at(1, 2, 0).cost, .fetches_per_pixel = 1, .to_baseline = one, .to_truth = one};
  group[1] = {.frame_ms = at(3, 4, 0).cost, .fetches_per_pixel = 2, .to_baseline = other, .to_truth = other};
  group[1].to_truth->ssim = 0.8;
  group[1].to_truth->flip = 0.05;
  const std::vector<FrontierBits> bits = frontier_bits(group);
  EXPECT_EQ(bits[0].on_frontier, (1u << 20) - 1);
  EXPECT_EQ(bits[1].on_frontier, 0b11u | 0b11u << (2 * (5 + 2)));
}

}  // namespace
}  // namespace lamina
