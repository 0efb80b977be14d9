// SPDX-License-Identifier: Apache-2.0
#include "harness/record/sweep_rows.h"

#include "harness/record/fields.h"

namespace lamina {

using lines::field;

constexpr auto fields(const SweepRow::Parameter*) {
  using Row = SweepRow::Parameter;
  return std::tuple(field("path", &Row::path), field("unit", &Row::unit), field("values", &Row::values));
}

constexpr auto fields(const SweepRow::Limit*) {
  using Row = SweepRow::Limit;
  return std::tuple(field("metric", &Row::metric), field("limit", &Row::value));
}

constexpr auto fields(const SweepRow*) {
  using Row = SweepRow;
  return std::tuple(field("parameters", &Row::parameters), field("zip", &Row::zip), field("points", &Row::points),
                    lines::group("shard", field("index", &Row::shard_index), field("count", &Row::shard_count)),
                    field("limits", &Row::limits));
}

constexpr auto fields(const CrossoverRow*) {
  using Row = CrossoverRow;
  return std::tuple(field("parameter", &Row::parameter), field("backend", &Row::backend), field("effect", &Row::effect),
                    field("variant", &Row::variant), field("other", &Row::other), field("metric", &Row::metric),
                    field("limit", &Row::limit), field("at", &Row::at), field("tolerance", &Row::tolerance),
                    field("sentence", &Row::sentence), lines::left_out("held", &Row::held),
                    lines::left_out("claim", &Row::claim), lines::left_out("remark", &Row::remark));
}

lines::Line to_json(const SweepRow& row) { return lines::line_of("sweep", row, "sweep"); }
lines::Line to_json(const CrossoverRow& row) {
  return lines::line_of("crossover", row, "crossover of " + row.variant + " on " + row.backend);
}

template SweepRow row_of(const lines::Json& line, const std::string& where);
template nlohmann::ordered_json schema_of<SweepRow>();
template CrossoverRow row_of(const lines::Json& line, const std::string& where);
template nlohmann::ordered_json schema_of<CrossoverRow>();

}  // namespace lamina
