// SPDX-License-Identifier: Apache-2.0
// The families of functions that transparent surfaces are made of, on every backend, against their oracles of 200 bits.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/effects/family_shaders.h"

namespace lamina {
namespace {

constexpr size_t layer_inputs = 400;

constexpr const char* layer_folders[] = {"compositing", "moment_transmittance", "step_reconstruction"};

class TransparencyShaders : public FamilyShaders {
 protected:
  TransparencyShaders() : FamilyShaders(layer_inputs) {}
};

TEST_P(TransparencyShaders, EveryFunctionKeepsTheBoundsThatItClaims) { EXPECT_GT(judge_claims(layer_folders).size(), 10u); }

// Missing pixels beside a step: a quarter for the mean of four, nothing for pairs, whatever the phase.
TEST_P(TransparencyShaders, StepsAreReconstructedAsWorkedOutByHand) {
  const Family family = family_in("step_reconstruction");
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
  const Family family = family_in("moment_transmittance");
  const FunctionErrors safe = errors(family, "bias_5e_5", "one"), none = errors(family, "unbiased_moments", "one");
  EXPECT_EQ(safe.nonfinite, 0u);
  EXPECT_LT(safe.max_over - safe.max_under, 0.005);
  EXPECT_GT(none.max_over - none.max_under, 0.2);
}

// Chebyshev, Markov and Stieltjes: of all layers with these moments at most a share rho lies at z, 1 / rho = (1, z, z^2) B^-1
// (1, z, z^2)^T for the Hankel matrix B, and what is before z is known to within rho. rho is the least mean of a squared
// parabola that is 1 at z. For two layers (x - z0)(x - z1) has none but what the bias b mixes in, an even distribution with the
// moments 0, 3/8, 0, 3/8. So rho <= b (3/8 (1 + s^2 + 2 p) + p^2) / ((z - z0)(z - z1))^2 with s = z0 + z1, p = z0 z1. A quarter
// of it counts as before z, and the bias itself moves a share of b.
TEST_P(TransparencyShaders, TheBiasBoundsWhatFourMomentsErrBy) {
  const Family family = family_in("moment_transmittance");
  for (const auto& [function, bias] : {std::pair("bias_5e_5", 5e-5), {"bias_5e_4", 5e-4}, {"bias_5e_3", 5e-3}})
    for (const char* set : {"apart", "near_one", "faint"}) {
      const Points points = family.oracle->points(set, layer_inputs, 5);
      const std::vector<float> found = FunctionRunner(*backend_, shaders_folder(), family, function).values(points);
      size_t over = 0, under = 0;
      double most = 0;
      for (size_t i = 0; i < points.size(); ++i) {
        const auto at = [&](size_t input) { return double(points[i][input]); };
        const double z0 = at(0), z1 = at(1), total = at(3), z = at(4), sum = z0 + z1, product = z0 * z1,
                     parabola = (z - z0) * (z - z1), even = 0.375 * (1 + sum * sum + 2 * product) + product * product;
        const double rho = bias * even / (parabola * parabola), before = (z0 < z ? at(2) : 0) + (z1 < z ? 1 - at(2) : 0);
        const double right = std::exp(-total * before), error = double(found[i]) - right;
        // The system's last pivot is about the bias, of numbers of about 1 in binary32.
        const double rounded = 1e-6 + 1e-7 / bias * std::min(rho, 1.0) * total;
        over += error > right * std::expm1(total * (0.75 * rho + bias)) + rounded;
        under += error < right * std::expm1(-total * (0.25 * rho + bias)) - rounded;
        most = std::max(most, std::abs(error));
      }
      EXPECT_EQ(over, 0u) << function << " " << set;
      EXPECT_EQ(under, 0u) << function << " " << set;
      EXPECT_GT(most, set == std::string("faint") ? 1e-6 : 1e-3) << "what there is to bound";
    }
  // The corner of "apart" that errs most.
  EXPECT_NEAR(values(family, "bias_5e_5", {{-0.95f, -0.45f, 0.1f, 4, -0.85f}})[0] - std::exp(-0.4f), 0.0664f, 0.003f);
}

// An opaque layer in front: sorting shows nothing behind it, weights do.
TEST_P(TransparencyShaders, WeightsLeakBehindAnOpaqueLayer) {
  const Family family = family_in("compositing");
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

INSTANTIATE_TEST_SUITE_P(Backends, TransparencyShaders, api_parameters, backend_test_name);

TEST(TransparencyOracles, GiveTheFiguresThatAreKnown) {
  const Family layers = family_in("compositing"), moments = family_in("moment_transmittance"),
               steps = family_in("step_reconstruction");
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
