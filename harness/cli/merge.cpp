// SPDX-License-Identifier: Apache-2.0
// lamina merge: the records of a sweep's shards to one, with answers and reports of the whole.
#include <fmt/format.h>

#include "harness/cli/commands.h"
#include "harness/cli/sweep_end.h"
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

}  // namespace

int run_merge(const std::vector<std::filesystem::path>& records, const std::filesystem::path& out) {
  std::vector<std::filesystem::path> folders, files;
  for (const std::filesystem::path& given : records) {
    folders.push_back(std::filesystem::is_directory(given) ? given : given.parent_path());
    files.push_back(folders.back() / "record.jsonl");
  }
  const Joined joined = join_records(files);
  make_run_folder("merge", out);
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

}  // namespace lamina
