// SPDX-License-Identifier: Apache-2.0
// Transparent layers against values worked out by hand, on every backend.
#include <gtest/gtest.h>

#include "harness/quality/quality.h"
#include "tests/effects/glass_scenes.h"

namespace lamina {
namespace {

const char* const order_free[] = {"weighted_blended", "weighted_blended_printed", "weighted_saturated", "moments_4"};

class TransparentLayers : public GlassOnEachBackend {
 protected:
  void expect_near(const Image& picture, glm::vec3 expected, float error, const std::string& what) {
    const glm::vec3 found = pixel(picture, picture.width / 2, picture.height / 2);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], error) << what << " " << c;
  }
};

TEST_P(TransparentLayers, PeelingIsExactForEveryNumberOfLayers) {
  const glm::vec3 lights[] = {{0.6f, 0.1f, 0.1f}, {0.55f, 0.3f, 0.05f}, {0.5375f, 0.2875f, 0.1f}, {0.65f, 0.4f, 0.2125f}};
  const float through[] = {0.5f, 0.25f, 0.1875f, 0.046875f};
  for (size_t count = 1; count <= 4; ++count) {
    std::vector<Sheet> sheets = four_sheets();
    sheets.resize(count);
    std::ranges::reverse(sheets);  // the order of objects is no matter
    const std::string what = std::to_string(count);
    expect_near(glass(glass_sheets(sheets, glm::vec3(0.2f)), "depth_peeling"), lights[count - 1], half_error, what);
    const glm::vec3 dark = pixel(glass(glass_sheets(sheets, glm::vec3(0)), "depth_peeling"), 8, 8);
    expect_near(glass(glass_sheets(sheets, glm::vec3(1)), "depth_peeling"), dark + through[count - 1], half_error, what);
  }
}

TEST_P(TransparentLayers, TheOrderInDepthMatters) {
  std::vector<Sheet> sheets = four_sheets();
  for (size_t i = 0; i < 4; ++i) sheets[i].z = 8 - 2 * float(i);
  expect_near(glass(glass_sheets(sheets, glm::vec3(0.2f)), "depth_peeling"), {0.80625f, 0.853125f, 0.821875f}, half_error, "");
}

TEST_P(TransparentLayers, OneLayerIsExactByEveryMethodWithoutNoise) {
  for (const auto& [opacity, z] : {std::pair(0.5, 2.0f), {0.02, 5.0f}, {0.95, 60.0f}}) {
    const Scene scene = glass_sheets({{opacity, {0.25f, 1, 0}, z}}, {1, 0.5f, 0.25f});
    const Image exact = glass(scene, "depth_peeling");
    const glm::vec3 layer = pixel(exact, 8, 8);
    EXPECT_NEAR(layer.g, opacity + (1 - opacity) * 0.5, half_error);
    for (const VariantManifest& each : library().effect("transparency").variants)
      if (!each.name.starts_with("stochastic"))
        expect_near(glass(scene, each.name), layer, 2 * half_error, each.name + " " + std::to_string(opacity));
  }
}

TEST_P(TransparentLayers, BlendedWeightsGiveTheirPrintedSums) {
  const Scene scene = glass_sheets(four_sheets(), glm::vec3(0.2f));
  const glm::vec3 by_equation[] = {{0.77584f, 0.27187f, 0.12254f},
                                   {0.85297f, 0.14003f, 0.04561f},
                                   {0.67329f, 0.66978f, 0.49063f},
                                   {0.85663f, 0.15650f, 0.06507f}};
  for (const std::string name : {"weighted_blended", "weighted_blended_printed"})
    for (int i = 0; i < 4; ++i)
      expect_near(glass(scene, name, 16, {{name + ".weight", i}}), by_equation[i], 0.003f, name + std::to_string(i + 7));
  expect_near(glass(scene, "weighted_saturated"), {0.60508f, 0.60508f, 0.48594f}, 0.003f, "a plain average");
  std::vector<Sheet> two = four_sheets();
  two.resize(2);
  const Scene pair = glass_sheets(two, glm::vec3(0.2f));
  expect_near(glass(pair, "weighted_blended"), {0.64999f, 0.20001f, 0.05f}, 0.003f, "two layers");
  expect_near(glass(pair, "weighted_saturated"), {0.425f, 0.425f, 0.05f}, 0.003f, "two layers, averaged");
}

TEST_P(TransparentLayers, MomentsComeNearerThanWeights) {
  const Scene scene = glass_sheets(four_sheets(), glm::vec3(0.2f));
  const glm::vec3 exact(0.65f, 0.4f, 0.2125f);
  const auto error = [&](const std::string& name) { return glm::length(pixel(glass(scene, name), 8, 8) - exact); };
  EXPECT_LT(error("moments_4"), 0.12f);
  for (const char* name : {"weighted_blended", "weighted_saturated", "single_layer"})
    EXPECT_GT(error(name), error("moments_4") + 0.03f) << name;
}

TEST_P(TransparentLayers, AnOpaqueFrontHidesAllButFromWeights) {
  // A little less than 1 everywhere, so that it is no plain opaque object.
  const std::vector<Sheet> sheets = {{0.9999, {1, 0, 0}, 2}, {0.9, {0, 1, 0}, 2.5f}};
  const Scene scene = glass_sheets(sheets, glm::vec3(0, 0, 1));
  for (const char* name : {"depth_peeling", "single_layer", "moments_4", "checkerboard_mean", "quad_stipple", "stochastic_16"})
    expect_near(glass(scene, name), {1, 0, 0}, 0.02f, name);
  for (const char* name : {"weighted_blended", "weighted_saturated"})
    EXPECT_GT(pixel(glass(scene, name), 8, 8).g, 0.2f) << name;
}

// 22 layers of weight 3000 and colour 1 are more than 65504.
TEST_P(TransparentLayers, SumsOverflowAsPrintedAndHoldByDefault) {
  std::vector<Sheet> sheets;
  for (int i = 0; i < 30; ++i) sheets.push_back({0.9998, {1, 0.25f, 0}, 0.2f + 0.002f * float(i)});
  const Scene scene = glass_sheets(sheets, glm::vec3(0));
  expect_near(glass(scene, "weighted_blended"), {1, 0.25f, 0}, 0.01f, "scaled");
  const Image printed = glass(scene, "weighted_blended_printed");
  EXPECT_TRUE(count_nonfinite(printed) > 0 || std::abs(pixel(printed, 8, 8).g - 0.25f) > 0.05f)
      << "sums that stop at 65504, or become infinite: " << pixel(printed, 8, 8).g;
  sheets.resize(20);
  expect_near(glass(glass_sheets(sheets, glm::vec3(0)), "weighted_blended_printed"), {1, 0.25f, 0}, 0.01f, "20 fit");
}

TEST_P(TransparentLayers, StochasticSamplesAreRightInTheMean) {
  const Scene scene = glass_sheets(four_sheets(), glm::vec3(0.2f));
  const glm::vec3 exact(0.65f, 0.4f, 0.2125f);
  for (const auto& [name, samples] : {std::pair("stochastic_4", 4), {"stochastic_16", 16}}) {
    const Image picture = glass(scene, name, 64);
    glm::dvec3 sum(0), squares(0);
    for (size_t i = 0; i < 4096; ++i)
      for (int c = 0; c < 3; ++c) {
        const double value = double(picture.rgba[4 * i + size_t(c)]);
        sum[c] += value / 4096, squares[c] += value * value / 4096;
      }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], exact[c], 0.02) << name;
    // Red is 1 (the first and the last sheet), 0, or 0.2: by hand 0.3 + 0.7 * ...; a sample's variance over their number.
    const double variance = squares.r - sum.r * sum.r, one = 0.640625 + 0.046875 * 0.04 - 0.65 * 0.65;
    EXPECT_NEAR(variance, one / samples, 0.2 * one / samples) << name;
  }
  EXPECT_NEAR(pixel(glass(glass_sheets({{0.4, {1, 1, 1}, 3}}, glm::vec3(0)), "stochastic_16_corrected"), 8, 8).r, 0.4,
              half_error)
      << "the opacity of all layers is exact";
}

// Only the nearest layer: the others vanish, what is opaque stays.
TEST_P(TransparentLayers, SingleLayersKeepTheNearest) {
  const Scene scene = glass_sheets(four_sheets(), glm::vec3(0.2f));
  for (const char* name :
       {"single_layer", "checkerboard_mean", "checkerboard_directed", "checkerboard_twelve", "quad_stipple"}) {
    const Image picture = glass(scene, name);
    for (int i = 3; i < 13; ++i)
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixel(picture, i, 8)[c], c == 0 ? 0.6f : 0.1f, half_error) << name << " " << i;
  }
}

TEST_P(TransparentLayers, WhatIsNotTransparentIsLeftOut) {
  const Scene with = glass_sheets({{0, {1, 0, 0}, 2}}, glm::vec3(0.2f));
  EXPECT_FALSE(make_plan(library(), with).of("transparency")->called_for) << "an opacity of 0";
  Scene masked = with;
  masked.objects[0].effects.at("transparency").numbers["opacity"] = 0.5;
  masked.objects[0].effects.at("transparency").textures["transparent_color"] =
      constant_texture("clear", {1, 1, 1, 0}, TexelMeaning::colour);
  settle_facts(masked.objects[0], library().effect("transparency"));
  EXPECT_FALSE(make_plan(library(), masked).of("transparency")->called_for) << "a mask of 0";
  const Scene whole = glass_sheets({{1, {1, 0, 0}, 2}, {1, {0, 1, 0}, 4}}, glm::vec3(0.2f));
  for (const VariantManifest& each : library().effect("transparency").variants) {
    const auto made = drawing(whole, each.name, 16);
    ASSERT_EQ(made->graph.passes.size(), 1u) << each.name;
    EXPECT_EQ(made->graph.passes[0].pass->name, "opaque");
    EXPECT_EQ(pixel(made->frame.picture(), 8, 8), glm::vec3(1, 0, 0)) << each.name;
  }
  // One is opaque, one is not: the opaque one is no layer.
  const Scene mixed = glass_sheets({{0.5, {1, 0, 0}, 2}, {1, {0, 1, 0}, 4}}, glm::vec3(0.2f));
  for (const VariantManifest& each : library().effect("transparency").variants) {
    const auto made = drawing(mixed, each.name, 16);
    EXPECT_EQ(made->graph.passes[0].pass->name, "opaque");
    if (!each.name.starts_with("stochastic")) expect_near(made->frame.picture(), {0.5f, 0.5f, 0}, 2 * half_error, each.name);
  }
}

TEST_P(TransparentLayers, NothingShowsBehindWhatIsOpaque) {
  const Scene scene = glass_sheets({{1, {1, 0, 0}, 2}, {0.5, {0, 1, 0}, 4}}, glm::vec3(0.2f));
  for (const VariantManifest& each : library().effect("transparency").variants)
    expect_near(glass(scene, each.name), {1, 0, 0}, half_error, each.name);
}

// Light and eye straight before the sheet: Lambert's 1 and Blinn's (10 + 8) / 8.
TEST_P(TransparentLayers, HighlightsAreNormalised) {
  Scene scene = glass_sheets({{0.5, {0.25f, 0.25f, 0.25f}, 2}}, glm::vec3(0));
  scene.ambient = glm::vec3(0);
  Light lamp;
  lamp.direction = {0, 0, -1};
  scene.lights = {lamp};
  auto& numbers = scene.objects[0].effects.at("transparency").numbers;
  numbers["specular"] = 1, numbers["gloss"] = 10;
  for (const char* name : {"depth_peeling", "single_layer", "checkerboard_mean", "quad_stipple"})
    expect_near(glass(scene, name, 33), glm::vec3(0.5f * (0.25f + 2.25f)), 0.01f, name);
}

TEST_P(TransparentLayers, MoreLayersThanTheLimitAreSaid) {
  std::vector<Sheet> sheets;
  for (int i = 0; i < 20; ++i) sheets.push_back({0.05, {1, 1, 1}, 2 + 0.1f * float(i)});
  const Scene scene = glass_sheets(sheets, glm::vec3(0));
  const auto limited = drawing(scene, "depth_peeling", 16);
  ASSERT_EQ(limited->frame.unfinished(0).size(), 1u);
  EXPECT_EQ(limited->frame.unfinished(0)[0]->pass->name, "peel");
  expect_near(limited->frame.picture(), glm::vec3(float(1 - std::pow(0.95, 16))), half_error, "the nearest 16");
  const auto all = drawing(scene, "depth_peeling", 16, {{"depth_peeling.layers", 24}});
  EXPECT_TRUE(all->frame.unfinished(0).empty());
  expect_near(all->frame.picture(), glm::vec3(float(1 - std::pow(0.95, 20))), half_error, "all 20");
}

INSTANTIATE_TEST_SUITE_P(Backends, TransparentLayers, api_parameters, backend_test_name);

TEST(Compositing, GoesFrontToBackAsFarAsAsked) {
  std::vector<PremultipliedLayer> layers;
  for (const Sheet& sheet : four_sheets()) layers.push_back({glm::dvec3(sheet.color) * sheet.opacity, sheet.opacity});
  const auto over = [&](size_t kept) {
    const LayersLight found = composited(layers, kept);
    return found.light + found.through * 0.2;
  };
  EXPECT_NEAR(glm::length(over(0) - glm::dvec3(0.65, 0.4, 0.2125)), 0, 1e-12);
  EXPECT_NEAR(glm::length(over(2) - glm::dvec3(0.55, 0.3, 0.05)), 0, 1e-12);
  EXPECT_NEAR(composited(layers, 0).through, 0.046875, 1e-12);
  EXPECT_EQ(composited({}, 0).through, 1);
}

}  // namespace
}  // namespace lamina
