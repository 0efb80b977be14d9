// SPDX-License-Identifier: Apache-2.0
// Names in manifests that stand for one of a few values.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "harness/core/format.h"
#include "harness/core/text.h"
#include "harness/core/toml_table.h"

namespace lamina {

inline constexpr double largest_number = 1e300;

// The enumerator whose place in `names` the word under `key` has, or `otherwise` where the key is absent.
template <class Enum>
Enum choice(const TomlTable& table, std::string_view key, const std::vector<std::string>& names, Enum otherwise) {
  const auto name = table.optional_string(key);
  if (!name) return otherwise;
  const auto found = std::find(names.begin(), names.end(), *name);
  if (found == names.end()) throw table.error(key, unknown_name(key, *name, names));
  return static_cast<Enum>(found - names.begin());
}

// The words under 'of', and the place among them of the one under 'value': the first where there is none.
inline std::pair<std::vector<std::string>, size_t> read_words(const TomlTable& table) {
  const std::vector<std::string> words = table.optional_strings("of").value_or(std::vector<std::string>{});
  if (words.empty()) throw table.error(table.has("of") ? "of" : "", "'of' must list the words to choose among");
  return {words, choice(table, "value", words, size_t{0})};
}

// 'filter' and 'wrap', where the table has them.
inline Sampler read_sampler(const TomlTable& table, Sampler otherwise) {
  return {choice(table, "filter", filter_names, otherwise.filter), choice(table, "wrap", wrap_names, otherwise.wrap)};
}

}  // namespace lamina
