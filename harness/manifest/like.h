// SPDX-License-Identifier: Apache-2.0
// A manifest that says like = "NAME": all of the manifest NAME.toml beside it, with what it says otherwise. docs/manifest.md
// has the rules.
#pragma once

#include "harness/core/toml_table.h"

namespace lamina {

// Nodes remember the file that they come from. Throws Error(bad_input, "variants", "FILE:LINE", ...).
TomlTable manifest_nodes(const std::filesystem::path& file, TomlFormPtr form);

}  // namespace lamina
