// SPDX-License-Identifier: Apache-2.0
// Three and more layers, and the shadows between them, against closed forms: uniform stacks, an edge, a slanted light.
#include <array>
#include <cmath>
#include <random>

#include "tests/effects/backends_agree.h"
#include "tests/graph/each_backend.h"
#include "tests/graph/layer_stacks.h"

namespace lamina {
namespace {

class DeepLayers : public EachBackend {};
INSTANTIATE_TEST_SUITE_P(Backends, DeepLayers, backend_parameters, backend_test_name);

const std::vector<UniformLayer> printed = {{0.8f, 0.3f}, {0.6f, 0.4f}, {0.4f, 0.5f}, {0.9f, 1}};

// 0.3 of 0.8, 0.4 of 0.6 and 0.5 of 0.4 over a base of 0.9.
TEST(DeepLayersByHand, UniformStacksAsWorkedOut) {
  const std::array<std::array<double, 3>, 3> expected = {
      {{0.87, 0.681, 0.8025}, {0.786, 0.51636, 0.619618}, {0.681, 0.43257, 0.476607}}};
  for (size_t n = 2; n <= 4; ++n) {
    std::vector<UniformLayer> sheets(printed.begin(), printed.begin() + ptrdiff_t(n - 1));
    sheets.push_back(printed[3]);
    EXPECT_NEAR(single_bounce(sheets, 0), expected[n - 2][0], 1e-5);
    EXPECT_NEAR(single_bounce(sheets, 1), expected[n - 2][1], 1e-5);
    EXPECT_NEAR(all_bounces(sheets), expected[n - 2][2], 1e-5);
  }
}

TEST_P(DeepLayers, UniformStacksShowWhatTheRuleGives) {
  for (const size_t n : {2, 4}) {
    std::vector<UniformLayer> sheets(printed.begin(), printed.begin() + ptrdiff_t(n - 1));
    sheets.push_back(printed[3]);
    for (const float shadowing : {0.0f, 1.0f})
      for (const std::string_view name :
           {"light_map", "vertex_normal", "one_light_fetch", "shadows_premultiplied", "covered_map"})
        EXPECT_NEAR(pixel(picture(stack_scene(sheets, shadowing), name, 16), 8, 8).r, single_bounce(sheets, double(shadowing)),
                    0.006)
            << name << " " << n << " layers, shadows " << shadowing;
  }
  // A white furnace: without shadows all light comes back, with them the first bounce alone.
  EXPECT_NEAR(pixel(picture(stack_scene({{1, 0.5f}, {1, 1}}, 0), "light_map", 16), 8, 8).r, 1, 0.006);
  EXPECT_NEAR(pixel(picture(stack_scene({{1, 0.5f}, {1, 1}}, 1), "light_map", 16), 8, 8).r, 0.75, 0.006);
}

// Six layers of any kind: nothing shows more than all bounces between them give.
TEST_P(DeepLayers, NoStackShowsMoreThanAllItsBounces) {
  std::mt19937 random(5);
  const auto number = [&] { return float(random() >> 8) * 0x1p-24f; };
  for (int i = 0; i < 2; ++i) {
    std::vector<UniformLayer> sheets;
    for (int n = 0; n < 6; ++n) sheets.push_back({number(), n == 5 ? 1 : number()});
    for (const std::string_view name : {"light_map", "one_light_fetch"}) {
      const double seen = pixel(picture(stack_scene(sheets, 1), name, 16), 8, 8).r;
      EXPECT_LE(seen, all_bounces(sheets) + 0.006) << name << i;
      EXPECT_NEAR(seen, single_bounce(sheets, 1), 0.006) << name << i;
    }
  }
}

// A clear half beside an opaque one: below the clear half at half a radius from the edge a disc sees 1 - (acos x - x sqrt(1 -
// x^2)) / pi = 0.8045 of it clear, beyond the radius all.
TEST_P(DeepLayers, AnEdgesShadowIsAsSoftAsTheDiscIsWide) {
  Scene scene = stack_scene({{0, 0}, {1, 1}}, 1);
  stack_of(scene).numbers["thickness"] = 8;
  stack_of(scene).textures["outer_albedo"] = make_texture(
      "half", filled(64, [](uint32_t x, uint32_t) { return glm::vec4(0, 0, 0, x < 32 ? 1 : 0); }), TexelMeaning::colour);
  for (const auto& [name, off_by] :
       {std::pair("light_map", 0.12), {"ring_disc", 0.08}, {"one_light_fetch", 0.15}, {"shadows_premultiplied", 0.15}}) {
    const Image image = picture(scene, name);
    EXPECT_NEAR(pixel(image, 27, 40).r, 0.838, off_by) << name;  // 4.5 texels from the edge of 8
    EXPECT_NEAR(pixel(image, 16, 40).r, 1, name == std::string("light_map") ? 0.004 : 0.1) << name;
  }
  EXPECT_NEAR(pixel(picture(scene, "shadows_at_center"), 28, 40).r, 1, 0.004);
  EXPECT_NEAR(pixel(picture(scene, "shadows_left_out"), 28, 40).r, 1, 0.004);
}

// Light from 45 degrees on the right comes through the surface as many texels further right as the layer is deep.
TEST_P(DeepLayers, SlantedLightMovesTheShadowByTheDepth) {
  Scene scene = stack_scene({{0, 0}, {1, 1}}, 1);
  stack_of(scene).numbers["thickness"] = 10;
  stack_of(scene).numbers["scattering"] = 0;
  stack_of(scene).textures["outer_albedo"] =
      make_texture("half", filled(64, [](uint32_t x, uint32_t) { return glm::vec4(0, 0, 0, x >= 4 && x < 40 ? 1 : 0); }),
                   TexelMeaning::colour);
  scene.ambient = glm::vec3(0);
  scene.lights.push_back({"low", Light::Kind::directional, glm::normalize(glm::vec3(-1, 0, -1)), {}, glm::vec3(1)});
  for (const std::string_view name : {"light_map", "one_light_fetch", "vertex_normal", "mean_normal", "shadows_at_center"}) {
    const Image image = picture(scene, name);
    EXPECT_NEAR(pixel(image, 27, 32).r, std::sqrt(0.5), 0.01) << name;
    EXPECT_NEAR(pixel(image, 33, 32).r, 0, 0.01) << name;
  }
  EXPECT_NEAR(pixel(picture(scene, "shadows_left_out"), 33, 32).r, std::sqrt(0.5), 0.01);
}

// A layer more is 26 fetches the chapter's way, and 13 more for each layer but the outer one that shades it; by one tap of the
// map 14 and one.
TEST_P(DeepLayers, LayersCostWhatTheirTapsDo) {
  const auto fetches = [&](size_t layers, float shadowing, std::string_view name) {
    std::vector<UniformLayer> sheets(layers, {0.5f, 0.5f});
    DrawnFrame drawn(*backend_, library(), stack_scene(sheets, shadowing),
                     {.variant = &variant(name), .width = 16, .height = 16, .build = Build::counting, .aspect = 1});
    const PassCounts composite = drawn.frame.frame_counts().back();
    return composite.fetches() / composite.fragments;
  };
  for (const uint64_t n : {3, 6}) {
    EXPECT_EQ(fetches(n, 0, "light_map"), 3 + 26 * (n - 1)) << n;
    EXPECT_EQ(fetches(n, 1, "light_map"), 3 + 26 * (n - 1) + 13 * (n - 1) * (n - 2) / 2) << n;
    EXPECT_EQ(fetches(n, 0, "one_light_fetch"), 3 + 14 * (n - 1)) << n;
    EXPECT_EQ(fetches(n, 1, "one_light_fetch"), 3 + 14 * (n - 1) + (n - 1) * (n - 2) / 2) << n;
    EXPECT_EQ(fetches(n, 0, "one_fetch_disc"), 3 + 2 * (n - 1)) << n;
  }
}

// A shadow that falls nowhere: without depth, where the layers lie on each other, each texel is shaded by what lies on it.
TEST_P(DeepLayers, CullingAtThicknessZeroChangesNoPixelUnderShadows) {
  Scene culled = bumpy_scene(0, 1);
  stack_of(culled).numbers["shadowing"] = 0.75f;
  Scene whole = culled;
  stack_of(whole).numbers["thickness"] = 1e-30f;
  Scene unshaded = culled;
  stack_of(unshaded).numbers["shadowing"] = 0;
  for (const std::string_view name :
       {"light_map", "vertex_normal", "one_light_fetch", "blurred_once", "shadows_premultiplied"}) {
    EXPECT_EQ(picture(culled, name).rgba, picture(whole, name).rgba) << name;
    EXPECT_NE(picture(culled, name).rgba, picture(unshaded, name).rgba) << name;
  }
}

TEST(DeepLayersAcrossBackends, OpenGlAgreesWithVulkan) {
  Scene scene = bumpy_scene(5, 1);
  const Scene stack = stack_scene(std::vector<UniformLayer>(4, {0.5f, 0.5f}), 1);
  EffectValues& layers = stack_of(scene);
  const EffectValues& deeper = stack.objects[0].effects.at("layered_material");
  for (const auto& [name, texture] : deeper.textures) layers.textures.emplace(name, texture);
  for (const auto& [name, number] : deeper.numbers) layers.numbers.emplace(name, number);
  expect_backends_agree("layered_material", {scene}, 64);
}

}  // namespace
}  // namespace lamina
