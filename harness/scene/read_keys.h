// SPDX-License-Identifier: Apache-2.0
// Tables of scene files by what effects declare: which keys there are, what they take, and where a mistake stands.
#pragma once

#include <filesystem>
#include <vector>

#include "harness/core/toml_table.h"
#include "harness/manifest/library.h"
#include "harness/scene/keys.h"

namespace lamina {

// What [objects.NAME] may hold: where the object is, and what effects declare of objects.
TomlFormPtr object_form(const Library& library);
// What [effects.NAME] may hold: what this effect declares of the whole scene.
TomlFormPtr effect_keys_form(const EffectManifest& effect);

// What one [objects.NAME] says to effects; the table is of the form above. Files are relative to `folder` and must be
// there; nothing is loaded yet. Throws Error(bad_input) with file and line: for a key that there is not, with the nearest; for
// a value that the declaration does not allow; for an effect that is spoken of and taken away; for two that exclude each other.
Keys read_object_keys(const TomlTable& table, const Library& library, const std::filesystem::path& folder);
// What [effects.NAME] says to one effect about the whole scene.
Keys read_scene_keys(const TomlTable& table, const EffectManifest& effect, const std::filesystem::path& folder);

}  // namespace lamina
