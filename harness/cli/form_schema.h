// SPDX-License-Identifier: Apache-2.0
// JSON Schemas (draft 7, which editors of TOML read) of what a TOML file may hold.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "harness/core/toml_form.h"

namespace lamina {

// Of a table: its keys, what they take, those that must be there. It refuses nothing that the readers take; what holds across
// keys they alone know.
nlohmann::ordered_json schema_of_form(const TomlForm& form);

}  // namespace lamina
