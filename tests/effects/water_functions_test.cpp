// SPDX-License-Identifier: Apache-2.0
// Water's functions: waves on the host and in shaders against closed forms, Fresnel from both sides, in-scatter, RGBM and the
// way of refracted rays against figures that were worked out elsewhere.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "harness/effects/water/caustic_table.h"
#include "harness/effects/water/water_light.h"
#include "harness/effects/water/waves.h"
#include "harness/scene/textures.h"
#include "tests/effects/family_shaders.h"

namespace lamina {
namespace {

constexpr double index_of_water = 1.333;

EffectValues no_waves() {
  EffectValues values;
  for (int i = 1; i <= max_waves; ++i)
    for (const auto& [name, value] : {std::pair("amplitude", 0.0), {"length", 1.0}, {"direction", 0.0}, {"steepness", 0.0}})
      values.numbers[fmt::format("wave_{}_{}", i, name)] = value;
  values.numbers["wave_depth"] = 0;
  return values;
}
void set_wave(EffectValues& values, int i, double amplitude, double length, double degrees, double steepness) {
  values.numbers[fmt::format("wave_{}_amplitude", i)] = amplitude;
  values.numbers[fmt::format("wave_{}_length", i)] = length;
  values.numbers[fmt::format("wave_{}_direction", i)] = degrees;
  values.numbers[fmt::format("wave_{}_steepness", i)] = steepness;
}
// Of a sum of steepnesses.
GerstnerWaves four_waves(double sum) {
  EffectValues values = no_waves();
  set_wave(values, 1, .18, 8, 10, sum / 4);
  set_wave(values, 2, .10, 5, 55, sum / 4);
  set_wave(values, 3, .06, 3.2, -40, sum / 4);
  set_wave(values, 4, .03, 2, 100, sum / 4);
  return GerstnerWaves(values);
}

struct KnownPoint {
  double x, z, time;
  glm::dvec3 place, normal;
  double jacobian;
};
const KnownPoint known_points[] = {{0, 0, 0, {.409041, 0, .171812}, {-.271636, .952497, -.137708}, 1},
                                   {3, 5, 2, {2.869886, .268423, 4.957611}, {.071227, .997424, .008431}, .601246},
                                   {10, -4, 7.5, {9.646238, -.049411, -4.020641}, {.253327, .966705, -.036146}, 1.230353}};

TEST(GerstnerWaves, GiveTheFiguresThatAreKnown) {
  const GerstnerWaves waves = four_waves(.8);
  for (const KnownPoint& known : known_points) {
    const WavePoint point = waves.at({known.x, known.z}, known.time);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(point.position[c], known.place[c], 1e-6) << known.x << " " << c;
      EXPECT_NEAR(point.normal()[c], known.normal[c], 1e-6) << known.x << " " << c;
    }
    EXPECT_NEAR(point.jacobian(), known.jacobian, 1e-6);
  }
}

TEST(GerstnerWaves, OneWaveRunsAsFastAsItIsLong) {
  EffectValues values = no_waves();
  set_wave(values, 1, .5, 10, 0, 1);
  const GerstnerWaves one(values);
  const GerstnerWave& wave = one.waves().at(0);
  EXPECT_NEAR(wave.wave_number(), .628319, 1e-6);
  EXPECT_NEAR(wave.frequency() / wave.wave_number(), 3.9513, 1e-4);
  EXPECT_NEAR(2 * std::numbers::pi / wave.frequency(), 2.5308, 1e-4);
  EXPECT_NEAR(wave.reach_m / .5, 3.18310, 1e-5) << "the limit of Q, at a steepness of 1";
  for (const auto& [length, deep, shallow] : {std::tuple{1., 1.2495, 1.2495}, {10., 3.9513, 2.9487}, {100., 12.4952, 3.1300}}) {
    EXPECT_NEAR((GerstnerWave{1, length}.frequency() / GerstnerWave{1, length}.wave_number()), deep, 1e-4);
    EXPECT_NEAR((GerstnerWave{1, length, {1, 0}, 0, 1}.frequency() / GerstnerWave{1, length}.wave_number()), shallow, 1.1e-4);
  }
  // From crest to crest it is as long as it says; one period later it is the same.
  for (const double x : {0.3, 4.0}) {
    EXPECT_NEAR(one.height_over({x, 2}, 1), one.height_over({x + 10, 2}, 1), 1e-3);
    EXPECT_NEAR(one.at({x, 2}, 1).position.y, one.at({x, 2}, 1 + 2 * std::numbers::pi / wave.frequency()).position.y, 1e-12);
  }
}

TEST(GerstnerWaves, SinkByHalfTheSumOfTheirOrbits) {
  EffectValues values = no_waves();
  set_wave(values, 1, .5, 10, 0, 2 * std::numbers::pi / 10 * .5);  // Q = 1
  const GerstnerWaves one(values);
  EXPECT_NEAR(one.sinking_m(), .0785, 1e-4);
  double mean = 0;
  for (int i = 0; i < 1000; ++i) mean += one.height_over({.01 * i, 0}, 0) / 1000;
  EXPECT_NEAR(mean, -one.sinking_m(), 1e-6);
}

TEST(GerstnerWaves, NormalsAreThoseOfFiniteDifferences) {
  const GerstnerWaves waves = four_waves(1);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec2 ground(0.37 * i - 20, 11 - 0.61 * i);
    const double step = 1e-5;
    const auto place = [&](double x, double z) { return waves.at(ground + glm::dvec2(x, z), 3).position; };
    const glm::dvec3 normal = glm::normalize(glm::cross(place(0, step) - place(0, -step), place(step, 0) - place(-step, 0)));
    EXPECT_LT(glm::distance(normal, waves.at(ground, 3).normal()), 1e-6) << i;
  }
}

TEST(GerstnerWaves, AreFoundUnderAPlace) {
  const GerstnerWaves waves = four_waves(.8);
  double squares = 0, steps_4 = 0;
  for (int i = 0; i < 500; ++i) {
    const glm::dvec2 xz(0.217 * i, 3 - 0.091 * i), ground = waves.ground_under(xz, 5);
    const glm::dvec3 p = waves.at(ground, 5).position;
    squares += glm::dot(glm::dvec2(p.x, p.z) - xz, glm::dvec2(p.x, p.z) - xz) / 500;
    steps_4 += std::pow(waves.at(waves.ground_under(xz, 5, 4), 5).position.y - waves.height_over(xz, 5), 2) / 500;
  }
  EXPECT_LT(std::sqrt(squares), 1e-4);
  EXPECT_NEAR(std::sqrt(steps_4), 1.1e-4, 6e-5) << "rms of the height after four steps";
}

TEST(GerstnerWaves, NeverFold) {
  EffectValues values = no_waves();
  for (int i = 1; i <= 4; ++i) set_wave(values, i, .2, 1 + i, 30 * i, 1);
  const GerstnerWaves waves(values);
  for (int i = 0; i < 5000; ++i) EXPECT_GE(waves.at({0.0131 * i, 0.077 * i}, 0).jacobian(), -1e-12) << i;
  set_wave(values, 1, 1000, .01, 0, 1);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(std::isfinite(GerstnerWaves(values).at({i * 0.3, i * 1.7}, 1e6).normal().y)) << i;
  EXPECT_TRUE(GerstnerWaves(no_waves()).waves().empty());
}

// A bottom that rises from 4 m to the shore along x, over 8 m around the middle.
EffectValues rising_bottom() {
  EffectValues values = no_waves();
  set_wave(values, 1, .2, 3, 30, .3);
  set_wave(values, 2, .1, 5, -50, .2);
  Texels depth{64, 2, {}};
  for (int i = 0; i < 128; ++i) depth.rgba.emplace_back(glm::vec3(1 - float(i % 64) / 63), 1);
  values.textures["bottom"] = make_texture("bottom", depth, TexelMeaning::data);
  values.numbers["bottom_depth"] = 4, values.numbers["bottom_width"] = 8;
  return values;
}

TEST(GerstnerWaves, FadeTowardsTheShore) {
  const GerstnerWaves waves(rising_bottom());
  for (const double z : {-3.0, 0.7, 9.0}) {
    EXPECT_NEAR(waves.at({5, z}, 1).position.y, 0, 1e-12) << "on the shore and beyond";
    EXPECT_NEAR(waves.at({5, z}, 1).position.x, 5, 1e-12) << "points do not slide either";
    // Where the bottom is 4 m deep, more than half of each wave, they are whole.
    EffectValues values = rising_bottom();
    values.numbers["bottom_depth"] = 0;
    EXPECT_NEAR(waves.at({-4.5, z}, 1).position.y, GerstnerWaves(values).at({-4.5, z}, 1).position.y, 1e-9);
  }
  // Tangents hold the fading, but for steps of the map, which is of bytes.
  for (int i = 0; i < 60; ++i) {
    const glm::dvec2 ground(-3.4 + 0.11 * i, 0.3 * i);
    const auto place = [&](double x, double z) { return waves.at(ground + glm::dvec2(x, z), 2).position; };
    const double step = 1e-4;
    const WavePoint point = waves.at(ground, 2);
    EXPECT_LT(glm::distance((place(step, 0) - place(-step, 0)) / (2 * step), point.along_x), 0.015) << i;
    EXPECT_LT(glm::distance((place(0, step) - place(0, -step)) / (2 * step), point.along_z), 0.015) << i;
  }
}

class WaterShaders : public FamilyShaders {
 protected:
  WaterShaders() : FamilyShaders(500) {}
  double value(const char* folder, const char* function, const std::vector<float>& point) {
    return double(values(family_in(folder), function, {point}).at(0));
  }
};

TEST_P(WaterShaders, EveryFunctionKeepsTheBoundsThatItClaims) {
  static const char* const folders[] = {"gerstner",         "wave_phase", "water_in_scatter",
                                        "water_extinction", "rgbm8",      "refraction_way"};
  EXPECT_GT(judge_claims(folders).size(), 19u);
}

TEST_P(WaterShaders, WavesAreThoseThatAreKnown) {
  const Family family = family_in("gerstner");
  for (const KnownPoint& known : known_points)
    for (int c = 0; c < 6; ++c) {
      const double right = c < 3 ? known.place[c] : known.normal[c - 3];
      EXPECT_NEAR(value("gerstner", "exact_gerstner", {float(known.x), float(known.z), float(known.time), float(c)}), right,
                  4e-6);
      EXPECT_NEAR(family.oracle->value(std::vector{known.x, known.z, known.time, double(c)}), right, 1e-6);
    }
  const double gems[] = {.089360, .995987, .004884};
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(value("gerstner", "gems_gerstner", {3, 5, 2, float(3 + c)}), gems[c], 4e-6);
}

// Far from the origin a phase that is not reduced is off; half floats are off from ten metres on.
TEST_P(WaterShaders, PlainPhasesFailFarOut) {
  const Family family = family_in("wave_phase");
  const auto worst = [&](const char* function, const char* set) {
    const FunctionErrors found = errors(family, function, set);
    return std::max(found.max_over, -found.max_under);
  };
  EXPECT_GT(worst("plain_phase", "far"), 1e-4);
  EXPECT_GT(worst("plain_phase", "very_far"), 0.01);
  EXPECT_GT(worst("half_phase", "near"), 0.005);
  EXPECT_LT(worst("remainder_phase", "very_far"), 2e-6);
}

TEST_P(WaterShaders, FresnelIsThatOfWaterFromBothSides) {
  const double degrees[] = {0, 30, 45, 60, 70, 80, 85, 89};
  const double above[] = {.020373, .021436, .027898, .059691, .133475, .347917, .583523, .896276},
               below[] = {.020373, .025519, .139458, 1, 1, 1, 1, 1},
               schlick[] = {.020373, .020415, .022485, .050987, .141189, .397846, .641305, .917448};
  for (int i = 0; i < 8; ++i) {
    const auto cosine = static_cast<float>(std::cos(degrees[i] * std::numbers::pi / 180));
    const auto n = static_cast<float>(index_of_water);
    EXPECT_NEAR(value("fresnel", "exact_fresnel", {cosine, n}), above[i], 2e-6) << degrees[i];
    EXPECT_NEAR(value("fresnel", "exact_fresnel", {cosine, 1 / n}), below[i], 2e-6) << degrees[i];
    EXPECT_NEAR(value("fresnel", "schlick_fresnel", {cosine, n}), schlick[i], 2e-6) << degrees[i];
    EXPECT_NEAR(reflected_by_water(double(cosine), index_of_water), above[i], 1e-6);
  }
}

TEST_P(WaterShaders, InScatterIsWhatIsKnown) {
  const double right[] = {.00216374, .01032117, .01193662};
  const float ways[] = {1, 10, 10000};
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(.03 / (4 * std::numbers::pi) * value("water_in_scatter", "closed_in_scatter", {.1f, ways[i], 1, 1}), right[i],
                1e-8);
  const FunctionErrors naive = errors(family_in("water_in_scatter"), "naive_in_scatter", "thin");
  EXPECT_GT(std::max(naive.max_over, -naive.max_under), 0.03) << "1 - e^-x cancels";
}

// Pope and Fry's red, green and blue light after 1, 5 and 10 m: down and up, or up alone.
TEST_P(WaterShaders, ExtinctionIsWhatIsKnown) {
  const float absorbed[] = {.340f, .0565f, .00922f}, metres[] = {1, 5, 10};
  const double left[3][3] = {{.7118, .9451, .9908}, {.1827, .7539, .9549}, {.0334, .5684, .9119}};
  for (int m = 0; m < 3; ++m)
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(value("water_extinction", "along_both_ways", {absorbed[c], 0, metres[m], 1}), left[m][c], 6e-5);
      EXPECT_NEAR(value("water_extinction", "along_both_ways", {absorbed[c], metres[m] / 4, metres[m] / 2, .5f}), left[m][c],
                  6e-5);
    }
  const FunctionErrors straight = errors(family_in("water_extinction"), "straight_down", "everyday");
  EXPECT_GT(straight.max_over, 0.1) << "a low sun's way is half as long again";
}

// In view angles from an eye 2 m over water 1 m deep, at 20, 45, 60 and 75 degrees.
TEST_P(WaterShaders, RefractedWaysAreOffAsIsKnown) {
  const double degrees[] = {20, 45, 60, 75}, unbent[] = {1.68, 3.81, 4.79, 4.41}, as_long[] = {-.03, -.51, -1.68, -5.02};
  for (int i = 0; i < 4; ++i) {
    const double angle = degrees[i] * std::numbers::pi / 180, out = 2 * std::tan(angle);
    const double inside = std::asin(std::sin(angle) / index_of_water), right = std::atan2(out + std::tan(inside), 3);
    const auto off = [&](const char* function, double down_over_way) {
      const double way = value("refraction_way", function, {float(std::cos(angle)), 1, float(index_of_water)});
      return (std::atan2(out + way, 2 + way * down_over_way) - right) * 180 / std::numbers::pi;
    };
    EXPECT_NEAR(off("unrefracted", 1 / std::tan(angle)), unbent[i], .006);
    EXPECT_NEAR(off("as_long", 1 / std::tan(inside)), as_long[i], .006);
    EXPECT_NEAR(off("down_to_depth", 1 / std::tan(inside)), 0, 1e-4);
  }
}

TEST(WaterLight, MeansOfFresnelAreReciprocal) {
  const Family family = family_in("fresnel");
  double above = 0, below = 0;
  constexpr int steps = 4000;
  for (int i = 0; i < steps; ++i) {
    const double cosine = (i + .5) / steps;
    above += 2 * cosine * reflected_by_water(cosine, index_of_water) / steps;
    below += 2 * cosine * family.oracle->value(std::vector{cosine, 1 / index_of_water}) / steps;
  }
  EXPECT_NEAR(above, .06640, 2e-5);
  EXPECT_NEAR(below, .47459, 2e-5);
  EXPECT_NEAR(below, 1 - (1 - above) / (index_of_water * index_of_water), 2e-5);
}

TEST(WaterTables, HaveTheMeansThatShadersCountOn) {
  const TiledTable caustics(make_caustic_table()), foam(make_foam_table());
  double mean = 0, lesser = 0, foam_mean = 0;
  constexpr int side = 400;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const glm::dvec2 at = (glm::dvec2(x, y) + .37) / double(side);
      mean += caustics.at(at) / (side * side);
      foam_mean += foam.at(at) / (side * side);
      // Over six by six tiles of the one pattern, which the other, turned and narrower, does not follow.
      const glm::dvec2 far = at * 6.0;
      lesser += std::min(caustics.at(far), caustics.at(glm::dvec2(-far.y, far.x) * .83)) / (side * side);
    }
  // Ripples have slopes of mean 0 and mean square 1 along both axes.
  const TiledTable ripples(make_ripple_table());
  for (const uint32_t channel : {0u, 1u}) {
    double sum = 0, squares = 0;
    for (int i = 0; i < side * side; ++i) {
      const double slope = ripples.at((glm::dvec2(i % side, i / side) + .37) / double(side), channel);
      sum += slope / (side * side), squares += slope * slope / (side * side);
    }
    EXPECT_NEAR(sum, 0, 5e-3);
    EXPECT_NEAR(squares, 1, 0.05) << "less a little that is lost between texels";
  }
  EXPECT_NEAR(mean, 1, 2e-3);
  EXPECT_NEAR(foam_mean, .5, 5e-3);
  EXPECT_NEAR(lesser, caustic_lesser_mean, 4e-3);
}

INSTANTIATE_TEST_SUITE_P(Backends, WaterShaders, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
