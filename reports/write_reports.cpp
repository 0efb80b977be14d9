// SPDX-License-Identifier: Apache-2.0
// Every report of a run's folder.
#include "harness/core/text.h"
#include "reports/gate.h"
#include "reports/reports.h"

namespace lamina {

void write_reports(const std::filesystem::path& run_folder) {
  const Record record = read_record(run_folder / "record.jsonl");
  write_file_atomically(run_folder / "summary.md", markdown_summary(record));
  write_file_atomically(run_folder / "cells.csv", cells_csv(record));
  write_file_atomically(run_folder / "index.html", html_report(record));
  if (!record.gates.empty() || !record.verdicts.empty()) write_gate_reports(record, run_folder);
}

}  // namespace lamina
