// SPDX-License-Identifier: Apache-2.0
#include "harness/sweep/points.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>

#include "harness/core/error.h"

namespace lamina {
namespace {

std::optional<double> number_in(std::string_view text) {
  double value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<size_t> count_in(std::string_view text) {
  size_t value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(at, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

double rounded(double value) { return std::stod(fmt::format("{:.12g}", value)); }

class Values {
 public:
  explicit Values(const std::string& option) : option_(option) {}

  std::vector<double> parse(std::string_view text) const {
    const std::vector<std::string_view> range = split(text, ':');
    if (range.size() == 1) return list(text);
    if (range.size() != 3 || range[2].empty()) refuse(usage);
    const bool geometric = range[2].front() == 'x';
    const double from = number(range[0]), to = number(range[1]), step = number(range[2].substr(geometric ? 1 : 0));
    return geometric ? multiplied(from, to, step) : added(from, to, step);
  }

 private:
  static constexpr const char* usage = "takes FROM:TO:STEP, FROM:TO:xFACTOR or A,B,C, as in 0:32:1, 1:64:x2 or 1,2,5";
  // What rounding may add to the number of steps.
  static constexpr double slack = 1e-9;

  [[noreturn]] void refuse(const std::string& why) const { throw Error(ErrorKind::bad_input, "sweep", option_, why); }

  double number(std::string_view text) const {
    const auto value = number_in(text);
    if (!value) refuse(fmt::format("'{}' is no number: it {}", text, usage));
    return *value;
  }

  std::vector<double> list(std::string_view text) const {
    std::vector<double> values;
    for (const std::string_view part : split(text, ',')) values.push_back(number(part));
    if (std::set<double>(values.begin(), values.end()).size() != values.size()) refuse("has a value twice; give each once");
    return values;
  }

  const std::vector<double>& distinct(const std::vector<double>& values) const {
    if (std::set<double>(values.begin(), values.end()).size() != values.size())
      refuse("has values that are equal to 12 digits; take larger steps");
    return values;
  }

  size_t steps(double count) const {
    if (count + 1 > static_cast<double>(max_values)) refuse(fmt::format("has more than {} values", max_values));
    return static_cast<size_t>(std::floor(count + slack));
  }

  std::vector<double> added(double from, double to, double step) const {
    if (step == 0 || (to - from) / step < 0) refuse(fmt::format("steps of {} do not lead from {} to {}", step, from, to));
    std::vector<double> values;
    const size_t last = steps((to - from) / step);
    for (size_t i = 0; i <= last; ++i) values.push_back(rounded(from + static_cast<double>(i) * step));
    return distinct(values);
  }

  std::vector<double> multiplied(double from, double to, double factor) const {
    if (!(factor > 0) || factor == 1 || from == 0 || !(to / from > 0) || std::log(to / from) / std::log(factor) < 0)
      refuse(fmt::format("multiplying by {} does not lead from {} to {}", factor, from, to));
    std::vector<double> values;
    const size_t last = steps(std::log(to / from) / std::log(factor));
    for (size_t i = 0; i <= last; ++i) values.push_back(rounded(from * std::pow(factor, static_cast<double>(i))));
    return distinct(values);
  }

  std::string option_;
};

}  // namespace

SweptParameter parse_swept(const std::string& text) {
  const size_t equals = text.rfind('=');  // a path may hold one, values never do
  if (equals == std::string::npos || equals == 0)
    throw Error(ErrorKind::bad_input, "sweep", "--set " + text,
                "takes PATH=VALUES, as in objects.heart.thickness=0:32:1; 'lamina list --parameters SCENE' names the paths");
  SweptParameter swept;
  swept.path = text.substr(0, equals);
  const std::string_view values = std::string_view(text).substr(equals + 1);
  // "nan" is a number that none may be, and no word.
  const auto is_word = [](std::string_view part) {
    double number = 0;
    return !part.empty() && std::isalpha(static_cast<unsigned char>(part[0])) &&
           std::from_chars(part.data(), part.data() + part.size(), number).ec != std::errc();
  };
  if (is_word(split(values, ',').front()))
    for (const std::string_view word : split(values, ',')) swept.words.emplace_back(word);
  else
    swept.values = Values("--set " + text).parse(values);
  return swept;
}

void SweepPoints::check() const {
  std::set<std::string> paths;
  for (const SweptParameter& parameter : parameters) {
    if (!paths.insert(parameter.path).second)
      throw Error(ErrorKind::bad_input, "sweep", "--set " + parameter.path, "is given twice; give all its values at once");
    if (zip && parameter.values.size() != parameters.front().values.size())
      throw Error(ErrorKind::bad_input, "sweep", "--zip",
                  fmt::format("{} has {} values and {} has {}; pairs need as many of each", parameters.front().path,
                              parameters.front().values.size(), parameter.path, parameter.values.size()));
  }
  double count = 1;
  for (const SweptParameter& parameter : parameters) count *= zip ? 1 : static_cast<double>(parameter.values.size());
  if (count > static_cast<double>(max_values))
    throw Error(ErrorKind::bad_input, "sweep", "--set", fmt::format("{} points are more than {}", count, max_values));
}

size_t SweepPoints::count() const {
  if (parameters.empty()) return 0;
  if (zip) return parameters.front().values.size();
  size_t count = 1;
  for (const SweptParameter& parameter : parameters) count *= parameter.values.size();
  return count;
}

std::vector<double> SweepPoints::at(size_t point) const {
  std::vector<double> values(parameters.size());
  for (size_t i = parameters.size(); i-- > 0;) {
    const std::vector<double>& all = parameters[i].values;
    values[i] = all[zip ? point : point % all.size()];
    if (!zip) point /= all.size();
  }
  return values;
}

Shard parse_shard(const std::string& text) {
  const std::vector<std::string_view> parts = split(text, '/');
  const auto k = count_in(parts.front()), n = count_in(parts.back());
  if (parts.size() != 2 || !k || !n || *k < 1 || *k > *n)
    throw Error(ErrorKind::bad_input, "sweep", "--shard " + text, "takes K/N with K from 1 to N, as in 2/8");
  return {*k - 1, *n};
}

Schedule parse_schedule(const std::string& option, const std::string& text) {
  if (text == "none") return {0};
  if (text == "all") return {1};
  const auto every = text.starts_with("every:") ? count_in(std::string_view(text).substr(6)) : std::nullopt;
  if (!every || *every < 1)
    throw Error(ErrorKind::bad_input, "sweep", fmt::format("{} {}", option, text), "takes none, all or every:N");
  return {*every};
}

std::string words_of(Schedule schedule) {
  if (schedule.every == 0) return "none";
  return schedule.every == 1 ? "all" : fmt::format("every:{}", schedule.every);
}

}  // namespace lamina
