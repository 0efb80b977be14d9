// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/toml_values.h"

namespace lamina {

void expect_keys(const TomlTable& table, std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys) table.has(key);
  table.refuse_unknown_keys();
}

std::optional<glm::vec3> vec3(const TomlTable& table, std::string_view key) {
  constexpr float largest = 1e9f;  // metres; squares of differences stay far inside a float's range
  const std::optional<glm::vec3> value = table.optional_vec3(key);
  if (value && !glm::all(glm::lessThanEqual(glm::abs(*value), glm::vec3(largest))))
    throw table.error(key, fmt::format("'{}' must lie within +-1e9", key));
  return value;
}

glm::vec3 required_vec3(const TomlTable& table, std::string_view key) {
  const std::optional<glm::vec3> value = vec3(table, key);
  if (!value) throw table.error({}, fmt::format("'{}' is missing: it must be a list of three numbers", key));
  return *value;
}

std::optional<glm::vec3> colour(const TomlTable& table, std::string_view key, float highest) {
  const std::optional<glm::vec3> value = table.optional_vec3(key);
  if (value &&
      !(glm::all(glm::greaterThanEqual(*value, glm::vec3(0))) && glm::all(glm::lessThanEqual(*value, glm::vec3(highest)))))
    throw table.error(key, fmt::format("'{}' must be a linear colour [r, g, b], each from 0 to {}", key, highest));
  return value;
}

}  // namespace lamina
