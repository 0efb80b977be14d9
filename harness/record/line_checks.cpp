// SPDX-License-Identifier: Apache-2.0
#include "harness/record/line_checks.h"

#include "harness/core/error.h"

namespace lamina::line_checks {

void refuse(const std::string& where, std::string message) {
  throw Error(ErrorKind::bad_input, "record", where, std::move(message));
}

void check(const Json& value, const Fields& fields, const std::string& where, const std::string& inside) {
  if (!value.is_object()) refuse(where, fmt::format("{} is not an object", inside.empty() ? "the line" : inside));
  for (const auto& [name, type] : fields) {
    const auto field = value.find(name);
    if (field == value.end()) refuse(where, fmt::format("the field '{}{}' is missing", inside, name));
    if (!type.fits(*field)) refuse(where, fmt::format("the field '{}{}' is not {}", inside, name, type.words));
  }
}

void check_interval(const Json& interval, const std::string& where, const std::string& inside) {
  if (interval.is_null()) return;
  check(interval, {{"median", number}, {"low", number}, {"high", number}, {"rounds", count}, {"coverage", number}}, where,
        inside);
}

bool is_moment(const std::string& words) {
  constexpr std::string_view pattern = "dddd-dd-ddTdd:dd:ddZ";
  if (words.size() != pattern.size()) return false;
  for (size_t i = 0; i < words.size(); ++i)
    if (pattern[i] == 'd' ? words[i] < '0' || words[i] > '9' : words[i] != pattern[i]) return false;
  return true;
}

}  // namespace lamina::line_checks
