// SPDX-License-Identifier: Apache-2.0
// What a table of a TOML file may hold: its keys, and what each takes. TomlTable checks what is read by it, and JSON Schemas
// for editors are made of it, so that both say the same.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

struct TomlForm;
using TomlFormPtr = std::shared_ptr<const TomlForm>;

// One way to write a value.
struct TomlValue {
  enum class Kind : uint8_t { string, boolean, number, numbers, strings, table, tables };
  Kind kind = Kind::string;
  double min = -std::numeric_limits<double>::infinity();  // of a number, or of each in a list
  double max = std::numeric_limits<double>::infinity();
  bool whole = false;                   // number: whole ones alone
  std::vector<size_t> counts = {};      // of a list: it has one of these lengths; empty: any
  std::vector<std::string> words = {};  // of a string, or each in a list: one of these; empty: any
  std::string what = {};                // what a word is, in messages: "kind of light"; "": the key
  std::string pattern = {};             // of a string: ECMA 262, for editors; the reader says more
  TomlFormPtr form = {};                // of a table, or of each [[table]]
};

struct TomlKey {
  std::string name;
  std::string about;              // a line for editors
  std::vector<TomlValue> values;  // the ways to write it
  bool required = false;
};

struct TomlForm {
  std::vector<TomlKey> keys;
  std::optional<TomlKey> others = {};  // what every other key takes, where names are free: [targets.NAME]
  // The forms that it may have, where a key of its own says which; TomlTable::by() then reads it by that one.
  std::vector<TomlFormPtr> one_of = {};

  // The key, or `others`; null where there is none of this name.
  const TomlKey* key(std::string_view name) const;
};

// How values are written, in the order of use: form::number(0, 1).
namespace form {
TomlFormPtr make(std::vector<TomlKey> keys, std::optional<TomlKey> others = std::nullopt);
TomlFormPtr one_of(std::vector<TomlKey> keys, std::vector<TomlFormPtr> forms);
TomlFormPtr anything();  // of a file that is not read by its keys
TomlValue text(std::string pattern = "");
TomlValue word(std::vector<std::string> words, std::string what = "");
TomlValue flag();
TomlValue number(double min = -std::numeric_limits<double>::infinity(), double max = std::numeric_limits<double>::infinity());
TomlValue whole(double min, double max);
TomlValue numbers(double min, double max, std::vector<size_t> counts = {});
TomlValue texts(std::vector<std::string> words = {}, std::string pattern = "");
TomlValue table(TomlFormPtr of);
TomlValue tables(TomlFormPtr of);
}  // namespace form

}  // namespace lamina
