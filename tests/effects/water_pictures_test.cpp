// SPDX-License-Identifier: Apache-2.0
// Water's pictures against closed forms: a still pool over a level bottom, its edge, its light by distance; what is left out;
// numbers that nothing good can come of; and the truth's rays.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "harness/effects/water/water_light.h"
#include "harness/effects/water/water_rays.h"
#include "harness/effects/water/waves.h"
#include "harness/scene/made/water_grid.h"
#include "harness/scene/place_objects.h"
#include "tests/effects/backends_agree.h"
#include "tests/effects/hair_scenes.h"
#include "tests/scene/made_files.h"

namespace lamina {
namespace {

constexpr uint32_t water_size = 48;
// What 8-bit codes of sRGB hold: about 0.6, 0.5 and 0.4.
float light_of_code(float code) { return std::pow((code / 255 + 0.055f) / 1.055f, 2.4f); }
const glm::vec3 bottom_albedo(light_of_code(203), light_of_code(188), light_of_code(170));
constexpr glm::vec3 sky_light(0.2f, 0.3f, 0.5f), sun_light(0.9f, 0.8f, 0.7f), around(0.3f, 0.35f, 0.4f);

using Numbers = std::map<std::string, double>;

// Still water over a level bottom of one colour, seen from `above_m` straight down, or at a slant.
Scene still_pool(double depth_m, const Numbers& numbers = {}, bool slant = false) {
  Scene scene;
  std::vector<Object> objects;
  objects.push_back(water_object(scene, water_rectangle({-6, -6}, {6, 6}, 0.25f), 0.25f, 0));
  Object bottom;
  bottom.name = "bottom";
  bottom.mesh = water_rectangle({-60, -60}, {60, 60}, 10);
  bottom.world_from_object[3] = glm::vec4(0, -depth_m, 0, 1);
  bottom.said.values = {{"albedo", {bottom_albedo}}};
  objects.push_back(std::move(bottom));
  Keys said = std::move(scene.said["water"]);
  for (const auto& [name, value] :
       Numbers{{"wave_1_amplitude", 0}, {"wave_2_amplitude", 0}, {"caustics", 0}, {"specular", 0}, {"soft_edge", 0}})
    said.values[name] = {value};
  for (const auto& [name, value] : numbers) said.values[name] = {value};
  scene = declared_scene(std::move(objects));
  scene.said["water"] = std::move(said);
  declare_said(scene, builtin_library());
  scene.lights.push_back({"sun", Light::Kind::directional, glm::normalize(glm::vec3(-0.4f, -0.8f, 0.2f)), {}, sun_light});
  scene.ambient = around, scene.background = sky_light;
  View& view = scene.views[0];
  view.fov_y_degrees = 30, view.near_m = 0.1f, view.far_m = 200;
  view.eye = slant ? glm::vec3(0, 1.5f, 5) : glm::vec3(0, 4, 0), view.target = glm::vec3(0, 0, 0);
  view.up = slant ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
  return scene;
}

Numbers waves_on(Numbers numbers = {}) {
  numbers.insert({{"wave_1_amplitude", 0.02},
                  {"wave_1_length", 2.1},
                  {"wave_1_steepness", 0.1},
                  {"wave_2_amplitude", 0.015},
                  {"wave_2_length", 1.4}});
  return numbers;
}

// What still water shows of a level bottom, by the formulas: a ray that comes at this angle to the vertical.
glm::dvec3 still_light(double depth_m, double angle, bool reflects = true) {
  const double n = 1.333, inside = std::asin(std::sin(angle) / n), way = depth_m / std::cos(inside);
  const glm::dvec3 to_sun = -glm::normalize(glm::dvec3(-0.4, -0.8, 0.2));
  const double sun_cosine = std::sqrt(1 - (1 - to_sun.y * to_sun.y) / (n * n));
  const glm::dvec3 b(.012, .014, .016), c = glm::dvec3(.30, .049, .002) + b;
  const double share = reflects ? reflected_by_water(std::cos(angle), n) : 0;
  glm::dvec3 light;
  for (int i = 0; i < 3; ++i) {
    const double e = double(sun_light[i]), k = c[i] * (1 + std::cos(inside) / sun_cosine),
                 k_sky = c[i] * (1 + std::cos(inside) / .83);
    const double bottom =
        double(bottom_albedo[i]) *
        (e * to_sun.y * std::exp(-c[i] * depth_m / sun_cosine) + double(around[i]) * std::exp(-c[i] * depth_m / .83)) *
        std::exp(-c[i] * way);
    const double in =
        b[i] / 4 * e * to_sun.y / sun_cosine * (1 - reflected_by_water(to_sun.y, n)) * (1 - std::exp(-k * way)) / k +
        b[i] / 2 * .9336 * double(around[i]) * (1 - std::exp(-k_sky * way)) / k_sky;
    light[i] = (1 - share) * (bottom + in) + share * double(sky_light[i]);
  }
  return light;
}

// In radians, of a pixel seen straight down from still_pool's eye.
double angle_of(int x, int y) {
  const double half = std::tan(15 * std::numbers::pi / 180), middle = water_size / 2.0;
  return std::atan(half * std::hypot(x + .5 - middle, y + .5 - middle) / middle);
}

double decibels(const Image& a, const Image& b) { return psnr_db(to_display(a), to_display(b)); }

class WaterPictures : public EachBackend {
 protected:
  Image seen(const Scene& scene, std::string_view name) { return picture(scene, name, water_size); }
  // `own`, the baseline's picture of the first view, by the truth where it has an answer.
  Image truth_of(const Scene& scene, size_t rays, const Image& own) {
    const VariantManifest& baseline = variant("full");
    const auto size = static_cast<uint32_t>(own.width);
    DrawnFrame drawn(*backend_, library(), scene,
                     {.variant = &baseline, .width = size, .height = size, .told = &baseline, .aspect = 1});
    const auto targets = drawn.frame.targets_of(baseline);
    DiskCache cache("");
    const TruthAnswer answer =
        water_rays({scene, drawn.bakes.occluders(), cache, rays})->answer({targets, scene.views[0], {}}, [](double) {});
    EXPECT_FALSE(answer.pixels.empty());
    Image image = own;
    for (size_t i = 0; i < answer.pixels.size(); ++i)
      for (int c = 0; c < 3; ++c) image.rgba[4 * answer.pixels[i] + size_t(c)] = answer.steps.back().light[i][c];
    return image;
  }
};

TEST_P(WaterPictures, StillWaterIsAClosedForm) {
  for (const double depth : {0.5, 2.0}) {
    const Image image = seen(still_pool(depth), "full");
    for (const auto& [x, y] : {std::pair(24, 24), {30, 10}, {44, 40}, {3, 24}}) {
      const glm::dvec3 right = still_light(depth, angle_of(x, y));
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(double(pixel(image, x, y)[c]), right[c], 1.5e-3) << depth << " " << x << " " << c;
    }
  }
}

// Where there is no depth, water shows the bottom and what is reflected; with a soft edge the bottom alone.
TEST_P(WaterPictures, TheEdgeIsTheBottom) {
  const Image hard = seen(still_pool(1e-3), "full"), soft = seen(still_pool(1e-3, {{"soft_edge", 1}}), "full");
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(double(pixel(hard, 24, 24)[c]), still_light(0, 0)[c], 2e-3) << c;
    EXPECT_NEAR(double(pixel(soft, 24, 24)[c]), still_light(0, 0, false)[c], 2e-3) << c;
  }
}

// The exponentials of the water's colour at 5 m, against the spectrum's: red is 0.18 there, blue 0.99.
TEST_P(WaterPictures, FiveMetresTakeTheRed) {
  const Numbers clear = {{"scattering", 0}};
  const glm::vec3 shallow = pixel(seen(still_pool(1e-3, clear), "full"), 24, 24),
                  deep = pixel(seen(still_pool(2.27, clear), "full"), 24, 24);
  // 2.27 m down and up again by sun (cosine 0.92) and sky are about 5 m.
  EXPECT_NEAR(double(deep.r / shallow.r), .24, .03);
  EXPECT_NEAR(double(deep.g / shallow.g), .79, .02);
  EXPECT_NEAR(double(deep.b / shallow.b), .99, .005);
}

// On still water every reflected ray is seen in the same place, however far it goes.
TEST_P(WaterPictures, StillWaterReflectsTheSameAtAnyDistance) {
  Scene scene = still_pool(2, {}, true);
  Object post;
  post.name = "post";
  post.mesh = water_rectangle({-0.5f, -0.5f}, {0.5f, 0.5f}, 1);
  post.world_from_object = glm::mat4({1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1.5f, 0, 0}, {0.2f, 0.7f, -3, 1});
  post.said.values = {{"albedo", {glm::vec3(0.9f, 0.1f, 0.1f)}}};
  Scene made = declared_scene({std::move(post)});
  scene.objects.push_back(std::move(made.objects[0]));
  const Image by_depth = seen(scene, "full");
  EXPECT_GT(decibels(by_depth, seen(scene, "direction_only")), 55);
  EXPECT_GT(decibels(by_depth, seen(scene, "guessed_distance")), 55);
  EXPECT_LT(decibels(by_depth, seen(scene, "sky_map")), 40) << "the post is reflected";
}

// Points that the device drew are the host's.
TEST_P(WaterPictures, TheVertexShaderAndTheHostHaveTheSameWaves) {
  Scene scene = still_pool(2, waves_on({{"wave_3_amplitude", 0.03}, {"wave_3_length", 3}, {"wave_3_steepness", 0.3}}));
  scene.time_s = 1.7f;
  const VariantManifest& baseline = variant("full");
  DrawnFrame drawn(*backend_, library(), scene,
                   {.variant = &baseline, .width = water_size, .height = water_size, .told = &baseline, .aspect = 1});
  const Image told = drawn.frame.targets_of(baseline).at("seen_ground");
  const GerstnerWaves waves(scene.effects.at("water"));
  double worst = 0, highest = 0;
  size_t checked = 0;
  for (size_t i = 0; i < told.rgba.size(); i += 4) {
    if (!(told.rgba[i + 3] > 0)) continue;
    const double height = waves.at({told.rgba[i], told.rgba[i + 1]}, 1.7f).position.y;
    worst = std::max(worst, std::abs(height - double(told.rgba[i + 2]))), highest = std::max(highest, std::abs(height));
    ++checked;
  }
  EXPECT_EQ(checked, size_t(water_size * water_size));
  EXPECT_GT(highest, 0.03);
  EXPECT_LT(worst, 6e-3) << "edges of 0.25 m cut off waves of 1.4 m by this at most";
}

TEST_P(WaterPictures, WhatIsNotAskedForIsLeftOut) {
  const auto passes_of = [&](const Scene& scene, const char* name) {
    const Plan plan = make_plan(library(), scene, 1);
    ShaderCache shaders(backend_->info().api, library().shaders);
    std::set<std::string> names;
    for (const GraphPass& pass : make_graph(plan, configuration_with(plan, variant(name)), scene, shaders).passes)
      names.insert(pass.pass->name);
    return names;
  };
  const Scene scene = still_pool(2);
  EXPECT_TRUE(passes_of(scene, "full").contains("mirror"));
  EXPECT_FALSE(passes_of(scene, "full").contains("told"));
  EXPECT_FALSE(passes_of(scene, "sky_map").contains("mirror"));
  EXPECT_FALSE(passes_of(scene, "sky_map").contains("mirror_blur"));
  Scene away = still_pool(2);
  away.views[0].target = {0, 20, 0}, away.views[0].eye = {0, 10, 0};
  EXPECT_FALSE(make_plan(library(), away, 1).of("water")->called_for) << "no view sees it";
  // A feature whose number is next to nothing shows the same as one that is left out.
  const Image none = seen(still_pool(1.5), "full");
  for (const auto& [name, value] : Numbers{{"wave_3_amplitude", 1e-9},
                                           {"caustics", 1e-9},
                                           {"specular", 1e-9},
                                           {"foam", 1e-9},
                                           {"ripples", 1e-9},
                                           {"dispersion", 1e-9},
                                           {"bottom_depth", 1e4},
                                           {"soft_edge", 1e-3}})
    EXPECT_GT(decibels(none, seen(still_pool(1.5, {{name, value}}), "full")), 70) << name;
}

// Whatever the numbers, light is finite and not below 0.
TEST_P(WaterPictures, HostileNumbersAreBounded) {
  std::vector<Scene> scenes;
  Numbers steep = waves_on();
  for (int i = 1; i <= 4; ++i) steep[fmt::format("wave_{}_steepness", i)] = 1, steep[fmt::format("wave_{}_amplitude", i)] = 0.3;
  scenes.push_back(still_pool(1, steep, true));
  scenes.push_back(still_pool(
      1, {{"wave_1_amplitude", 1000}, {"wave_1_length", 0.01}, {"specular", 100}, {"foam", 1}, {"foam_height", 0.001}}, true));
  scenes.push_back(still_pool(1, {{"absorption_red", 1e4}, {"scattering", 1e4}, {"scattering_g", -0.95}}, true));
  scenes.push_back(
      still_pool(1, {{"absorption_red", 0}, {"absorption_blue", 0}, {"scattering", 0}, {"refraction_index", 1.0001}}, true));
  Scene below = still_pool(2, waves_on(), true);
  below.views[0].eye = {0, -1, 3}, below.views[0].target = {0, 0.3f, -1};
  scenes.push_back(below);
  Scene night = still_pool(1, waves_on({{"specular", 1}, {"caustics", 1}}), true);
  night.lights[0].direction = glm::normalize(glm::vec3(0.3f, 0.5f, 0));
  scenes.push_back(night);
  Scene dark = still_pool(1, waves_on({{"specular", 1}}), true);
  dark.lights.clear();
  scenes.push_back(dark);
  for (size_t i = 0; i < scenes.size(); ++i)
    for (const char* name : {"full", "cheapest", "rough_fresnel"}) {
      const Image image = seen(scenes[i], name);
      EXPECT_EQ(nonfinite_pixels(image), 0u) << i << " " << name;
      EXPECT_GE(*std::ranges::min_element(image.rgba), 0) << i << " " << name;
    }
}

// The truth of still water is the closed form too.
TEST_P(WaterPictures, TheTruthIsTheClosedFormOnStillWater) {
  const Scene scene = still_pool(2);
  const Image truth = truth_of(scene, 4, seen(scene, "full"));
  for (const auto& [x, y] : {std::pair(24, 24), {44, 40}})
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(double(pixel(truth, x, y)[c]), still_light(2, angle_of(x, y))[c], 1e-3);
}

// On waves the baseline is near the truth, and nearer than what gives up much.
TEST_P(WaterPictures, TheBaselineIsNearTheTruth) {
  constexpr uint32_t size = 96;
  Scene scene = load_scene("pool", builtin_library());
  for (const char* view : {"above", "grazing"}) {
    std::erase_if(scene.views, [&](const View& other) {
      return scene.views.size() > 1 && other.name == (std::string(view) == "above" ? "edge" : "above");
    });
    ASSERT_EQ(scene.views[0].name, view);
    const Image own = picture(scene, "full", size), truth = truth_of(scene, 9, own);
    EXPECT_GT(decibels(own, truth), 24) << view;
    EXPECT_LT(decibels(picture(scene, "cheapest", size), truth) + 4, decibels(own, truth)) << view;
  }
}

// A red ball's edges are colour fringes where colours are bent apart.
TEST_P(WaterPictures, DispersionBendsColoursApart) {
  const auto scene_with = [](double factor) { return still_pool(2, {{"dispersion", factor}}, true); };
  const Image none = seen(scene_with(0), "full"), some = seen(scene_with(1), "full");
  EXPECT_GT(decibels(none, some), 50) << "over an even bottom no colour moves";
}

// The truth's steps: what is left when the device's own pictures are kept, and when they are dropped one after the other.
TEST_P(WaterPictures, TheTruthTellsWhatCosts) {
  Scene scene = load_scene("beach", builtin_library(), 0.4f);
  const VariantManifest& baseline = variant("full");
  DrawnFrame drawn(*backend_, library(), scene,
                   {.variant = &baseline, .width = 64, .height = 64, .told = &baseline, .aspect = 1});
  const auto targets = drawn.frame.targets_of(baseline);
  DiskCache cache("");
  const TruthAnswer answer =
      water_rays({scene, drawn.bakes.occluders(), cache, 4})->answer({targets, scene.views[0], {}}, [](double) {});
  ASSERT_EQ(answer.steps.size(), 3u);
  EXPECT_GT(answer.pixels.size(), 1000u);
  for (const TruthStep& step : answer.steps)
    for (const glm::vec3& light : step.light)
      ASSERT_TRUE(std::isfinite(light.r + light.g + light.b) && light.r >= 0) << step.name;
}

TEST(WaterBackends, AgreeAndHaveNoNaN) {
  const auto at = [](const char* scene) { return load_scene(scene, builtin_library(), 0.7f); };
  expect_backends_agree("water", {at("beach")});  // which has all that water can have
  expect_backends_agree("water", {at("pool"), at("open_sea")}, 48, {}, /*baseline_alone=*/true);
}

TEST(WaterNumbers, AreRefusedOutsideTheirRanges) {
  const Folder folder;
  for (const char* line : {"wave_1_length = 0", "wave_1_steepness = 1.1", "wave_2_amplitude = -1", "absorption_red = -0.1",
                           "refraction_index = 1"}) {
    const std::string file =
        folder.write("sea.toml", std::string("[scene]\nbuiltin = \"pool\"\n[effects.water]\n") + line + "\n").string();
    const std::string key = std::string(line).substr(0, std::string(line).find(' '));
    expect_refused([&] { load_scene(file, builtin_library()); }, {"sea.toml:4:", key});
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, WaterPictures, backend_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
