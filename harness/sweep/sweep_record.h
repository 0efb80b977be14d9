// SPDX-License-Identifier: Apache-2.0
// The record of a sweep on disk. A run resumes it where an earlier run of the same sweep stopped, at whatever byte that was;
// merge joins the records of several shards.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "harness/record/record.h"
#include "harness/sweep/points.h"

namespace lamina {

// What identifies a cell of a sweep: backend, effect, variant, view, point.
using CellKey = std::tuple<std::string, std::string, std::string, std::string, size_t>;

// Finds the points of cells.
class PointIndex {
 public:
  explicit PointIndex(const SweepPoints& points);
  // Throws Error(bad_input, "record", where, ...) for a cell that is of no point.
  CellKey key_of(const CellRow& cell, const std::string& where) const;

 private:
  std::vector<std::string> paths_;
  std::map<std::vector<double>, size_t> points_;
};

// What an earlier run left, after continue_record().
struct Earlier {
  std::set<CellKey> cells;
  std::set<std::string> kinds;  // of the other lines
  size_t cut_bytes = 0;         // of a line that was cut short
  bool finished = false;        // it had its answers
};

// Keeps other sweeps and merges out of a run's folder for as long as it lives: two that write one record would spoil it. Ends
// with the process, however that ends. Where the file system knows no such locks there is none.
class FolderLock {
 public:
  // Throws Error(bad_input, stage, ...) where another has it.
  FolderLock(const std::string& stage, const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int folder_ = -1;
};

// Makes the record in `file` ready to be appended to. It cuts off what follows the last newline, and the answers, which come
// last: they are computed again by the limits of `sweep`, which are written into the file. Does nothing where there is no file,
// or fewer than two whole lines in it. `run` and `sweep` are the lines that the present run would begin with. Throws
// Error(bad_input) where the lines in the file show other inputs, settings, devices or another program.
std::optional<Earlier> continue_record(const std::filesystem::path& file, const nlohmann::json& run, const SweepRow& sweep,
                                       const SweepPoints& points);

// Records of shards of one sweep, or of parts of it, joined as one run would have left them, without answers.
struct Joined {
  std::vector<nlohmann::ordered_json> lines;
  size_t cells = 0, duplicates = 0;  // duplicates that agree
  std::vector<std::string> missing;  // a sentence for each variant and backend that lacks points
  bool several_machines = false;     // then times are left out, ratios stay
};
// `files` in any order. Throws Error(bad_input) for records of different sweeps, and for two cells that disagree in anything
// but times, naming both.
Joined join_records(const std::vector<std::filesystem::path>& files);

// The points of a sweep line.
SweepPoints points_of(const SweepRow& sweep);

}  // namespace lamina
