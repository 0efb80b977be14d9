// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/sweep_end.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/sweep/answers.h"
#include "reports/sweep/sweep_text.h"

namespace lamina {

bool end_sweep(const std::filesystem::path& out, RecordWriter& record) {
  const std::filesystem::path file = out / "record.jsonl";
  bool failed = false;
  {
    Record read = read_record(file);
    std::vector<Limit> limits;
    for (const nlohmann::json& limit : read.sweeps.front().at("limits"))
      limits.push_back({limit.at("metric"), limit.at("limit")});
    const std::vector<Curve> curves = curves_of(read);
    const std::vector<CrossoverRow> found = answers(curves, limits);
    read.crossovers.clear();
    for (const CrossoverRow& row : found) {
      record.append(to_json(row));
      read.crossovers.push_back(to_json(row));
    }
    failed =
        std::any_of(read.cells.begin(), read.cells.end(), [](const auto& cell) { return cell.at("status") == "failed"; }) ||
        std::any_of(read.timers.begin(), read.timers.end(), [](const auto& timer) { return !timer.at("ok"); });
    fmt::print("{}\n{}", sweep_terminal(curves), answers_terminal(read, out / "summary.md"));
  }
  write_reports(out);
  fmt::print("report: {}\n", (out / "index.html").string());
  return failed;
}

}  // namespace lamina
