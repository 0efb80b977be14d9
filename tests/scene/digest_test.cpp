// SPDX-License-Identifier: Apache-2.0
// Digests decide what may be resumed, kept or taken from a cache: whatever an effect declares must be in them.
#include "harness/scene/digest.h"

#include <gtest/gtest.h>

#include "harness/scene/textures.h"
#include "tests/builtin_library.h"

namespace lamina {
namespace {

// Two objects, one of each built-in effect, with everything that the effects declare.
Scene example() {
  Scene scene;
  scene.name = "example";
  for (const EffectManifest& effect : builtin_library().effects) {
    Object& object = scene.objects.emplace_back();
    object.name = effect.name;
    object.mesh.vertices.resize(3);
    object.mesh.indices = {0, 1, 2};
    EffectValues& values = object.effects[effect.name];
    for (const NumberManifest& number : effect.object.numbers) values.numbers[number.name] = number.value.value_or(1);
    for (const WordManifest& word : effect.object.words) values.words[word.name] = word.value;
    for (const TextureManifest& texture : effect.object.textures)
      values.textures[texture.name] = constant_texture(texture.name, glm::vec4(0.5f), TexelMeaning::data);
  }
  scene.lights.emplace_back();
  scene.views.emplace_back();
  return scene;
}

TEST(Digest, EverythingThatIsDeclaredCounts) {
  const std::string whole = scene_digest(example());
  EXPECT_EQ(scene_digest(example()), whole) << "the same scene, made again";
  size_t changes = 0;
  const auto expect_other = [&](const Scene& changed, const std::string& what) {
    ++changes;
    EXPECT_NE(scene_digest(changed), whole) << what;
  };
  for (size_t i = 0; i < example().objects.size(); ++i) {
    const EffectManifest& effect = builtin_library().effects[i];
    for (const NumberManifest& number : effect.object.numbers) {
      Scene scene = example();
      scene.objects[i].effects.at(effect.name).numbers[number.name] += 1;
      expect_other(scene, number.name);
      scene.objects[i].effects.at(effect.name).numbers.erase(number.name);
      expect_other(scene, number.name + ", not known");
    }
    for (const WordManifest& word : effect.object.words) {
      Scene scene = example();
      scene.objects[i].effects.at(effect.name).words[word.name] = word.of.back();
      expect_other(scene, word.name);
    }
    for (const TextureManifest& texture : effect.object.textures) {
      Scene scene = example();
      scene.objects[i].effects.at(effect.name).textures[texture.name] =
          constant_texture(texture.name, glm::vec4(0.25f), TexelMeaning::data);
      expect_other(scene, texture.name);
    }
  }
  Scene scene = example();
  scene.lights[0].casts = true;
  expect_other(scene, "a light that casts");
  scene = example();
  scene.effects["surface"].numbers["level"] = 0;
  expect_other(scene, "a number of the scene");
  EXPECT_GT(changes, 12u);
}

// Whatever a picture follows from beside the effects' own values.
TEST(Digest, EverythingOfTheSceneCounts) {
  const auto told = [] {
    Scene scene = example();
    scene.effects["surface"] = {{{"level", 0}}, {{"kind", "thick"}}, {}, {}};
    scene.effects["surface"].textures["sky"] = constant_texture("sky", glm::vec4(0), TexelMeaning::data);
    return scene;
  };
  const std::string whole = scene_digest(told());
  const std::pair<const char*, void (*)(Scene&)> changes[] = {
      {"name", [](Scene& s) { s.name = "other"; }},
      {"ambient", [](Scene& s) { s.ambient.g += 1; }},
      {"background", [](Scene& s) { s.background.b += 1; }},
      {"object's name", [](Scene& s) { s.objects[0].name = "other"; }},
      {"object's place", [](Scene& s) { s.objects[0].world_from_object[3].x = 1; }},
      {"object's vertices", [](Scene& s) { s.objects[0].mesh.vertices[1].uv.x = 0.5f; }},
      {"object's triangles",
       [](Scene& s) {
         s.objects[0].mesh.indices = {0, 2, 1};
       }},
      {"number of an effect", [](Scene& s) { s.effects["surface"].numbers["level"] = 1; }},
      {"word of an effect", [](Scene& s) { s.effects["surface"].words["kind"] = "thin"; }},
      {"texture of an effect",
       [](Scene& s) { s.effects["surface"].textures["sky"] = constant_texture("sky", glm::vec4(1), TexelMeaning::data); }},
      {"light's name", [](Scene& s) { s.lights[0].name = "other"; }},
      {"light's kind", [](Scene& s) { s.lights[0].kind = Light::Kind::point; }},
      {"light's direction", [](Scene& s) { s.lights[0].direction.x += 1; }},
      {"light's position", [](Scene& s) { s.lights[0].position.y += 1; }},
      {"light's radiance", [](Scene& s) { s.lights[0].radiance.b += 1; }},
      {"light's angular radius", [](Scene& s) { s.lights[0].angular_radius += 0.25f; }},
      {"light's radius", [](Scene& s) { s.lights[0].radius_m += 0.25f; }},
      {"whether a light casts", [](Scene& s) { s.lights[0].casts = !s.lights[0].casts; }},
      {"one more light", [](Scene& s) { s.lights.emplace_back(); }},
      {"view's name", [](Scene& s) { s.views[0].name = "other"; }},
      {"view's eye", [](Scene& s) { s.views[0].eye.x += 1; }},
      {"view's target", [](Scene& s) { s.views[0].target.y += 1; }},
      {"view's up", [](Scene& s) { s.views[0].up.z += 1; }},
      {"view's angle", [](Scene& s) { s.views[0].fov_y_degrees += 1; }},
      {"view's near plane", [](Scene& s) { s.views[0].near_m *= 2; }},
      {"view's far plane", [](Scene& s) { s.views[0].far_m *= 2; }}};
  for (const auto& [what, change] : changes) {
    Scene scene = told();
    change(scene);
    EXPECT_NE(scene_digest(scene), whole) << what;
  }
}

// Numbers that go into uniform blocks leave the device as it is; textures, and what a baker is told, do not.
TEST(Digest, OnlyWhatIsOnTheDeviceMakesItAnew) {
  const Library& library = builtin_library();
  const std::string there = device_digest(example(), library);
  for (size_t i = 0; i < library.effects.size(); ++i) {
    const EffectManifest& effect = library.effects[i];
    for (const NumberManifest& number : effect.object.numbers) {
      Scene scene = example();
      scene.objects[i].effects.at(effect.name).numbers[number.name] += 1;
      EXPECT_EQ(device_digest(scene, library) == there, effect.baker.empty()) << number.name;
    }
    for (const TextureManifest& texture : effect.object.textures) {
      Scene scene = example();
      scene.objects[i].effects.at(effect.name).textures[texture.name] =
          constant_texture(texture.name, glm::vec4(0.25f), TexelMeaning::data);
      EXPECT_NE(device_digest(scene, library), there) << texture.name;
    }
  }
  Scene moved = example();
  moved.objects[0].world_from_object[3].x = 1;
  EXPECT_NE(device_digest(moved, library), there) << "rays meet it elsewhere";
}

}  // namespace
}  // namespace lamina
