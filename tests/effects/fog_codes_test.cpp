// SPDX-License-Identifier: Apache-2.0
// Variants that sum codes: exact to their bits for as many surfaces as they hold, saturated and not wrapped beyond. And the
// family of functions that does the same without hulls.
#include <gtest/gtest.h>

#include "tests/effects/caps.h"
#include "tests/effects/fog_cases.h"

namespace lamina {
namespace {

struct CodeFormat {
  const char* variant;
  int bits;      // of a channel
  int surfaces;  // a side
  bool dithered;
};
constexpr CodeFormat code_formats[] = {
    {"rgb8_12", 4, 17, false},        {"rgb8_15", 5, 8, false},          {"rgb8_18", 6, 4, false},
    {"rgb8_21", 7, 2, false},         {"rgb8_12_dithered", 4, 15, true}, {"rgb8_15_dithered", 5, 7, true},
    {"rgb8_18_dithered", 6, 3, true}, {"rgb8_21_dithered", 7, 1, true},  {"integer_codes", 8, 8, false}};
constexpr float reach_m = 8;

// As many boxes, one in the other: every front 2 m to 2.5 m away, every back beyond the reach, so that all channels are full.
std::vector<Object> boxes_of_fog(int count) {
  std::vector<Object> boxes;
  for (int i = 0; i < count; ++i) boxes.push_back(fog_box("box", {-4, -4, -9}, {4, 4, -2 - 0.5f * float(i) / float(count)}, 1));
  return boxes;
}
double thickness_of_boxes(int count) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += double(reach_m) - (2 + 0.5 * i / count);
  return sum;
}

class FogCodes : public FogOnEachBackend {};

TEST_P(FogCodes, ExactToTheirBitsAndThenSaturated) {
  for (const CodeFormat& format : code_formats) {
    SCOPED_TRACE(format.variant);
    FogCases cases;
    const int counts[] = {1, format.surfaces, format.surfaces + 1, 3 * format.surfaces};
    for (const int count : counts) cases.add("boxes", boxes_of_fog(count), {0, 0, 0}, {0, 0, -1}, thickness_of_boxes(count));
    Scene scene = cases.scene();
    scene.effects.at("volume_fog").numbers["reach"] = reach_m;
    const std::vector<Thickness> found = thickness(scene, format.variant, 5);
    const double unit = reach_m * std::pow(2.0, -3 * format.bits);
    for (size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(found[i].middle_m(), thickness_of_boxes(counts[i]), counts[i] * (unit * (format.dithered ? 2 : 1) + 1e-5))
          << counts[i];
    // Sums of what adds stop growing; what takes away goes on, by 2.5 m a box at most.
    for (size_t i = 2; i < 4; ++i) {
      EXPECT_LE(found[i].middle_m(), thickness_of_boxes(counts[i]) + counts[i] * unit);
      EXPECT_GE(found[i].middle_m(), found[1].middle_m() - 2.5 * (counts[i] - counts[1]) - counts[i] * 2 * unit);
      // Depths beyond the reach are not dithered, so they need no room for a carry.
      if (std::string(format.variant) != "integer_codes" && (!format.dithered || i == 3)) {
        EXPECT_LT(found[i].middle_m(), thickness_of_boxes(counts[i]) - 0.5);
      }
    }
  }
}

// Dithering leaves no bias: the mean over a slanted face is that of floats, far below a unit.
TEST_P(FogCodes, DitheringHasNoBias) {
  FogCases cases;
  cases.add("slanted", {fog_box("box", {-1, -1, -1}, {1, 1, 1}, 1)}, {2.1f, 1.7f, 4.2f}, {0, 0, 0}, 2);
  Scene scene = cases.scene();
  scene.effects.at("volume_fog").numbers["reach"] = reach_m;
  const double unit = reach_m / 4096;
  const Thickness dithered = thickness(scene, "rgb8_12_dithered", 128)[0];
  double sum = 0, squares = 0;
  size_t count = 0;
  for (size_t i = 0; i < dithered.own_m.size(); ++i) {
    if (dithered.exact_m[i] == 0) continue;
    const double error = dithered.own_m[i] - dithered.exact_m[i];
    sum += error, squares += error * error, ++count;
  }
  ASSERT_GT(count, 3000u);
  EXPECT_LT(std::abs(sum / double(count)), 4 * 0.6 * unit / std::sqrt(double(count)));
  EXPECT_NEAR(std::sqrt(squares / double(count)), 0.578 * unit, 0.05 * unit) << "along rays it is a little more";
}

// Half floats are rounded toward 0 here, so a sum of depths is wrong in the mean too: below, by about half a unit of a depth
// for each face that is added to one.
TEST_P(FogCodes, HalfSumsHaveABias) {
  FogCases cases;
  cases.add("slanted", {fog_box("box", {-1, -1, -1}, {1, 1, 1}, 1)}, {2.1f, 1.7f, 4.2f}, {0, 0, 0}, 2);
  const Thickness half = thickness(cases.scene(), "half_sum", 128)[0];
  double sum = 0;
  size_t count = 0;
  for (size_t i = 0; i < half.own_m.size(); ++i)
    if (half.exact_m[i] != 0) sum += half.own_m[i] - half.exact_m[i], ++count;
  constexpr double unit = 1.0 / 256;  // from 4 m to 8 m
  EXPECT_NEAR(sum / double(count) / unit, -0.40, 0.1);
}

// Faces that touch have one code, dithered or not.
TEST_P(FogCodes, EqualFacesCancelExactly) {
  FogCases cases;
  const glm::vec3 low(-0.7f, -0.9f, -0.8f), high(0.6f, 0.8f, 0.9f);
  cases.add("nothing", {fog_box("fog", low, high, 1), fog_box("hole", low, high, 1, true)}, {1, 2, 5}, {0, 0, 0}, 0);
  for (const char* name : {"rgb8_18_dithered", "integer_codes", "six_passes"}) {
    const std::vector<Thickness> found = thickness(cases.scene(), name);
    EXPECT_GT(found.at(0).own_m.size(), 100u) << "pixels";
    for (const double metres : found[0].own_m) ASSERT_EQ(metres, 0) << name;
  }
}

// The other ways to sum, within what each is known to lose, on two nested spheres, with a wall in the inner one and without.
TEST_P(FogCodes, EveryVariantAgreesWithFloats) {
  FogCases cases;
  cases.add("nested", {sphere_of_fog(2, {0, 0, 0}), sphere_of_fog(1, {0, 0, 0}), wall(0)}, {0, 0, 5}, {0, 0, 0}, 3);
  Scene scene = cases.scene();
  scene.effects.at("volume_fog").numbers["reach"] = reach_m;
  // A wall of 8 m fills the view: no edge for a smaller target to miss.
  const std::pair<const char*, double> known[] = {{"half_sum", 0.04},   {"three_passes", 0.04},    {"five_passes", 1e-3},
                                                  {"six_passes", 1e-3}, {"half_resolution", 0.35}, {"half_depth_aware", 0.35},
                                                  {"ramp_table", 0},    {"integer_codes", 5e-6},   {"analytic", 0.02}};
  for (const auto& [name, bound] : known) {
    const Thickness found = thickness(scene, name, 64)[0];
    double worst = 0;
    for (size_t i = 0; i < found.own_m.size(); ++i)
      if (found.exact_m[i] > 1.5) worst = std::max(worst, std::abs(found.own_m[i] - found.exact_m[i]));
    EXPECT_LE(worst, bound) << name;
    EXPECT_NEAR(found.middle_m(), 3, 0.1) << name;
  }
}

const Family& depth_encodings() {
  static const Family family = load_family(shaders_folder() / "depth_encoding/family.toml", effect_code());
  return family;
}

class DepthEncodings : public EachBackend {};

TEST_P(DepthEncodings, EveryFunctionKeepsTheBoundsThatItClaims) {
  const std::vector<PointSet> sets = make_sets(depth_encodings(), 2000, 5);
  size_t claimed = 0;
  for (const FamilyFunction& function : depth_encodings().functions) {
    FunctionRunner runner(*backend_, shaders_folder(), depth_encodings(), function.name);
    for (const PointSet& set : sets) {
      const FamilyClaim* bounds = function.claim(set.name);
      if (!bounds) continue;
      SCOPED_TRACE(function.name + " " + set.name);
      ++claimed;
      const FunctionErrors errors = judge(set.points, runner.values(set.points), truth_of(*depth_encodings().oracle, set));
      EXPECT_LE(errors.max_over, bounds->over);
      EXPECT_GE(errors.max_under, bounds->under);
      EXPECT_EQ(errors.nonfinite, 0u);
    }
  }
  EXPECT_EQ(claimed, 8 + 5 + 7 + 5 + 4 + 4 + 3 * 3u);
}

// The naive forms fail where the others do not: codes as n / 255 in 16-bit floats, and depths read back from a depth buffer.
TEST_P(DepthEncodings, NaiveFormsFail) {
  const auto errors_of = [&](const char* name, size_t set) {
    const PointSet points = make_sets(depth_encodings(), 2000, 5).at(set);
    FunctionRunner runner(*backend_, shaders_folder(), depth_encodings(), name);
    return judge(points.points, runner.values(points.points), truth_of(*depth_encodings().oracle, points));
  };
  EXPECT_GT(errors_of("unit_codes_half_sum", 4).rms, 1000 * errors_of("integer_codes_sum", 4).rms);
  EXPECT_GT(errors_of("depth_buffer_sum", 0).rms, 100 * errors_of("float_sum32", 0).rms);
  EXPECT_LT(errors_of("rgb8_21_sum", 6).mean_absolute, 40) << "beyond what it holds it stops, and does not wrap";
  EXPECT_GT(errors_of("rgb8_21_sum", 6).rms, 0.1);
}

// By hand: 0.25 and 0.75, three times, a step of 0.125 apart, the last back face cut at 1: 0.5 + 0.5 + 0.5.
TEST(DepthOracle, SumsWhatTheDefinitionSays) {
  const Oracle& oracle = *depth_encodings().oracle;
  EXPECT_EQ(oracle.value(std::vector<double>{0.25, 0.75, 0.125, 3}), 1.5);
  EXPECT_EQ(oracle.value(std::vector<double>{0.25, 0.75, 0.125, 4}), 1.875) << "the fourth back face is cut at 1";
  EXPECT_EQ(oracle.condition(std::vector<double>{0.25, 0.75, 0, 2}, 1), 2);
  EXPECT_NE(oracle.refusal(std::vector<double>{0.75, 0.25, 0, 1}), "");
  EXPECT_NE(oracle.refusal(std::vector<double>{0.25, 0.75, 0, 1.5}), "");
  for (const PointSet& set : make_sets(depth_encodings(), 500, 3))
    for (size_t i = 0; i < set.points.size(); ++i)
      ASSERT_EQ(oracle.refusal(std::vector<double>(set.points[i].begin(), set.points[i].end())), "") << set.name;
}

INSTANTIATE_TEST_SUITE_P(Backends, FogCodes, api_parameters, backend_test_name);
INSTANTIATE_TEST_SUITE_P(Backends, DepthEncodings, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
