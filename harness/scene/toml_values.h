// SPDX-License-Identifier: Apache-2.0
// Values of scene files: vectors and colours out of a TOML table, checked.
#pragma once

#include <glm/glm.hpp>
#include <initializer_list>
#include <optional>

#include "harness/core/toml_table.h"

namespace lamina {

// Refuses all other keys, before any of these is missed.
void expect_keys(const TomlTable& table, std::initializer_list<std::string_view> keys);

// Three numbers, each within +-1e9; nothing where the key is absent.
std::optional<glm::vec3> vec3(const TomlTable& table, std::string_view key);
// The same, and an error where the key is absent.
glm::vec3 required_vec3(const TomlTable& table, std::string_view key);

// Linear red, green, blue, each from 0 to `highest`.
std::optional<glm::vec3> colour(const TomlTable& table, std::string_view key, float highest);

}  // namespace lamina
