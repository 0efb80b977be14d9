// SPDX-License-Identifier: Apache-2.0
// What a scene says under the keys that effects declare: by a scene file, or by code that makes a scene.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <set>
#include <string>
#include <variant>

#include "harness/scene/effect_values.h"

namespace lamina {

struct KeyValue {
  // A number, a word, a colour (linear, 0 to 1), a picture's file, or a finished texture (of code; for a key of transparency
  // its alpha counts).
  std::variant<double, std::string, glm::vec3, std::filesystem::path, Texture> value;
  std::string where = {};  // FILE:LINE
};

struct Keys {
  std::map<std::string, KeyValue, std::less<>> values;  // by the whole key, dots and all
  std::set<std::string> calls;                          // effects that are spoken of
  std::set<std::string> taken_away;                     // effects
  std::string where = {};

  const KeyValue* find(const std::string& key) const {
    const auto found = values.find(key);
    return key.empty() || found == values.end() ? nullptr : &found->second;
  }
};

}  // namespace lamina
