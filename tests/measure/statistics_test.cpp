// SPDX-License-Identifier: Apache-2.0
#include "harness/measure/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>

#include "harness/core/error.h"

namespace lamina {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

std::string refusal(const auto& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::failed);
    return error.message();
  }
  return "";
}

std::vector<double> one_to(size_t n) {
  std::vector<double> samples(n);
  std::iota(samples.begin(), samples.end(), 1.0);
  return samples;
}

// Coverage of x(k), x(n+1-k) by counting: of 2^n equally likely ways to fall below or above the median, those with k .. n-k
// below.
double counted_coverage(size_t n, size_t k) {
  uint64_t ways = 0, choose = 1;  // exact: n <= 40
  for (size_t below = 0; below <= n; ++below) {
    if (below >= k && below <= n - k) ways += choose;
    choose = choose * (n - below) / (below + 1);
  }
  return std::ldexp(static_cast<double>(ways), -static_cast<int>(n));
}

// Few samples: the whole range, with what it covers by definition, 1 - 2 / 2^n; enough of them: as narrow as asked for.
TEST(WidestInterval, SaysWhatFewSamplesCover) {
  const Interval one = widest_interval(std::vector<double>{3}, 0.99);
  EXPECT_EQ(one.low, 3);
  EXPECT_EQ(one.high, 3);
  EXPECT_EQ(one.coverage, 0);
  for (size_t n = 2; n <= 7; ++n) {
    const Interval all = widest_interval(one_to(n), 0.999);
    EXPECT_EQ(all.low, one_to(n).front()) << n;
    EXPECT_EQ(all.high, one_to(n).back()) << n;
    EXPECT_NEAR(all.coverage, 1 - std::ldexp(2.0, -static_cast<int>(n)), 1e-12) << n;
  }
  const Interval many = widest_interval(one_to(40), 0.95), same = median_interval(one_to(40), 0.95);
  EXPECT_EQ(many.low, same.low);
  EXPECT_EQ(many.high, same.high);
  EXPECT_THROW(widest_interval(std::vector<double>{}, 0.9), Error);
  EXPECT_THROW(widest_interval(one_to(9), 1), Error);
}

TEST(Median, HasKnownAnswers) {
  EXPECT_EQ(median(std::vector{7.0}), 7);
  EXPECT_EQ(median(std::vector{9.0, 1.0, 5.0}), 5);
  EXPECT_EQ(median(std::vector{4.0, 1.0, 100.0, 2.0}), 3);
  EXPECT_EQ(median(std::vector{2.0, 2.0}), 2);
  EXPECT_EQ(median(std::vector{-3.0, -1.0}), -2);
}

TEST(Median, LeavesTheSamplesInTheirOrder) {
  const std::vector<double> samples = {3, 1, 2};
  median(samples);
  EXPECT_EQ(samples, (std::vector<double>{3, 1, 2}));
}

TEST(Median, RefusesNoSamplesAndWhatIsNotFinite) {
  EXPECT_NE(refusal([] { median({}); }).find("no samples"), std::string::npos);
  for (const double bad : {nan, inf, -inf})
    EXPECT_NE(refusal([&] { median(std::vector{1.0, bad, 2.0}); }).find("sample 1"), std::string::npos) << bad;
}

TEST(MedianInterval, IsTheNarrowestPairWhoseBinomialCoverageIsEnough) {
  for (const double confidence : {0.5, 0.9, 0.95})
    for (size_t n = min_rounds_for_95; n <= 40; ++n) {
      const Interval interval = median_interval(one_to(n), confidence);
      const size_t k = static_cast<size_t>(interval.low);  // samples are their own ranks
      EXPECT_EQ(interval.high, static_cast<double>(n + 1 - k)) << n;
      EXPECT_EQ(interval.median, static_cast<double>(n + 1) / 2) << n;
      EXPECT_EQ(interval.rounds, n);
      EXPECT_NEAR(interval.coverage, counted_coverage(n, k), 1e-14) << n;
      EXPECT_GE(interval.coverage, confidence) << n;
      if (k + 1 > n - k) continue;
      EXPECT_LT(counted_coverage(n, k + 1), confidence) << n;  // one rank narrower would not do
    }
}

TEST(MedianInterval, HasThePublishedRanks) {
  // From tables of the sign test at 95%: n = 6 takes the extremes, 10 the ranks 2 and 9, 20 the ranks 6 and 15.
  const auto ranks = [](size_t n) { return std::pair{median_interval(one_to(n)).low, median_interval(one_to(n)).high}; };
  EXPECT_EQ(ranks(6), (std::pair{1.0, 6.0}));
  EXPECT_EQ(ranks(10), (std::pair{2.0, 9.0}));
  EXPECT_EQ(ranks(20), (std::pair{6.0, 15.0}));
  EXPECT_DOUBLE_EQ(median_interval(one_to(6)).coverage, 0.96875);
}

TEST(MedianInterval, ApproachesTheNormalLimitForManySamples) {
  // Ranks n/2 -+ 1.95996 sqrt(n)/2, also where 2^-n is no longer a double.
  for (const size_t n : {1001, 2000, 100000}) {
    const Interval interval = median_interval(one_to(n));
    EXPECT_NEAR(interval.low, (static_cast<double>(n) - 1.95996 * std::sqrt(n)) / 2, 1.5) << n;
    EXPECT_NEAR(interval.coverage, 0.95, 0.005) << n;
  }
}

TEST(MedianInterval, RefusesTooFewSamples) {
  const std::string message = refusal([] { median_interval(one_to(min_rounds_for_95 - 1)); });
  EXPECT_NE(message.find("5 samples give at most 0.9375 confidence"), std::string::npos) << message;
  EXPECT_EQ(refusal([] { median_interval(one_to(min_rounds_for_95)); }), "");
  EXPECT_NE(refusal([] { median_interval(one_to(6), 0.97); }), "");
  EXPECT_NE(refusal([] { median_interval({}); }), "");
  for (const double confidence : {0.0, 1.0, -1.0, nan})
    EXPECT_NE(refusal([&] { median_interval(one_to(9), confidence); }).find("not between 0 and 1"), std::string::npos);
}

TEST(MedianInterval, CoversTheTrueMedianOfASkewedDistribution) {
  // Exponential, median ln 2. True coverages are 0.969, 0.965 and 0.957; of 4000 draws 94% is at least five deviations below.
  std::mt19937_64 random(20030);
  for (const size_t n : {6, 15, 31}) {
    int covered = 0;
    for (int draw = 0; draw < 4000; ++draw) {
      std::vector<double> samples(n);
      for (double& sample : samples) sample = -std::log(std::ldexp(static_cast<double>(random() >> 11) + 0.5, -53));
      const Interval interval = median_interval(samples);
      covered += interval.low <= std::log(2.0) && std::log(2.0) <= interval.high;
    }
    EXPECT_GE(covered, 4000 * 0.94) << n;
    EXPECT_NEAR(covered / 4000.0, median_interval(one_to(n)).coverage, 0.014) << n;  // at most five deviations
  }
}

TEST(RatioInterval, PairsByRound) {
  // Rounds drift tenfold while the ratio stays 2: unpaired ratios would spread from 0.2 to 20.
  std::vector<double> a, b;
  for (int round = 0; round < 8; ++round) b.push_back(1 + 9 * round / 7.0), a.push_back(2 * b.back());
  const Interval interval = ratio_interval(a, b);
  EXPECT_EQ(interval.median, 2);
  EXPECT_EQ(interval.low, 2);
  EXPECT_EQ(interval.high, 2);
  EXPECT_EQ(interval.rounds, 8);
}

TEST(RatioInterval, DividesTheFirstByTheSecond) {
  const std::vector<double> a = {1, 2, 3, 4, 5, 6}, b = {2, 2, 2, 2, 2, 2};
  const Interval interval = ratio_interval(a, b);
  EXPECT_EQ(interval.low, 0.5);
  EXPECT_EQ(interval.median, 1.75);
  EXPECT_EQ(interval.high, 3);
}

TEST(RatioInterval, RefusesUnpairedSamplesAndDivisorsThatAreNotPositive) {
  EXPECT_NE(refusal([] { ratio_interval(one_to(7), one_to(6)); }).find("7 samples over 6"), std::string::npos);
  for (const double bad : {0.0, -1.0, nan}) {
    std::vector<double> b = one_to(6);
    b[3] = bad;
    EXPECT_NE(refusal([&] { ratio_interval(one_to(6), b); }).find("round 3"), std::string::npos) << bad;
  }
  EXPECT_NE(refusal([] { ratio_interval(one_to(5), one_to(5)); }).find("5 samples"), std::string::npos);
  EXPECT_NE(refusal([] { ratio_interval(std::vector<double>(6, 1e300), std::vector<double>(6, 1e-300)); }), "");
}

}  // namespace
}  // namespace lamina
