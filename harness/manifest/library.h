// SPDX-License-Identifier: Apache-2.0
// Every effect with its variants, from the folders variants/ and shaders/ and a user's own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/manifest/effect_manifest.h"

namespace lamina {

// The keys of an object that say where it is; no effect may claim one.
inline const std::vector<TomlKey> placement_keys = {
    {"position", "metres, [x, y, z]", {form::numbers(-1e9, 1e9, {3})}},
    {"rotation_degrees", "turned about x, then y, then z", {form::numbers(-1e9, 1e9, {3})}},
    {"scale", "one number or [x, y, z], above 0", {form::number(1e-6, 1e6), form::numbers(0, 1e9, {3})}}};

struct Library {
  std::vector<EffectManifest> effects;  // in drawing order: those that do not read the frame, then those that do
  std::filesystem::path shaders;        // the folder of the built-in shaders
  const EffectCode* code = nullptr;

  // Throws Error(bad_input) with the nearest names.
  const EffectManifest& effect(std::string_view name) const;
  // Equal for libraries whose effects declare the same, byte for byte.
  std::string declarations() const;
  // What objects are drawn by that no other effect draws; null where no effect says so.
  const EffectManifest* otherwise() const;
};

// `home` holds variants/ and shaders/. Each of `user_dirs` holds variant manifests (which name their effect) and their shaders,
// or folders of whole effects with an effect.toml like the built-in ones. Throws Error(bad_input, "variants", "FILE:LINE",
// ...), also where two effects claim one key.
Library load_library(const std::filesystem::path& home, const EffectCode& code,
                     const std::vector<std::filesystem::path>& user_dirs = {});

}  // namespace lamina
