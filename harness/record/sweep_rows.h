// SPDX-License-Identifier: Apache-2.0
// Lines of the record that a sweep adds to its cells: what was swept, and what the curves answer.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace lamina {

struct SweepRow {
  struct Parameter {
    std::string path, unit;
    std::vector<double> values;
  };
  struct Limit {
    std::string metric;
    double value = 0;
  };
  std::vector<Parameter> parameters;
  bool zip = false;   // values in pairs; else a grid, the last parameter fastest
  size_t points = 0;  // of the whole sweep
  size_t shard_index = 0, shard_count = 1;
  std::vector<Limit> limits;
};

struct CrossoverRow {
  std::string parameter, backend, effect, variant;
  std::string other;  // another variant, or "" where `limit` says what is crossed
  std::string metric;
  std::optional<double> limit, at;  // at: the parameter's value; none where nothing is crossed
  double tolerance = 0;             // of at
  std::string sentence;             // without its full stop
  // Empty in records of before they were kept.
  std::map<std::string, double> held;  // values of the other swept parameters, by path
  std::string claim, remark;           // the sentence's parts before and after " on BACKEND"
};

// One line of the record each. Throws Error(failed) for a number that is not finite.
nlohmann::ordered_json to_json(const SweepRow& row);
nlohmann::ordered_json to_json(const CrossoverRow& row);

}  // namespace lamina
