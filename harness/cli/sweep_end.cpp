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
    const std::vector<Curve> curves = curves_of(read);
    read.crossovers = answers(curves, read.sweeps.front().limits);
    for (const CrossoverRow& row : read.crossovers) record.append(to_json(row));
    failed = std::ranges::any_of(read.cells, &CellRow::failed) || !std::ranges::all_of(read.timers, &TimerRow::ok);
    fmt::print("{}\n{}", sweep_terminal(curves), answers_terminal(read, out / "summary.md"));
  }
  write_reports(out);
  fmt::print("report: {}\n", (out / "index.html").string());
  return failed;
}

}  // namespace lamina
