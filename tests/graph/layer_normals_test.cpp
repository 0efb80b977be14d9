// SPDX-License-Identifier: Apache-2.0
// Normal maps of layers below the outer one: a flat map changes nothing, to the bit; a constant tilted one gives Lambert's law.
#include <cmath>

#include "harness/effects/layered_material/layer_truth.h"
#include "harness/scene/facts.h"
#include "tests/graph/each_backend.h"
#include "tests/graph/layer_stacks.h"

namespace lamina {
namespace {

class LayerNormals : public EachBackend {
 protected:
  const EffectManifest& effect() {
    for (const EffectManifest& one : library().effects)
      if (one.name == "layered_material") return one;
    throw std::runtime_error("no such effect");
  }
  // Gives a layer a normal map, the same normal everywhere, and finds the facts anew.
  void tilt(Scene& scene, const std::string& layer, glm::vec3 normal) {
    stack_of(scene).textures[layer + "_normal"] = make_texture(
        layer, filled(64, [&](uint32_t, uint32_t) { return glm::vec4(0.5f + 0.5f * normal, 1); }), TexelMeaning::normal_mean);
    for (const std::string name : {"inner", "layer_3", "layer_4", "layer_5", "layer_6"})
      if (!stack_of(scene).textures.contains(name + "_normal"))
        stack_of(scene).textures[name + "_normal"] = constant_texture(name, {0.5f, 0.5f, 1, 1}, TexelMeaning::normal_mean);
    settle_facts(scene.objects[0], effect());
  }
};
INSTANTIATE_TEST_SUITE_P(Backends, LayerNormals, backend_parameters, backend_test_name);

const glm::vec3 flat(0, 0, 1);
const std::vector<UniformLayer> sheets = {{0.8f, 0}, {0.6f, 0.5f}, {0.5f, 1}};

// Clear over a half-clear sheet over a base, lit by a lamp at a slant and from all around.
Scene lit_stack(float thickness, float shadowing) {
  Scene scene = stack_scene(sheets, shadowing);
  stack_of(scene).numbers["thickness"] = double(thickness);
  scene.ambient = glm::vec3(0.2f);
  scene.lights = {{"lamp", Light::Kind::directional, -glm::vec3(0.6f, 0, 0.8f), {}, glm::vec3(1)}};
  return scene;
}
double lambert(glm::vec3 normal) { return 0.2 + double(std::max(glm::dot(normal, glm::vec3(0.6f, 0, 0.8f)), 0.0f)); }

TEST_P(LayerNormals, AFlatMapChangesNothing) {
  for (const std::string_view name : {"light_map", "mean_normal"}) {
    Scene scene = bumpy_scene(4, 1);
    tilt(scene, "layer_3", flat);
    const Image expected = picture(scene, name);
    // 64 texels of codes that are as flat as 8 bits can say.
    tilt(scene, "inner", flat);
    EXPECT_EQ(picture(scene, name).rgba, expected.rgba) << name;
    tilt(scene, "inner", glm::normalize(glm::vec3(0.4f, 0, 1)));
    EXPECT_NE(picture(scene, name).rgba, expected.rgba) << name;
  }
}

TEST_P(LayerNormals, AConstantTiltIsLambertsLaw) {
  const glm::vec3 towards = glm::normalize(glm::vec3(0.5f, 0.2f, 1)), away = glm::normalize(glm::vec3(-1, 0, 0.4f));
  for (const float thickness : {0.0f, 3.0f})
    for (const std::string_view name : {"light_map", "vertex_normal", "ring_disc"})
      for (const glm::vec3 normal : {towards, away}) {
        if (normal == away && name != "light_map") continue;
        Scene scene = lit_stack(thickness, 0);
        tilt(scene, "inner", normal);
        EXPECT_NEAR(pixel(picture(scene, name, 16), 8, 8).r, 0.5 * 0.6 * lambert(normal) + 0.5 * 0.5 * lambert(flat), 0.008)
            << name << " " << thickness;
        tilt(scene, "layer_3", towards);
        EXPECT_NEAR(pixel(picture(scene, name, 16), 8, 8).r, 0.5 * 0.6 * lambert(normal) + 0.5 * 0.5 * lambert(towards), 0.008)
            << name << " " << thickness;
      }
}

// Under shadows the map's light is scaled as the smooth surface's is: the half-clear sheet lets half of it through.
TEST_P(LayerNormals, ShadowsFallOnTheMapsLight) {
  const glm::vec3 towards = glm::normalize(glm::vec3(0.5f, 0.2f, 1));
  for (const std::string_view name : {"light_map", "one_light_fetch", "shadows_at_center"}) {
    Scene scene = lit_stack(3, 1);
    tilt(scene, "layer_3", towards);
    EXPECT_NEAR(pixel(picture(scene, name, 16), 8, 8).r, 0.5 * 0.6 * lambert(flat) + 0.5 * 0.5 * 0.5 * lambert(towards), 0.008)
        << name;
  }
}

TEST_P(LayerNormals, TheModelsTruthSaysTheSame) {
  const glm::vec3 towards = glm::normalize(glm::vec3(0.5f, 0.2f, 1));
  Scene scene = lit_stack(3, 1);
  tilt(scene, "inner", towards);
  tilt(scene, "layer_3", towards);
  const SeenLayers seen{{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, flat, {0.5, 0.5}, {1.0 / 64, 0}, {0, 1.0 / 64}, {}, {}};
  EXPECT_NEAR(LayerModel(scene, 0).light(seen, {0, 0, 10}, 64, 0.3).all.r,
              double(pixel(picture(scene, "light_map", 16), 8, 8).r), 0.008);
}

}  // namespace
}  // namespace lamina
