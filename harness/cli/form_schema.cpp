// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/form_schema.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace lamina {
namespace {

using Schema = nlohmann::ordered_json;
using Kind = TomlValue::Kind;

Schema schema_of_number(const TomlValue& value) {
  Schema schema = {{"type", value.whole ? "integer" : "number"}};
  if (std::isfinite(value.min)) schema["minimum"] = value.min;
  if (std::isfinite(value.max)) schema["maximum"] = value.max;
  return schema;
}

Schema schema_of_string(const TomlValue& value) {
  if (!value.words.empty()) return {{"enum", value.words}};
  Schema schema = {{"type", "string"}};
  if (!value.pattern.empty()) schema["pattern"] = value.pattern;
  return schema;
}

Schema schema_of_list(const TomlValue& value, Schema item) {
  const Schema any_length = {{"type", "array"}, {"items", std::move(item)}};
  if (value.counts.empty()) return any_length;
  Schema lengths = Schema::array();
  for (const size_t count : value.counts) {
    Schema one = any_length;
    one["minItems"] = count, one["maxItems"] = count;
    lengths.push_back(one);
  }
  return lengths.size() == 1 ? lengths.front() : Schema{{"anyOf", lengths}};
}

Schema schema_of_value(const TomlValue& value) {
  switch (value.kind) {
    case Kind::string:
      return schema_of_string(value);
    case Kind::boolean:
      return {{"type", "boolean"}};
    case Kind::number:
      return schema_of_number(value);
    case Kind::numbers:
      return schema_of_list(value, schema_of_number(value));
    case Kind::strings:
      return schema_of_list(value, schema_of_string(value));
    case Kind::table:
      return schema_of_form(*value.form);
    case Kind::tables:
      return {{"type", "array"}, {"items", schema_of_form(*value.form)}};
  }
  return {};
}

Schema schema_of_key(const TomlKey& key) {
  Schema ways = Schema::array();
  for (const TomlValue& value : key.values) ways.push_back(schema_of_value(value));
  Schema schema = ways.size() == 1 ? ways.front() : Schema{{"anyOf", ways}};
  if (!key.about.empty()) schema["description"] = key.about;
  return schema;
}

}  // namespace

nlohmann::ordered_json schema_of_form(const TomlForm& form) {
  if (!form.one_of.empty()) {
    Schema forms = Schema::array();
    for (const TomlFormPtr& one : form.one_of) forms.push_back(schema_of_form(*one));
    return {{"anyOf", forms}};
  }
  Schema schema = {{"type", "object"}, {"properties", Schema::object()}};
  Schema required = Schema::array();
  for (const TomlKey& key : form.keys) {
    schema["properties"][key.name] = schema_of_key(key);
    if (key.required) required.push_back(key.name);
  }
  if (!required.empty()) schema["required"] = required;
  schema["additionalProperties"] = form.others ? schema_of_key(*form.others) : Schema(false);
  return schema;
}

}  // namespace lamina
