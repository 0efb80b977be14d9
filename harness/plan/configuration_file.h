// SPDX-License-Identifier: Apache-2.0
// A file that says at which variant each effect stands: what `lamina choose` writes, and compare, sweep, gate and plan take.
//
//   [configuration]
//   scene = "heart_in_fog"         # what it was chosen for
//   [variants]
//   EFFECT = "VARIANT"             # others stand at their baselines
//   [parameters]
//   "VARIANT.PARAMETER" = 512      # others have their defaults
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "harness/core/toml_form.h"
#include "harness/plan/plan.h"

namespace lamina {

TomlFormPtr configuration_form();

// Sets plan.chosen. Throws Error(bad_input) with the file and line for a key that is unknown, an effect that is none, a variant
// that its effect has not (any more), and a parameter that its variant has not, with the nearest name; and for a value out of
// the parameter's range. Effects that the scene does not call for may be named.
void apply_configuration(Plan& plan, const std::filesystem::path& file);

// Of these variants, by effect; a parameter that differs from that of the library's variant of the same name is written too.
std::string configuration_text(const std::string& scene, const Library& library, const Configuration& configuration);

}  // namespace lamina
