// SPDX-License-Identifier: Apache-2.0
#include "harness/sweep/swept_scene.h"

#include <algorithm>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/graph/inputs.h"
#include "harness/scene/default_views.h"

namespace lamina {
namespace {

using Texture = std::shared_ptr<const TextureImage>;

// Every texture of a scene, in a fixed order; null where an object has no layers.
std::vector<Texture*> textures_of(Scene& scene) {
  std::vector<Texture*> textures;
  for (Object& object : scene.objects) {
    textures.push_back(&object.albedo);
    if (!object.layers) continue;
    for (Texture* texture : {&object.layers->outer_albedo, &object.layers->outer_normal, &object.layers->inner_albedo})
      textures.push_back(texture);
  }
  return textures;
}

bool same(const TextureImage& a, const TextureImage& b) {
  return a.format == b.format && a.width == b.width && a.height == b.height && a.levels == b.levels;
}

template <class T>
std::string_view bytes_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

// What was moved out of the depth range that a view was given comes back into it.
void widen_depth(Scene& scene) {
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) {
    View fitted = view;
    fit_depth(fitted, bounds);
    view.near_m = std::min(view.near_m, fitted.near_m);
    view.far_m = std::max(view.far_m, fitted.far_m);
  }
}

// Whether setting `later` changes a number that `earlier` has set, which the record would then tell wrongly.
bool undoes(const Scene& scene, const std::string& earlier, const std::string& later) {
  constexpr std::string_view all = "objects.*.";
  if (later.starts_with(all))
    return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
      return earlier == "objects." + object.name + "." + later.substr(all.size());
    });
  return std::any_of(scene.lights.begin(), scene.lights.end(), [&](const Light& light) {
    const std::string intensity = "lights." + light.name + ".intensity", radiance = "lights." + light.name + ".radiance.";
    return (earlier == intensity && later.starts_with(radiance)) || (later == intensity && earlier.starts_with(radiance));
  });
}

std::string words_of_number(double value) { return fmt::format("{:.6g}", value); }

}  // namespace

SweptScene::SweptScene(Scene scene, const Library& library, SweepPoints points)
    : base_(std::move(scene)), moment_(base_), points_(std::move(points)) {
  points_.check();
  const std::vector<Parameter> all = lamina::parameters_of(base_, library);
  for (SweptParameter& swept : points_.parameters) {
    const Parameter& parameter = parameter_named(all, swept.path);
    for (const Parameter& earlier : parameters_)
      if (undoes(base_, earlier.path, swept.path))
        throw Error(ErrorKind::bad_input, "sweep", "--set " + swept.path,
                    fmt::format("would change what --set {} has set; {}", earlier.path,
                                swept.path.starts_with("objects.*.") ? "give it first" : "leave one of them out"));
    for (const double value : swept.values) check_value(parameter, value);
    swept.unit = parameter.unit;
    parameters_.push_back(parameter);
  }
}

const Scene& SweptScene::at_time(float time_s) {
  if (moment_.time_s == time_s) return moment_;
  Scene next = load_scene(base_.source, time_s);
  std::erase_if(next.views, [&](const View& view) {
    return std::none_of(base_.views.begin(), base_.views.end(), [&](const View& kept) { return kept.name == view.name; });
  });
  const std::vector<Texture*> known = textures_of(base_), made = textures_of(next);
  for (size_t i = 0; i < made.size() && made.size() == known.size(); ++i)
    if (*made[i] && *known[i] && same(**made[i], **known[i])) *made[i] = *known[i];
  moment_ = std::move(next);
  return moment_;
}

Scene SweptScene::at(size_t point) {
  const std::vector<double> values = points_.at(point);
  float time_s = base_.time_s;
  for (size_t i = 0; i < values.size(); ++i)
    if (parameters_[i].path == time_path) time_s = static_cast<float>(values[i]);
  Scene scene = at_time(time_s);
  for (size_t i = 0; i < values.size(); ++i)
    if (parameters_[i].set) parameters_[i].set(scene, values[i]);
  if (std::any_of(parameters_.begin(), parameters_.end(), [](const Parameter& parameter) { return parameter.moves; }))
    widen_depth(scene);
  return scene;
}

std::map<std::string, double> SweptScene::params(size_t point) const {
  std::map<std::string, double> params;
  const std::vector<double> values = points_.at(point);
  for (size_t i = 0; i < values.size(); ++i) params[parameters_[i].path] = values[i];
  return params;
}

Parameters SweptScene::parameters_of_variant(const VariantManifest& variant, size_t point) const {
  Parameters own;
  const std::map<std::string, double> values = params(point);
  for (const ParameterManifest& parameter : variant.parameters)
    if (const auto set = values.find(variant.name + "." + parameter.name); set != values.end())
      own[parameter.name] = set->second;
  return own;
}

std::string SweptScene::words(size_t point) const {
  std::string text;
  const std::vector<double> values = points_.at(point);
  for (size_t i = 0; i < values.size(); ++i)
    text += fmt::format("{}{} {}{}{}", i == 0 ? "" : ", ", parameters_[i].path, words_of_number(values[i]),
                        parameters_[i].unit.empty() ? "" : " ", parameters_[i].unit);
  return text;
}

std::string scene_hash(const Scene& scene) {
  Scene copy = scene;  // textures_of() hands out pointers to change them by
  std::string text = scene.name + meshes_hash(scene);
  for (const Texture* texture : textures_of(copy)) {
    if (!*texture) continue;
    text += bytes_of((*texture)->format);
    for (const std::vector<std::byte>& level : (*texture)->levels)
      text += hash_hex({reinterpret_cast<const char*>(level.data()), level.size()});
  }
  for (const Object& object : scene.objects) {
    text += object.name;
    text += bytes_of(object.world_from_object);
    if (object.layers) text += fmt::format(" {} {}", object.layers->thickness_texels, object.layers->scattering);
    if (const auto& bake = object.apertures)
      text += fmt::format(" {} {} {} {} {}", static_cast<int>(bake->baker), bake->map_texels, bake->rays, bake->seed,
                          bake->bias_m.value_or(0));
  }
  for (const Light& light : scene.lights) {
    text += light.name;
    text += fmt::format(" {} {} {}", static_cast<int>(light.kind), light.angular_radius, light.radius_m);
    for (const glm::vec3& v : {light.direction, light.position, light.radiance}) text += bytes_of(v);
  }
  for (const View& view : scene.views) {
    text += view.name;
    for (const glm::vec3& v : {view.eye, view.target, view.up}) text += bytes_of(v);
    text += fmt::format(" {} {} {}", view.fov_y_degrees, view.near_m, view.far_m);
  }
  text += bytes_of(scene.ambient), text += bytes_of(scene.background);
  return hash_hex(text);
}

}  // namespace lamina
