// SPDX-License-Identifier: Apache-2.0
// The families of functions that scattering is made of, on every backend, against their oracles of 200 bits.
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/effects/family_shaders.h"

namespace lamina {
namespace {

constexpr size_t scattering_inputs = 500;
const char* const scattering_folders[] = {"henyey_greenstein",  "cornette_shanks", "rayleigh",       "transmittance",
                                          "mean_transmittance", "slab_in_scatter", "fresnel",        "refraction",
                                          "wrap_lighting",      "back_light",      "thickness_ramp", "depth_bias"};

double oracle_value(const Family& family, std::vector<double> point) { return family.oracle->value(point); }

class ScatteringShaders : public FamilyShaders {
 protected:
  ScatteringShaders() : FamilyShaders(scattering_inputs) {}
};

TEST_P(ScatteringShaders, EveryFunctionKeepsTheBoundsThatItClaims) { EXPECT_GT(judge_claims(scattering_folders).size(), 100u); }

TEST_P(ScatteringShaders, NaiveFormsFailWhereStableOnesDoNot) {
  const Family hg = family_in("henyey_greenstein"), mean = family_in("mean_transmittance"), slab = family_in("slab_in_scatter"),
               fresnel = family_in("fresnel");
  EXPECT_GT(errors(hg, "naive_hg", "forward").max_eps, 1e5);
  EXPECT_GT(errors(hg, "naive_hg", "peak").nonfinite, 0u);
  EXPECT_GT(errors(mean, "naive_mean", "thin").max_over - errors(mean, "naive_mean", "thin").max_under, 0.9);
  EXPECT_EQ(errors(mean, "naive_mean", "none").nonfinite, scattering_inputs);
  EXPECT_EQ(errors(slab, "naive_slab", "at_the_sun").nonfinite, scattering_inputs);
  EXPECT_GT(errors(slab, "naive_slab", "beside_the_sun").max_over, 0.1);
  EXPECT_GT(errors(fresnel, "textbook_fresnel", "inside").nonfinite, scattering_inputs / 10);
}

// Over all directions: 1 within 1e-6, whatever g. Nodes are even in the logarithm of the base's root, where the peak is flat.
TEST_P(ScatteringShaders, HenyeyAndGreensteinSumToOneOverAllDirections) {
  const Family hg = family_in("henyey_greenstein");
  using Rule = boost::math::quadrature::gauss<double, 60>;
  Points points(2);
  std::vector<double> weights;
  const std::vector<double> sizes = {0.01, 0.25, 0.5, 0.76, 0.8, 0.9, 0.95, 0.99};
  for (const double size : sizes)
    for (const double sign : {-1.0, 1.0}) {
      const auto g = static_cast<float>(sign * size);
      const double a = std::abs(double(g)), low = std::log(1 - a), high = std::log(1 + a);
      for (size_t i = 0; i < Rule::weights().size(); ++i)
        for (const double side : {-1, 1}) {
          const double root = std::exp((low + high) / 2 + side * Rule::abscissa()[i] * (high - low) / 2);
          const double cosine = sign * std::clamp((1 + a * a - root * root) / (2 * a), -1.0, 1.0);
          points.add({g, static_cast<float>(cosine)});
          // The shader is asked at a rounded cosine: what it errs there, it errs here.
          weights.push_back(2 * std::numbers::pi * root * root / a * Rule::weights()[i] * (high - low) / 2 *
                            oracle_value(hg, {g, cosine}) / oracle_value(hg, {g, points[points.size() - 1][1]}));
        }
    }
  FunctionRunner stable(*backend_, shaders_folder(), hg, "stable_hg"),
      misprinted(*backend_, shaders_folder(), hg, "misprinted_hg");
  const std::vector<float> right = stable.values(points), wrong = misprinted.values(points);
  const size_t nodes = 2 * Rule::weights().size();
  for (size_t first = 0; first < points.size(); first += nodes) {
    double sum = 0, wrong_sum = 0;
    for (size_t i = first; i < first + nodes; ++i) sum += weights[i] * right[i], wrong_sum += weights[i] * wrong[i];
    const double g = points[first][0];
    EXPECT_NEAR(sum, 1, 1e-6) << g;
    EXPECT_NEAR(wrong_sum, (1 - g) / (1 + g), 2e-6 * (1 - g) / (1 + g)) << g;
  }
}

TEST(ScatteringOracles, GiveTheFiguresThatAreKnown) {
  const auto near = [](double value, double figure) { EXPECT_NEAR(value, figure, 1e-5 * figure); };
  const Family hg = family_in("henyey_greenstein");
  for (const auto& [g, at_0, at_90, at_180] : {std::tuple{.5, .477465, .0427058, .0176839},
                                               {.8, 3.58099, .0136404, .00491219},
                                               {.99, 1583.59, .000568346, .000200948}}) {
    near(oracle_value(hg, {g, 1}), at_0);
    near(oracle_value(hg, {g, 0}), at_90);
    near(oracle_value(hg, {g, -1}), at_180);
  }
  near(oracle_value(family_in("rayleigh"), {0}), .0596831);
  const Family slab = family_in("slab_in_scatter");
  for (const auto& [view, sun, light] : {std::tuple{1., 1., .136343006},
                                         {1., .2, .100703706},
                                         {.5, .5, .232367692},
                                         {.1, 1., .722496968},
                                         {.1, .2, .494864892},
                                         {.01, .5, .740968290}})
    near(oracle_value(slab, {.16 / sun, .16 / view}), light);
  const Family fresnel = family_in("fresnel");
  const double degrees[] = {0, 45, 60, 75, 85};
  for (const auto& [eta, passed] : {std::pair{1.3, std::vector{.982987, .976183, .946600, .798664, .426004}},
                                    {1.4, {.972222, .963421, .928023, .768717, .401678}},
                                    {1.5, {.960000, .949760, .910813, .746939, .387200}}})
    for (size_t i = 0; i < 5; ++i) near(1 - oracle_value(fresnel, {std::cos(glm::radians(degrees[i])), eta}), passed[i]);
  EXPECT_EQ(oracle_value(fresnel, {0.1, 1 / 1.5}), 1) << "total reflection";
}

// The mean cosine of Cornette and Shanks's function is not g: .843636 at g = .8. Its integral is 1.
TEST(ScatteringOracles, CornetteAndShanksHaveTheMeanCosineThatIsKnown) {
  const Family family = family_in("cornette_shanks");
  double sum = 0, mean = 0;
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double cosine = (2 * i + 1.0) / steps - 1,
                 part = 2 * std::numbers::pi * oracle_value(family, {0.8, cosine}) * 2 / steps;
    sum += part, mean += part * cosine;
  }
  EXPECT_NEAR(sum, 1, 1e-6);
  EXPECT_NEAR(mean, .843636, 1e-6);
}

TEST(ScatteringOracles, ConditionsAreThoseOfTheFormulas) {
  const Family transmittance = family_in("transmittance"), hg = family_in("henyey_greenstein");
  for (const double x : {0.1, 1.0, 30.0})
    EXPECT_NEAR(transmittance.oracle->condition(std::vector{x}, std::exp(-x)), x, 1e-9 * x);
  // By hand: c dp/dc / p = 3 g c / base.
  const double g = 0.5, c = 0.25, base = 1 + g * g - 2 * g * c;
  const double by_cosine = 3 * g * c / base, by_g = g * (-2 * g / (1 - g * g) - 1.5 * (2 * g - 2 * c) / base);
  EXPECT_NEAR(hg.oracle->condition(std::vector{g, c}, oracle_value(hg, {g, c})), by_cosine + std::abs(by_g), 1e-9);
}

TEST(ScatteringOracles, RefuseWhatHasNoValue) {
  const Family hg = family_in("henyey_greenstein"), mean = family_in("mean_transmittance");
  EXPECT_NE(hg.oracle->refusal(std::vector{1.0, 0.5}), "") << "g of 1: all light goes straight on";
  EXPECT_NE(hg.oracle->refusal(std::vector{0.5, 1.01}), "");
  EXPECT_NE(mean.oracle->refusal(std::vector{-1.0}), "");
  EXPECT_NE(mean.oracle->refusal(std::vector{std::nan("")}), "");
  for (const char* folder : scattering_folders) {
    const Family family = family_in(folder);
    for (const FamilySet& set : family.sets) {
      const Points points = family.oracle->points(set.name, 500, 3);
      for (size_t i = 0; i < points.size(); ++i)
        ASSERT_EQ(family.oracle->refusal(std::vector<double>(points[i].begin(), points[i].end())), "")
            << folder << " " << set.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, ScatteringShaders, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
