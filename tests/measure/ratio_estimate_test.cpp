// SPDX-License-Identifier: Apache-2.0
// Ratios of made-up strips, whose answers follow from the definitions, and the truth of the errors that are stated with them.
#include "harness/measure/ratio_estimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "harness/core/error.h"

namespace lamina {
namespace {

using Strips = std::vector<StripPair>;

double ratio_of(const Strips& strips) { return std::exp(estimate_ratio(strips).log_ratio); }

// `count` strips of that ratio, each off by normal noise of `sigma`, in either order by turns.
Strips noisy(size_t count, double ratio, double sigma, std::mt19937_64& random) {
  std::normal_distribution<double> noise(0, sigma);
  Strips strips;
  for (size_t i = 0; i < count; ++i) strips.push_back({3, 3 * ratio * std::exp(noise(random)), i % 2 == 0});
  return strips;
}

TEST(RatioEstimate, EqualStripsGiveTheirRatioWithoutError) {
  const RatioEstimate estimate = estimate_ratio(Strips{{2, 3}, {4, 6}, {1, 1.5}});
  EXPECT_NEAR(estimate.log_ratio, std::log(1.5), 1e-12);
  EXPECT_NEAR(estimate.error, 0, 1e-12);
  EXPECT_EQ(estimate.strips, 3u);
}

TEST(RatioEstimate, TurnedRoundItIsTheInverse) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    Strips strips = noisy(40, 1.07, 0.1, random), turned;
    for (const StripPair& strip : strips) turned.push_back({strip.after, strip.before, !strip.after_first});
    EXPECT_NEAR(ratio_of(strips) * ratio_of(turned), 1, 1e-6);
    EXPECT_NEAR(estimate_ratio(strips).error, estimate_ratio(turned).error, 1e-6);
  }
}

// Another process ran during one strip in ten: they count as little as strips that are off by less than a deviation.
TEST(RatioEstimate, StripsThatMetAnotherProcessHardlyCount) {
  std::mt19937_64 random(4);
  Strips strips = noisy(200, 1.1, 0.01, random);
  const double without = estimate_ratio(strips).log_ratio;
  for (size_t i = 0; i < strips.size(); i += 10) strips[i].after *= 3;
  EXPECT_NEAR(estimate_ratio(strips).log_ratio, without, 0.003);
  for (size_t i = 0; i < strips.size(); i += 10) strips[i].after *= 1000;
  EXPECT_NEAR(estimate_ratio(strips).log_ratio, without, 0.003) << "however long it ran";
}

// The first of two pays for cold caches, by a quarter. Orders need not come equally often.
TEST(RatioEstimate, WhatTheOrderCostsIsTakenOut) {
  Strips strips;
  for (int i = 0; i < 40; ++i)
    strips.push_back(i % 4 == 0 ? StripPair{2, 2 * 1.1 * 1.25, true} : StripPair{2 * 1.25, 2 * 1.1, false});
  EXPECT_NEAR(ratio_of(strips), 1.1, 1e-9);
  EXPECT_NEAR(estimate_ratio(strips).error, 0, 1e-9);
}

TEST(RatioEstimate, AChangeOfPartOfThePictureStillShows) {
  std::mt19937_64 random(5);
  Strips strips = noisy(300, 1, 0.03, random);
  for (size_t i = 0; i < strips.size(); i += 5) strips[i].after *= 1.5, strips[i + 1].after_first = strips[i].after_first;
  const RatioEstimate estimate = estimate_ratio(strips);
  EXPECT_GT(estimate.log_ratio, 3 * estimate.error) << "a fifth of the strips";
  EXPECT_LT(estimate.log_ratio, std::log(1.1)) << "their mean ratio";
}

// Long strips tell more than short ones.
TEST(RatioEstimate, StripsCountByWhatTheyLast) {
  std::mt19937_64 random(6);
  Strips strips = noisy(100, 1, 0.05, random);
  const Strips slower = noisy(100, 1.04, 0.05, random);
  strips.insert(strips.end(), slower.begin(), slower.end());
  const double equal = estimate_ratio(strips).log_ratio;
  for (size_t i = 100; i < 200; ++i) strips[i].before *= 20, strips[i].after *= 20;
  EXPECT_GT(estimate_ratio(strips).log_ratio, equal + 0.01);
}

// Over many samples the estimate scatters by its own error: for normal noise, and for Student's with three degrees of freedom.
TEST(RatioEstimate, ItsErrorIsWhatItScattersBy) {
  std::mt19937_64 random(7);
  std::student_t_distribution<double> tails(3);
  for (const bool with_tails : {false, true})
    for (const size_t count : {30u, 120u}) {
      double square = 0;
      constexpr int trials = 1500;
      for (int trial = 0; trial < trials; ++trial) {
        Strips strips = noisy(count, 1, with_tails ? 0 : 0.05, random);
        if (with_tails)
          for (StripPair& strip : strips) strip.after *= std::exp(0.05 * tails(random));
        const RatioEstimate estimate = estimate_ratio(strips);
        square += std::pow(estimate.log_ratio / estimate.error, 2);
      }
      EXPECT_NEAR(std::sqrt(square / trials), 1, 0.2) << count << (with_tails ? " with tails" : "");
    }
}

TEST(RatioEstimate, WhatIsNoMeasurementIsRefused) {
  EXPECT_THROW(estimate_ratio(Strips{}), Error);
  EXPECT_THROW(estimate_ratio(Strips{{1, 1}, {1, 1}}), Error) << "two are too few to estimate their spread";
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, std::nan(""), infinity}) {
    EXPECT_THROW(estimate_ratio(Strips{{1, 1}, {1, bad}, {1, 1}}), Error) << bad;
    EXPECT_THROW(estimate_ratio(Strips{{1, 1}, {bad, 1}, {1, 1}}), Error) << bad;
  }
}

// Two heaps with nothing between them: an error, and not a small one.
TEST(RatioEstimate, TwoHeapsAreUncertain) {
  Strips strips;
  for (int i = 0; i < 20; ++i) strips.push_back({1, i < 10 ? 0.9 : 1 / 0.9, false});
  EXPECT_GT(estimate_ratio(strips).error, 0.02);
}

}  // namespace
}  // namespace lamina
