// SPDX-License-Identifier: Apache-2.0
// lamina history: how each cell's figures went over records, and where they changed.
#include <fmt/format.h>
#include <unistd.h>

#include "harness/cli/commands.h"
#include "harness/core/text.h"
#include "harness/history/history_reports.h"

namespace lamina {

int run_history(const HistoryOptions& options) {
  const History history = load_history(options.records);
  fmt::print("{}", history_table(history, ::isatty(STDOUT_FILENO) == 1));
  if (options.csv.empty()) return 0;
  write_file_atomically(options.csv, history_csv(history));
  fmt::print("\ntable: {}\n", options.csv.string());
  return 0;
}

}  // namespace lamina
