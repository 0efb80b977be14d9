// SPDX-License-Identifier: Apache-2.0
#include "harness/record/sweep_rows.h"

#include "harness/record/fields.h"

namespace lamina {

using lines::field;

constexpr auto fields(const SweepRow::Parameter*) {
  return std::tuple(field("path", &SweepRow::Parameter::path), field("unit", &SweepRow::Parameter::unit),
                    field("values", &SweepRow::Parameter::values));
}

constexpr auto fields(const SweepRow::Limit*) {
  return std::tuple(field("metric", &SweepRow::Limit::metric), field("limit", &SweepRow::Limit::value));
}

constexpr auto fields(const SweepRow*) {
  return std::tuple(
      field("parameters", &SweepRow::parameters), field("zip", &SweepRow::zip), field("points", &SweepRow::points),
      lines::group("shard", field("index", &SweepRow::shard_index), field("count", &SweepRow::shard_count)),
      field("limits", &SweepRow::limits));
}

constexpr auto fields(const CrossoverRow*) {
  return std::tuple(field("parameter", &CrossoverRow::parameter), field("backend", &CrossoverRow::backend),
                    field("effect", &CrossoverRow::effect), field("variant", &CrossoverRow::variant),
                    field("other", &CrossoverRow::other), field("metric", &CrossoverRow::metric),
                    field("limit", &CrossoverRow::limit), field("at", &CrossoverRow::at),
                    field("tolerance", &CrossoverRow::tolerance), field("sentence", &CrossoverRow::sentence));
}

lines::Line to_json(const SweepRow& row) { return lines::line_of("sweep", row, "sweep"); }
lines::Line to_json(const CrossoverRow& row) {
  return lines::line_of("crossover", row, "crossover of " + row.variant + " on " + row.backend);
}

template SweepRow row_of(const lines::Json& line, const std::string& where);
template CrossoverRow row_of(const lines::Json& line, const std::string& where);

}  // namespace lamina
