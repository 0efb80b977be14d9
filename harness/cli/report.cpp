// SPDX-License-Identifier: Apache-2.0
// lamina report: summary.md, cells.csv and index.html again, from records alone.
#include <fmt/format.h>
#include <unistd.h>

#include "harness/cli/commands.h"
#include "reports/gate.h"
#include "reports/reports.h"

namespace lamina {

int run_report(const std::vector<std::filesystem::path>& records) {
  for (const std::filesystem::path& given : records) {
    const std::filesystem::path folder = std::filesystem::is_directory(given) ? given : given.parent_path();
    const Record record = read_record(folder / "record.jsonl");
    write_reports(folder);
    if (!record.gates.empty() || !record.verdicts.empty()) fmt::print("{}\n", gate_table(record, ::isatty(STDOUT_FILENO) == 1));
    fmt::print("{}\nreport: {}\n", terminal_table(record, ::isatty(STDOUT_FILENO) == 1), (folder / "index.html").string());
  }
  return 0;
}

}  // namespace lamina
