// SPDX-License-Identifier: Apache-2.0
// The families of functions that transparent surfaces are made of, on every backend, against their oracles of 200 bits.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/effects/caps.h"

namespace lamina {
namespace {

constexpr size_t layer_inputs = 400;

Family layer_family(const std::string& folder) { return load_family(shaders_folder() / folder / "family.toml", effect_code()); }

class TransparencyShaders : public ::testing::TestWithParam<std::string_view> {
 protected:
  void SetUp() override {
    try {
      backend_ = open_backend(GetParam());
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
  }
  FunctionErrors errors(const Family& family, const std::string& function, const std::string& set) {
    FunctionRunner runner(*backend_, shaders_folder(), family, function);
    const PointSet points{set, "", family.oracle->points(set, layer_inputs, 5)};
    return judge(points.points, runner.values(points.points), truth_of(*family.oracle, points));
  }
  std::vector<float> values(const Family& family, const std::string& function, const std::vector<std::vector<float>>& points) {
    Points asked(points.at(0).size());
    for (const std::vector<float>& point : points) asked.add(point);
    return FunctionRunner(*backend_, shaders_folder(), family, function).values(asked);
  }
  std::unique_ptr<Backend> backend_;
};

TEST_P(TransparencyShaders, EveryFunctionKeepsTheBoundsThatItClaims) {
  size_t claimed = 0;
  for (const char* folder : {"compositing", "moment_transmittance", "step_reconstruction"}) {
    const Family family = layer_family(folder);
    for (const FamilyFunction& function : family.functions)
      for (const FamilySet& set : family.sets) {
        const FamilyClaim* bounds = function.claim(set.name);
        if (!bounds) continue;
        SCOPED_TRACE(function.name + " " + set.name);
        ++claimed;
        const FunctionErrors found = errors(family, function.name, set.name);
        EXPECT_LE(found.max_over, bounds->over);
        EXPECT_GE(found.max_under, bounds->under);
        EXPECT_EQ(found.nonfinite, 0u);
      }
  }
  EXPECT_GT(claimed, 10u);
}

// Missing pixels beside a step: a quarter for the mean of four, nothing for pairs, whatever the phase.
TEST_P(TransparencyShaders, StepsAreReconstructedAsWorkedOutByHand) {
  const Family family = layer_family("step_reconstruction");
  std::vector<std::vector<float>> upright;
  for (const float phase : {0.0f, 0.125f, 0.25f, 0.5f, 0.75f})
    for (int pixel = -2; pixel <= 2; ++pixel) upright.push_back({0, float(pixel) + 0.5f + phase});
  const std::vector<float> exact = values(family, "full_rate", upright);
  const auto worst = [&](const std::string& function, size_t phase) {
    const std::vector<float> found = values(family, function, upright);
    float most = 0;
    for (size_t i = 5 * phase; i < 5 * phase + 5; ++i) most = std::max(most, std::abs(found[i] - exact[i]));
    return most;
  };
  const float of_mean[] = {0.25f, 0.21875f, 0.1875f, 0.125f, 0.1875f};
  for (size_t phase = 0; phase < 5; ++phase) {
    EXPECT_NEAR(worst("mean_of_four_ends", phase), of_mean[phase], 1e-5) << phase;
    EXPECT_EQ(worst("directed_pair", phase), 0) << phase;
  }
  std::vector<std::vector<float>> diagonal;
  for (int i = -6; i <= 6; ++i) diagonal.push_back({1, 0.5f * float(i)});
  const std::vector<float> share = values(family, "full_rate", diagonal), mean = values(family, "mean_of_four_ends", diagonal);
  float most = 0;
  for (size_t i = 0; i < diagonal.size(); ++i) most = std::max(most, std::abs(mean[i] - share[i]));
  EXPECT_NEAR(most, 0.3125f, 1e-5) << "box-filtered, phases of half a pixel";
}

// Four moments of two layers say all of them; with one layer the system has rank 1, and only a bias keeps it solvable.
TEST_P(TransparencyShaders, TheMomentSystemNeedsItsBias) {
  const Family family = layer_family("moment_transmittance");
  const FunctionErrors safe = errors(family, "bias_5e_5", "one"), none = errors(family, "unbiased_moments", "one");
  EXPECT_EQ(safe.nonfinite, 0u);
  EXPECT_LT(safe.max_over - safe.max_under, 0.005);
  EXPECT_GT(none.max_over - none.max_under, 0.2);
}

// An opaque layer in front: sorting shows nothing behind it, weights do.
TEST_P(TransparencyShaders, WeightsLeakBehindAnOpaqueLayer) {
  const Family family = layer_family("compositing");
  EXPECT_LT(errors(family, "four_moments", "opaque_front").max_over, 0.02);
  for (const char* name : {"weighted_7", "weighted_9", "weighted_average"}) {
    const FunctionErrors found = errors(family, name, "opaque_front");
    EXPECT_GT(std::max(found.max_over, -found.max_under), 0.1) << name;
  }
  // The much-copied weight is a plain average, to the last digits.
  const FunctionErrors copied = errors(family, "weighted_saturated", "everyday"),
                       average = errors(family, "weighted_average", "everyday");
  EXPECT_NEAR(copied.max_over, average.max_over, 1e-5);
  EXPECT_NEAR(copied.max_under, average.max_under, 1e-5);
  // Scaled sums in halves err by little more than sums in floats.
  for (const std::string equation : {"weighted_7", "weighted_8", "weighted_9", "weighted_10"}) {
    const FunctionErrors whole = errors(family, equation, "everyday"), half = errors(family, "half_" + equation, "everyday");
    EXPECT_LT(half.max_over, whole.max_over + 0.004) << equation;
    EXPECT_GT(half.max_under, whole.max_under - 0.004) << equation;
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, TransparencyShaders,
                         testing::ValuesIn(std::vector<std::string_view>(backend_names().begin(), backend_names().end())),
                         [](const auto& test) { return std::string(test.param); });

TEST(TransparencyOracles, GiveTheFiguresThatAreKnown) {
  const Family layers = layer_family("compositing"), moments = layer_family("moment_transmittance"),
               steps = layer_family("step_reconstruction");
  const std::vector<double> three = {0.5, 0, 1, 2, 2};
  EXPECT_NEAR(layers.oracle->value(three), 0.5 + 0.25 * 0 + 0.125, 1e-15);
  const std::vector<double> falling = {1, -0.5, 0.25, 2, 2};
  EXPECT_NEAR(layers.oracle->value(falling), 0.25, 1e-15) << "nothing shows behind an opaque layer";
  const std::vector<double> between = {-0.5, 0.5, 0.25, 2, 0}, behind = {-0.5, 0.5, 0.25, 2, 0.9};
  EXPECT_NEAR(moments.oracle->value(between), std::exp(-0.5), 1e-15);
  EXPECT_NEAR(moments.oracle->value(behind), std::exp(-2.0), 1e-15);
  for (const auto& [slope, offset, share] :
       {std::tuple(0.0, 0.25, 0.75), {1.0, 0.0, 0.5}, {1.0, 1.0, 1.0}, {1.0, 0.5, 0.875}}) {
    const std::vector<double> point = {slope, offset};
    EXPECT_NEAR(steps.oracle->value(point), share, 1e-15) << slope << " " << offset;
  }
}

}  // namespace
}  // namespace lamina
