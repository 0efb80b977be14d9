// SPDX-License-Identifier: Apache-2.0
// Water's pictures against closed forms: a still pool over a level bottom, its edge, its light by distance; what is left out;
// numbers that nothing good can come of; and the truth's rays.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "harness/effects/water/water_light.h"
#include "harness/effects/water/water_rays.h"
#include "harness/effects/water/waves.h"
#include "tests/effects/backends_agree.h"
#include "tests/effects/water_scenes.h"
#include "tests/scene/made_files.h"

namespace lamina {
namespace {

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
  const WaterNumbersSaid clear = {{"scattering", 0}};
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
  EXPECT_FALSE(passes_of(scene, "full").contains("splash_step"));
  Scene away = still_pool(2);
  away.views[0].target = {0, 20, 0}, away.views[0].eye = {0, 10, 0};
  EXPECT_FALSE(make_plan(library(), away, 1).of("water")->called_for) << "no view sees it";
  // Features whose numbers are next to nothing show the same as ones that are left out.
  const WaterNumbersSaid hardly = {{"wave_3_amplitude", 1e-9}, {"caustics", 1e-9},   {"specular", 1e-9}, {"foam", 1e-9},
                                   {"ripples", 1e-9},          {"dispersion", 1e-9}, {"splashes", 1e-9}, {"bottom_depth", 1e4},
                                   {"soft_edge", 1e-3}};
  EXPECT_GT(decibels(seen(still_pool(1.5), "full"), seen(still_pool(1.5, hardly), "full")), 70);
}

// Whatever the numbers, light is finite and not below 0.
TEST_P(WaterPictures, HostileNumbersAreBounded) {
  std::vector<Scene> scenes;
  WaterNumbersSaid steep = waves_on();
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
  const auto is_bounded = [&](size_t i, const char* name) {
    const Image image = picture(scenes[i], name, 24);
    EXPECT_EQ(nonfinite_pixels(image), 0u) << i << " " << name;
    EXPECT_GE(*std::ranges::min_element(image.rgba), 0) << i << " " << name;
  };
  for (size_t i = 0; i < scenes.size(); ++i) is_bounded(i, "full");
  is_bounded(0, "rough_fresnel"), is_bounded(1, "cheapest"), is_bounded(0, "area_caustics"), is_bounded(0, "fft");
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
  constexpr uint32_t size = 80;
  Scene scene = load_scene("pool", builtin_library());
  for (const char* view : {"above", "grazing"}) {
    std::erase_if(scene.views, [&](const View& other) {
      return scene.views.size() > 1 && other.name == (std::string(view) == "above" ? "edge" : "above");
    });
    ASSERT_EQ(scene.views[0].name, view);
    const Image own = picture(scene, "full", size), truth = truth_of(scene, 4, own);
    EXPECT_GT(decibels(own, truth), 29) << view;
    EXPECT_LT(decibels(picture(scene, "cheapest", size), truth) + 4, decibels(own, truth)) << view;
  }
}

// Beyond an edge across the view the bottom is black: red, which is bent less, sees it from another row than blue.
TEST_P(WaterPictures, DispersionBendsColoursApart) {
  constexpr double depth = 2, edge_z = -1.5, factor = 30;
  Scene scene = still_pool(
      depth,
      {{"dispersion", factor}, {"absorption_red", 0}, {"absorption_green", 0}, {"absorption_blue", 0}, {"scattering", 0}},
      true);
  scene.background = glm::vec3(0);
  Object far;
  far.name = "far";
  far.mesh = water_rectangle({-60, -60}, {60, float(edge_z)}, 10);
  far.world_from_object[3] = glm::vec4(0, 0.005 - depth, 0, 1);
  far.said.values = {{"albedo", {glm::vec3(0)}}};
  Scene made = declared_scene({std::move(far)});
  scene.objects.push_back(std::move(made.objects[0]));
  const Image image = seen(scene, "full");
  // The row, between pixels, where a channel is half as bright as well below.
  const auto row_of = [&](int channel) {
    const float half = 0.5f * pixel(image, 24, 46)[channel];
    for (int y = 45; y > 0; --y)
      if (pixel(image, 24, y)[channel] < half)
        return y + double((half - pixel(image, 24, y)[channel]) /
                          (pixel(image, 24, y + 1)[channel] - pixel(image, 24, y)[channel]));
    return -1.0;
  };
  // By Snell's law: the eye is 1.5 m over the water, 5 m before the middle, where it looks.
  const auto row_by = [&](double index) {
    double low = 0.2, high = 1.5;
    for (int i = 0; i < 50; ++i) {
      const double angle = (low + high) / 2,
                   lands = 1.5 * std::tan(angle) + depth * std::tan(std::asin(std::sin(angle) / index));
      (lands < 5 - edge_z ? low : high) = angle;
    }
    const double up = low - std::atan2(5, 1.5);
    return 24 * (1 - std::tan(up) / std::tan(15 * std::numbers::pi / 180)) - 0.5;
  };
  const double green = row_by(1.333), red = row_by(1.333 - 0.0025 * factor), blue = row_by(1.333 + 0.0037 * factor);
  ASSERT_GT(std::abs(red - blue), 2) << "rows apart";
  EXPECT_NEAR(row_of(1), green, 0.8);
  EXPECT_NEAR(row_of(0) - row_of(2), red - blue, 0.15 * std::abs(red - blue));
}

// The truth's steps: what is left when the device's own pictures are kept, and when they are dropped one after the other.
TEST_P(WaterPictures, TheTruthTellsWhatCosts) {
  Scene scene = load_scene("beach", builtin_library(), 0.4f);
  const VariantManifest& baseline = variant("full");
  DrawnFrame drawn(*backend_, library(), scene,
                   {.variant = &baseline, .width = 40, .height = 40, .told = &baseline, .aspect = 1});
  const auto targets = drawn.frame.targets_of(baseline);
  DiskCache cache("");
  const TruthAnswer answer =
      water_rays({scene, drawn.bakes.occluders(), cache, 1})->answer({targets, scene.views[0], {}}, [](double) {});
  ASSERT_EQ(answer.steps.size(), 5u);
  EXPECT_GT(answer.pixels.size(), 400u);
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

INSTANTIATE_TEST_SUITE_P(Backends, WaterPictures, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
