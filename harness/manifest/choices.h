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

// The enumerator whose place among the form's words the word under `key` has, or `otherwise` where the key is absent.
template <class Enum>
Enum choice(const TomlTable& table, std::string_view key, Enum otherwise) {
  const auto name = table.optional_string(key);
  if (!name) return otherwise;
  const std::vector<std::string>& names = table.form_of(key, TomlValue::Kind::string).words;
  return static_cast<Enum>(std::find(names.begin(), names.end(), *name) - names.begin());
}

// The words under 'of', and the place among them of the one under 'value': the first where there is none.
inline std::pair<std::vector<std::string>, size_t> read_words(const TomlTable& table) {
  const std::vector<std::string> words = table.optional_strings("of").value_or(std::vector<std::string>{});
  if (words.empty()) throw table.error(table.has("of") ? "of" : "", "'of' must list the words to choose among");
  const auto value = table.optional_string("value");
  const auto found = value ? std::find(words.begin(), words.end(), *value) : words.begin();
  if (found == words.end()) throw table.error("value", unknown_name("value", *value, words));
  return {words, static_cast<size_t>(found - words.begin())};
}

// 'filter' and 'wrap' in a form.
inline const TomlKey filter_key = {"filter", "how samplers read it", {form::word(filter_names)}};
inline const TomlKey wrap_key = {"wrap", "what lies beyond its edges", {form::word(wrap_names)}};

// 'filter' and 'wrap', where the table has them.
inline Sampler read_sampler(const TomlTable& table, Sampler otherwise) {
  return {choice(table, "filter", otherwise.filter), choice(table, "wrap", otherwise.wrap)};
}

}  // namespace lamina
