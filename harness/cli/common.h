// SPDX-License-Identifier: Apache-2.0
// What commands do alike: where they read variants, shaders and scenes, which variants they compare, the folder they write.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/cli/home.h"
#include "harness/cli/options.h"
#include "harness/plan/plan.h"

namespace lamina {

Library load_library_for(const SceneOptions& options);
// A scene that has objects and views, or Error(bad_input).
Scene load_scene_for(const SceneOptions& options, const Library& library);

// make_plan(), and at which variants effects stand by the options' configuration file.
Plan plan_for(const SceneOptions& options, const Library& library, const Scene& scene,
              std::optional<double> aspect = std::nullopt);

// Whether the options ask for this variant; a baseline is always compared.
bool is_compared(const VariantManifest& variant, const CellOptions& options);
// Effects with something to compare; where there are none, whatever the scene calls for, so that its picture and cost are
// known.
std::vector<const EffectManifest*> compared_effects(const Plan& plan);
std::vector<std::string> variant_names(const std::vector<const EffectManifest*>& effects);
// Throws Error(bad_input) for the first of `wanted` that is not in `known`, with the nearest known name. `stage` is the
// command.
void check_variant_names(std::string_view stage, const std::vector<std::string>& wanted, const std::vector<std::string>& known);

// Makes `out`, which may be there. Throws Error(bad_input) where it cannot be made or written.
void make_folder(std::string_view stage, const std::filesystem::path& out);
// Makes `out` and its images/, which may be there. Throws Error(bad_input) where they cannot be made or written.
void make_run_folder(std::string_view stage, const std::filesystem::path& out);
// The same for a run that begins anew: pictures of an earlier one are gone.
void make_new_run_folder(std::string_view stage, const std::filesystem::path& out);

}  // namespace lamina
