// SPDX-License-Identifier: Apache-2.0
// lamina history: how each cell's figures went over records, and where they changed.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include "harness/cli/commands.h"
#include "harness/cli/placeholders.h"
#include "harness/core/text.h"
#include "harness/history/history_reports.h"

namespace lamina {
namespace {

struct HistoryOptions {
  std::vector<std::filesystem::path> records;  // run folders or record files
  std::filesystem::path csv;                   // empty: none
};

int run_history(const HistoryOptions& options) {
  const History history = load_history(options.records);
  fmt::print("{}", history_table(history, ::isatty(STDOUT_FILENO) == 1));
  if (options.csv.empty()) return 0;
  write_file_atomically(options.csv, history_csv(history));
  fmt::print("\ntable: {}\n", options.csv.string());
  return 0;
}

}  // namespace

Command add_history(CLI::App& program) {
  auto options = std::make_shared<HistoryOptions>();
  CLI::App& command = *program.add_subcommand("history", "How each cell's figures changed over records, and at which commit");
  command.add_option("record", options->records, "Run folders or their record.jsonl, two or more")
      ->required()
      ->type_name(placeholder::record);
  command.add_option("--csv", options->csv, "File for every point of every trend")->type_name(placeholder::file);
  return {&command, [=](const std::string&) { return run_history(*options); }};
}

}  // namespace lamina
