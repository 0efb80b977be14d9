// SPDX-License-Identifier: Apache-2.0
// lamina report: summary.md, cells.csv and index.html again, from records alone.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include "harness/cli/commands.h"
#include "harness/cli/placeholders.h"
#include "harness/core/error.h"
#include "harness/history/history_reports.h"
#include "reports/gate/gate.h"
#include "reports/reports.h"

namespace lamina {
namespace {

struct ReportCommand {
  std::vector<std::filesystem::path> records;  // folders of runs, or their record.jsonl
  std::filesystem::path out;                   // empty: each run's own folder
  bool single_file = false;
};

// How the records' figures went, where they have any in common.
std::string history_of(const std::vector<std::filesystem::path>& given) {
  try {
    return html_history(load_history(given));
  } catch (const Error&) {
    return "";
  }
}

int run_report(const ReportCommand& options) {
  std::vector<std::filesystem::path> folders;
  for (const std::filesystem::path& given : options.records) {
    const bool file = !std::filesystem::is_directory(given);
    if (file && given.filename() != "record.jsonl")
      throw Error(ErrorKind::bad_input, "report", given.string(),
                  "is neither a run's folder nor a record.jsonl; give the folder that a run left (--out)");
    folders.push_back(file ? std::filesystem::absolute(given).parent_path() : given);
  }
  const bool together = !options.out.empty();
  for (size_t i = 0; i < folders.size(); ++i) {
    const Record record = read_record(folders[i] / "record.jsonl");
    const bool colours = ::isatty(STDOUT_FILENO) == 1;
    if (!record.gates.empty() || !record.verdicts.empty()) fmt::print("{}\n", gate_table(record, colours));
    fmt::print("{}\n", terminal_table(record, colours));
    if (!together)
      fmt::print("report: {}\n",
                 write_reports(std::vector{folders[i]}, {.single_file = options.single_file, .out = {}}).string());
  }
  if (together)
    fmt::print("report: {}\n",
               write_reports(folders, {options.single_file, options.out, history_of(options.records)}).string());
  return 0;
}

}  // namespace

Command add_report(CLI::App& program) {
  auto options = std::make_shared<ReportCommand>();
  CLI::App& command =
      *program.add_subcommand("report", "Writes reports again from records; several records side by side with --out");
  command.add_option("record", options->records, "Run folders or their record.jsonl")
      ->required()
      ->type_name(placeholder::record);
  command.add_option("--out", options->out, "Folder for one report of all records (default: each beside its record)")
      ->type_name(placeholder::directory);
  command.add_flag("--single-file", options->single_file, "Put the pictures into the page, so that one file is all");
  return {&command, [=](const std::string&) { return run_report(*options); }};
}

}  // namespace lamina
