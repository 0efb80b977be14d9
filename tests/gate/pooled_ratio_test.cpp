// SPDX-License-Identifier: Apache-2.0
// Ratios of several processes whose answers follow from the definitions, and what comparisons tell each other, on noise whose
// distribution is known.
#include "harness/gate/pooled_ratio.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "harness/core/error.h"

namespace lamina {
namespace {

using Processes = std::vector<RatioEstimate>;

TEST(Pool, ProcessesAreWeightedByTheirErrorsAndNoneMoreThanTheMiddleOne) {
  const PooledRatio equal = pool(Processes{{0.02, 0.01, 50}, {0.02, 0.01, 60}});
  EXPECT_NEAR(equal.log_ratio, 0.02, 1e-12);
  EXPECT_NEAR(equal.within, 0.01 * 0.01 / 2, 1e-15);
  EXPECT_EQ(equal.strips, 110u);
  const PooledRatio noisy = pool(Processes{{0, 0.01, 9}, {0, 0.01, 9}, {0.09, 0.02, 9}});
  EXPECT_NEAR(noisy.log_ratio, 0.09 / 9, 1e-12) << "weights 4, 4 and 1";
  const PooledRatio lucky = pool(Processes{{0.3, 1e-6, 4}, {0, 0.01, 9}, {0, 0.01, 9}});
  EXPECT_NEAR(lucky.log_ratio, 0.1, 1e-12) << "weights 1, 1 and 1";
}

// Three of equal weight at -1, 0 and 1: the variance of their mean is 1 / 3, by two degrees of freedom.
TEST(Pool, TheirScatterIsThatOfTheMean) {
  const PooledRatio pooled = pool(Processes{{-1, 0.1, 9, 7}, {0, 0.1, 9, 7}, {1, 0.1, 9, 7}});
  EXPECT_NEAR(pooled.disagreement * pooled.within, 1.0 / 3, 1e-12);
  EXPECT_NEAR(pooled.disagreement_freedom, 2, 1e-12);
  EXPECT_NEAR(pooled.within_freedom, 21, 1e-12);
  EXPECT_EQ(pool(Processes{{0.5, 0.1, 9, 7}}).disagreement_freedom, 0) << "one process says nothing of it";
  EXPECT_GT(settle(pool(Processes{{0, 0, 10}, {0.1, 0, 10}})).error, 0.04) << "times without noise too";
}

// Four degrees of freedom that say 3, and twelve that say 2: 2.25 by sixteen.
TEST(Settle, OthersModerateTheDisagreement) {
  const PooledRatio pooled{0.02, 100, 1e-4, 90, 3, 4};
  const RatioEstimate ratio = settle(pooled, {2, 12});
  EXPECT_EQ(ratio.log_ratio, 0.02);
  EXPECT_NEAR(ratio.error, std::sqrt(2.25e-4), 1e-12);
  // Of the variance of 2.25, 1.5 is the others', which is taken times what 90 degrees of freedom tell.
  EXPECT_NEAR(ratio.freedom, 1 / (1.0 / 16 + 1.5 * 1.5 / (2.25 * 2.25 * 90)), 1e-9);
  EXPECT_NEAR(settle({0.02, 100, 1e-4, 1e9, 3, 4}, {2, 12}).freedom, 16, 1e-6) << "well measured: all degrees of freedom";
  EXPECT_LT(settle({0.02, 6, 1e-4, 2, 3, 4}, {2, 12}).freedom, 4) << "few strips";
  EXPECT_NEAR(settle(pooled).error, std::sqrt(3e-4), 1e-12) << "alone";
  EXPECT_NEAR(settle(pooled).freedom, 4, 1e-9) << "alone";
  const RatioEstimate agreeing = settle({0.02, 100, 1e-4, 90, 0.1, 4});
  EXPECT_NEAR(agreeing.error, 0.01, 1e-12) << "never less than its own strips allow";
  EXPECT_NEAR(agreeing.freedom, 1 / (1.0 / 4 + 0.9 * 0.9 / 90), 1e-9) << "nor believed the more for agreeing";
  const RatioEstimate one = settle(pool(Processes{{0.5, 0.1, 9, 7}}));
  EXPECT_NEAR(one.error, 0.1, 1e-12);
  EXPECT_NEAR(one.freedom, 7, 1e-9) << "one process has its own";
}

// Disagreements of `count` comparisons drawn from the model: each true one is `typical` times prior / chi2(prior), each
// measured one that times chi2(4) / 4. A prior of 0: all true ones are equal.
std::vector<PooledRatio> drawn(size_t count, double typical, double prior, std::mt19937_64& random) {
  std::chi_squared_distribution<double> of_processes(4), of_comparisons(prior > 0 ? prior : 1);
  std::vector<PooledRatio> all;
  for (size_t i = 0; i < count; ++i) {
    const double here = prior > 0 ? typical * prior / of_comparisons(random) : typical;
    all.push_back({0, 100, 1e-4, 90, here * of_processes(random) / 4, 4});
  }
  return all;
}

TEST(SharedDisagreement, IsFoundAgainInManyComparisons) {
  std::mt19937_64 random(11);
  for (const double prior : {3.0, 8.0, 20.0}) {
    const SharedDisagreement shared = shared_disagreement(drawn(20000, 2.5, prior, random));
    EXPECT_NEAR(shared.typical, 2.5, 0.15) << prior;
    EXPECT_NEAR(shared.freedom / prior, 1, 0.15) << prior;
  }
}

TEST(SharedDisagreement, EqualOnesAreWorthMoreTheMoreThereAre) {
  std::mt19937_64 random(12);
  std::vector<double> worth;
  for (const size_t count : {3u, 10u, 100u, 3000u}) {
    double sum = 0;
    for (int trial = 0; trial < 200; ++trial) {
      const SharedDisagreement shared = shared_disagreement(drawn(count, 1, 0, random));
      EXPECT_LE(shared.freedom, 4 * static_cast<double>(count - 1) + 1e-9);
      sum += shared.freedom / 200;
    }
    if (!worth.empty()) {
      EXPECT_GT(sum, 1.5 * worth.back()) << count;
    }
    worth.push_back(sum);
  }
  EXPECT_GT(worth[1], 4) << "ten comparisons more than double what one knows by itself";
  const SharedDisagreement wild =
      shared_disagreement(std::vector<PooledRatio>{{0, 9, 1e-4, 9, 1e-3, 4}, {0, 9, 1e-4, 9, 1, 4}, {0, 9, 1e-4, 9, 1e3, 4}});
  EXPECT_LT(wild.freedom, 1) << "comparisons that differ by factors of a thousand tell each other nothing";
}

TEST(SharedDisagreement, OneComparisonOrOneProcessTellsNothing) {
  std::mt19937_64 random(13);
  EXPECT_EQ(shared_disagreement({}).freedom, 0);
  EXPECT_EQ(shared_disagreement(drawn(1, 2, 0, random)).freedom, 0);
  std::vector<PooledRatio> alone = drawn(5, 2, 0, random);
  for (PooledRatio& each : alone) each.disagreement_freedom = 0;
  EXPECT_EQ(shared_disagreement(alone).freedom, 0);
  std::vector<PooledRatio> exact = drawn(5, 2, 0, random);
  for (PooledRatio& each : exact) each.disagreement = 0;
  EXPECT_TRUE(std::isfinite(shared_disagreement(exact).typical)) << "processes that agree to the bit";
}

// Over many gates a settled ratio lies beyond its own interval as often as it should, whether comparisons disagree alike or
// not; and it lies beyond fewer intervals of one width than without the others, or they would be of no use.
TEST(SharedDisagreement, IntervalsStayTrueWhenComparisonsBorrow) {
  std::mt19937_64 random(14);
  std::normal_distribution<double> normal;
  for (const double spread : {0.0, 0.7}) {  // of the logarithm of each comparison's own scatter
    for (const double chance : {0.05, 0.005}) {
      int beyond = 0, count = 0;
      double reach = 0, reach_alone = 0;
      for (int gate = 0; gate < 1500; ++gate) {
        std::vector<PooledRatio> pooled;
        for (int i = 0; i < 12; ++i) {
          const double scatter = 0.01 * std::exp(spread * normal(random));
          Processes processes;
          for (int process = 0; process < 5; ++process) processes.push_back({scatter * normal(random), 0.004, 60, 58});
          pooled.push_back(pool(processes));
        }
        const SharedDisagreement shared = shared_disagreement(pooled);
        const auto reach_of = [&](const RatioEstimate& ratio) {
          return ratio.error * boost::math::quantile(boost::math::students_t(ratio.freedom), 1 - chance / 2);
        };
        for (const PooledRatio& each : pooled) {
          const double here = reach_of(settle(each, shared));
          beyond += std::abs(each.log_ratio) > here, ++count;
          reach += here, reach_alone += reach_of(settle(each));
        }
      }
      EXPECT_LE(beyond, 1.3 * chance * count) << spread << ", " << chance;
      EXPECT_GE(beyond, 0.5 * chance * count) << spread << ", " << chance;
      EXPECT_LT(reach, 0.85 * reach_alone) << spread << ", " << chance;
    }
  }
}

TEST(Pool, NothingAndWhatIsNotFiniteAreRefused) {
  EXPECT_THROW(pool(Processes{}), Error);
  EXPECT_THROW(pool(Processes{{0, 0.1, 9}, {std::nan(""), 0.1, 9}}), Error);
  EXPECT_THROW(pool(Processes{{0, std::numeric_limits<double>::infinity(), 9}}), Error);
}

}  // namespace
}  // namespace lamina
