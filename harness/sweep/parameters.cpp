// SPDX-License-Identifier: Apache-2.0
#include "harness/sweep/parameters.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/scene/declare.h"
#include "harness/scene/default_views.h"
#include "harness/scene/facts.h"

namespace lamina {
namespace {

constexpr double furthest_m = 1e6, brightest = 60000;
constexpr std::array<const char*, 3> axes = {"x", "y", "z"}, channels = {"red", "green", "blue"};

class Collector {
 public:
  explicit Collector(const Scene& scene) : scene_(scene) {}

  Parameter& add(std::string path, std::string unit, std::string title, double min, double max, std::optional<double> value,
                 std::function<void(Scene&, double)> set, bool whole = false) {
    all.push_back(
        {std::move(path), std::move(unit), std::move(title), min, max, false, whole, {}, false, value, std::move(set)});
    return all.back();
  }
  // `get` finds the number in any scene like this one.
  template <class Get>
  void add_float(std::string path, std::string unit, std::string title, double low, double high, Get get) {
    Scene& unchanged = const_cast<Scene&>(scene_);  // only read here: `get` serves both ways
    add(std::move(path), std::move(unit), std::move(title), low, high, decimal(get(unchanged)),
        [get](Scene& scene, double value) { get(scene) = static_cast<float>(value); });
  }
  template <class Get>
  void add_vec3(const std::string& path, const std::array<const char*, 3>& names, const char* unit, const std::string& title,
                double low, double high, Get get) {
    for (int i = 0; i < 3; ++i)
      add_float(path + "." + names[i], unit, title, low, high, [get, i](Scene& scene) -> float& { return get(scene)[i]; });
  }

  std::vector<Parameter> all;

 private:
  const Scene& scene_;
};

// The alpha of every texel, where it is one.
std::optional<double> alpha_of(const TextureImage& texture) {
  const std::vector<std::byte>& texels = texture.levels[0];
  for (size_t i = 7; i < texels.size(); i += 4)
    if (texels[i] != texels[3]) return std::nullopt;
  return std::round(std::to_integer<int>(texels[3]) / 255.0 * 1e4) / 1e4;
}

double place_of(const std::vector<std::string>& words, const std::string& word) {
  return static_cast<double>(std::find(words.begin(), words.end(), word) - words.begin());
}

// What an effect declares, of an object or of the scene. `values` finds it in any scene like this one; `changed` is called
// after a texture was replaced.
void add_declared(Collector& out, const std::string& prefix, const Declarations& declared, const Scene& unchanged,
                  const std::function<EffectValues&(Scene&)>& values, const std::function<void(Scene&)>& changed) {
  const EffectValues& now = values(const_cast<Scene&>(unchanged));  // only read here
  for (const NumberManifest& number : declared.numbers) {
    const auto known = now.numbers.find(number.name);
    Parameter& made = out.add(
        prefix + number.key, number.unit, number.title, number.min, number.max,
        known == now.numbers.end() ? std::nullopt : std::optional(known->second),
        [values, name = number.name, whole = number.whole](Scene& scene, double value) {
          values(scene).numbers[name] = whole ? value : decimal(static_cast<float>(value));
        },
        number.whole);
    made.or_zero = number.or_zero;
  }
  for (const TextureManifest& texture : declared.textures) {
    if (texture.alpha.empty()) continue;
    out.add(prefix + texture.alpha, "", texture.alpha_title, 0, 1, alpha_of(*now.textures.at(texture.name)),
            [values, changed, name = texture.name, meaning = texture.meaning](Scene& scene, double value) {
              set_alpha(values(scene).textures.at(name), meaning, static_cast<float>(value));
              changed(scene);
            });
  }
  for (const WordManifest& word : declared.words) {
    Parameter& made = out.add(
        prefix + word.key, "", word.title, 0, static_cast<double>(word.of.size() - 1),
        place_of(word.of, now.words.at(word.name)),
        [values, name = word.name, of = word.of](Scene& scene, double value) {
          values(scene).words[name] = of.at(static_cast<size_t>(value));
        },
        true);
    made.words = word.of;
  }
}

void add_object(Collector& out, const Scene& scene, const Library& library, size_t i) {
  const Object& object = scene.objects[i];
  const std::string path = "objects." + object.name + ".";
  for (const EffectManifest& effect : library.effects)
    if (object.effects.contains(effect.name))
      add_declared(
          out, path, effect.object, scene,
          [i, name = effect.name](Scene& s) -> EffectValues& { return s.objects[i].effects.at(name); },
          [i, &effect](Scene& s) { settle_facts(s.objects[i], effect); });
  for (int axis = 0; axis < 3; ++axis)
    out.add_float(path + "position." + axes[axis], "m", "where its origin lies", -furthest_m, furthest_m,
                  [i, axis](Scene& s) -> float& { return s.objects[i].world_from_object[3][axis]; });
  for (int axis = 0; axis < 3; ++axis)
    out.add(path + "rotation_degrees." + axes[axis], "degrees", "turned further about its origin", -360, 360, 0.0,
            [i, axis](Scene& s, double value) {
              glm::mat4& world = s.objects[i].world_from_object;
              glm::vec3 about(0);
              about[axis] = 1;
              const glm::mat4 turn = glm::rotate(glm::mat4(1), glm::radians(static_cast<float>(value)), about);
              const glm::vec4 place = world[3];
              world = turn * world;
              world[3] = place;
            });
  out.add(path + "scale", "", "larger about its origin", 1e-6, 1e6, 1.0, [i](Scene& s, double value) {
    for (int column = 0; column < 3; ++column) s.objects[i].world_from_object[column] *= static_cast<float>(value);
  });
}

// Where a directional light comes from: azimuth from +z towards +x, elevation above the horizon.
glm::dvec2 angles_of(const Light& light) {
  const glm::dvec3 to_light = -glm::dvec3(light.direction);
  return glm::degrees(glm::dvec2(std::atan2(to_light.x, to_light.z), std::asin(std::clamp(to_light.y, -1.0, 1.0))));
}

void set_angles(Light& light, glm::dvec2 degrees) {
  const glm::dvec2 at = glm::radians(degrees);
  light.direction = -glm::vec3(std::sin(at.x) * std::cos(at.y), std::sin(at.y), std::cos(at.x) * std::cos(at.y));
}

float strongest(glm::vec3 radiance) { return std::max({radiance.x, radiance.y, radiance.z}); }

void add_light(Collector& out, const Scene& scene, size_t i) {
  const Light& light = scene.lights[i];
  const std::string path = "lights." + light.name + ".";
  // Its colour stays; a black light becomes white.
  out.add(path + "intensity", "", "irradiance of its strongest channel at normal incidence (point: at 1 m)", 0, brightest,
          decimal(strongest(light.radiance)), [i](Scene& s, double value) {
            glm::vec3& radiance = s.lights[i].radiance;
            const float now = strongest(radiance);
            radiance = now > 0 ? radiance * (static_cast<float>(value) / now) : glm::vec3(static_cast<float>(value));
          });
  out.add_vec3(path + "radiance", channels, "", "irradiance at normal incidence (point: at 1 m), linear", 0, brightest,
               [i](Scene& s) -> glm::vec3& { return s.lights[i].radiance; });
  if (light.kind == Light::Kind::point) {
    out.add_vec3(path + "position", axes, "m", "", -furthest_m, furthest_m,
                 [i](Scene& s) -> glm::vec3& { return s.lights[i].position; });
    out.add_float(path + "radius", "m", "of its sphere", 0, 1e9, [i](Scene& s) -> float& { return s.lights[i].radius_m; });
    return;
  }
  const glm::dvec2 angles = angles_of(light);
  out.add(path + "azimuth_degrees", "degrees", "where it comes from, from +z towards +x", -360, 360,
          decimal(static_cast<float>(angles.x)), [i](Scene& s, double value) {
            set_angles(s.lights[i], {value, angles_of(s.lights[i]).y});
          });
  out.add(path + "elevation_degrees", "degrees", "where it comes from, above the horizon", -90, 90,
          decimal(static_cast<float>(angles.y)), [i](Scene& s, double value) {
            set_angles(s.lights[i], {angles_of(s.lights[i]).x, value});
          });
  out.add(path + "angular_radius_degrees", "degrees", "", 0, 90, decimal(glm::degrees(light.angular_radius)),
          [i](Scene& s, double value) { s.lights[i].angular_radius = glm::radians(static_cast<float>(value)); });
}

void add_view(Collector& out, const Scene& scene, size_t i) {
  const std::string path = "views." + scene.views[i].name + ".";
  out.add_vec3(path + "eye", axes, "m", "", -furthest_m, furthest_m, [i](Scene& s) -> glm::vec3& { return s.views[i].eye; });
  out.add_vec3(path + "target", axes, "m", "", -furthest_m, furthest_m,
               [i](Scene& s) -> glm::vec3& { return s.views[i].target; });
  out.add_float(path + "fov_y_degrees", "degrees", "angle of view from bottom to top", 0.1, 179,
                [i](Scene& s) -> float& { return s.views[i].fov_y_degrees; });
}

// The last `count` parts of a path: 2 of "objects.heart.thickness" are "heart.thickness".
std::string last_parts(const std::string& path, size_t count) {
  size_t begin = path.size();
  for (size_t part = 0; part < count && begin > 0; ++part) {
    const size_t dot = path.rfind('.', begin - 1);
    begin = dot == std::string::npos ? 0 : dot;
  }
  return path.substr(begin + (begin > 0 && begin < path.size() ? 1 : 0));
}

// The paths whose ends are nearest to `path`, which may lack the beginning: "'objects.a.thickness' or 'objects.b.thickness'";
// "" where none is near.
std::string nearest_paths(const std::vector<Parameter>& parameters, const std::string& path) {
  constexpr size_t max_named = 3;
  const size_t parts = 1 + static_cast<size_t>(std::count(path.begin(), path.end(), '.'));
  std::vector<std::string> ends;
  for (const Parameter& parameter : parameters) ends.push_back(last_parts(parameter.path, parts));
  const std::string nearest = nearest_name(path, ends);
  std::vector<std::string> named;
  for (size_t i = 0; i < ends.size() && named.size() < max_named; ++i)
    if (!nearest.empty() && ends[i] == nearest) named.push_back("'" + parameters[i].path + "'");
  return fmt::format("{}", fmt::join(named, " or "));
}

// "objects.*.thickness" for "objects.NAME.thickness", of one object too: what is written for one scene then serves another.
void add_for_all(Collector& out, const Scene& scene) {
  const std::vector<Parameter> single = out.all;
  std::vector<std::string> done;
  for (const Parameter& first : single)
    for (const Object& object : scene.objects) {
      const std::string prefix = "objects." + object.name + ".";
      if (!first.path.starts_with(prefix)) continue;
      const std::string name = first.path.substr(prefix.size());
      if (std::find(done.begin(), done.end(), name) != done.end()) continue;
      std::vector<Parameter> same;
      for (const Object& other : scene.objects)
        for (const Parameter& candidate : single)
          if (candidate.path == "objects." + other.name + "." + name) same.push_back(candidate);
      done.push_back(name);
      Parameter all = first;
      all.path = "objects.*." + name;
      all.title += all.title.empty() ? "of all objects" : ", of all objects";
      for (const Parameter& one : same)
        if (one.value != first.value) all.value.reset();
      all.set = [same](Scene& s, double value) {
        for (const Parameter& one : same) one.set(s, value);
      };
      out.all.push_back(std::move(all));
    }
}

}  // namespace

std::vector<Parameter> parameters_of(const Scene& scene, const Library& library) {
  Collector out(scene);
  out.add(time_path, "s", "moment of the scene", -1e6, 1e6, decimal(scene.time_s), {});
  out.add_vec3("scene.ambient", channels, "", "irradiance from all around, linear", 0, brightest,
               [](Scene& s) -> glm::vec3& { return s.ambient; });
  out.add_vec3("scene.background", channels, "", "linear", 0, brightest, [](Scene& s) -> glm::vec3& { return s.background; });
  for (const EffectManifest& effect : library.effects)
    if (scene.effects.contains(effect.name))
      add_declared(
          out, "effects." + effect.name + ".", effect.scene, scene,
          [name = effect.name](Scene& s) -> EffectValues& { return s.effects.at(name); }, [](Scene&) {});
  for (size_t i = 0; i < scene.objects.size(); ++i) add_object(out, scene, library, i);
  add_for_all(out, scene);
  for (size_t i = 0; i < scene.lights.size(); ++i) add_light(out, scene, i);
  for (size_t i = 0; i < scene.views.size(); ++i) add_view(out, scene, i);
  for (const EffectManifest& effect : library.effects)
    for (const VariantManifest& variant : effect.variants)
      for (const ParameterManifest& parameter : variant.parameters)
        out.add(variant.name + "." + parameter.name, parameter.unit, parameter.title, parameter.min, parameter.max,
                parameter.value, {}, parameter.whole)
            .words = parameter.words;
  for (Parameter& parameter : out.all) {
    const auto has = [&](const char* part) { return parameter.path.find(part) != std::string::npos; };
    parameter.moves =
        parameter.path.starts_with("views.") ||
        (parameter.path.starts_with("objects.") && (has(".position.") || has(".rotation_degrees.") || has(".scale")));
  }
  return std::move(out.all);
}

const Parameter& parameter_named(const std::vector<Parameter>& parameters, const std::string& path) {
  for (const Parameter& parameter : parameters)
    if (parameter.path == path) return parameter;
  const std::string nearest = nearest_paths(parameters, path);
  throw Error(ErrorKind::bad_input, "sweep", "--set " + path,
              fmt::format("unknown parameter '{}'{}; 'lamina list --parameters SCENE' names all", path,
                          nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest)));
}

void check_value(const Parameter& parameter, double value) {
  const auto refuse = [&](const std::string& why) {
    throw Error(ErrorKind::bad_input, "sweep", "--set " + parameter.path, fmt::format("{} {}", value, why));
  };
  if (parameter.or_zero && value == 0) return;
  if (!(value >= parameter.min && value <= parameter.max))
    refuse(fmt::format("is out of range: it takes {}{} to {}{}{}", parameter.or_zero ? "0, or " : "", parameter.min,
                       parameter.max, parameter.unit.empty() ? "" : " ", parameter.unit));
  if (parameter.whole && value != std::floor(value)) refuse("is not a whole number");
}

}  // namespace lamina
