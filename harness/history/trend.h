// SPDX-License-Identifier: Apache-2.0
// How the figures of each cell went over records.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/record/record.h"

namespace lamina {

// One figure of a cell. A noisy one moves from run to run by itself; any other is a count or an error, of which every change
// larger than `tolerance` is real.
struct TrendFigure {
  std::string_view name, unit;  // "frame", "ms"; the unit is "" for plain numbers
  int digits;                   // after the point, where it is shown
  bool lower_is_better;
  bool noisy;
  double tolerance;  // in the figure's unit; noisy ones: the least standard deviation that is believed, of their median
};

struct HistoryRecord {
  std::string name;  // the path as it was given
  Record record;
};
// "a486914e12ab", or "unknown"; "2026-01-31" of the commit, else of the run, or "".
std::string commit_of(const HistoryRecord& record);
std::string day_of(const HistoryRecord& record);

// What is the same thing in two records: everything about a cell but what was measured, and but for the device.
struct TrendCell {
  std::string scene, effect, variant, backend, view;
  int width = 0, height = 0;
  std::string params;  // "objects.heart.thickness 6, scene.time 0"
  auto operator<=>(const TrendCell&) const = default;
};

struct TrendStep {
  size_t point = 0;              // index of the first point after it
  double before = 0, after = 0;  // noisy figures: medians of the levels on both sides; others: the points on both sides
  bool elsewhere = false;        // the machine, device or driver changed here too
};

struct Trend {
  struct Point {
    size_t record = 0;  // index into History::records
    double value = 0;   // finite, or infinite for the PSNR of identical pictures
  };
  TrendCell cell;
  const TrendFigure* figure = nullptr;
  std::string machine;  // frame times are of one machine, device and driver, named here; "" for other figures
  std::vector<Point> points;
  std::vector<TrendStep> steps;
};

struct History {
  std::vector<HistoryRecord> records;  // by commit date where all have one, else by their own date, else as given
  std::vector<Trend> trends;           // by cell in order of appearance, then by figure; each of two points or more
  std::vector<std::string> notes;      // how the records were ordered, and all that limits the trends, a sentence each
};

// Throws Error(bad_input) for fewer than two records, and where no cell is in two of them.
History make_history(std::vector<HistoryRecord> records);
// Of these folders of runs, or their record files. Throws as read_record() does too, and Error(bad_input) for one given twice.
History load_history(const std::vector<std::filesystem::path>& given);

}  // namespace lamina
