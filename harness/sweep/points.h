// SPDX-License-Identifier: Apache-2.0
// The points of a sweep, which of them a shard computes, and which of them get an expensive measurement.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lamina {

// One `--set PATH=VALUES`. Values are distinct, in the order given.
struct SweptParameter {
  std::string path, unit;
  std::vector<double> values;
  std::vector<std::string> words;  // as given, of a parameter that takes words; `values` are then their places
};

// VALUES: "FROM:TO:STEP" (both ends included; TO only where a step meets it), "FROM:TO:xFACTOR" (geometric), or "A,B,C".
// Computed values are rounded to 12 digits, so that 0:1:0.1 has a 0.3. Without a unit. Throws Error(bad_input) for what is none
// of these, a step that leads nowhere, a value twice, or more than max_values.
inline constexpr size_t max_values = 100000;
SweptParameter parse_swept(const std::string& text);

struct SweepPoints {
  std::vector<SweptParameter> parameters;
  bool zip = false;  // the first values together, then the second ones, ...; else every combination, the last parameter fastest

  // Throws Error(bad_input) where zipped lists differ in length, a path comes twice, or there are more than max_values points.
  void check() const;
  size_t count() const;
  // One value a parameter.
  std::vector<double> at(size_t point) const;
};

// Part `index` of `count`: every count-th point, so that expensive ends of a range are shared. The same points on every
// machine.
struct Shard {
  size_t index = 0, count = 1;
  bool has(size_t point) const { return point % count == index; }
};
// "K/N", K from 1 to N. Throws Error(bad_input).
Shard parse_shard(const std::string& text);

// Which points of the whole grid get something: the same ones in every shard and after every interruption.
struct Schedule {
  size_t every = 0;  // 0: none; 1: all; N: the first, and every N-th after it
  bool has(size_t point) const { return every > 0 && point % every == 0; }
};
// "none", "all" or "every:N". Throws Error(bad_input) about `option`.
Schedule parse_schedule(const std::string& option, const std::string& text);
std::string words_of(Schedule schedule);

}  // namespace lamina
