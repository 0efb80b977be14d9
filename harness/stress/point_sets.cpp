// SPDX-License-Identifier: Apache-2.0
#include "harness/stress/point_sets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

#include "harness/core/error.h"

namespace lamina {
namespace {

// The nearest binary32 in the input's range: pi is none.
float in_range(double number, const FamilyInput& input) {
  constexpr float no_bound = std::numeric_limits<float>::infinity();
  const float rounded = static_cast<float>(number);
  if (rounded > input.to) return std::nextafter(rounded, -no_bound);
  return rounded < input.from ? std::nextafter(rounded, no_bound) : rounded;
}

float grid_number(const FamilyInput& input, size_t i, size_t steps) {
  const size_t place = i + (input.low_open ? 1 : 0), last = steps - 1 + (input.low_open ? 1 : 0) + (input.high_open ? 1 : 0);
  return in_range(input.from + (input.to - input.from) * static_cast<double>(place) / static_cast<double>(last), input);
}

std::string grid_words(const Family& family, size_t steps) {
  std::vector<std::string> ranges;
  for (const FamilyInput& input : family.inputs)
    ranges.push_back(fmt::format("{} in {}{}, {}{}", input.name, input.low_open ? "(" : "[", input.from_words, input.to_words,
                                 input.high_open ? ")" : "]"));
  const std::vector<size_t> sides(family.inputs.size(), steps);
  return fmt::format("{} {}", fmt::join(sides, " x "),
                     family.grid.empty() ? fmt::format("{}", fmt::join(ranges, ", ")) : family.grid);
}

double number(const std::string& text, const std::string& where) {
  size_t used = 0;
  double value = 0;
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used == 0 || text.find_first_not_of(" \t\r", used) != std::string::npos || !std::isfinite(value))
    throw Error(ErrorKind::bad_input, "stress", where, fmt::format("'{}' is not a finite number", text));
  return value;
}

bool is_header(const std::string& line, const Family& family) {
  const std::string& name = family.inputs.front().name;
  return line.starts_with(name) && !std::isalnum(static_cast<unsigned char>(line.c_str()[name.size()]));
}

// One line's inputs and the right value behind them, which holds for the numbers as written: where they are no binary32 numbers
// the rounded ones have another.
void read_point(const Family& family, const std::string& line, const std::string& where, PointSet& set) {
  std::vector<std::string> fields;
  std::stringstream cells(line);
  for (std::string cell; std::getline(cells, cell, ',');) fields.push_back(cell);
  const size_t inputs = family.inputs.size();
  if (fields.size() < inputs)
    throw Error(
        ErrorKind::bad_input, "stress", where,
        fmt::format("needs {} and may have {}, separated by commas", fmt::join(family.input_names(), ","), family.value));
  std::vector<double> written;
  for (size_t i = 0; i < inputs; ++i) written.push_back(number(fields[i], where));
  if (const std::string refusal = family.oracle->refusal(written); !refusal.empty())
    throw Error(ErrorKind::bad_input, "stress", where, refusal);
  const std::vector<float> rounded(written.begin(), written.end());
  set.points.add(rounded);
  const bool exact = std::vector<double>(rounded.begin(), rounded.end()) == written;
  set.given.push_back(fields.size() > inputs && exact ? number(fields[inputs], where) : std::nan(""));
}

}  // namespace

std::vector<PointSet> make_sets(const Family& family, size_t count, uint64_t seed) {
  std::vector<PointSet> sets;
  for (const FamilySet& set : family.sets) sets.push_back({set.name, set.what, family.oracle->points(set.name, count, seed)});
  return sets;
}

PointSet make_grid(const Family& family, size_t steps) {
  const auto refuse = [&](const std::string& message) {
    throw Error(ErrorKind::bad_input, "stress", fmt::format("--grid {}", steps), message);
  };
  const size_t inputs = family.inputs.size();
  if (steps < 2) refuse("a grid has 2 steps or more");
  const double power = std::pow(static_cast<double>(steps), static_cast<double>(inputs));
  if (power > max_grid_points) refuse(fmt::format("{}^{} points are more than {}", steps, inputs, max_grid_points));
  PointSet set{"grid", grid_words(family, steps), Points(inputs)};
  const auto points = static_cast<size_t>(power);
  std::vector<float> point(inputs);
  for (size_t n = 0; n < points; ++n) {
    size_t rest = n;
    for (size_t i = inputs; i-- > 0; rest /= steps) point[i] = grid_number(family.inputs[i], rest % steps, steps);
    if (family.oracle->refusal(std::vector<double>(point.begin(), point.end())).empty()) set.points.add(point);
  }
  if (set.points.size() == 0) refuse(fmt::format("the oracle of '{}' has a value at none of these points", family.name));
  return set;
}

PointSet read_points(const Family& family, const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw Error(ErrorKind::bad_input, "stress", file.string(), "cannot be read; check that the file exists");
  PointSet set{"points", file.filename().string(), Points(family.inputs.size())};
  std::string line;
  size_t line_number = 0;
  bool first = true;
  while (std::getline(in, line)) {
    ++line_number;
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.starts_with('#')) continue;
    if (std::exchange(first, false) && is_header(line, family)) continue;
    read_point(family, line, fmt::format("{}:{}", file.string(), line_number), set);
  }
  if (set.points.size() == 0)
    throw Error(ErrorKind::bad_input, "stress", file.string(),
                fmt::format("holds no points; give lines of {}", fmt::join(family.input_names(), ",")));
  return set;
}

}  // namespace lamina
