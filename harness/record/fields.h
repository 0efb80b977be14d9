// SPDX-License-Identifier: Apache-2.0
// Rows of the record by one list of fields each, inside this folder only. For every row there is a function
//
//   constexpr auto fields(const Row*) { return std::tuple(field("name", &Row::member), ...); }
//
// in the order in which the line is written. The list is all that writing, checking, reading and the JSON Schema need. What
// must hold across fields stands beside it, in `void check(const Row&, const At&)`.
#pragma once

#include <tuple>

#include "harness/measure/statistics.h"
#include "harness/record/kinds.h"
#include "harness/record/row_of.h"

namespace lamina::lines {

// A field that the JSON Schema of an object requires.
inline void require(Line& schema, const char* name, Line value) {
  schema["properties"][name] = std::move(value);
  schema["required"].push_back(name);
}

template <class K, class Row, class T>
struct Field {
  const char* name;
  T Row::*member;
  void write(Line& line, const Row& row, const At& at) const { line[name] = K::write(row.*member, at.in(name)); }
  void read(Row& row, const Json& object, const At& at) const {
    row.*member = K::read(value_of<K>(object, name, at), at.in(name));
  }
  void describe(Line& schema) const { require(schema, name, K::schema()); }
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

// One that records of before it lack.
template <class K, class Row, class T>
struct MayLack : Field<K, Row, T> {
  void read(Row& row, const Json& object, const At& at) const {
    if (object.contains(this->name)) Field<K, Row, T>::read(row, object, at);
  }
  void describe(Line& schema) const { schema["properties"][this->name] = K::schema(); }
};
template <class Row, class T>
constexpr auto may_lack(const char* name, T Row::*member) {
  return MayLack<Kind<T>, Row, T>{{name, member}};
}
template <class K, class Row, class T>
constexpr auto may_lack(const char* name, T Row::*member) {
  return MayLack<K, Row, T>{{name, member}};
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
  void describe(Line& schema) const { schema["properties"][name] = K::schema(); }
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
      refuse(at, fmt::format(fmt::runtime(wrong), at.in("").path()));
  }
  void describe(Line& schema) const { require(schema, name, Kind<T>::schema()); }
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

template <class... Fields>
void describe_fields(Line& schema, const std::tuple<Fields...>& fields) {
  std::apply([&](const auto&... each) { (each.describe(schema), ...); }, fields);
}
template <class... Fields>
Line schema_of_fields(const std::tuple<Fields...>& fields) {
  Line schema = {{"type", "object"}, {"properties", Line::object()}, {"required", Line::array()}};
  describe_fields(schema, fields);
  return schema;
}

// Fields of the row in an object of their own.
template <class... Fields>
struct Group {
  const char* name;
  std::tuple<Fields...> fields;
  void write(Line& line, const auto& row, const At& at) const { write_fields(line[name], row, fields, at.in(name)); }
  void read(auto& row, const Json& object, const At& at) const {
    const auto& value = object.find(name);
    if (value == object.end()) refuse(at, fmt::format("the field '{}' is missing", at.in(name).path()));
    if (!value->is_object()) refuse(at, fmt::format("the field '{}' is not an object", at.in(name).path()));
    read_fields(row, *value, fields, at.in(name));
  }
  void describe(Line& schema) const { require(schema, name, schema_of_fields(fields)); }
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
  void describe(Line& schema) const { describe_fields(schema, fields(static_cast<const Inside*>(nullptr))); }
};
template <class Row, class Inside>
constexpr auto part(Inside Row::*member) {
  return Part<Row, Inside>{member};
}

template <class T>
Line Kind<T>::write(const T& row, const At& at) {
  Line line = Line::object();
  write_fields(line, row, fields(static_cast<const T*>(nullptr)), at);
  return line;
}

template <class T>
Line Kind<T>::schema() {
  return schema_of_fields(fields(static_cast<const T*>(nullptr)));
}

template <class T>
T Kind<T>::read(const Json& value, const At& at) {
  if (!value.is_object()) refuse(at, (at.path().empty() ? "the line" : at.path() + ".") + " is not an object");
  T row;
  read_fields(row, value, fields(static_cast<const T*>(nullptr)), at);
  if constexpr (requires { check(row, at); }) check(row, at);
  return row;
}

}  // namespace lamina::lines

namespace lamina {

template <class Row>
Row row_of(const nlohmann::json& line, const std::string& where) {
  return lines::Kind<Row>::read(line, {where});
}

template <class Row>
nlohmann::ordered_json schema_of() {
  return lines::Kind<Row>::schema();
}

}  // namespace lamina

namespace lamina::lines {

// The line of a row; `owner` names it where a number is not finite.
template <class Row>
Line line_of(const char* kind, const Row& row, const std::string& owner) {
  Line line = {{"kind", kind}};
  write_fields(line, row, fields(static_cast<const Row*>(nullptr)), {owner});
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
