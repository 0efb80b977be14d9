// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/scene_file.h"

#include <algorithm>

#include "harness/core/text.h"
#include "harness/core/toml_table.h"
#include "harness/scene/declare.h"
#include "harness/scene/default_views.h"
#include "harness/scene/gltf/gltf.h"
#include "harness/scene/made/builtin_scenes.h"
#include "harness/scene/nearest_surface.h"
#include "harness/scene/place_objects.h"
#include "harness/scene/read_keys.h"
#include "harness/scene/toml_values.h"

namespace lamina {
namespace {

TomlFormPtr light_form(const char* kind) {
  const bool directional = std::string_view(kind) == "directional";
  std::vector<TomlKey> keys = {
      {"kind", "directional or point", {form::word({kind})}, true},
      {"color", "linear", {colour_value(max_radiance)}},
      {"intensity", "irradiance at normal incidence; a point light's at 1 m", {form::number(0, max_radiance)}},
      {"casts", "passes with the view of a light are drawn for it", {form::flag()}}};
  if (directional) {
    keys.push_back({"direction", "the way the light travels", {vec3_value()}, true});
    keys.push_back({"angular_radius_degrees", "size as seen from the scene", {form::number(0, 90)}});
  } else {
    keys.push_back({"position", "metres", {vec3_value()}, true});
    keys.push_back({"radius", "of its sphere, metres", {form::number(0, 1e9)}});
  }
  return form::make(keys);
}
const TomlFormPtr directional_light = light_form("directional"), point_light = light_form("point");

std::vector<std::string> names_of_effects_of_scenes(const Library& library) {
  std::vector<std::string> names;
  for (const EffectManifest& effect : library.effects)
    if (!effect.scene.empty() || !effect.of_objects()) names.push_back(effect.name);
  return names;
}

Scene scene_of_model(const std::filesystem::path& file, std::optional<float> time_s) {
  LoadedModel model = load_gltf(file, time_s);
  Scene scene;
  scene.mesh_moves = model.mesh_moves;
  scene.objects_move = model.objects_move;
  scene.objects = std::move(model.objects);
  scene.warnings = std::move(model.warnings);
  scene.time_s = time_s.value_or(0);
  scene.background = glm::vec3(0.05f);  // mid-dark, neutral: neither hides silhouettes nor outshines the object
  scene.ambient = {0.10f, 0.11f, 0.125f};
  return scene;
}

// The scene that [scene] starts from.
Scene base_scene(const TomlTable& table, const std::filesystem::path& folder, std::optional<float> time_s) {
  if (table.has("model") == table.has("builtin"))
    throw table.error({}, "[scene] needs either model = \"FILE\" (.glb or .gltf) or builtin = \"NAME\"");
  if (table.has("builtin")) {
    return read_builtin(table.string("builtin"), time_s.value_or(0));
  }
  const std::filesystem::path file = folder / table.string("model");
  if (!std::filesystem::is_regular_file(file)) throw table.error("model", fmt::format("there is no file {}", file.string()));
  return scene_of_model(file, time_s);
}

Light read_light(const std::string& name, const TomlTable& either) {
  const TomlTable table = either.by(either.string("kind") == "directional" ? directional_light : point_light);
  table.check_keys();
  Light light;
  light.name = name;
  if (table.string("kind") == "directional") {
    const glm::vec3 direction = table.vec3("direction");
    if (!(glm::length(direction) > 1e-6f))
      throw table.error("direction", "'direction' has no length; give the way the light travels");
    light.direction = glm::normalize(direction);
    light.angular_radius = glm::radians(static_cast<float>(table.optional_number("angular_radius_degrees").value_or(0)));
  } else {
    light.kind = Light::Kind::point;
    light.position = table.vec3("position");
    light.radius_m = static_cast<float>(table.optional_number("radius").value_or(0));
  }
  light.radiance =
      table.optional_vec3("color").value_or(glm::vec3(1)) * static_cast<float>(table.optional_number("intensity").value_or(1));
  light.casts = table.optional_bool("casts").value_or(false);
  return light;
}

View read_view(const std::string& name, const TomlTable& table) {
  table.check_keys();
  View view;
  view.name = name;
  view.eye = table.vec3("eye");
  view.target = table.vec3("target");
  view.up = table.optional_vec3("up").value_or(view.up);
  view.fov_y_degrees = static_cast<float>(table.optional_number("fov_y_degrees").value_or(view.fov_y_degrees));
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
    keep_what_is_near(scene.views.back(), scene.objects);
  }
}

// [objects.NAME]: where the object is, and the values of its effects' keys. "*" holds for all, and is applied first.
void read_objects(Scene& scene, const TomlTable& root, const std::filesystem::path& folder, const Library& library) {
  std::vector<std::string> names;
  for (const Object& object : scene.objects) names.push_back(object.name);
  std::vector<std::pair<std::string, TomlTable>> entries = root.tables("objects");
  std::stable_partition(entries.begin(), entries.end(), [](const auto& entry) { return entry.first == "*"; });
  for (const auto& [name, table] : entries) {
    const Keys keys = read_object_keys(table, library, folder);
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
  const std::vector<std::string> known = names_of_effects_of_scenes(library);
  if (const TomlTable table = root.table("effects"); true)
    for (const std::string& name : table.keys())
      if (std::find(known.begin(), known.end(), name) == known.end())
        throw table.error(name, unknown_name("effect with something to say of a scene", name, known));
  for (const auto& [name, table] : root.tables("effects")) {
    const EffectManifest& effect = library.effect(name);
    apply_scene_keys(scene, effect, read_scene_keys(table, effect, folder), library);
  }
}

}  // namespace

TomlFormPtr scene_form(const Library& library) {
  const TomlFormPtr scene =
      form::make({{"model", "a .glb or .gltf file", {form::text()}},
                  {"builtin", "a built-in scene's name", {form::word(builtin_scenes(), "built-in scene")}},
                  {"name", "the scene's name in records", {form::text()}},
                  {"time", "moment, in seconds", {form::number(-1e6, 1e6)}},
                  {"still", "true: nothing moves, so that what can be done once is", {form::flag()}},
                  {"background", "linear colour behind everything", {colour_value(max_radiance)}},
                  {"ambient", "irradiance from all around", {colour_value(max_radiance)}}});
  const TomlFormPtr view = form::make({{"eye", "metres", {vec3_value()}, true},
                                       {"target", "metres", {vec3_value()}, true},
                                       {"up", "up in the picture", {vec3_value()}},
                                       // Open ends: neither 0 nor 180 degrees makes a picture.
                                       {"fov_y_degrees", "angle of view from bottom to top", {form::number(0.1, 179)}}});
  const TomlFormPtr light = form::one_of({{"kind", "", {form::word({"directional", "point"}, "kind of light")}, true}},
                                         {directional_light, point_light});
  std::vector<TomlKey> effects;
  for (const std::string& name : names_of_effects_of_scenes(library)) {
    const EffectManifest& effect = library.effect(name);
    effects.push_back({name, effect.title, {form::table(effect_keys_form(effect))}});
  }
  const auto named = [](const char* about, TomlFormPtr of) {
    return std::vector{form::table(form::make({}, TomlKey{"NAME", about, {form::table(std::move(of))}}))};
  };
  return form::make({{"scene", "what the scene starts from", {form::table(scene)}, true},
                     {"objects", "by name, or \"*\" for all", named("an object", object_form(library))},
                     {"effects", "of the whole scene", {form::table(form::make(effects))}},
                     {"lights", "they replace the scene's", named("a light", light)},
                     {"views", "they replace the scene's", named("a view", view)}});
}

Scene read_model(const std::filesystem::path& file, const Library& library, std::optional<float> time_s) {
  Scene scene = scene_of_model(file, time_s);
  scene.name = file.stem().string();
  declare_objects(scene.objects, library);
  return scene;
}

Scene read_scene_file(const std::filesystem::path& file, const Library& library, std::optional<float> time_s) {
  const TomlTable root = TomlTable::parse(file, "scene", scene_form(library));
  if (!root.has("scene")) throw root.error({}, "[scene] is missing; it names the model or the built-in scene");
  root.check_keys();
  const TomlTable table = root.table("scene");
  table.check_keys();

  if (const auto file_time_s = table.optional_number("time"); file_time_s && !time_s) time_s = static_cast<float>(*file_time_s);
  const std::filesystem::path folder = file.parent_path();
  Scene scene = base_scene(table, folder, time_s);
  scene.name = table.optional_string("name").value_or(file.stem().string());
  if (table.optional_bool("still").value_or(false)) scene.mesh_moves = scene.objects_move = scene.lights_move = false;
  scene.background = table.optional_vec3("background").value_or(scene.background);
  scene.ambient = table.optional_vec3("ambient").value_or(scene.ambient);
  declare_objects(scene.objects, library);
  declare_said(scene, library);
  read_objects(scene, root, folder, library);
  read_effects(scene, root, folder, library);
  read_lights(scene, root);
  read_views(scene, root);
  return scene;
}

}  // namespace lamina
