// SPDX-License-Identifier: Apache-2.0
#include "harness/sweep/swept_scene.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/scene/default_views.h"
#include "harness/scene/digest.h"

namespace lamina {
namespace {

// Every texture of a scene, in a fixed order.
std::vector<Texture*> textures_of(Scene& scene) {
  std::vector<Texture*> textures;
  const auto add = [&](auto& effects) {
    for (auto& [effect, values] : effects)
      for (auto& [name, texture] : values.textures) textures.push_back(&texture);
  };
  for (Object& object : scene.objects) add(object.effects);
  add(scene.effects);
  return textures;
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

// Whether setting `later` changes a number that `earlier` has set: the record would then be wrong about it.
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

// Words as their places among those that the parameter takes.
void settle_words(SweptParameter& swept, const Parameter& parameter) {
  const auto refuse = [&](const std::string& why) { throw Error(ErrorKind::bad_input, "sweep", "--set " + swept.path, why); };
  if (parameter.words.empty() && !swept.words.empty())
    refuse(fmt::format("'{}' is no number, which it takes", swept.words.front()));
  if (!parameter.words.empty() && swept.words.empty()) refuse(fmt::format("takes words: {}", fmt::join(parameter.words, ", ")));
  for (const std::string& word : swept.words) {
    const auto found = std::find(parameter.words.begin(), parameter.words.end(), word);
    if (found == parameter.words.end()) refuse(unknown_name("word", word, parameter.words));
    const auto place = static_cast<double>(found - parameter.words.begin());
    if (std::find(swept.values.begin(), swept.values.end(), place) != swept.values.end())
      refuse("has a value twice; give each once");
    swept.values.push_back(place);
  }
}

std::string words_of_number(double value) { return fmt::format("{:.6g}", value); }

}  // namespace

SweptScene::SweptScene(Scene scene, const Library& library, SweepPoints points)
    : library_(library), base_(std::move(scene)), points_(std::move(points)) {
  const std::vector<Parameter> all = lamina::parameters_of(base_, library);
  for (SweptParameter& swept : points_.parameters) settle_words(swept, parameter_named(all, swept.path));
  points_.check();
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
  if (moment_ && moment_->time_s == time_s) return *moment_;
  Scene next = load_scene(base_.source, library_, time_s);
  std::erase_if(next.views, [&](const View& view) {
    return std::none_of(base_.views.begin(), base_.views.end(), [&](const View& kept) { return kept.name == view.name; });
  });
  const std::vector<Texture*> known = textures_of(base_), made = textures_of(next);
  for (size_t i = 0; i < made.size() && made.size() == known.size(); ++i)
    if (texture_digest(*made[i]) == texture_digest(*known[i])) *made[i] = *known[i];
  moment_ = std::move(next);
  return *moment_;
}

Scene SweptScene::at(size_t point) {
  const std::vector<double> values = points_.at(point);
  std::optional<float> time_s;
  for (size_t i = 0; i < values.size(); ++i)
    if (parameters_[i].path == time_path) time_s = static_cast<float>(values[i]);
  Scene scene = time_s ? at_time(*time_s) : base_;
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

std::map<std::string, std::string> SweptScene::words_at(size_t point) const {
  std::map<std::string, std::string> words;
  const std::vector<double> values = points_.at(point);
  for (size_t i = 0; i < values.size(); ++i)
    if (!parameters_[i].words.empty()) words[parameters_[i].path] = parameters_[i].words[static_cast<size_t>(values[i])];
  return words;
}

std::string SweptScene::words(size_t point) const {
  std::string text;
  const std::vector<double> values = points_.at(point);
  for (size_t i = 0; i < values.size(); ++i)
    text += fmt::format(
        "{}{} {}{}{}", i == 0 ? "" : ", ", parameters_[i].path,
        parameters_[i].words.empty() ? words_of_number(values[i]) : parameters_[i].words[static_cast<size_t>(values[i])],
        parameters_[i].unit.empty() ? "" : " ", parameters_[i].unit);
  return text;
}

}  // namespace lamina
