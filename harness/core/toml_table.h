// SPDX-License-Identifier: Apache-2.0
// A TOML table that knows where it stands in its file and what it may hold (toml_form.h), so that every mistake is reported
// once, with file and line, and an unknown key with the nearest known one. Asking for a key that the form lacks, or for another
// kind of value than it has there, is a programmer's mistake: std::logic_error.
#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/core/error.h"
#include "harness/core/toml_form.h"

namespace lamina {

class TomlTable {
 public:
  // Throws Error(bad_input, stage, "FILE:LINE", ...) for text that is not TOML.
  static TomlTable parse(const std::filesystem::path& file, std::string stage, TomlFormPtr form = form::anything());
  // The same table by another form, where what it holds depends on a key of it.
  TomlTable by(TomlFormPtr form) const { return {root_, table_, file_, stage_, std::move(form)}; }
  static toml::table parse_nodes(const std::filesystem::path& file, const std::string& stage);
  // Of nodes that were parsed, maybe from several files; `file` is named where a node knows of none.
  TomlTable(toml::table root, const std::filesystem::path& file, std::string stage, TomlFormPtr form);

  // "FILE:LINE" of a key, or of the table itself where the key is absent.
  std::string where(std::string_view key = {}) const;
  // An Error about a key.
  Error error(std::string_view key, std::string message) const;

  bool has(std::string_view key) const;
  bool is_string(std::string_view key) const;
  bool is_table(std::string_view key) const;
  bool is_list(std::string_view key) const;
  bool is_list_of_strings(std::string_view key) const;  // an empty list is none
  std::vector<std::string> keys() const;
  // Present and as the form says, or an Error; the optional ones allow absence. Numbers are finite and within the form's range.
  std::string string(std::string_view key) const;
  double number(std::string_view key) const;
  glm::vec3 vec3(std::string_view key) const;
  std::optional<std::string> optional_string(std::string_view key) const;
  std::optional<bool> optional_bool(std::string_view key) const;
  std::optional<double> optional_number(std::string_view key) const;
  std::optional<glm::vec3> optional_vec3(std::string_view key) const;
  std::optional<std::vector<double>> optional_numbers(std::string_view key) const;
  std::optional<std::vector<std::string>> optional_strings(std::string_view key) const;
  // A sub-table, an empty one where absent.
  TomlTable table(std::string_view key) const;
  // Sub-tables by name in the order of the file; every entry must be a table.
  std::vector<std::pair<std::string, TomlTable>> tables(std::string_view key) const;
  // [[key]] entries.
  std::vector<TomlTable> array_of_tables(std::string_view key) const;
  // The keys of this table in file order, with their values as text ("1", "2.5", "name", "true").
  std::vector<std::pair<std::string, std::string>> texts() const;

  // The table's keys and values as JSON, keys in alphabetical order: comments, layout and order do not show.
  std::string content() const;

  // Throws for the first key that the form does not have, and for one that it requires and is not there.
  void check_keys() const;
  // What the form says of a value of this kind under the key.
  const TomlValue& form_of(std::string_view key, TomlValue::Kind kind) const;

 private:
  TomlTable(std::shared_ptr<const toml::table> root, const toml::table* table, std::string file, std::string stage,
            TomlFormPtr form)
      : root_(std::move(root)), table_(table), file_(std::move(file)), stage_(std::move(stage)), form_(std::move(form)) {}
  const toml::node* find(std::string_view key) const;
  Error missing(std::string_view key) const;
  void check_word(std::string_view key, const TomlValue& form, const std::string& word) const;

  std::shared_ptr<const toml::table> root_;
  const toml::table* table_;
  std::string file_, stage_;
  TomlFormPtr form_;
};

}  // namespace lamina
