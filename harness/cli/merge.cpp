// SPDX-License-Identifier: Apache-2.0
// lamina merge: the records of a sweep's shards to one, with answers and reports of the whole.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "harness/cli/commands.h"
#include "harness/cli/common.h"
#include "harness/cli/sweep_end.h"
#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/sweep/sweep_record.h"

namespace lamina {
namespace {

// The pictures that cells name, from where they are to where the joined record is; those of cells that several have are alike.
void copy_pictures(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& out) {
  for (const std::filesystem::path& folder : folders) {
    if (!std::filesystem::is_directory(folder / "images") || std::filesystem::equivalent(folder, out)) continue;
    std::filesystem::copy(folder / "images", out / "images",
                          std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
  }
}

// The record of a folder; a path that is not a folder is a record itself.
std::filesystem::path record_of(const std::filesystem::path& given) {
  if (std::filesystem::is_directory(given)) return given / "record.jsonl";
  if (!std::filesystem::exists(given))
    throw Error(ErrorKind::bad_input, "merge", given.string(), "is not there; name the folders of a sweep's shards");
  return given;
}

// A record in `out` is replaced only where all its cells are in the joined record: an earlier join of the same sweep.
void check_nothing_is_lost(const std::filesystem::path& out, std::vector<std::filesystem::path> files, const Joined& joined) {
  const std::filesystem::path there = out / "record.jsonl";
  if (!std::filesystem::exists(there) || std::filesystem::is_empty(there)) return;
  const auto refuse = [&](const std::string& why) {
    throw Error(ErrorKind::bad_input, "merge", out.string(), why + "; choose another folder with --out, or remove this one");
  };
  files.push_back(there);
  size_t cells = 0;
  try {
    cells = join_records(files).cells;
  } catch (const Error& error) {
    refuse(fmt::format("holds a record that these do not continue ({})", error.what()));
  }
  if (cells > joined.cells) refuse(fmt::format("holds {} cells that these records lack", cells - joined.cells));
}

int run_merge(const std::vector<std::filesystem::path>& records, const std::filesystem::path& out) {
  std::vector<std::filesystem::path> folders, files;
  for (const std::filesystem::path& given : records) {
    files.push_back(record_of(given));
    folders.push_back(files.back().parent_path());
  }
  const Joined joined = join_records(files);
  make_run_folder("merge", out);
  const FolderLock lock("merge", out);
  check_nothing_is_lost(out, files, joined);
  copy_pictures(folders, out);
  const std::filesystem::path file = out / "record.jsonl";
  std::string text;
  for (const nlohmann::ordered_json& line : joined.lines) text += line.dump() + '\n';
  write_file_atomically(file, text);
  RecordWriter record(file, true);
  const bool failed = end_sweep(out, record);
  fmt::print("joined {} cells of {} records{}\n", joined.cells, files.size(),
             joined.duplicates > 0 ? fmt::format("; {} were there twice, and agree", joined.duplicates) : "");
  for (const std::string& missing : joined.missing) fmt::print(stderr, "lamina: {}\n", missing);
  return failed || !joined.missing.empty() ? 1 : 0;
}

}  // namespace

Command add_merge(CLI::App& program) {
  struct Options {
    std::vector<std::filesystem::path> records;
    std::filesystem::path out = "lamina-sweep";
  };
  auto options = std::make_shared<Options>();
  CLI::App& command =
      *program.add_subcommand("merge", "Joins the records of a sweep's shards, and gives the answers of the whole sweep");
  command.add_option("record", options->records, "Run folders or their record.jsonl")
      ->required()
      ->type_name(placeholder::record);
  add_out(command, options->out, "Folder for the joined record, report and pictures");
  return {&command, [=](const std::string&) { return run_merge(options->records, options->out); }};
}

}  // namespace lamina
