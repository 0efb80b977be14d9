// SPDX-License-Identifier: Apache-2.0
// A feature that an effect calls at_zero draws the same, to the bit, with its definition where what it needs is 0. All of an
// effect's at once, by its baseline; LAMINA_ALL_SCENES=1 asks each feature and need alone, by every variant.
#include <algorithm>
#include <cstdlib>

#include "harness/quality/same_bits.h"
#include "harness/scene/textures.h"
#include "tests/graph/each_backend.h"
#include "tests/graph/small_parameters.h"

namespace lamina {
namespace {

// A scene of each effect that has such features.
const std::map<std::string, std::string> zero_scenes = {{"water", "pool"},
                                                        {"hair", "hair_head"},
                                                        {"skin", "skin_plate"},
                                                        {"atmosphere", "far_ridges"},
                                                        {"layered_material", "heart"},
                                                        {"translucency", "leaf_pair"}};

// The number, or the texture that the fact is of, becomes 0.
void make_zero(Scene& scene, const EffectManifest& effect, const std::string& need) {
  const auto fact = std::ranges::find(effect.facts, need, &FactManifest::name);
  const auto zero = [&](EffectValues& values) {
    if (const auto number = values.numbers.find(need); number != values.numbers.end()) number->second = 0;
    if (fact == effect.facts.end()) return;
    values.facts[need] = 0;
    const float colour = fact->function == "seen_alpha" ? 0.5f : 0.0f;
    if (const auto texture = values.textures.find(fact->texture); texture != values.textures.end())
      texture->second = constant_texture("zero", {colour, colour, colour, 0}, TexelMeaning::colour);
  };
  for (Object& object : scene.objects)
    if (const auto values = object.effects.find(effect.name); values != object.effects.end()) zero(values->second);
  if (const auto values = scene.effects.find(effect.name); values != scene.effects.end()) zero(values->second);
}

class AtZero : public EachBackend {
 protected:
  static constexpr uint32_t size_px = 40;

  struct Asked {
    std::vector<std::string> features, zeros;
  };
  static std::vector<const FeatureManifest*> at_zero(const EffectManifest& effect) {
    std::vector<const FeatureManifest*> features;
    for (const FeatureManifest& feature : effect.features)
      if (feature.at_zero) features.push_back(&feature);
    return features;
  }

  Image picture_of(const Graph& graph, SceneResources& resources) {
    Frame frame(resources, graph, Build::timed);
    frame.run_once(Timing::off);
    frame.run(0, Timing::off);
    return frame.picture();
  }

  // With the features where the zeros are 0, and without.
  void expect_same(const EffectManifest& effect, const Asked& asked, bool all_variants) {
    Library only = library();
    for (EffectManifest& other : only.effects)
      for (FeatureManifest& feature : other.features)
        feature.at_zero =
            other.name == effect.name && std::ranges::find(asked.features, feature.define) != asked.features.end();
    Scene scene = load_scene(zero_scenes.at(effect.name), library());
    for (const std::string& need : asked.zeros) make_zero(scene, effect, need);
    const Plan without = make_plan(only, scene, 1);
    ASSERT_TRUE(without.of(effect.name)->called_for);
    Plan with = without;
    with.culling = Culling::off;
    ShaderCache shaders(backend_->info().api, only.shaders);
    Bakes bakes(scene, *only.code, DiskCache(""));
    SceneResources resources(*backend_, scene, only, size_px, size_px, &bakes);
    const Parameters parameters = small_parameters(only);
    for (const VariantManifest& variant : only.effect(effect.name).variants) {
      if (!variant.baseline && !all_variants) continue;
      SCOPED_TRACE(variant.name + " with " + asked.features.front() + ", " + asked.zeros.front() + " = 0");
      const Configuration configuration = configuration_with(without, variant);
      try {
        const Graph plain = make_graph(without, configuration, scene, shaders, nullptr, parameters),
                    more = make_graph(with, configuration, scene, shaders, nullptr, parameters);
        if (variant.baseline) {
          EXPECT_NE(plain.shader_hashes(), more.shader_hashes()) << "the definition is in no shader";
        }
        const BitDifference difference = bit_difference(picture_of(plain, resources), picture_of(more, resources));
        EXPECT_EQ(difference.pixels, 0u) << "by " << difference.largest << " at " << difference.x << ", " << difference.y;
      } catch (const Error& error) {
        if (!all_variants) throw;
        fmt::print("not drawn: {}: {}\n", variant.name, error.what());
      }
    }
  }
};
INSTANTIATE_TEST_SUITE_P(Backends, AtZero, backend_parameters, backend_test_name);

TEST_P(AtZero, TheDefinitionChangesNoBit) {
  const char* all = std::getenv("LAMINA_ALL_SCENES");
  size_t asked_features = 0;
  for (const EffectManifest& effect : library().effects) {
    Asked together;
    for (const FeatureManifest* feature : at_zero(effect)) {
      ASSERT_TRUE(zero_scenes.contains(effect.name)) << effect.name << " has " << feature->define << ": give it a scene above";
      ++asked_features;
      together.features.push_back(feature->define);
      for (const NeedManifest& need : feature->needs) {
        together.zeros.push_back(need.name);
        if (all && *all) expect_same(effect, {{feature->define}, {need.name}}, true);
      }
    }
    if (!together.features.empty() && !(all && *all)) expect_same(effect, together, false);
  }
  EXPECT_GE(asked_features, 10u);
}

}  // namespace
}  // namespace lamina
