// SPDX-License-Identifier: Apache-2.0
// One [[pass]] of a variant's manifest, and the settings that it shares with targets.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/manifest/variant_manifest.h"

namespace lamina {

// Names of targets that the harness makes itself.
inline constexpr std::string_view frame_target = "frame", depth_name = "depth";

// The parameter that "$NAME" stands for. Throws for one that there is not, with the nearest.
const ParameterManifest& parameter_named(const TomlTable& table, std::string_view key, const VariantManifest& variant,
                                         const std::string& reference);
// A number in the form's range, or a number parameter whose whole range lies there; nothing where the key is absent.
std::optional<Setting> read_setting(const TomlTable& table, std::string_view key, const VariantManifest& variant);
// A list of them: of numbers, or of "$NAME".
std::vector<Setting> read_settings(const TomlTable& table, std::string_view key, const VariantManifest& variant);

// As manifests and records name it.
std::string_view name_of(Blend blend);

// "$NAME", for forms.
inline constexpr const char* parameter_pattern = "^\\$.+";
// What a [[pass]] may hold. Not `whole`: of a manifest that is like another, whose pass may say the rest.
TomlFormPtr pass_form(bool whole);
// The variant's targets and parameters are known already.
PassManifest read_pass(const TomlTable& table, const VariantManifest& variant, const std::filesystem::path& shaders);

}  // namespace lamina
