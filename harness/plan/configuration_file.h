// SPDX-License-Identifier: Apache-2.0
// A file that says at which variant each effect stands: what `lamina choose` writes, and compare, sweep, gate and plan take.
//
//   [configuration]
//   scene = "heart_in_fog"         # what it was chosen for
//   [variants]
//   EFFECT = "VARIANT"             # others stand at their baselines
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "harness/core/toml_form.h"
#include "harness/plan/plan.h"

namespace lamina {

TomlFormPtr configuration_form();

// Sets plan.chosen. Throws Error(bad_input) with the file and line for a key that is unknown, an effect that is none, and a
// variant that its effect has not (any more), with the nearest name. Effects that the scene does not call for may be named.
void apply_configuration(Plan& plan, const std::filesystem::path& file);

std::string configuration_text(const std::string& scene, const std::map<std::string, std::string>& variants);

}  // namespace lamina
