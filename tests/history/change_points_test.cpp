// SPDX-License-Identifier: Apache-2.0
// Where levels change: closed forms, and the false-alarm rate that the header states.
#include "harness/history/change_points.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "harness/core/error.h"

namespace lamina {
namespace {

using Steps = std::vector<size_t>;

std::vector<double> noise(size_t count, uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> samples(count);
  for (double& sample : samples) sample = normal(random);
  return samples;
}
std::vector<double> with_step(std::vector<double> samples, size_t at, double height) {
  for (size_t i = at; i < samples.size(); ++i) samples[i] += height;
  return samples;
}

TEST(NoisySteps, NoneInWhatIsConstant) {
  for (const double level : {0.0, 1.0, -3.5, 1e9}) EXPECT_EQ(noisy_steps(std::vector<double>(30, level), 0), Steps());
}

TEST(NoisySteps, OneWithoutNoiseIsAtItsIndex) {
  for (const size_t at : {3, 10, 17}) EXPECT_EQ(noisy_steps(with_step(std::vector<double>(20, 1.0), at, 0.1), 0), Steps({at}));
}

TEST(NoisySteps, OneOfTenDeviationsIsAtItsIndexWhateverTheSignAndScale) {
  for (uint64_t seed = 0; seed < 20; ++seed)
    for (const double scale : {1e-6, 1.0, 1e6}) {
      std::vector<double> samples = with_step(noise(24, seed), 11, seed % 2 ? 10 : -10);
      for (double& sample : samples) sample = 1000 * scale + scale * sample;
      EXPECT_EQ(noisy_steps(samples, 0), Steps({11})) << "seed " << seed << ", scale " << scale;
    }
}

TEST(NoisySteps, TwoAreBothFound) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    EXPECT_EQ(noisy_steps(with_step(with_step(noise(36, seed), 12, 10), 24, 10), 0), Steps({12, 24})) << seed;  // stairs
    EXPECT_EQ(noisy_steps(with_step(with_step(noise(36, seed), 12, 10), 24, -10), 0), Steps({12, 24}))
        << seed;  // there and back
  }
}

TEST(NoisySteps, AnOutlierAloneIsNone) {
  for (const double height : {5.0, 20.0, -1000.0})
    for (const size_t at : {0, 7, 15, 29}) {
      std::vector<double> samples = noise(30, 3);
      ASSERT_EQ(noisy_steps(samples, 0), Steps());
      samples[at] += height;
      EXPECT_EQ(noisy_steps(samples, 0), Steps()) << height << " at " << at;
    }
}

TEST(NoisySteps, AnOutlierHidesNoStep) {
  std::vector<double> samples = with_step(noise(30, 5), 15, 10);
  samples[6] += 500;
  EXPECT_EQ(noisy_steps(samples, 0), Steps({15}));
}

TEST(NoisySteps, TheLeastDeviationHidesWhatIsSmaller) {
  const std::vector<double> samples = with_step(std::vector<double>(20, 1.0), 10, 0.01);
  EXPECT_EQ(noisy_steps(samples, 0.001), Steps({10}));
  EXPECT_EQ(noisy_steps(samples, 0.01), Steps());
}

TEST(NoisySteps, TooFewSamplesShowNone) {
  EXPECT_EQ(noisy_steps({}, 0), Steps());
  EXPECT_EQ(noisy_steps(with_step(std::vector<double>(min_samples_for_steps - 1, 0.0), 4, 100), 0), Steps());
  EXPECT_EQ(noisy_steps(with_step(std::vector<double>(min_samples_for_steps, 0.0), 4, 100), 0), Steps({4}));
}

TEST(NoisySteps, ShortestLevelsAreAsTheHeaderSays) {
  const auto found = [](size_t count, size_t last) {
    return !noisy_steps(with_step(std::vector<double>(count, 1.0), count - last, 50), 1).empty();
  };
  EXPECT_FALSE(found(12, 1));
  EXPECT_TRUE(found(12, 2));
  EXPECT_FALSE(found(13, 2));
  EXPECT_TRUE(found(115, 3));
  EXPECT_FALSE(found(116, 3));
}

TEST(NoisySteps, PureNoiseRaisesFewFalseAlarms) {
  for (const size_t count : {8, 10, 15, 20, 50}) {
    constexpr int series = 1000;
    int alarms = 0;
    for (int i = 0; i < series; ++i) alarms += !noisy_steps(noise(count, count * series + i), 0).empty();
    EXPECT_LE(alarms, series / 50) << count << " samples";
  }
}

TEST(NoisySteps, RefusesWhatIsNotFinite) {
  std::vector<double> samples(10, 1.0);
  samples[4] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(noisy_steps(samples, 0), Error);
  samples[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(noisy_steps(samples, 0), Error);
  EXPECT_THROW(exact_steps(samples, 0), Error);
}

TEST(ExactSteps, EveryChangeIsOneAtOnce) {
  EXPECT_EQ(exact_steps({}, 0), Steps());
  EXPECT_EQ(exact_steps(std::vector<double>{5, 5, 5}, 0), Steps());
  EXPECT_EQ(exact_steps(std::vector<double>{5, 6}, 0), Steps({1}));
  EXPECT_EQ(exact_steps(std::vector<double>{5, 6, 5, 5}, 0), Steps({1, 2}));
}

TEST(ExactSteps, AToleranceIsFromTheLevelsStartSoThatDriftIsFound) {
  EXPECT_EQ(exact_steps(std::vector<double>{1, 1.5, 1, 0.5}, 0.5), Steps());
  EXPECT_EQ(exact_steps(std::vector<double>{1, 1.25, 1.5, 1.75, 2}, 0.5), Steps({3}));
}

TEST(ExactSteps, IdenticalPicturesAreALevelOfTheirOwn) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(exact_steps(std::vector<double>{inf, inf, 40, 40, inf}, 0.05), Steps({2, 4}));
}

}  // namespace
}  // namespace lamina
