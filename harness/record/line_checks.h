// SPDX-License-Identifier: Apache-2.0
// What readers of the record's lines check fields with, inside this folder only.
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace lamina::line_checks {

using Json = nlohmann::json;

// What a field may hold, and how a message says so.
struct Type {
  bool (*fits)(const Json&);
  const char* words;
};
using Fields = std::initializer_list<std::pair<const char*, Type>>;

// Throws Error(bad_input, "record", where, message).
[[noreturn]] void refuse(const std::string& where, std::string message);
// Throws where a field is missing or does not fit. `inside` names the object in messages: "" for the line itself, "passes." for
// one of its passes.
void check(const Json& value, const Fields& fields, const std::string& where, const std::string& inside = "");
// An Interval's fields, or null.
void check_interval(const Json& interval, const std::string& where, const std::string& inside);
// Whether the text is a moment as records write it: "2026-01-31T23:59:59Z", UTC, in the order of its characters.
bool is_moment(const std::string& words);

template <bool (*element_fits)(const Json&)>
bool all_fit(const Json& value) {
  for (const Json& element : value)
    if (!element_fits(element)) return false;
  return true;
}
inline bool is_number(const Json& value) { return value.is_number(); }
inline bool is_boolean(const Json& value) { return value.is_boolean(); }
inline bool is_text(const Json& value) { return value.is_string(); }

inline constexpr Type text = {is_text, "a string"};
inline constexpr Type boolean = {is_boolean, "true or false"};
inline constexpr Type booleans = {[](const Json& v) { return v.is_array() && all_fit<is_boolean>(v); },
                                  "an array of true and false"};
inline constexpr Type count = {[](const Json& v) { return v.is_number_unsigned(); }, "a whole number"};
inline constexpr Type count_or_null = {[](const Json& v) { return v.is_null() || v.is_number_unsigned(); },
                                       "a whole number or null"};
inline constexpr Type number = {is_number, "a number"};
inline constexpr Type number_or_null = {[](const Json& v) { return v.is_null() || v.is_number(); }, "a number or null"};
inline constexpr Type numbers = {[](const Json& v) { return v.is_array() && all_fit<is_number>(v); }, "an array of numbers"};
inline constexpr Type array = {[](const Json& v) { return v.is_array(); }, "an array"};
inline constexpr Type point_or_null = {[](const Json& v) { return v.is_null() || (!v.empty() && numbers.fits(v)); },
                                       "an array of numbers or null"};
inline constexpr Type object = {[](const Json& v) { return v.is_object(); }, "an object"};
inline constexpr Type object_or_null = {[](const Json& v) { return v.is_null() || v.is_object(); }, "an object or null"};
inline constexpr Type numbers_by_name = {[](const Json& v) { return v.is_object() && all_fit<is_number>(v); },
                                         "an object of numbers"};
inline constexpr Type texts = {[](const Json& v) { return v.is_array() && all_fit<is_text>(v); }, "an array of strings"};
inline constexpr Type status = {[](const Json& v) { return v == "ok" || v == "failed"; }, "\"ok\" or \"failed\""};
inline constexpr Type moment = {[](const Json& v) { return v.is_string() && is_moment(v.get_ref<const std::string&>()); },
                                "a moment in UTC like \"2026-01-31T23:59:59Z\""};
inline constexpr Type moment_or_null = {[](const Json& v) { return v.is_null() || moment.fits(v); },
                                        "a moment in UTC like \"2026-01-31T23:59:59Z\" or null"};

}  // namespace lamina::line_checks
