// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/scene_file.h"

#include <algorithm>

#include "harness/core/text.h"
#include "harness/core/toml_table.h"
#include "harness/scene/declare.h"
#include "harness/scene/default_views.h"
#include "harness/scene/gltf/gltf.h"
#include "harness/scene/made/builtin_scenes.h"
#include "harness/scene/place_objects.h"
#include "harness/scene/read_keys.h"
#include "harness/scene/toml_values.h"

namespace lamina {
namespace {

// A light's or a sky's strongest channel; half floats end at 65504.
constexpr float brightest = 60000;

Scene scene_of_objects(LoadedModel model, float time_s) {
  Scene scene;
  scene.objects = std::move(model.objects);
  scene.warnings = std::move(model.warnings);
  scene.time_s = time_s;
  scene.background = glm::vec3(0.05f);  // mid-dark, neutral: neither hides silhouettes nor outshines the object
  scene.ambient = {0.10f, 0.11f, 0.125f};
  return scene;
}

// The scene that [scene] starts from.
Scene base_scene(const TomlTable& table, const std::filesystem::path& folder, float time_s) {
  if (table.has("model") == table.has("builtin"))
    throw table.error({}, "[scene] needs either model = \"FILE\" (.glb or .gltf) or builtin = \"NAME\"");
  if (table.has("builtin")) {
    const std::string name = table.string("builtin");
    const std::vector<std::string> known = builtin_scenes();
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw table.error("builtin", unknown_name("built-in scene", name, known));
    return read_builtin(name, time_s);
  }
  const std::filesystem::path file = folder / table.string("model");
  if (!std::filesystem::is_regular_file(file)) throw table.error("model", fmt::format("there is no file {}", file.string()));
  return scene_of_objects(load_gltf(file), time_s);
}

Light read_light(const std::string& name, const TomlTable& table) {
  static const std::vector<std::string> kinds = {"directional", "point"};
  const std::string kind = table.string("kind");
  Light light;
  light.name = name;
  if (kind == "directional") {
    expect_keys(table, {"kind", "direction", "angular_radius_degrees", "color", "intensity", "casts"});
    const glm::vec3 direction = required_vec3(table, "direction");
    if (!(glm::length(direction) > 1e-6f))
      throw table.error("direction", "'direction' has no length; give the way the light travels");
    light.direction = glm::normalize(direction);
    light.angular_radius = glm::radians(static_cast<float>(table.optional_number("angular_radius_degrees", 0, 90).value_or(0)));
  } else if (kind == "point") {
    expect_keys(table, {"kind", "position", "radius", "color", "intensity", "casts"});
    light.kind = Light::Kind::point;
    light.position = required_vec3(table, "position");
    light.radius_m = static_cast<float>(table.optional_number("radius", 0, 1e9).value_or(0));
  } else {
    throw table.error("kind", unknown_name("kind of light", kind, kinds));
  }
  light.radiance = colour(table, "color", brightest).value_or(glm::vec3(1)) *
                   static_cast<float>(table.optional_number("intensity", 0, brightest).value_or(1));
  light.casts = table.optional_bool("casts").value_or(false);
  return light;
}

View read_view(const std::string& name, const TomlTable& table) {
  expect_keys(table, {"eye", "target", "up", "fov_y_degrees"});
  View view;
  view.name = name;
  view.eye = required_vec3(table, "eye");
  view.target = required_vec3(table, "target");
  view.up = vec3(table, "up").value_or(view.up);
  // Open ends: neither 0 nor 180 degrees makes a picture.
  view.fov_y_degrees = static_cast<float>(table.optional_number("fov_y_degrees", 0.1, 179).value_or(view.fov_y_degrees));
  const glm::vec3 ahead = view.target - view.eye;
  if (!(glm::length(ahead) > 0))
    throw table.error("target", "'eye' and 'target' are the same point; the view has no direction");
  const float sine = glm::length(glm::cross(glm::normalize(ahead), view.up)) / glm::length(view.up);
  if (!(sine > 1e-4f)) throw table.error("up", "'up' is zero or points along the view; choose another");
  return view;
}

void read_lights(Scene& scene, const TomlTable& root) {
  const auto entries = root.tables("lights");
  if (root.has("lights") && entries.empty())
    throw root.error("lights", "[lights] has no light; add [lights.NAME] or leave it out");
  if (entries.size() > max_lights)
    throw root.error("lights", fmt::format("there are {} lights; at most {} are drawn", entries.size(), max_lights));
  if (!entries.empty()) scene.lights.clear();
  for (const auto& [name, table] : entries) scene.lights.push_back(read_light(name, table));
}

void read_views(Scene& scene, const TomlTable& root) {
  const auto entries = root.tables("views");
  if (root.has("views") && entries.empty()) throw root.error("views", "[views] has no view; add [views.NAME] or leave it out");
  if (entries.empty()) return;
  scene.views.clear();
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (const auto& [name, table] : entries) {
    scene.views.push_back(read_view(name, table));
    fit_depth(scene.views.back(), bounds);
  }
}

// [objects.NAME]: where the object is, and the values of its effects' keys. "*" holds for all, and is applied first.
void read_objects(Scene& scene, const TomlTable& root, const std::filesystem::path& folder, const Library& library) {
  std::vector<std::string> names;
  for (const Object& object : scene.objects) names.push_back(object.name);
  std::vector<std::pair<std::string, TomlTable>> entries = root.tables("objects");
  std::stable_partition(entries.begin(), entries.end(), [](const auto& entry) { return entry.first == "*"; });
  for (const auto& [name, table] : entries) {
    const Keys keys = read_object_keys(table, placement_keys, library, folder);
    const Placement place = read_placement(table);
    const bool all = name == "*";
    if (!all && std::find(names.begin(), names.end(), name) == names.end())
      throw table.error({}, unknown_name("object", name, names));
    for (Object& object : scene.objects) {
      if (!all && object.name != name) continue;
      object.world_from_object = place.applied(object.world_from_object);
      apply_keys(object, keys, all, library);
    }
  }
}

// [effects.NAME]: the values of an effect's keys of the whole scene.
void read_effects(Scene& scene, const TomlTable& root, const std::filesystem::path& folder, const Library& library) {
  std::vector<std::string> known;
  for (const EffectManifest& effect : library.effects)
    if (!effect.scene.empty() || !effect.of_objects()) known.push_back(effect.name);
  for (const auto& [name, table] : root.tables("effects")) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw root.table("effects").error(name, unknown_name("effect with something to say of a scene", name, known));
    const EffectManifest& effect = library.effect(name);
    apply_scene_keys(scene, effect, read_scene_keys(table, effect, folder), library);
  }
}

}  // namespace

Scene read_model(const std::filesystem::path& file, const Library& library, float time_s) {
  Scene scene = scene_of_objects(load_gltf(file), time_s);
  scene.name = file.stem().string();
  declare_objects(scene.objects, library);
  return scene;
}

Scene read_scene_file(const std::filesystem::path& file, const Library& library, std::optional<float> time_s) {
  const TomlTable root = TomlTable::parse(file, "scene");
  expect_keys(root, {"scene", "objects", "effects", "lights", "views"});
  if (!root.has("scene")) throw root.error({}, "[scene] is missing; it names the model or the built-in scene");
  const TomlTable table = root.table("scene");
  expect_keys(table, {"model", "builtin", "name", "time", "background", "ambient"});

  const auto file_time_s = table.optional_number("time", -1e6, 1e6);
  const std::filesystem::path folder = file.parent_path();
  Scene scene = base_scene(table, folder, time_s.value_or(static_cast<float>(file_time_s.value_or(0))));
  scene.name = table.optional_string("name").value_or(file.stem().string());
  scene.background = colour(table, "background", brightest).value_or(scene.background);
  scene.ambient = colour(table, "ambient", brightest).value_or(scene.ambient);
  declare_objects(scene.objects, library);
  declare_said(scene, library);
  read_objects(scene, root, folder, library);
  read_effects(scene, root, folder, library);
  read_lights(scene, root);
  read_views(scene, root);
  return scene;
}

}  // namespace lamina
