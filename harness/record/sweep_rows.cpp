// SPDX-License-Identifier: Apache-2.0
#include "harness/record/sweep_rows.h"

#include "harness/record/finite.h"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& value, const std::string& owner, const char* what) {
  return value ? finite(*value, owner, what) : Json(nullptr);
}

}  // namespace

Json to_json(const SweepRow& row) {
  Json parameters = Json::array(), limits = Json::array();
  for (const SweepRow::Parameter& parameter : row.parameters) {
    for (const double value : parameter.values) finite(value, "sweep of " + parameter.path, "a value");
    parameters.push_back({{"path", parameter.path}, {"unit", parameter.unit}, {"values", parameter.values}});
  }
  for (const auto& [metric, value] : row.limits)
    limits.push_back({{"metric", metric}, {"limit", finite(value, "sweep", metric)}});
  return {{"kind", "sweep"},
          {"parameters", parameters},
          {"zip", row.zip},
          {"points", row.points},
          {"shard", {{"index", row.shard_index}, {"count", row.shard_count}}},
          {"limits", limits}};
}

Json to_json(const CrossoverRow& row) {
  const std::string owner = "crossover of " + row.variant + " on " + row.backend;
  return {{"kind", "crossover"},
          {"parameter", row.parameter},
          {"backend", row.backend},
          {"effect", row.effect},
          {"variant", row.variant},
          {"other", row.other},
          {"metric", row.metric},
          {"limit", number_or_null(row.limit, owner, "limit")},
          {"at", number_or_null(row.at, owner, "at")},
          {"tolerance", finite(row.tolerance, owner, "tolerance")},
          {"sentence", row.sentence}};
}

}  // namespace lamina
