// SPDX-License-Identifier: Apache-2.0
// The shaders' functions on every backend against the reference.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "harness/effects/cap_intersection/cap_area.h"
#include "harness/effects/cap_intersection/cap_table.h"
#include "tests/effects/family_shaders.h"

namespace lamina {
namespace {

constexpr size_t inputs_per_set = 20000;

// The distances a thousandth of the way to pi larger.
Points moved_apart(Points points) {
  for (size_t i = 0; i < points.size(); ++i) points[i][2] += (3.14159250f - points[i][2]) * 1e-3f;
  return points;
}

class CapShaders : public FamilyShaders {
 protected:
  CapShaders() : FamilyShaders(inputs_per_set) {}

  // Errors by set of one variant.
  std::map<std::string, FunctionErrors> errors(const std::string& variant) {
    std::map<std::string, FunctionErrors> all;
    FunctionRunner runner(*backend_, shaders_folder(), caps(), variant);
    for (const PointSet& set : make_sets(caps(), inputs_, 5))
      all[set.name] = judge(set.points, runner.values(set.points), truth_of_caps(set));
    return all;
  }
};

TEST_P(CapShaders, EveryFunctionKeepsTheBoundsThatItClaims) {
  size_t claimed = 0;
  for (const FamilyFunction& function : caps().functions)
    for (const auto& [set, errors] : errors(function.name)) {
      const FamilyClaim* bounds = function.claim(set);
      if (!bounds) continue;
      SCOPED_TRACE(function.name + " " + set);
      ++claimed;
      EXPECT_LE(errors.max_over, bounds->over);
      EXPECT_GE(errors.max_under, bounds->under);
      EXPECT_LE(errors.max_eps_kappa, bounds->eps_kappa.value_or(std::numeric_limits<double>::infinity()));
      EXPECT_FALSE(errors.first_fault);
    }
  EXPECT_EQ(claimed, 3 * 10 + 5 * 5u);  // three claim something on all sets, five on those of radii up to pi/2
}

TEST_P(CapShaders, ExactCapKeepsItsBoundsOnEverySet) {
  for (const auto& [set, errors] : errors("exact_cap")) {
    SCOPED_TRACE(set);
    EXPECT_LE(errors.max_eps, 32);
    EXPECT_LE(errors.max_eps_kappa, 4);
    EXPECT_EQ(errors.negative, 0u);
    EXPECT_EQ(errors.nonfinite, 0u);
    EXPECT_EQ(errors.not_zero, 0u);
  }
}

// Figures for radii up to pi / 2, of the smaller cap: of the first two from an independent search of that box, of the fits what
// tools/fit_cap gives them.
TEST_P(CapShaders, ApproximationsErrAsMuchAsTheyAreKnownTo) {
  for (const auto& [variant, over, under] : {std::tuple{"smoothstep_cap", 0.1605, -0.0962},
                                             {"linear_cap", 0.115, -0.058},
                                             {"quick_fit_cap", 0.01575, -0.01575},
                                             {"fitted_cap", 0.00769, -0.00769},
                                             {"close_fit_cap", 0.00484, -0.00484}}) {
    const FunctionErrors errors = this->errors(variant)["overlaps"];
    EXPECT_NEAR(errors.max_over, over, 0.02 * over) << variant;
    EXPECT_NEAR(errors.max_under, under, -0.02 * under) << variant;
  }
}

TEST_P(CapShaders, FoldingKeepsTheFitsErrorForAllRadii) {
  for (const auto& [set, errors] : errors("folded_fit_cap")) {
    EXPECT_LE(errors.max_over, 1.02 * 0.00769) << set;
    EXPECT_GE(errors.max_under, -1.02 * 0.00769) << set;
  }
}

TEST_P(CapShaders, NoAreaIsNegativeButTheNaiveOnes) {
  for (const std::string& variant : caps().function_names()) {
    if (variant == "naive_cap") continue;
    for (const auto& [set, errors] : errors(variant))
      EXPECT_EQ(errors.nonfinite + errors.negative, 0u) << variant << " " << set;
  }
}

// The area of fitted_cap too, which folded_fit_cap takes for radii up to pi / 2, never grows with the distance.
TEST_P(CapShaders, FittedAreaFallsWithDistance) {
  FunctionRunner runner(*backend_, shaders_folder(), caps(), "folded_fit_cap");
  for (const PointSet& set : make_sets(caps(), inputs_per_set, 7)) {
    const Points further = moved_apart(set.points);
    const std::vector<float> here = runner.values(set.points), there = runner.values(further);
    for (size_t i = 0; i < here.size(); ++i) {
      const double r0 = set.points[i][0], r1 = set.points[i][1], d = set.points[i][2];
      ASSERT_LE(there[i], here[i] + 32 * 0x1p-23 * smaller_cap_area(r0, r1)) << set.name << " " << r0 << " " << r1 << " " << d;
    }
  }
}

TEST_P(CapShaders, NaiveFormulaFailsWhereTheExactOneDoesNot) {
  const auto errors = this->errors("naive_cap");
  EXPECT_GT(errors.at("tiny").negative + errors.at("tiny").nonfinite, inputs_per_set / 10);
  EXPECT_GT(errors.at("tangent_outside").max_eps, 1e3);
}

// d area / d d <= 0: in binary32, by neighbouring distances, up to the rounding of exact_cap.
TEST_P(CapShaders, ExactCapFallsWithDistance) {
  FunctionRunner runner(*backend_, shaders_folder(), caps(), "exact_cap");
  for (const auto& [r0, r1] :
       {std::pair{1.5f, 0.4f}, {1.57079637f, 1.57079637f}, {2.5f, 1.2f}, {1e-4f, 1.2e-4f}, {2.9f, 2.8f}}) {
    Points inputs(3);
    for (int i = 0; i <= 4096; ++i) inputs.add({r0, r1, std::min(r0 + r1, 3.14159250f) * static_cast<float>(i) / 4096.0f});
    const std::vector<float> areas = runner.values(inputs);
    const double rounding = 32 * 0x1p-23 * smaller_cap_area(r0, r1),
                 steepest = 2 * std::min(std::sin(double(r0)), std::sin(double(r1)));
    for (size_t i = 1; i < areas.size(); ++i) {
      ASSERT_LE(areas[i], areas[i - 1] + rounding) << r0 << " " << r1 << " " << inputs[i][2];
      ASSERT_LE(areas[i - 1] - areas[i], steepest * (double(inputs[i][2]) - inputs[i - 1][2]) + rounding)
          << r0 << " " << r1 << " " << inputs[i][2];
    }
  }
}

// The same from every hard input.
TEST_P(CapShaders, ExactCapFallsWithDistanceOnEverySet) {
  FunctionRunner runner(*backend_, shaders_folder(), caps(), "exact_cap");
  for (const PointSet& set : make_sets(caps(), inputs_per_set, 7)) {
    const Points further = moved_apart(set.points);
    const std::vector<float> here = runner.values(set.points), there = runner.values(further);
    for (size_t i = 0; i < here.size(); ++i) {
      const double r0 = set.points[i][0], r1 = set.points[i][1], d = set.points[i][2];
      const double rounding = 32 * 0x1p-23 * smaller_cap_area(r0, r1),
                   steepest = 2 * std::min(std::sin(double(r0)), std::sin(double(r1)));
      ASSERT_LE(there[i], here[i] + rounding) << set.name << " " << r0 << " " << r1 << " " << d;
      ASSERT_LE(here[i] - there[i], steepest * (further[i][2] - d) + rounding)
          << set.name << " " << r0 << " " << r1 << " " << d;
    }
  }
}

TEST_P(CapShaders, ExactCapAtTheEndsOfItsRange) {
  FunctionRunner runner(*backend_, shaders_folder(), caps(), "exact_cap");
  constexpr float pi_float = 3.14159274f;
  const Points inputs(3, {{0, 1, 0.5f},
                          {1, 1, 0},
                          {pi_float, 1, 2},
                          {pi_float, pi_float, pi_float},
                          {1, 1, pi_float},
                          {pi_float / 2, pi_float / 2, pi_float},
                          {1e-30f, 1, 0}});
  const std::vector<double> expected = {0, 2.8883657975136403, 2.8883657975136403, 12.566370614359172, 0, 0, 0};
  const std::vector<float> areas = runner.values(inputs);
  for (size_t i = 0; i < inputs.size(); ++i) EXPECT_NEAR(areas[i], expected[i], 2e-6) << i;
}

// Every hard input has the area of the sound one that it stands for.
TEST_P(CapShaders, WhatIsNoCapHasADefinedArea) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity(),
                  pi_float = 3.14159274f;
  const std::vector<float> radii = {0, -0.0f, -1, -infinite, nan, 1e-30f, 1, 1.5f, pi_float, 4, 1e30f, infinite};
  const std::vector<float> distances = {nan, -infinite, -1, -0.0f, 0, 0.5f, 2, pi_float, 4, infinite};
  Points hard(3), sound(3);
  std::vector<bool> none;
  for (const float r0 : radii)
    for (const float r1 : radii)
      for (const float d : distances) {
        none.push_back(!(r0 > 0) || !(r1 > 0) || std::isnan(d));
        hard.add({r0, r1, d});
        if (none.back())
          sound.add({1, 1, 3});
        else
          sound.add({std::min(r0, pi_float), std::min(r1, pi_float), std::clamp(d, 0.0f, pi_float)});
      }
  for (const std::string& variant : caps().function_names()) {
    FunctionRunner runner(*backend_, shaders_folder(), caps(), variant);
    const std::vector<float> areas = runner.values(hard), expected = runner.values(sound);
    for (size_t i = 0; i < hard.size(); ++i) {
      const float r0 = hard[i][0], r1 = hard[i][1], d = hard[i][2];
      EXPECT_TRUE(std::isfinite(areas[i])) << variant << " " << r0 << " " << r1 << " " << d;
      EXPECT_EQ(areas[i], none[i] ? 0 : expected[i]) << variant << " " << r0 << " " << r1 << " " << d;
    }
  }
}

TEST(CapFamily, JudgesByTheSmallerCap) {
  const PointSet set{"", "", Points(3, {{1, 1, 0}, {1, 1, 0}, {1, 1, 3}, {1, 1, 3}})};
  const double cap = smaller_cap_area(1, 1);
  const std::vector<float> areas = {static_cast<float>(1.5 * cap), static_cast<float>(0.75 * cap), -0.5f, std::nanf("")};
  PointTruth truth = truth_of_caps(set);
  truth.conditions = {1, 1, 0, 0};
  const FunctionErrors errors = judge(set.points, areas, truth);
  EXPECT_NEAR(errors.max_over, 0.5, 1e-6);
  EXPECT_NEAR(errors.max_under, std::min(-0.25, -0.5 / cap), 1e-6);
  EXPECT_EQ(errors.negative, 1u);
  EXPECT_EQ(errors.not_zero, 1u);
  EXPECT_EQ(errors.nonfinite, 1u);
  ASSERT_TRUE(errors.first_fault);
  EXPECT_EQ(*errors.first_fault, (std::vector<double>{1, 1, 3})) << "the one that is negative";
  EXPECT_NEAR(errors.mean_absolute, (0.5 + 0.25 + 0.5 / cap) / 3, 1e-6);
  EXPECT_NEAR(errors.max_eps_kappa, 0.5 * 0x1p23, 2);
}

// A function whose file is there, but that the family does not declare, would never be run.
TEST(CapFamily, DeclaresEveryFunctionOfItsFolder) {
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(shaders_folder() / "cap_intersection"))
    if (entry.path().filename().string().ends_with("_cap.glsl")) files.insert(entry.path().stem().string());
  const std::vector<std::string> names = caps().function_names();
  EXPECT_EQ(files, std::set<std::string>(names.begin(), names.end()));
  EXPECT_EQ(names.front(), "exact_cap");
}

TEST(CapFamily, TheTablesClaimIsThatOfTheTable) {
  for (const FamilyFunction& function : caps().functions)
    if (function.name == "lut_cap") {
      EXPECT_EQ(function.claim("large")->over, cap_table_error);
      EXPECT_EQ(function.claim("large")->under, -cap_table_error);
    }
}

TEST(CapFamily, EverySetIsOfCaps) {
  for (const PointSet& set : make_sets(caps(), 2000, 3))
    for (size_t i = 0; i < set.points.size(); ++i)
      ASSERT_EQ(caps().oracle->refusal(std::vector<double>(set.points[i].begin(), set.points[i].end())), "") << set.name;
}

// Kept from before families were data: seeds mean the same points.
TEST(CapFamily, SeedsMeanTheSamePoints) {
  EXPECT_NE(make_sets(caps(), 1000, 1)[1].points[0][0], make_sets(caps(), 1000, 2)[1].points[0][0]);
  EXPECT_EQ(make_sets(caps(), 1000, 1)[1].points[999][0], make_sets(caps(), 2000, 1)[1].points[999][0]);
}

INSTANTIATE_TEST_SUITE_P(Backends, CapShaders, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
