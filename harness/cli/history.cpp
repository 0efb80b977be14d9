// SPDX-License-Identifier: Apache-2.0
// lamina history: how each cell's figures went over records, and where they changed.
#include <fmt/format.h>
#include <unistd.h>

#include <set>

#include "harness/cli/commands.h"
#include "harness/core/text.h"
#include "harness/history/history_reports.h"

namespace lamina {

int run_history(const HistoryOptions& options) {
  std::vector<HistoryRecord> records;
  std::set<std::filesystem::path> seen;
  for (const std::filesystem::path& given : options.records) {
    const std::filesystem::path file = std::filesystem::is_directory(given) ? given / "record.jsonl" : given;
    Record record = read_record(file);
    if (!seen.insert(std::filesystem::canonical(file)).second)
      throw Error(ErrorKind::bad_input, "history", given.string(), "is given twice; a trend needs each record once");
    records.push_back({given.string(), std::move(record)});
  }
  const History history = make_history(std::move(records));
  fmt::print("{}", history_table(history, ::isatty(STDOUT_FILENO) == 1));
  if (options.csv.empty()) return 0;
  write_file_atomically(options.csv, history_csv(history));
  fmt::print("\ntable: {}\n", options.csv.string());
  return 0;
}

}  // namespace lamina
