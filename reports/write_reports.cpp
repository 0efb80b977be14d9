// SPDX-License-Identifier: Apache-2.0
// Every report of one run's folder, or one of several runs in a folder of its own.
#include <map>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "reports/gate/gate.h"
#include "reports/pictures.h"
#include "reports/reports.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;

// The folder below the report's that holds what is one record's: "a" of the first; "" where there is one.
std::string subfolder(size_t index, size_t count) {
  if (count == 1) return "";
  return index < 26 ? std::string(1, static_cast<char>('a' + index)) : std::to_string(index + 1);
}

}  // namespace

std::string gate_json(const Record& record) {
  using Json = nlohmann::ordered_json;
  const auto line = [](const auto& row) { return Json(nlohmann::json(to_json(row))); };  // fields in the order of their names
  Json whole = {{"gate", nullptr}, {"aas", Json::array()}, {"verdicts", Json::array()}};
  if (!record.gates.empty()) whole["gate"] = line(record.gates.back());
  for (const SameArmRow& aa : record.aas) whole["aas"].push_back(line(aa));
  for (const VerdictRow& row : record.verdicts) whole["verdicts"].push_back(line(row));
  return whole.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_gate_reports(const Record& record, const std::filesystem::path& folder) {
  write_file_atomically(folder / "gate.md", gate_markdown(record));
  write_file_atomically(folder / "junit.xml", gate_junit(record));
  write_file_atomically(folder / "gate.json", gate_json(record));
}

fs::path write_reports(const std::vector<fs::path>& run_folders, const ReportOptions& options) {
  const bool own_folder = options.out.empty();
  if (own_folder && run_folders.size() != 1)
    throw Error(ErrorKind::bad_input, "report", "--out", "is missing: say where one report of several records goes");
  const fs::path out = own_folder ? run_folders[0] : options.out;
  std::vector<Record> records;
  for (const fs::path& folder : run_folders) records.push_back(read_record(folder / "record.jsonl"));

  std::map<std::string, std::pair<fs::path, std::string>> files;  // folder and path there of each picture of the page
  std::string summary;
  for (size_t i = 0; i < records.size(); ++i) {
    const fs::path below = subfolder(i, records.size());
    std::error_code failure;
    fs::create_directories(out / below, failure);
    if (failure)
      throw Error(ErrorKind::bad_input, "report", (out / below).string(), "cannot be made; choose another with --out");
    summary += markdown_summary(records[i]);
    write_file_atomically(out / below / "cells.csv", cells_csv(records[i]));
    if (!records[i].gates.empty() || !records[i].verdicts.empty()) write_gate_reports(records[i], out / below);
    for_each_picture(records[i], [&](std::string& path) {
      if (!own_folder && !options.single_file) copy_picture(run_folders[i], out / below, path);
      const std::string from_page = (below / path).generic_string();
      files[from_page] = {run_folders[i], path};
      path = from_page;
    });
    if (options.single_file) continue;
    for (CellRow& cell : records[i].cells)
      for_each_picture(cell, [&](const std::string& path) { write_pixel_script(out, path); });
  }
  write_file_atomically(out / "summary.md", summary);
  const PictureUrl inside = [&](const std::string& path) { return std::apply(data_url, files.at(path)); };
  write_file_atomically(out / "index.html", html_report(records, options.single_file ? inside : PictureUrl(), options.history));
  return out / "index.html";
}

fs::path write_reports(const fs::path& run_folder) { return write_reports(std::vector{run_folder}, ReportOptions{}); }

}  // namespace lamina
