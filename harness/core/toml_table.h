// SPDX-License-Identifier: Apache-2.0
// A TOML table that remembers where it stands in its file and which keys it was asked for, so that every mistake is reported
// once, with file and line, and an unknown key with the nearest known one.
#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "harness/core/error.h"

namespace lamina {

class TomlTable {
 public:
  // Throws Error(bad_input, stage, "FILE:LINE", ...) for text that is not TOML.
  static TomlTable parse(const std::filesystem::path& file, std::string stage);

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
  // Present and of the right type, or an Error; the optional forms allow absence. Numbers are finite and within [low, high].
  std::string string(std::string_view key) const;
  std::optional<std::string> optional_string(std::string_view key) const;
  std::optional<bool> optional_bool(std::string_view key) const;
  std::optional<double> optional_number(std::string_view key, double low, double high) const;
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

  // Throws for the first key that nobody asked for.
  void refuse_unknown_keys() const;

 private:
  TomlTable(std::shared_ptr<const toml::table> root, const toml::table* table, std::string file, std::string stage)
      : root_(std::move(root)), table_(table), file_(std::move(file)), stage_(std::move(stage)) {}
  const toml::node* find(std::string_view key) const;

  std::shared_ptr<const toml::table> root_;
  const toml::table* table_;
  std::string file_, stage_;
  mutable std::set<std::string, std::less<>> asked_;
};

}  // namespace lamina
