// SPDX-License-Identifier: Apache-2.0
#include "harness/sweep/sweep_record.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>

#include "harness/core/error.h"
#include "harness/core/text.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(const std::string& where, const std::string& why) {
  throw Error(ErrorKind::bad_input, "record", where, why);
}

// What makes two records parts of one sweep; the run line's other fields may differ.
constexpr const char* identity[] = {"schema", "lamina", "commit", "build", "scene", "source", "settings", "inputs"};

// The first field in which they differ, as "settings.width is 64, not 512"; "" where they agree.
std::string difference(const Json& have, const Json& want) {
  const Json changes = Json::diff(have, want);
  if (changes.empty()) return "";
  std::string pointer = changes.front().at("path");
  const auto words = [&](const Json& value) {
    const Json::json_pointer at(pointer);
    std::string text = value.contains(at) ? value.at(at).dump() : "absent";
    return text.size() > 60 ? text.substr(0, 57) + "..." : text;
  };
  const std::string had = words(have), wanted = words(want);
  std::replace(pointer.begin(), pointer.end(), '/', '.');
  return fmt::format("'{}' is {}, not {}", pointer.substr(1), had, wanted);
}

Json identity_of(const Json& run) {
  Json fields = Json::object();
  for (const char* name : identity)
    if (run.contains(name)) fields[name] = run.at(name);
  return fields;
}

Json parsed(const std::string& line, const std::string& where) {
  try {
    Json json = Json::parse(line);
    if (json.is_object() && json.contains("kind")) return json;
  } catch (const Json::exception&) {
  }
  refuse(where, "is no line of a record; the file is damaged: remove it, or choose another folder with --out");
}

}  // namespace

FolderLock::FolderLock(const std::string& stage, const std::filesystem::path& folder)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (folder_ < 0 || ::flock(folder_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(folder_);
  throw Error(ErrorKind::bad_input, stage, folder.string(),
              "another sweep or merge is writing here; wait until it has ended, or choose another folder with --out");
}

FolderLock::~FolderLock() {
  if (folder_ >= 0) ::close(folder_);
}

PointIndex::PointIndex(const SweepPoints& points) {
  for (const SweptParameter& parameter : points.parameters) paths_.push_back(parameter.path);
  for (size_t point = 0; point < points.count(); ++point) points_.emplace(points.at(point), point);
}

CellKey PointIndex::key_of(const CellRow& cell, const std::string& where) const {
  std::vector<double> values;
  for (const std::string& path : paths_)
    if (const auto value = cell.params.find(path); value != cell.params.end()) values.push_back(value->second);
  const auto found = points_.find(values);
  if (found == points_.end()) refuse(where, "is a cell of no point of this sweep; the file is damaged or of another sweep");
  return {cell.backend, cell.effect, cell.variant, cell.view, found->second};
}

std::optional<Earlier> continue_record(const std::filesystem::path& file, const Json& run, const SweepRow& sweep,
                                       const SweepPoints& points) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  const PointIndex index(points);
  const nlohmann::ordered_json sweep_line = to_json(sweep);
  Earlier earlier;
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  std::string first_line, other_limits;    // the second line, where its limits are not those of `sweep`
  size_t keep = 0, number = 0, whole = 0;  // bytes to keep; lines; bytes of whole lines
  while (std::getline(stream, line) && !stream.eof()) {
    const std::string where = fmt::format("{}:{}", file.string(), ++number);
    const Json json = parsed(line, where);
    const std::string kind = json.at("kind");
    const auto expect = [&](const Json& have, const Json& want, const char* what) {
      if (const std::string differs = difference(have, want); !differs.empty())
        refuse(where, fmt::format("this folder holds another {}: {}; choose another folder with --out, or remove this one",
                                  what, differs));
    };
    if (number == 1 && kind != "run") refuse(where, "is not the first line of a record; choose another folder with --out");
    if (number == 1) {
      Json have = identity_of(json), want = identity_of(run);
      have["devices"] = json.value("devices", Json()), want["devices"] = run.at("devices");
      if (run.at("settings").value("time", "none") != "none")  // times of two machines do not mix
        have["machine"] = json.value("machine", Json()), want["machine"] = run.at("machine");
      expect(have, want, "run");
      first_line = line;
    } else if (number == 2) {
      Json have = json;
      have["limits"] = sweep_line["limits"];
      expect(have, sweep_line, "sweep");
      if (have != json) other_limits = line;
    }
    whole += line.size() + 1;
    if (kind == "crossover") {
      earlier.finished = true;
      continue;
    }
    keep = whole;
    if (kind != "cell")
      earlier.kinds.insert(kind);
    else if (!earlier.cells.insert(index.key_of(row_of<CellRow>(json, where), where)).second)
      refuse(where, "is a cell that an earlier line has; the file is damaged: remove it, or choose another folder with --out");
  }
  stream.close();
  earlier.cut_bytes = std::filesystem::file_size(file) - whole;
  // Without both first lines there is nothing to go on from.
  if (number < 2) return std::nullopt;
  std::filesystem::resize_file(file, keep);
  if (!other_limits.empty()) {
    nlohmann::ordered_json with_limits = nlohmann::ordered_json::parse(other_limits);
    with_limits["limits"] = sweep_line["limits"];
    const size_t cells = first_line.size() + 1 + other_limits.size() + 1;
    write_file_atomically(file, first_line + '\n' + with_limits.dump() + '\n' + read_file(file, "record").substr(cells));
  }
  return earlier;
}

SweepPoints points_of(const SweepRow& sweep) {
  SweepPoints points;
  points.zip = sweep.zip;
  for (const SweepRow::Parameter& parameter : sweep.parameters)
    points.parameters.push_back({parameter.path, parameter.unit, parameter.values, {}});
  return points;
}

}  // namespace lamina
