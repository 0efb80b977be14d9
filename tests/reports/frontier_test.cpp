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

TEST(Frontier, TheCloserBeatsWhatIsNotMeasurablyCheaper) {
  EXPECT_TRUE(beats(at(1, 2, 0.1), at(3, 4, 0.2)));     // closer and faster
  EXPECT_TRUE(beats(at(3, 5, 0.1), at(2, 3, 0.2)));     // closer, and the intervals touch
  EXPECT_FALSE(beats(at(3, 5, 0.1), at(2, 2.9, 0.2)));  // closer, but measurably slower
  EXPECT_FALSE(beats(at(1, 2, 0.2), at(3, 4, 0.1)));    // faster, but errs more
}

TEST(Frontier, OfWhatErrsAlikeTheMeasurablyCheaperBeats) {
  EXPECT_TRUE(beats(at(1, 2, 0.1), at(3, 4, 0.1)));
  EXPECT_FALSE(beats(at(1, 3, 0.1), at(3, 4, 0.1)));
  EXPECT_FALSE(beats(at(1, 2, 0.1), at(1, 2, 0.1)));
}

TEST(Frontier, WhatIsNotKnownNeitherBeatsNorIsBeaten) {
  EXPECT_FALSE(beats({.cost = std::nullopt, .error = 0.0}, at(3, 4, 1)));
  EXPECT_FALSE(beats(at(1, 2, 0), {.cost = at(3, 4, 1).cost, .error = std::nullopt}));
  const std::vector<CostAndErrors> group = {{.frame_ms = at(1, 2, 0).cost, .to_baseline = no_error}, {}};
  EXPECT_EQ(frontier_bits(group)[1], 0u);
}

TEST(Frontier, TheClosestOfSeveralIsNamed) {
  const Contender all[] = {at(1, 2, 0.3), at(1, 2, 0.1), at(3, 4, 0.4), at(0.1, 0.2, 0.9)};
  EXPECT_EQ(beaten_by(all), (std::vector<size_t>{1, 1, 1, 3}));
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
  const std::vector<uint32_t> bits = frontier_bits(group);
  EXPECT_EQ(bits[0], (1u << 20) - 1);
  EXPECT_EQ(bits[1], 0b11u | 0b11u << (2 * (5 + 2)));
}

}  // namespace
}  // namespace lamina
