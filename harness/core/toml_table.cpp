// SPDX-License-Identifier: Apache-2.0
#include "harness/core/toml_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "harness/core/text.h"

namespace lamina {

namespace {

// "two ", "two or three "
std::string counts_in_words(const std::vector<size_t>& counts) {
  static constexpr std::array<const char*, 5> words = {"no", "one", "two", "three", "four"};
  std::string text;
  for (const size_t count : counts)
    text +=
        fmt::format("{}{}", text.empty() ? "" : " or ", count < words.size() ? words[count] : std::to_string(count).c_str());
  return text.empty() ? "" : text + " ";
}

std::string kind_in_words(const TomlValue& value) {
  switch (value.kind) {
    case TomlValue::Kind::string:
      return "a string";
    case TomlValue::Kind::boolean:
      return "true or false";
    case TomlValue::Kind::number:
      return "a number";
    case TomlValue::Kind::numbers:
      return fmt::format("a list of {}finite numbers", counts_in_words(value.counts));
    case TomlValue::Kind::strings:
      return "a list of strings";
    case TomlValue::Kind::table:
      return "a table";
    case TomlValue::Kind::tables:
      return "a list of tables";
  }
  return "";
}

}  // namespace

TomlTable::TomlTable(toml::table root, const std::filesystem::path& file, std::string stage, TomlFormPtr form)
    : root_(std::make_shared<const toml::table>(std::move(root))),
      table_(root_.get()),
      file_(file.string()),
      stage_(std::move(stage)),
      form_(std::move(form)) {}

TomlTable TomlTable::parse(const std::filesystem::path& file, std::string stage, TomlFormPtr form) {
  toml::table root = parse_nodes(file, stage);
  return {std::move(root), file, std::move(stage), std::move(form)};
}

toml::table TomlTable::parse_nodes(const std::filesystem::path& file, const std::string& stage) {
  const std::string text = read_file(file, stage);
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& failure) {
    throw Error(ErrorKind::bad_input, stage, fmt::format("{}:{}", file.string(), failure.source().begin.line),
                std::string(failure.description()));
  }
}

const toml::node* TomlTable::find(std::string_view key) const {
  if (!form_->key(key)) throw std::logic_error(fmt::format("{}: the form has no key '{}'", where(), key));
  return table_->get(key);
}

const TomlValue& TomlTable::form_of(std::string_view key, TomlValue::Kind kind) const {
  if (const TomlKey* known = form_->key(key))
    for (const TomlValue& value : known->values)
      if (value.kind == kind) return value;
  throw std::logic_error(fmt::format("{}: the form has no such value under '{}'", where(), key));
}

Error TomlTable::missing(std::string_view key) const {
  return error({}, fmt::format("'{}' is missing: it must be {}", key, kind_in_words(form_->key(key)->values.front())));
}

std::string TomlTable::where(std::string_view key) const {
  const toml::node* node = key.empty() ? nullptr : table_->get(key);
  const toml::source_region& region = node ? node->source() : table_->source();
  return region.begin.line > 0 ? fmt::format("{}:{}", region.path ? *region.path : file_, region.begin.line) : file_;
}

Error TomlTable::error(std::string_view key, std::string message) const {
  return {ErrorKind::bad_input, stage_, where(key), std::move(message)};
}

bool TomlTable::has(std::string_view key) const { return find(key) != nullptr; }

bool TomlTable::is_string(std::string_view key) const { return has(key) && find(key)->is_string(); }
bool TomlTable::is_table(std::string_view key) const { return has(key) && find(key)->is_table(); }
bool TomlTable::is_list(std::string_view key) const { return has(key) && find(key)->is_array(); }
bool TomlTable::is_list_of_strings(std::string_view key) const {
  return is_list(key) && find(key)->is_homogeneous(toml::node_type::string);
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> names;
  for (const auto& [name, node] : *table_) {
    (void)node;
    names.emplace_back(name.str());
  }
  return names;
}

std::optional<std::string> TomlTable::optional_string(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  const TomlValue& form = form_of(key, TomlValue::Kind::string);
  if (!node->is_string()) throw error(key, fmt::format("'{}' must be a string", key));
  check_word(key, form, node->as_string()->get());
  return node->as_string()->get();
}

std::string TomlTable::string(std::string_view key) const {
  auto value = optional_string(key);
  if (!value) throw missing(key);
  return *value;
}

double TomlTable::number(std::string_view key) const {
  const auto value = optional_number(key);
  if (!value) throw missing(key);
  return *value;
}

glm::vec3 TomlTable::vec3(std::string_view key) const {
  const auto value = optional_vec3(key);
  if (!value) throw missing(key);
  return *value;
}

std::optional<bool> TomlTable::optional_bool(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  if (!node->is_boolean()) throw error(key, fmt::format("'{}' must be true or false", key));
  return node->as_boolean()->get();
}

std::optional<double> TomlTable::optional_number(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  const TomlValue& form = form_of(key, TomlValue::Kind::number);
  const auto value = node->value<double>();
  const bool fits = node->is_number() && value && std::isfinite(*value) && *value >= form.min && *value <= form.max;
  if (!fits || (form.whole && *value != std::floor(*value)))
    throw error(key, fmt::format("'{}' must be a {}number from {} to {}", key, form.whole ? "whole " : "", form.min, form.max));
  return value;
}

std::optional<std::vector<double>> TomlTable::optional_numbers(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  std::vector<double> values;
  const toml::array* array = node->as_array();
  for (size_t i = 0; array && i < array->size(); ++i) {
    const auto value = (*array)[i].value<double>();
    if ((*array)[i].is_number() && value && std::isfinite(*value)) values.push_back(*value);
  }
  const TomlValue& form = form_of(key, TomlValue::Kind::numbers);
  const bool counts =
      form.counts.empty() || std::find(form.counts.begin(), form.counts.end(), values.size()) != form.counts.end();
  if (!array || values.size() != array->size() || !counts)
    throw error(key, fmt::format("'{}' must be {}", key, kind_in_words(form)));
  for (const double value : values)
    if (!(value >= form.min && value <= form.max))
      throw error(key, fmt::format("'{}' must hold numbers from {} to {}", key, form.min, form.max));
  return values;
}

std::optional<glm::vec3> TomlTable::optional_vec3(std::string_view key) const {
  const auto values = optional_numbers(key);
  if (!values) return std::nullopt;
  return glm::vec3((*values)[0], (*values)[1], (*values)[2]);
}

std::optional<std::vector<std::string>> TomlTable::optional_strings(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  std::vector<std::string> values;
  const toml::array* array = node->as_array();
  for (size_t i = 0; array && i < array->size(); ++i)
    if ((*array)[i].is_string()) values.push_back((*array)[i].as_string()->get());
  const TomlValue& form = form_of(key, TomlValue::Kind::strings);
  if (!array || values.size() != array->size()) throw error(key, fmt::format("'{}' must be a list of strings", key));
  for (const std::string& value : values) check_word(key, form, value);
  return values;
}

TomlTable TomlTable::table(std::string_view key) const {
  static const auto empty = std::make_shared<const toml::table>();
  const toml::node* node = find(key);
  const TomlFormPtr form = form_of(key, TomlValue::Kind::table).form;
  if (!node) return {empty, empty.get(), file_, stage_, form};
  if (!node->is_table()) throw error(key, fmt::format("'{}' must be a table", key));
  return {root_, node->as_table(), file_, stage_, form};
}

std::vector<std::pair<std::string, TomlTable>> TomlTable::tables(std::string_view key) const {
  const TomlTable parent = table(key);
  std::vector<std::pair<std::string, TomlTable>> entries;
  for (const auto& [name, node] : *parent.table_) {
    (void)node;
    entries.emplace_back(std::string(name.str()), parent.table(name.str()));
  }
  // toml++ keeps keys sorted by name; the file's order is what its author means.
  std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return a.second.table_->source().begin.line < b.second.table_->source().begin.line;
  });
  return entries;
}

std::vector<TomlTable> TomlTable::array_of_tables(std::string_view key) const {
  const toml::node* node = find(key);
  std::vector<TomlTable> entries;
  const TomlFormPtr form = form_of(key, TomlValue::Kind::tables).form;
  if (!node) return entries;
  const toml::array* array = node->as_array();
  for (size_t i = 0; array && i < array->size(); ++i)
    if (const toml::table* entry = (*array)[i].as_table()) entries.push_back({root_, entry, file_, stage_, form});
  if (!array || entries.size() != array->size())
    throw error(key, fmt::format("'{}' must be a list of tables, [[{}]]", key, key));
  return entries;
}

std::vector<std::pair<std::string, std::string>> TomlTable::texts() const {
  std::vector<std::pair<std::string, std::string>> entries;
  for (const auto& [name, node] : *table_) {
    std::string text;
    if (node.is_string())
      text = node.as_string()->get();
    else if (node.is_integer())
      text = fmt::format("{}", node.as_integer()->get());
    else if (node.is_floating_point())
      text = fmt::format("{}", node.as_floating_point()->get());
    else if (node.is_boolean())
      text = node.as_boolean()->get() ? "true" : "false";
    else
      throw error(name.str(), fmt::format("'{}' must be a number, a string, true or false", name.str()));
    entries.emplace_back(std::string(name.str()), text);
  }
  return entries;
}

std::string TomlTable::content() const {
  std::ostringstream text;
  text << toml::json_formatter(*table_);
  return text.str();
}

void TomlTable::check_word(std::string_view key, const TomlValue& form, const std::string& word) const {
  if (!form.words.empty() && std::find(form.words.begin(), form.words.end(), word) == form.words.end())
    throw error(key, unknown_name(form.what.empty() ? key : form.what, word, form.words));
}

void TomlTable::check_keys() const {
  std::vector<std::string> known;
  for (const TomlKey& key : form_->keys) known.push_back(key.name);
  for (const auto& [name, node] : *table_) {
    (void)node;
    if (!form_->key(name.str())) throw error(name.str(), unknown_name("key", name.str(), known));
  }
  for (const TomlKey& key : form_->keys)
    if (key.required && !table_->get(key.name)) throw missing(key.name);
}

}  // namespace lamina
