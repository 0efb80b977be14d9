// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/common.h"

#include <unistd.h>

#include <algorithm>

#include "harness/core/text.h"
#include "harness/plan/configuration_file.h"

namespace lamina {

bool is_compared(const VariantManifest& variant, const CellOptions& options) {
  if (variant.baseline || options.variants.empty()) return true;
  return std::ranges::any_of(options.variants, [full = variant.effect + "/" + variant.name, &variant](const std::string& name) {
    return name == variant.name || name == full;
  });
}

Library load_library_for(const SceneOptions& options) {
  return load_library(home_folder(), effect_code(), options.variants_dirs);
}

Plan plan_for(const SceneOptions& options, const Library& library, const Scene& scene, std::optional<double> aspect) {
  Plan plan = make_plan(library, scene, aspect);
  if (!options.configuration.empty()) apply_configuration(plan, options.configuration);
  return plan;
}

void check_variant_names(std::string_view stage, const std::vector<std::string>& wanted,
                         const std::vector<std::string>& known) {
  for (const std::string& name : wanted)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Error(ErrorKind::bad_input, std::string(stage), "--variant", unknown_name("variant", name, known));
}

std::vector<const EffectManifest*> compared_effects(const Plan& plan) {
  std::vector<const EffectManifest*> several, all;
  for (const EffectPlan& entry : plan.effects) {
    if (!entry.called_for) continue;
    all.push_back(entry.effect);
    if (entry.effect->variants.size() > 1) several.push_back(entry.effect);
  }
  return several.empty() ? all : several;
}

std::vector<std::string> variant_names(const std::vector<const EffectManifest*>& effects) {
  std::vector<std::string> names;
  for (const EffectManifest* effect : effects)
    for (const VariantManifest& variant : effect->variants) names.push_back(variant.name);
  return names;
}

namespace {

bool can_be_made(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  return !failure && ::access(folder.c_str(), W_OK) == 0;
}

[[noreturn]] void refuse_folder(std::string_view stage, const std::filesystem::path& out) {
  throw Error(ErrorKind::bad_input, std::string(stage), out.string(),
              "the folder cannot be made or written; choose another with --out");
}

}  // namespace

void make_folder(std::string_view stage, const std::filesystem::path& out) {
  if (!can_be_made(out)) refuse_folder(stage, out);
}

void make_run_folder(std::string_view stage, const std::filesystem::path& out) {
  if (!can_be_made(out) || !can_be_made(out / "images")) refuse_folder(stage, out);
}

void make_new_run_folder(std::string_view stage, const std::filesystem::path& out) {
  std::error_code not_there;
  std::filesystem::remove_all(out / "images", not_there);
  make_run_folder(stage, out);
}

Scene load_scene_for(const SceneOptions& options, const Library& library) {
  Scene scene = load_scene(options.scene, library, options.time_s);
  if (scene.objects.empty()) throw Error(ErrorKind::bad_input, "scene", scene.source, "has no objects");
  if (scene.views.empty()) throw Error(ErrorKind::bad_input, "scene", scene.source, "has no views");
  return scene;
}

}  // namespace lamina
