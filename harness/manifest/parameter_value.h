// SPDX-License-Identifier: Apache-2.0
// A value that a file gives a variant's parameter, held against what the parameter takes.
#pragma once

#include <string>
#include <string_view>

#include "harness/core/toml_table.h"
#include "harness/manifest/variant_manifest.h"

namespace lamina {

// The value. Throws the table's Error about `key` where it is out of the parameter's range, or no whole number where it must
// be.
double checked_number(const ParameterManifest& parameter, double value, const TomlTable& table, std::string_view key);
// The word's place among the parameter's words. Throws the table's Error about `key`, with the nearest word, where it is none.
double checked_word(const ParameterManifest& parameter, const std::string& word, const TomlTable& table, std::string_view key);

}  // namespace lamina
