// SPDX-License-Identifier: Apache-2.0
#include "harness/manifest/parameter_value.h"

#include <algorithm>
#include <cmath>

#include "harness/core/text.h"

namespace lamina {

double checked_number(const ParameterManifest& parameter, double value, const TomlTable& table, std::string_view key) {
  if (!(value >= parameter.min && value <= parameter.max) || (parameter.whole && value != std::round(value)))
    throw table.error(key, fmt::format("'{}' holds {}, which is no {}number from {} to {}", key, value,
                                       parameter.whole ? "whole " : "", parameter.min, parameter.max));
  return value;
}

double checked_word(const ParameterManifest& parameter, const std::string& word, const TomlTable& table, std::string_view key) {
  const auto found = std::ranges::find(parameter.words, word);
  if (found == parameter.words.end()) throw table.error(key, unknown_name("word", word, parameter.words));
  return static_cast<double>(found - parameter.words.begin());
}

}  // namespace lamina
