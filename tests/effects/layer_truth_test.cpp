// SPDX-License-Identifier: Apache-2.0
// The layered material's truth against closed forms, and against a variant's picture where filters have little to do.
#include "harness/effects/layered_material/layer_truth.h"

#include <cmath>

#include "harness/effects/layered_material/layer_light.h"
#include "tests/graph/each_backend.h"
#include "tests/graph/layer_stacks.h"

namespace lamina {
namespace {

constexpr size_t samples = 2048;
const std::vector<UniformLayer> sheets = {{0.8f, 0.3f}, {0.6f, 0.4f}, {0.4f, 0.5f}, {0.9f, 1}};

// A place of the unit square, seen from `eye`; a pixel is a texel of 64.
SeenLayers seen_at(glm::dvec2 uv) {
  return {{uv.x - 0.5, 0.5 - uv.y, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, 1}, uv, {1.0 / 64, 0}, {0, 1.0 / 64}, {}, {}};
}
glm::dvec3 straight_above(glm::dvec2 uv) { return {uv.x - 0.5, 0.5 - uv.y, 10}; }

TEST(LayerTruth, UniformStacksShowWhatTheRuleGives) {
  for (const float shadowing : {0.0f, 0.5f, 1.0f}) {
    const Scene scene = stack_scene(sheets, shadowing);
    const glm::dvec2 middle(0.5);
    EXPECT_NEAR(LayerModel(scene, 0).light(seen_at(middle), straight_above(middle), 64, 0.3).all.r,
                single_bounce(sheets, double(shadowing)), 0.003);
  }
}

// x radii from the edge between a clear and an opaque half a disc sees 1 - (acos x - x sqrt(1 - x^2)) / pi of it clear.
TEST(LayerTruth, AnEdgesShadowIsTheDiscsShareOfIt) {
  Scene scene = stack_scene({{0, 0}, {1, 1}}, 1);
  stack_of(scene).numbers["thickness"] = 8;
  stack_of(scene).textures["outer_albedo"] = make_texture(
      "half", filled(64, [](uint32_t x, uint32_t) { return glm::vec4(0, 0, 0, x < 32 ? 1 : 0); }), TexelMeaning::colour);
  const LayerModel model(scene, 0);
  for (const double x : {0.25, 0.5, 0.75}) {
    const glm::dvec2 at(0.5 - 8 * x / 64, 0.5);
    SeenLayers seen = seen_at(at);
    seen.right = seen.down = glm::dvec2(0);
    EXPECT_NEAR(model.light(seen, straight_above(at), samples, 0.1).all.r, 1 - (std::acos(x) - x * std::sqrt(1 - x * x)) / M_PI,
                0.006)
        << x;
  }
}

// At 45 degrees light comes through the surface as many texels further as the layer is deep: of two lights each has its own
// shadow.
TEST(LayerTruth, EachLightHasItsOwnShadow) {
  Scene scene = stack_scene({{0, 0}, {1, 1}}, 1);
  stack_of(scene).numbers["thickness"] = 10;
  stack_of(scene).numbers["scattering"] = 0;
  stack_of(scene).textures["outer_albedo"] = make_texture(
      "half", filled(64, [](uint32_t x, uint32_t) { return glm::vec4(0, 0, 0, x < 40 ? 1 : 0); }), TexelMeaning::colour);
  scene.ambient = glm::vec3(0);
  scene.lights.push_back({"right", Light::Kind::directional, glm::normalize(glm::vec3(-1, 0, -1)), {}, {1, 0, 0}});
  scene.lights.push_back({"above", Light::Kind::directional, {0, 0, -1}, {}, {0, 1, 0}});
  const LayerModel model(scene, 0);
  const auto seen = [&](double texel) {
    const glm::dvec2 at(texel / 64, 0.5);
    return model.light(seen_at(at), straight_above(at), 64, 0.1).all;
  };
  EXPECT_NEAR(seen(24).r, std::sqrt(0.5), 0.01);
  EXPECT_NEAR(seen(34).r, 0, 1e-6);
  EXPECT_NEAR(seen(34).g, 1, 0.01);
}

// Two cycles a radius are finer than a disc shows; a quarter of a cycle leaves 2 J1(pi / 2) / (pi / 2) of a wave.
TEST(LayerTruth, TheInnerLayerIsBlurredByADisc) {
  for (const auto& [radius, left] :
       {std::pair(4.0, 2 * std::cyl_bessel_j(1.0, M_PI / 2) / (M_PI / 2)), {8.0, 2 * std::cyl_bessel_j(1.0, M_PI) / M_PI}}) {
    Scene scene = stack_scene({{0, 0}, {1, 1}}, 0);
    stack_of(scene).numbers["thickness"] = radius;
    stack_of(scene).textures["inner_albedo"] = make_texture(
        "wave",
        filled(64, [](uint32_t x,
                      uint32_t) { return glm::vec4(glm::vec3(float(0.5 + 0.5 * std::cos(2 * M_PI * (x + 0.5) / 16))), 1); }),
        TexelMeaning::colour);
    SeenLayers seen = seen_at({0.5, 0.5});
    seen.right = seen.down = glm::dvec2(0);
    EXPECT_NEAR(LayerModel(scene, 0).light(seen, straight_above({0.5, 0.5}), samples, 0.7).all.r, 0.5 + 0.5 * left, 0.012)
        << radius;
  }
}

// Beyond the charts light is that of the nearest texel that is covered; the texture repeats.
TEST(LayerLight, BeyondTheChartsItIsTheNearestTexels) {
  Scene scene = quad_scene({});
  for (Vertex& vertex : scene.objects[0].mesh.vertices) vertex.uv = vertex.uv * 0.5f + 0.25f;
  scene.lights.push_back({"lamp", Light::Kind::point, {}, {0, 0, 0.25f}, glm::vec3(1)});
  const LayerLight light(scene, scene.objects[0], *scene.objects[0].effects.at("layered_material").textures.at("outer_normal"));
  const double middle = light.at({0.5, 0.5})[0].r, edge = light.at({0.7485, 0.5})[0].r;
  EXPECT_NEAR(middle, 16, 0.05);
  EXPECT_NEAR(edge, 0.25 / std::pow(0.25 * 0.25 + 0.497 * 0.497, 1.5), 0.02);
  for (const glm::dvec2 outside : {glm::dvec2(0.9, 0.5), glm::dvec2(0.76, 0.5)})
    EXPECT_NEAR(light.at(outside)[0].r, edge, 0.02);
  EXPECT_NEAR(light.at({1.5, -0.5})[0].r, middle, 0.05);
}

class LayerTruthPictures : public EachBackend {};
INSTANTIATE_TEST_SUITE_P(Backends, LayerTruthPictures, api_parameters, backend_test_name);

// Bumps, three layers and shadows seen at a slant: 13 evenly spread taps come near to many. A turned frame, another sign of v
// or a ray bent the wrong way would not.
TEST_P(LayerTruthPictures, EvenTapsComeNear) {
  for (const float shadowing : {0.0f, 1.0f}) {
    Scene scene = bumpy_scene(3, 1);
    scene.lights.resize(1);
    EffectValues& layers = stack_of(scene);
    const EffectValues deeper =
        stack_scene({{0.8f, 0.5f}, {0.6f, 0.4f}, {0.2f, 1}}, shadowing).objects[0].effects.at("layered_material");
    for (const auto& [name, texture] : deeper.textures) layers.textures.emplace(name, texture);
    for (const auto& [name, number] : deeper.numbers) layers.numbers.emplace(name, number);
    layers.numbers["shadowing"] = shadowing;
    layers.numbers["scattering"] = 1;
    const Image image = picture(scene, "golden_disc");
    const LayerModel model(scene, 0);
    const View& view = scene.views[0];
    const glm::dvec3 eye(view.eye), ahead = glm::normalize(glm::dvec3(view.target) - eye),
                                    right = glm::normalize(glm::cross(ahead, glm::dvec3(view.up))),
                                    up = glm::cross(right, ahead);
    const double scale = std::tan(glm::radians(double(view.fov_y_degrees)) / 2);
    const auto uv_of = [&](double x, double y) {
      const glm::dvec3 ray = ahead + scale * ((x - 32) / 32 * right - (y - 32) / 32 * up);
      const glm::dvec3 at = eye - ray * (eye.z / ray.z);
      return glm::dvec2(at.x + 0.5, 0.5 - at.y);
    };
    double sum = 0, apart = 0;
    for (int y = 20; y < 44; y += 4)
      for (int x = 20; x < 44; x += 4) {
        const glm::dvec2 uv = uv_of(x + 0.5, y + 0.5);
        SeenLayers seen = seen_at(uv);
        seen.right = uv_of(x + 1.5, y + 0.5) - uv, seen.down = uv_of(x + 0.5, y + 1.5) - uv;
        const glm::dvec3 truth = model.light(seen, eye, 256, 0.2).all;
        sum += truth.r + truth.g + truth.b;
        for (int c = 0; c < 3; ++c) apart += std::abs(truth[c] - double(pixel(image, x, y)[c]));
      }
    EXPECT_LT(apart, 0.04 * sum) << shadowing;
  }
}

}  // namespace
}  // namespace lamina
