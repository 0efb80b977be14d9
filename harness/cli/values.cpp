// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/values.h"

#include <algorithm>
#include <filesystem>
#include <functional>

#include "harness/backend/backend.h"
#include "harness/cli/common.h"
#include "harness/cli/placeholders.h"
#include "harness/cli/schemas.h"
#include "harness/stress/family.h"
#include "harness/sweep/curves.h"
#include "harness/sweep/parameters.h"

namespace lamina {
namespace {

std::vector<std::string> typed_values(const Typed& typed, const std::string& option) {
  const auto found = typed.find(option);
  return found == typed.end() ? std::vector<std::string>{} : found->second;
}

SceneOptions scene_options(const Typed& typed) {
  SceneOptions options;
  const std::vector<std::string> scenes = typed_values(typed, "scene");
  if (!scenes.empty()) options.scene = scenes.back();
  for (const std::string& dir : typed_values(typed, "variants-dir")) options.variants_dirs.emplace_back(dir);
  return options;
}

Completions scenes(const Typed&) {
  Completions all{.files = true, .file_endings = {"toml", "glb", "gltf"}};
  for (const std::string& scene : builtin_scenes()) all.words.push_back({scene, "built-in scene"});
  return all;
}

Completions backends(const Typed&) {
  Completions all;
  for (const std::string_view name : backend_names()) all.words.push_back({std::string(name), "backend"});
  return all;
}

Completions devices(const Typed& typed) {
  Completions all;
  std::vector<std::string> asked = typed_values(typed, "backend");
  if (asked.empty()) asked = DeviceOptions().backends;
  for (const std::string& backend : asked) {
    const std::vector<DeviceInfo> there = survey_devices(backend).usable;
    for (size_t i = 0; i < there.size(); ++i)
      all.words.push_back({std::to_string(i), fmt::format("{} on {}", there[i].device, backend)});
  }
  return all;
}

Completions variants(const Typed& typed) {
  Completions all;
  const Library library = load_library_for(scene_options(typed));
  for (const EffectManifest& effect : library.effects)
    for (const VariantManifest& variant : effect.variants)
      all.words.push_back({variant.name, fmt::format("{}: {}", effect.name, variant.title)});
  return all;
}

Completions families(const Typed&) {
  Completions all{.files = true, .file_endings = {"toml"}};
  for (const Family& family : load_families(home_folder() / "shaders", effect_code()))
    all.words.push_back({family.name, family.title});
  return all;
}

Completions functions(const Typed& typed) {
  Completions all;
  const std::vector<std::string> asked = typed_values(typed, "family");
  for (const Family& family : load_families(home_folder() / "shaders", effect_code()))
    for (const FamilyFunction& function : family.functions)
      if (asked.empty() || asked.back() == family.name) all.words.push_back({function.name, family.title});
  return all;
}

Completions views(const Typed& typed) {
  Completions all;
  const SceneOptions options = scene_options(typed);
  for (const View& view : load_scene_for(options, load_library_for(options)).views) all.words.push_back({view.name, "view"});
  return all;
}

Completions paths(const Typed& typed) {
  Completions all;
  const SceneOptions options = scene_options(typed);
  const Library library = load_library_for(options);
  for (const Parameter& parameter : parameters_of(load_scene_for(options, library), library))
    all.words.push_back(
        {parameter.path + "=", fmt::format("[{:g} to {:g}] {}{}{}", parameter.min, parameter.max, parameter.unit,
                                           parameter.unit.empty() || parameter.title.empty() ? "" : ", ", parameter.title)});
  return all;
}

Completions limits(const Typed&) {
  Completions all;
  for (const Metric& metric : metrics) all.words.push_back({std::string(metric.name) + "=", metric.words});
  return all;
}

Completions schemas(const Typed&) {
  Completions all;
  for (const auto& [name, of] : schema_names()) all.words.push_back({name, of});
  return all;
}

}  // namespace

Completions completions_for(std::string_view word, const Typed& typed) {
  namespace of = placeholder;
  static const std::map<std::string_view, std::function<Completions(const Typed&)>> known = {
      {of::scene, scenes},
      {of::backend, backends},
      {of::device, devices},
      {of::variant, variants},
      {of::family, families},
      {of::function, functions},
      {of::view, views},
      {of::set, paths},
      {of::limit, limits},
      {of::schema, schemas},
      {of::schedule,
       [](const Typed&) {
         return Completions{.words = {{"none", ""}, {"all", ""}, {"every:", "every:N"}}};
       }},
      {of::directory, [](const Typed&) { return Completions{.folders = true}; }},
      {of::file, [](const Typed&) { return Completions{.files = true}; }},
      {of::record, [](const Typed&) { return Completions{.folders = true, .files = true, .file_endings = {"jsonl"}}; }},
      {of::gate_file, [](const Typed&) { return Completions{.files = true, .file_endings = {"toml"}}; }},
  };
  const auto found = known.find(word);
  return found == known.end() ? Completions{} : found->second(typed);
}

}  // namespace lamina
