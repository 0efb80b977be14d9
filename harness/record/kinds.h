// SPDX-License-Identifier: Apache-2.0
// Kinds of values in the record's lines, inside this folder only: the words for each, whether JSON fits it, how it is written
// and read, and its JSON Schema, which says what fits() does.
#pragma once

#include <fmt/format.h>

#include <climits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lamina::lines {

using Json = nlohmann::json;
using Line = nlohmann::ordered_json;

// A value's place, for messages: whose it is (FILE:LINE, or the row in words), its name, and what it lies in. It refers to all
// of them, since most places are never named.
struct At {
  std::string_view subject;
  std::string_view name{};  // "": the line itself
  const At* within = nullptr;
  At in(std::string_view field) const { return {subject, field, this}; }
  std::string path() const;  // "passes.ms"
};

// Throws Error(bad_input, "record", ...).
[[noreturn]] void refuse(const At& at, std::string message);
// The number, for JSON has neither NaN nor infinity, and the library would write a silent null. Throws Error(failed).
Line finite(double value, const At& at);

// The JSON Schema that also takes null.
inline Line or_null(Line schema) { return {{"anyOf", {std::move(schema), {{"type", "null"}}}}}; }

// A row, by its fields: fields.h defines write(), read() and schema().
template <class T>
struct Kind {
  static std::string words() { return "an object"; }
  static bool fits(const Json& value) { return value.is_object(); }
  static Line schema();
  static Line write(const T& row, const At& at);
  static T read(const Json& value, const At& at);
};

template <class T>
struct Scalar {
  static Line write(const T& value, const At&) { return value; }
  static T read(const Json& value, const At&) { return value.get<T>(); }
};
template <>
struct Kind<std::string> : Scalar<std::string> {
  static constexpr const char* many = "strings";
  static std::string words() { return "a string"; }
  static bool fits(const Json& value) { return value.is_string(); }
  static Line schema() { return {{"type", "string"}}; }
};
template <>
struct Kind<bool> : Scalar<bool> {
  static constexpr const char* many = "true and false";
  static std::string words() { return "true or false"; }
  static bool fits(const Json& value) { return value.is_boolean(); }
  static Line schema() { return {{"type", "boolean"}}; }
};
template <>
struct Kind<uint64_t> : Scalar<uint64_t> {
  static constexpr const char* many = "whole numbers";
  static std::string words() { return "a whole number"; }
  static bool fits(const Json& value) { return value.is_number_unsigned(); }
  static Line schema() { return {{"type", "integer"}, {"minimum", 0}}; }
};
template <>
struct Kind<uint32_t> : Scalar<uint32_t> {
  static std::string words() { return "a whole number"; }
  static bool fits(const Json& value) { return value.is_number_unsigned() && value.get<uint64_t>() <= UINT32_MAX; }
  static Line schema() { return {{"type", "integer"}, {"minimum", 0}, {"maximum", UINT32_MAX}}; }
};
template <>
struct Kind<int> : Scalar<int> {
  static std::string words() { return "a whole number"; }
  static bool fits(const Json& value) { return value.is_number_unsigned() && value.get<uint64_t>() <= INT_MAX; }
  static Line schema() { return {{"type", "integer"}, {"minimum", 0}, {"maximum", INT_MAX}}; }
};
template <>
struct Kind<double> : Scalar<double> {
  static constexpr const char* many = "numbers";
  static std::string words() { return "a number"; }
  static bool fits(const Json& value) { return value.is_number(); }
  static Line schema() { return {{"type", "number"}}; }
  static Line write(double value, const At& at) { return finite(value, at); }
};

template <class T>
struct Kind<std::optional<T>> {
  static std::string words() { return Kind<T>::words() + " or null"; }
  static bool fits(const Json& value) { return value.is_null() || Kind<T>::fits(value); }
  static Line schema() { return or_null(Kind<T>::schema()); }
  static Line write(const std::optional<T>& value, const At& at) { return value ? Kind<T>::write(*value, at) : Line(nullptr); }
  static std::optional<T> read(const Json& value, const At& at) {
    return value.is_null() ? std::nullopt : std::optional(Kind<T>::read(value, at));
  }
};

template <class T>
constexpr bool is_scalar = requires {
  Kind<T>::many;
};

template <class T>
struct Kind<std::vector<T>> {
  static std::string words() {
    if constexpr (is_scalar<T>) return std::string("an array of ") + Kind<T>::many;
    return "an array";
  }
  static bool fits(const Json& value) {
    if (!value.is_array()) return false;
    if constexpr (is_scalar<T>)
      for (const Json& element : value)
        if (!Kind<T>::fits(element)) return false;
    return true;
  }
  static Line schema() { return {{"type", "array"}, {"items", Kind<T>::schema()}}; }
  static Line write(const std::vector<T>& values, const At& at) {
    Line array = Line::array();
    for (const T& value : values) array.push_back(Kind<T>::write(value, at));
    return array;
  }
  static std::vector<T> read(const Json& array, const At& at) {
    std::vector<T> values;
    values.reserve(array.size());
    for (const Json& value : array) {
      if (!Kind<T>::fits(value))
        refuse(at, Kind<T>::fits(Json::object())
                       ? at.path() + ". is not an object"
                       : fmt::format("the field '{}' holds what is not {}", at.path(), Kind<T>::words()));
      values.push_back(Kind<T>::read(value, at));
    }
    return values;
  }
};

template <class T>
struct Kind<std::map<std::string, T>> {
  static std::string words() { return std::string("an object of ") + Kind<T>::many; }
  static bool fits(const Json& value) {
    if (!value.is_object()) return false;
    for (const Json& element : value)
      if (!Kind<T>::fits(element)) return false;
    return true;
  }
  static Line schema() { return {{"type", "object"}, {"additionalProperties", Kind<T>::schema()}}; }
  static Line write(const std::map<std::string, T>& values, const At& at) {
    Line object = Line::object();
    for (const auto& [name, value] : values) object[name] = Kind<T>::write(value, at.in(name));
    return object;
  }
  static std::map<std::string, T> read(const Json& value, const At&) { return value.get<std::map<std::string, T>>(); }
};

// A point in a function's inputs; null where it has none.
struct Point {
  static std::string words() { return "an array of numbers or null"; }
  static bool fits(const Json& value) { return value.is_null() || (!value.empty() && Kind<std::vector<double>>::fits(value)); }
  static Line schema() { return or_null({{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 1}}); }
  static Line write(const std::vector<double>& point, const At& at) {
    return point.empty() ? Line(nullptr) : Kind<std::vector<double>>::write(point, at);
  }
  static std::vector<double> read(const Json& value, const At& at) {
    return value.is_null() ? std::vector<double>{} : Kind<std::vector<double>>::read(value, at);
  }
};

// The value of that name in the object, of that kind.
template <class K>
const Json& value_of(const Json& object, const char* name, const At& at) {
  const auto value = object.find(name);
  if (value == object.end()) refuse(at, fmt::format("the field '{}' is missing", at.in(name).path()));
  if (!K::fits(*value)) refuse(at, fmt::format("the field '{}' is not {}", at.in(name).path(), K::words()));
  return *value;
}

}  // namespace lamina::lines
