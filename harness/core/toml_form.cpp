// SPDX-License-Identifier: Apache-2.0
#include "harness/core/toml_form.h"

#include <algorithm>

namespace lamina {

const TomlKey* TomlForm::key(std::string_view name) const {
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const TomlKey& one) { return one.name == name; });
  if (found != keys.end()) return &*found;
  return others ? &*others : nullptr;
}

namespace form {

using Kind = TomlValue::Kind;

TomlFormPtr make(std::vector<TomlKey> keys, std::optional<TomlKey> others) {
  return std::make_shared<const TomlForm>(TomlForm{std::move(keys), std::move(others)});
}

TomlFormPtr one_of(std::vector<TomlKey> keys, std::vector<TomlFormPtr> forms) {
  return std::make_shared<const TomlForm>(TomlForm{std::move(keys), TomlKey{"", "", {}}, std::move(forms)});
}

TomlFormPtr anything() {
  static const TomlFormPtr any = make({}, TomlKey{"", "", {}});
  return any;
}

TomlValue text(std::string pattern) { return {.kind = Kind::string, .pattern = std::move(pattern)}; }
TomlValue word(std::vector<std::string> words, std::string what) {
  return {.kind = Kind::string, .words = std::move(words), .what = std::move(what)};
}
TomlValue flag() { return {.kind = Kind::boolean}; }
TomlValue number(double min, double max) { return {.kind = Kind::number, .min = min, .max = max}; }
TomlValue whole(double min, double max) { return {.kind = Kind::number, .min = min, .max = max, .whole = true}; }
TomlValue numbers(double min, double max, std::vector<size_t> counts) {
  return {.kind = Kind::numbers, .min = min, .max = max, .counts = std::move(counts)};
}
TomlValue texts(std::vector<std::string> words, std::string pattern) {
  return {.kind = Kind::strings, .words = std::move(words), .pattern = std::move(pattern)};
}
TomlValue table(TomlFormPtr of) { return {.kind = Kind::table, .form = std::move(of)}; }
TomlValue tables(TomlFormPtr of) { return {.kind = Kind::tables, .form = std::move(of)}; }

}  // namespace form
}  // namespace lamina
