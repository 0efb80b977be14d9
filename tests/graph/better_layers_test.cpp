// SPDX-License-Identifier: Apache-2.0
// What the layered material's further variants claim, each on a picture whose answer is known.
#include <cmath>

#include "harness/quality/quality.h"
#include "tests/graph/each_backend.h"
#include "tests/graph/quad_scene.h"

namespace lamina {
namespace {

class BetterLayers : public EachBackend {
 protected:
  // Fragments that a variant's pass draws of view 0.
  uint64_t fragments(const Scene& scene, std::string_view name, std::string_view pass) {
    DrawnFrame drawn(*backend_, library(), scene,
                     {.variant = &variant(name), .width = 32, .height = 32, .build = Build::counting});
    for (const bool once : {true, false}) {
      const auto names = once ? drawn.frame.once_names() : drawn.frame.frame_names();
      const auto counts = once ? drawn.frame.once_counts() : drawn.frame.frame_counts();
      for (size_t i = 0; i < names.size(); ++i)
        if (names[i] == pass) return counts[i].fragments;
    }
    ADD_FAILURE() << "no pass " << pass;
    return 0;
  }
};
INSTANTIATE_TEST_SUITE_P(Backends, BetterLayers, backend_parameters, backend_test_name);
EffectValues& layers_in(Scene& scene) { return scene.objects[0].effects.at("layered_material"); }

// Columns of normals (+-0.6, 0, 0.8): their mean is (0, 0, 0.8), which lacks 1 - 0.64 of the length, so that N.L along x
// deviates by sqrt(0.18). Light from above: 0.8, where a mean made unit again would say 1. Light along the surface: 0.18^0.5 /
// sqrt(2 pi) = 0.1693, where the mean alone says 0. The picture is that times N.V, which is 0.8 in every column.
TEST_P(BetterLayers, ScatterOfNormalsLightsAsItsMeanAndDeviationSay) {
  for (const auto& [direction, light] :
       {std::pair(glm::vec3(0, 0, -1), 0.8), std::pair(glm::vec3(-1, 0, 0), std::sqrt(0.18 / (2 * M_PI)))}) {
    Scene scene = quad_scene({8, 1, glm::vec3(0.0f), glm::vec3(1.0f)});
    scene.ambient = glm::vec3(0);
    scene.lights.push_back({"sun", Light::Kind::directional, direction, {}, glm::vec3(1)});
    const Texels columns = filled(64, [](uint32_t x, uint32_t) { return glm::vec4(x % 2 ? 0.8f : 0.2f, 0.5f, 0.9f, 1); });
    layers_in(scene).textures["outer_normal"] = make_texture("columns", columns, TexelMeaning::normal);
    layers_in(scene).textures["outer_normal_mean"] = make_texture("columns", columns, TexelMeaning::normal_mean);
    EXPECT_NEAR(pixel(picture(scene, "mean_normal"), 32, 32).r, 0.8 * light, 0.012) << direction.x;
  }
}

// Seen straight on the ray is as long as the layers are apart: the first blurred map is the 13 taps themselves.
TEST_P(BetterLayers, WhatWasBlurredOnceIsThe13TapsSeenStraightOn) {
  Scene scene = bumpy_scene(6, 1);
  layers_in(scene).textures["outer_normal"] =
      quad_scene({}).objects[0].effects.at("layered_material").textures.at("outer_normal");
  scene.views[0] = quad_scene({}).views[0];
  const Image expected = picture(scene, "one_light_fetch");
  EXPECT_GE(psnr_db(to_display(picture(scene, "blurred_once")), to_display(expected)), 45);
  layers_in(scene).numbers["thickness"] = 3;
  EXPECT_LT(psnr_db(to_display(picture(scene, "one_light_fetch")), to_display(expected)), 40) << "the blur must show";
}

// Of two squares, one of which is turned away, one is lit; and what the eye sees is lit as ever, to the bit.
TEST_P(BetterLayers, TrianglesTurnedAwayAreNotLit) {
  Scene scene = bumpy_scene(6, 1);
  const Image expected = picture(scene, "one_light_fetch");
  EXPECT_EQ(picture(scene, "reached_light").rgba, expected.rgba);
  Mesh& mesh = scene.objects[0].mesh;
  for (Vertex& vertex : mesh.vertices) vertex.uv.x *= 0.5f;
  const uint64_t half = fragments(scene, "one_light_fetch", "light");
  const std::vector<Vertex> front = mesh.vertices;
  for (Vertex vertex : front) {
    vertex.uv.x = 1 - vertex.uv.x;
    vertex.normal = -vertex.normal;
    vertex.position.z -= 1;
    mesh.vertices.push_back(vertex);
  }
  for (const uint32_t index : {4, 5, 6, 4, 6, 7}) mesh.indices.push_back(index);
  EXPECT_EQ(half, 64u * 32);
  EXPECT_EQ(fragments(scene, "one_light_fetch", "light"), 2 * half);
  EXPECT_EQ(fragments(scene, "reached_light", "light"), half);
}

// A light map of half the side has a quarter of the texels, one of the frame's size as many as the frame.
TEST_P(BetterLayers, LightMapsAreAsLargeAsTheirVariantsSay) {
  const Scene scene = bumpy_scene(6, 1);
  EXPECT_EQ(fragments(scene, "one_light_fetch", "dilate"), 64u * 64);
  EXPECT_EQ(fragments(scene, "half_map", "dilate"), 32u * 32);
  EXPECT_EQ(fragments(scene, "footprint_map", "dilate"), 32u * 32);
}

// A chart that covers a quarter of its map: beside its edge light is that of the chart, nearly as if the map were filled. Rays
// that land further from it than their level is wide find none: 31.5 dB.
TEST_P(BetterLayers, AMapThatIsNotFilledShowsNoBackground) {
  Scene scene = bumpy_scene(4, 1);
  for (Vertex& vertex : scene.objects[0].mesh.vertices) vertex.uv = vertex.uv * 0.5f + 0.25f;
  const DisplayImage filled_map = to_display(picture(scene, "one_light_fetch", 96));
  EXPECT_GE(psnr_db(to_display(picture(scene, "covered_map", 96)), filled_map), 30);
  EXPECT_EQ(fragments(scene, "covered_map", "light"), 32u * 32);
}

// Light that falls smoothly over the surface, seen through smooth normals: all imitations are the baseline within what 8 bits
// show.
TEST_P(BetterLayers, ImitationsStayNearTheBaseline) {
  const Scene scene = bumpy_scene(4, 1);
  const DisplayImage baseline = to_display(picture(scene, "light_map", 96));
  const std::map<std::string_view, double> min_db = {{"one_light_fetch", 40}, {"reached_light", 40}, {"base_level_taps", 38},
                                                     {"blurred_once", 30},    {"covered_map", 40},   {"frugal", 38}};
  for (const auto& [name, db] : min_db) EXPECT_GE(psnr_db(to_display(picture(scene, name, 96)), baseline), db) << name;
}

}  // namespace
}  // namespace lamina
