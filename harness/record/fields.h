// SPDX-License-Identifier: Apache-2.0
// Rows of the record by one list of fields each, inside this folder only. For every row there is a function
//
//   constexpr auto fields(const Row*) { return std::tuple(field("name", &Row::member), ...); }
//
// in the order in which the line is written. The list is all that writing, checking and reading need. What must hold across
// fields stands beside it, in `void check(const Row&, const At&)`.
#pragma once

#include <fmt/format.h>

#include <climits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "harness/measure/statistics.h"
#include "harness/record/row_of.h"

namespace lamina::lines {

using Json = nlohmann::json;
using Line = nlohmann::ordered_json;

// A value's place, for messages: whose it is (FILE:LINE, or the row in words) and its path within ("passes.ms"; "": the line).
struct At {
  std::string subject, path;
  At in(const std::string& name) const { return {subject, path.empty() ? name : path + "." + name}; }
};

// Throws Error(bad_input, "record", ...).
[[noreturn]] void refuse(const At& at, std::string message);
// The number, for JSON has neither NaN nor infinity, and the library would write a silent null. Throws Error(failed).
Line finite(double value, const At& at);

// ---- Kinds of values: each with the words for it, whether JSON fits it, and how it is written and read ---------------------

// A row, by its fields.
template <class T>
struct Kind {
  static std::string words() { return "an object"; }
  static bool fits(const Json& value) { return value.is_object(); }
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
};
template <>
struct Kind<bool> : Scalar<bool> {
  static constexpr const char* many = "true and false";
  static std::string words() { return "true or false"; }
  static bool fits(const Json& value) { return value.is_boolean(); }
};
template <>
struct Kind<uint64_t> : Scalar<uint64_t> {
  static std::string words() { return "a whole number"; }
  static bool fits(const Json& value) { return value.is_number_unsigned(); }
};
template <>
struct Kind<int> : Scalar<int> {
  static std::string words() { return "a whole number"; }
  static bool fits(const Json& value) { return value.is_number_unsigned() && value.get<uint64_t>() <= INT_MAX; }
};
template <>
struct Kind<double> : Scalar<double> {
  static constexpr const char* many = "numbers";
  static std::string words() { return "a number"; }
  static bool fits(const Json& value) { return value.is_number(); }
  static Line write(double value, const At& at) { return finite(value, at); }
};

template <class T>
struct Kind<std::optional<T>> {
  static std::string words() { return Kind<T>::words() + " or null"; }
  static bool fits(const Json& value) { return value.is_null() || Kind<T>::fits(value); }
  static Line write(const std::optional<T>& value, const At& at) { return value ? Kind<T>::write(*value, at) : Line(nullptr); }
  static std::optional<T> read(const Json& value, const At& at) {
    return value.is_null() ? std::nullopt : std::optional(Kind<T>::read(value, at));
  }
};

template <class T>
constexpr bool is_scalar = requires { Kind<T>::many; };

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
        refuse(at, Kind<T>::fits(Json::object()) ? at.path + ". is not an object"
                                                 : fmt::format("the field '{}' holds what is not {}", at.path, Kind<T>::words()));
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
  static bool fits(const Json& value) {
    return value.is_null() || (!value.empty() && Kind<std::vector<double>>::fits(value));
  }
  static Line write(const std::vector<double>& point, const At& at) {
    return point.empty() ? Line(nullptr) : Kind<std::vector<double>>::write(point, at);
  }
  static std::vector<double> read(const Json& value, const At& at) {
    return value.is_null() ? std::vector<double>{} : Kind<std::vector<double>>::read(value, at);
  }
};

// ---- Fields of a row -------------------------------------------------------------------------------------------------------

// The value of that name in the object, of that kind.
template <class K>
const Json& value_of(const Json& object, const char* name, const At& at) {
  const auto value = object.find(name);
  if (value == object.end()) refuse(at, fmt::format("the field '{}' is missing", at.in(name).path));
  if (!K::fits(*value)) refuse(at, fmt::format("the field '{}' is not {}", at.in(name).path, K::words()));
  return *value;
}

template <class K, class Row, class T>
struct Field {
  const char* name;
  T Row::*member;
  void write(Line& line, const Row& row, const At& at) const { line[name] = K::write(row.*member, at.in(name)); }
  void read(Row& row, const Json& object, const At& at) const {
    row.*member = K::read(value_of<K>(object, name, at), at.in(name));
  }
};
template <class Row, class T>
constexpr auto field(const char* name, T Row::*member) {
  return Field<Kind<T>, Row, T>{name, member};
}
// Of another kind than its type's.
template <class K, class Row, class T>
constexpr auto field(const char* name, T Row::*member) {
  return Field<K, Row, T>{name, member};
}

// Left out where it is empty.
template <class K, class Row, class T>
struct LeftOut {
  const char* name;
  T Row::*member;
  void write(Line& line, const Row& row, const At& at) const {
    if constexpr (requires(const T& optional) { optional.has_value(); }) {
      if (row.*member) line[name] = K::write(*(row.*member), at.in(name));
    } else {
      if (!(row.*member).empty()) line[name] = K::write(row.*member, at.in(name));
    }
  }
  void read(Row& row, const Json& object, const At& at) const {
    if (object.contains(name)) row.*member = K::read(value_of<K>(object, name, at), at.in(name));
  }
};
template <class T>
struct Inner {
  using type = T;
};
template <class T>
struct Inner<std::optional<T>> {
  using type = T;
};
template <class Row, class T>
constexpr auto left_out(const char* name, T Row::*member) {
  return LeftOut<Kind<typename Inner<T>::type>, Row, T>{name, member};
}
template <class K, class Row, class T>
constexpr auto left_out(const char* name, T Row::*member) {
  return LeftOut<K, Row, T>{name, member};
}

// What follows from the fields before it. `wrong`: the message where it does not, with the path and its dot for "{}".
template <class Row, class T>
struct Derived {
  const char* name;
  T (*of)(const Row&);
  const char* wrong;
  void write(Line& line, const Row& row, const At& at) const { line[name] = Kind<T>::write(of(row), at.in(name)); }
  void read(Row& row, const Json& object, const At& at) const {
    if (Kind<T>::read(value_of<Kind<T>>(object, name, at), at.in(name)) != of(row))
      refuse(at, fmt::format(fmt::runtime(wrong), at.in("").path));
  }
};
template <class Row, class T>
constexpr auto derived(const char* name, T (*of)(const Row&), const char* wrong) {
  return Derived<Row, T>{name, of, wrong};
}

template <class Row, class... Fields>
void write_fields(Line& line, const Row& row, const std::tuple<Fields...>& fields, const At& at) {
  std::apply([&](const auto&... each) { (each.write(line, row, at), ...); }, fields);
}
template <class Row, class... Fields>
void read_fields(Row& row, const Json& object, const std::tuple<Fields...>& fields, const At& at) {
  std::apply([&](const auto&... each) { (each.read(row, object, at), ...); }, fields);
}

// Fields of the row in an object of their own.
template <class... Fields>
struct Group {
  const char* name;
  std::tuple<Fields...> fields;
  void write(Line& line, const auto& row, const At& at) const { write_fields(line[name], row, fields, at.in(name)); }
  void read(auto& row, const Json& object, const At& at) const {
    const auto& value = object.find(name);
    if (value == object.end()) refuse(at, fmt::format("the field '{}' is missing", at.in(name).path));
    if (!value->is_object()) refuse(at, fmt::format("the field '{}' is not an object", at.in(name).path));
    read_fields(row, *value, fields, at.in(name));
  }
};
template <class... Fields>
constexpr auto group(const char* name, Fields... fields) {
  return Group<Fields...>{name, {fields...}};
}

// A row whose fields stand among those of the row that holds it.
template <class Row, class Inside>
struct Part {
  Inside Row::*member;
  void write(Line& line, const Row& row, const At& at) const {
    write_fields(line, row.*member, fields(static_cast<const Inside*>(nullptr)), at);
  }
  void read(Row& row, const Json& object, const At& at) const {
    read_fields(row.*member, object, fields(static_cast<const Inside*>(nullptr)), at);
  }
};
template <class Row, class Inside>
constexpr auto part(Inside Row::*member) {
  return Part<Row, Inside>{member};
}

// ---- Rows ------------------------------------------------------------------------------------------------------------------

template <class T>
Line Kind<T>::write(const T& row, const At& at) {
  Line line = Line::object();
  write_fields(line, row, fields(static_cast<const T*>(nullptr)), at);
  return line;
}

template <class T>
T Kind<T>::read(const Json& value, const At& at) {
  if (!value.is_object()) refuse(at, (at.path.empty() ? "the line" : at.path + ".") + " is not an object");
  T row;
  read_fields(row, value, fields(static_cast<const T*>(nullptr)), at);
  if constexpr (requires { check(row, at); }) check(row, at);
  return row;
}

}  // namespace lamina::lines

namespace lamina {

template <class Row>
Row row_of(const nlohmann::json& line, const std::string& where) {
  return lines::Kind<Row>::read(line, {where, ""});
}

}  // namespace lamina

namespace lamina::lines {

// The line of a row; `owner` names it where a number is not finite.
template <class Row>
Line line_of(const char* kind, const Row& row, const std::string& owner) {
  Line line = {{"kind", kind}};
  write_fields(line, row, fields(static_cast<const Row*>(nullptr)), {owner, ""});
  return line;
}

}  // namespace lamina::lines

namespace lamina {

constexpr auto fields(const Interval*) {
  using lines::field;
  return std::tuple(field("median", &Interval::median), field("low", &Interval::low), field("high", &Interval::high),
                    field("rounds", &Interval::rounds), field("coverage", &Interval::coverage));
}

}  // namespace lamina
