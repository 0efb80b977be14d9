// SPDX-License-Identifier: Apache-2.0
// Pictures of the atmosphere on every backend, against closed forms and against the truth.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "harness/effects/atmosphere/single_scattering_truth.h"
#include "tests/effects/air_scenes.h"
#include "tests/effects/backends_agree.h"
#include "tests/folder.h"
#include "tests/graph/each_backend.h"

namespace lamina {
namespace {

// Only molecules, of one density everywhere nearby, that take beta of every metre.
std::map<std::string, double> even_air(double beta) {
  return {{"mie_amount", 0},      {"ozone_amount", 0},          {"rayleigh_height", 1e6},
          {"rayleigh_red", beta}, {"rayleigh_green", beta / 2}, {"rayleigh_blue", beta / 4}};
}
std::map<std::string, double> dark(std::map<std::string, double> numbers) {
  for (const char* name : {"sun_red", "sun_green", "sun_blue"}) numbers[name] = 0;
  return numbers;
}
// Pictures are half floats, and llvmpipe rounds them towards 0.
constexpr double half_ulp = 1.0 / 1024;

// What the variant's picture should be, from the truth's own passes on the device.
Image true_picture(Backend& backend, const Library& library, const VariantManifest& told, const Scene& scene, uint32_t width,
                   uint32_t height) {
  DrawnFrame drawn(backend, library, scene, {.variant = &told, .width = width, .height = height, .told = &told});
  DiskCache cache{""};
  const auto targets = drawn.frame.targets_of(told);
  const TruthAnswer answer =
      single_scattering_truth({scene, drawn.bakes.occluders(), cache})->answer({targets, scene.views[0], {}}, [](double) {});
  EXPECT_EQ(answer.pixels.size(), size_t{width} * height);
  Image image = drawn.picture();
  for (size_t i = 0; i < answer.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) image.rgba[4 * answer.pixels[i] + size_t(c)] = answer.steps.back().light[i][c];
  return image;
}

class Atmosphere : public EachBackend {
 protected:
  Image truth(const Scene& scene, uint32_t size) {
    return true_picture(*backend_, library(), variant("per_pixel"), scene, size, size);
  }
  // The greatest |made - right| / right over all pixels and channels; right is above `least` there.
  static double worst(const Image& made, const Image& right, float least) {
    double most = 0;
    for (size_t i = 0; i < made.rgba.size(); ++i)
      if (i % 4 != 3 && right.rgba[i] > least) most = std::max<double>(most, std::abs(made.rgba[i] / right.rgba[i] - 1));
    return most;
  }
  static void expect_finite(const Image& image) {
    for (const float value : image.rgba) ASSERT_TRUE(std::isfinite(value));
  }
};

// exp(-beta s) of what is behind, s along the ray and not along the axis.
TEST_P(Atmosphere, LetsThroughByBouguersLaw) {
  Scene scene = square_in_air({1, 1, 1}, dark(even_air(0.04)));
  scene.views[0].eye = {0, 0, 0.5f}, scene.views[0].fov_y_degrees = 90;  // corners are sqrt 3 times as far as the middle
  const Image image = picture(scene, "per_pixel", 33);
  for (const auto& [x, y] : {std::pair{16, 16}, {0, 0}, {32, 5}}) {
    const glm::vec3 way((float(x) - 16) / 33, (float(y) - 16) / 33, 0.5f);  // from the eye
    for (int c = 0; c < 3; ++c) {
      const double right = std::exp(-0.04 / (1 << c) * glm::length(way));
      EXPECT_NEAR(pixel(image, x, y)[c], right, 1.5 * half_ulp * right) << x << " " << y;
    }
  }
}

// A black wall 10 m away under a sun in the zenith: the air between is lit evenly, by sunlight that has passed 100 km of it.
TEST_P(Atmosphere, ScattersIntoAShortRayByItsClosedForm) {
  std::map<std::string, double> numbers = even_air(1e-3);
  numbers["top"] = 500, numbers["sun_red"] = 4;
  const Image image = picture(square_in_air({0, 0, 0}, numbers), "per_pixel", 33);
  const double phase = 3 / (16 * std::numbers::pi);
  for (int c = 0; c < 3; ++c) {
    const double beta = 1e-3 / (1 << c), sun = (c == 0 ? 4 : 1) * std::exp(-500 * beta);
    const double right = std::numbers::pi * phase * sun * (1 - std::exp(-10 * beta));
    EXPECT_NEAR(pixel(image, 16, 16)[c], right, 3 * half_ulp * right);
  }
}

TEST_P(Atmosphere, MarchesTheSkyToHalfAPercentOfTheTruth) {
  for (const auto& [zenith, sun] : {std::pair{0.0, 60.0}, {75.0, 28.0}, {80.0, 85.0}}) {
    const Scene scene = sky(zenith, sun_at(sun, 30), {{"sun_red", 3}, {"sun_green", 3}, {"sun_blue", 3}}, 600);
    const Image made = picture(scene, "per_pixel", 16);
    expect_finite(made);
    EXPECT_LT(worst(made, truth(scene, 16), 1e-3f), 0.005) << zenith << " " << sun;
  }
}

// A wall, with sky to all sides, in thick air.
TEST_P(Atmosphere, MarchesAerialPerspectiveToATenthOfAPercentOfTheTruth) {
  Scene scene = square_in_air({0.4f, 0.5f, 0.6f}, {{"density", 200}}, sun_at(70, -60));
  scene.views[0].eye = {3, 2, 12}, scene.views[0].target = {0, 0.3f, 0};
  const Image made = picture(scene, "per_pixel", 24), right = truth(scene, 24);
  expect_finite(made);
  size_t solid = 0;
  for (size_t i = 0; i < made.rgba.size(); i += 4) {
    if (made.rgba[i + 3] < 1) continue;
    ++solid;
    for (size_t c = i; c < i + 3; ++c) EXPECT_NEAR(made.rgba[c], right.rgba[c], 0.002 * right.rgba[c]);
  }
  EXPECT_GT(solid, 20u);
}

TEST_P(Atmosphere, CostsNothingWhereThereIsNone) {
  Scene without = square_in_air({0.3f, 0.5f, 0.7f}, {});
  without.effects.erase("atmosphere");
  const Plan none = make_plan(library(), without);
  EXPECT_FALSE(none.of("atmosphere")->called_for);
  const Image expected = picture(without, "lambert", 16);
  for (const char* number : {"density", "top"}) {
    const Scene scene = square_in_air({0.3f, 0.5f, 0.7f}, {{number, 0}});
    EXPECT_FALSE(make_plan(library(), scene).of("atmosphere")->called_for) << number;
    EXPECT_EQ(picture(scene, "per_pixel", 16).rgba, expected.rgba) << number;
  }
}

TEST_P(Atmosphere, HazeAndOzoneAreFeaturesOnlyWhereTheyAre) {
  const Scene scene = sky(60, sun_at(40), {{"mie_amount", 0}, {"ozone_amount", 0}});
  const Plan plan = make_plan(library(), scene);
  EXPECT_EQ(plan.of("atmosphere")->features.size(), 2u);
  for (const FeaturePlan& feature : plan.of("atmosphere")->features) EXPECT_FALSE(feature.on) << feature.define;
  EXPECT_LT(worst(picture(scene, "per_pixel", 8), truth(scene, 8), 1e-3f), 0.005);
}

// Twilight is what higher air still sees of the sun; in the planet's shadow nothing is scattered. Both are defined.
TEST_P(Atmosphere, ASunBelowTheHorizonLightsHighAirOrNone) {
  const std::map<std::string, double> bright = {{"sun_red", 1000}, {"sun_green", 1000}, {"sun_blue", 1000}};
  const Scene dusk = sky(70, sun_at(93), bright), night = sky(70, sun_at(115), bright);
  const Image at_dusk = picture(dusk, "per_pixel", 8), at_night = picture(night, "per_pixel", 8);
  expect_finite(at_dusk);
  EXPECT_LT(worst(at_dusk, truth(dusk, 8), 1e-2f), 0.25) << "the edge of the shadow falls between steps";
  for (size_t i = 0; i < at_night.rgba.size(); ++i) EXPECT_EQ(at_night.rgba[i], 0);
}

TEST_P(Atmosphere, WithoutASunItOnlyTakesLight) {
  Scene scene = square_in_air({1, 1, 1}, even_air(0.01));
  scene.lights.clear();
  const Image image = picture(scene, "per_pixel", 9);
  EXPECT_NEAR(pixel(image, 4, 4).r, std::exp(-0.1), 2 * half_ulp);
  EXPECT_NEAR(truth(scene, 9).rgba[4 * (4 * 9 + 4)], std::exp(-0.1), 1e-3);
}

// The three rays for which errors of marching are known; 4 pixels around each.
TEST_P(Atmosphere, EightStepsAreWithinFivePercentOfTheTruth) {
  for (const auto& [zenith, sun] : {std::pair{0.0, 60.0}, {80.0, 60.0}, {89.0, 85.0}}) {
    const Scene scene = sky(zenith, sun_at(sun), {{"sun_red", 3}, {"sun_green", 3}, {"sun_blue", 3}}, 0, 0.2f);
    const Image right = truth(scene, 2);
    EXPECT_LT(worst(picture(scene, "march_8", 2), right, 0), 0.05) << zenith << " " << sun;
    EXPECT_LT(worst(picture(scene, "transmittance_table", 2), right, 0), 0.05) << zenith << " " << sun;
  }
}

TEST_P(Atmosphere, ATableGivesTheSunlightThatItsPathGives) {
  for (const double sun : {20.0, 80.0, 89.0, 92.0}) {
    const Scene scene = sky(60, sun_at(sun, 90), {{"sun_red", 30}, {"sun_green", 30}, {"sun_blue", 30}}, 600);
    const Image path = picture(scene, "march_8", 12), table = picture(scene, "transmittance_table", 12);
    EXPECT_LT(worst(table, path, 0.01f), sun < 91 ? 0.01 : 0.03) << sun;
  }
}

TEST_P(Atmosphere, TheMisprintLosesTheShareThatItLosesOfAllDirections) {
  const std::map<std::string, double> haze = {
      {"rayleigh_red", 0}, {"rayleigh_green", 0}, {"rayleigh_blue", 0}, {"mie_amount", 100}, {"mie_g", 0.76}};
  const Scene scene = sky(45, sun_at(50, 20), haze);
  const Image right = picture(scene, "per_pixel", 6), wrong = picture(scene, "misprinted_phase", 6);
  for (size_t i = 0; i < right.rgba.size(); i += 4)
    EXPECT_NEAR(wrong.rgba[i] / right.rgba[i], 0.24 / 1.76, 2 * half_ulp * 0.24 / 1.76);
}

// Where air has one density and sunlight one colour the formula is exact.
TEST_P(Atmosphere, HoffmanAndPreethamsFormulaIsExactInEvenAir) {
  std::map<std::string, double> numbers = even_air(0.05);
  numbers["rayleigh_height"] = 1;  // the sun's path is 1 m of such air straight up
  const Scene scene = square_in_air({1, 1, 1}, numbers);
  const Image image = picture(scene, "hoffman_preetham", 33);
  for (int c = 0; c < 3; ++c) {
    const double beta = 0.05 / (1 << c), passed = std::exp(-10 * beta), sun = std::exp(-beta);
    const double right = passed + std::numbers::pi * 3 / (16 * std::numbers::pi) * sun * (1 - passed);
    EXPECT_NEAR(pixel(image, 16, 16)[c], right, 2 * half_ulp * right);
  }
}

// Which the slides' formula gives for the sky: the errors that are known of its green.
TEST_P(Atmosphere, HoffmanAndPreethamsFormulaIsOffAsItIsKnownToBe) {
  const std::map<std::string, double> bright = {{"sun_red", 3}, {"sun_green", 3}, {"sun_blue", 3}};
  for (const auto& [zenith, sun, low, high] :
       {std::tuple{0.0, 60.0, -0.15, 0.0}, {80.0, 60.0, -0.2, 0.0}, {89.0, 85.0, -0.7, -0.4}}) {
    const Scene scene = sky(zenith, sun_at(sun), bright, 0, 0.2f);
    const double error = picture(scene, "hoffman_preetham", 2).rgba[1] / truth(scene, 2).rgba[1] - 1;
    EXPECT_GT(error, low) << zenith << " " << sun;
    EXPECT_LT(error, high) << zenith << " " << sun;
  }
}

// The square's corners are its vertices, all at one distance: so is all of it between them.
TEST_P(Atmosphere, VerticesAreInterpolated) {
  Scene scene = square_in_air({1, 1, 1}, dark(even_air(0.4)));
  scene.views[0].eye = {0, 0, 0.6f};
  scene.views[0].fov_y_degrees = 70;
  const Image image = picture(scene, "per_vertex", 33);
  const double corner = std::sqrt(0.6 * 0.6 + 0.5);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixel(image, 16, 16)[c], std::exp(-0.4 / (1 << c) * corner), 3 * half_ulp);
}

TEST_P(Atmosphere, AFineGridOfVerticesIsTheSkyOfEveryPixel) {
  const Scene scene = sky(60, sun_at(40, 60), {{"sun_red", 3}, {"sun_green", 3}, {"sun_blue", 3}});
  EXPECT_LT(worst(picture(scene, "per_vertex", 16), picture(scene, "march_8", 16), 1e-3f), 0.02);
}

TEST_P(Atmosphere, EveryVariantIsFiniteUnderEverySun) {
  for (const VariantManifest& made : library().effect("atmosphere").variants)
    for (const double sun : {0.0, 90.0, 100.0, 180.0}) {
      SCOPED_TRACE(made.name + " " + std::to_string(sun));
      expect_finite(picture(sky(85, sun_at(sun)), made.name, 8));
    }
}

TEST(AtmosphereBackends, AgreeAndHaveNoNaN) {
  const std::map<std::string, double> bright = {{"sun_red", 3}, {"sun_green", 3}, {"sun_blue", 3}};
  Scene wall = square_in_air({0.4f, 0.5f, 0.6f}, {{"density", 200}}, sun_at(70, -60));
  wall.views[0].eye = {3, 2, 12}, wall.views[0].target = {0, 0.3f, 0};
  expect_backends_agree("atmosphere", {wall, sky(75, sun_at(60), bright, 600, 60), sky(89, sun_at(88, 20), bright, 2, 30)}, 32);
}

TEST(AtmosphereScenes, TheFilesLoadAndCallForIt) {
  // valley_noon says the same of a scene that takes ten times as long to make.
  for (const char* name : {"ridges_low_sun", "sky"}) {
    const std::string file = fmt::format("{}/variants/atmosphere/scenes/{}.toml", LAMINA_SOURCE_DIR, name);
    const Scene scene = load_scene(file, builtin_library());
    const Plan plan = make_plan(builtin_library(), scene);
    EXPECT_TRUE(plan.of("atmosphere")->called_for) << name;
    EXPECT_EQ(scene.background, glm::vec3(0)) << name;
  }
  const Scene ridges = load_scene("far_ridges", builtin_library());
  EXPECT_EQ(ridges.effects.at("atmosphere").numbers.at("sun_red"), 2);
  EXPECT_EQ(ridges.effects.at("atmosphere").numbers.at("top"), 100000);
}

// One message with file and line.
TEST(AtmosphereScenes, MistakesAreRefused) {
  const Folder folder;
  const auto refused = [&](const std::string& says, const std::string& why) {
    const std::filesystem::path file = folder.write("air.toml", "[scene]\nbuiltin = \"open_plane\"\n" + says + "\n");
    try {
      load_scene(file.string(), builtin_library());
      ADD_FAILURE() << says;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(file.string() + ":4"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
  };
  refused("[effects.atmosphere]\nmie.g = 1", "0.999");
  refused("[effects.atmosphere]\ndensity = -1", "0");
  refused("[effects.atmosphere]\nturbidity = 3", "density");
  refused("[views.near]\nfar = 1\neye = [0, 1, 1]\ntarget = [0, 0, 0]",
          "'far'");  // planes are fitted, so none lies before another
}

INSTANTIATE_TEST_SUITE_P(Backends, Atmosphere, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
