// SPDX-License-Identifier: Apache-2.0
// Makes a whole scene of what a command line names. Three steps: read it, add default lights and views, and find the facts that
// passes depend on (is anything transparent, can it be unwrapped).
#include <algorithm>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/scene/declare.h"
#include "harness/scene/default_views.h"
#include "harness/scene/facts.h"
#include "harness/scene/made/builtin_scenes.h"
#include "harness/scene/mesh/split_overlaps.h"
#include "harness/scene/mesh/unwrap_check.h"
#include "harness/scene/scene.h"
#include "harness/scene/scene_file.h"

namespace lamina {
namespace {

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

Scene read_scene(const std::string& source, const Library& library, std::optional<float> time_s) {
  const std::vector<std::string> builtin = builtin_scenes();
  if (std::find(builtin.begin(), builtin.end(), source) != builtin.end()) {
    Scene scene = read_builtin(source, time_s.value_or(0));
    declare_objects(scene.objects, library);
    declare_said(scene, library);
    return scene;
  }
  const std::filesystem::path file(source);
  const std::string extension = lower_case(file.extension().string());
  if (extension == ".toml") return read_scene_file(file, library, time_s);
  if (extension == ".glb" || extension == ".gltf") return read_model(file, library, time_s);
  const std::string expected = "a scene is a .toml scene file, a .glb or .gltf model, or the name of a built-in scene";
  if (std::filesystem::exists(file)) throw Error(ErrorKind::bad_input, "scene", source, "is no scene: " + expected);
  throw Error(ErrorKind::bad_input, "scene", source, fmt::format("{}; {}", unknown_name("scene", source, builtin), expected));
}

}  // namespace

Scene load_scene(const std::string& source, const Library& library, std::optional<float> time_s) {
  Scene scene = read_scene(source, library, time_s);
  scene.source = source;
  declare_scene(scene, library);
  if (scene.lights.empty()) scene.lights = default_lights(bounding_sphere(scene.objects));
  if (scene.views.empty()) scene.views = default_views(scene.objects);
  for (Object& object : scene.objects)
    if (pictures_repeat(object)) move_to_unit_tile(object.mesh);
  OverlapFractions overlaps;
  split_overlapping_objects(scene.objects, library, overlaps, scene.warnings);
  for (Object& object : scene.objects) {
    object.look.reset();
    object.unwrap_problem = unwrap_problem(object.mesh);
    if (uses_unwrap(object, library))
      if (std::string warning = overlap_warning(object, overlaps); !warning.empty())
        scene.warnings.push_back(std::move(warning));
    for (const EffectManifest* effect : effects_of(object, library)) {
      object.solid = object.solid && effect->solid;
      object.blocks_light = object.blocks_light && effect->blocks_light;
    }
    for (const EffectManifest& effect : library.effects) settle_facts(object, effect);
  }
  return scene;
}

}  // namespace lamina
