// SPDX-License-Identifier: Apache-2.0
#include "harness/history/trend.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "harness/core/error.h"
#include "harness/history/change_points.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

enum Figure : size_t { frame_ms, ratio, fetches, ssim, psnr, flip, psnr_to_truth };
// The tolerances of errors are half the last digit that is shown.
constexpr std::array<TrendFigure, 7> figures = {{
    {"frame", "ms", 3, true, true, 0.002},
    {"ratio to baseline", "", 3, true, true, 0.002},
    {"fetches", "", 0, true, false, 0},
    {"SSIM", "", 4, false, false, 5e-5},
    {"PSNR", "dB", 1, false, false, 0.05},
    {"FLIP", "", 4, true, false, 5e-5},
    {"PSNR to truth", "dB", 1, false, false, 0.05},
}};

TrendCell cell_of(const CellRow& cell) {
  return {.scene = cell.scene,
          .effect = cell.effect,
          .variant = cell.variant,
          .backend = cell.backend,
          .view = cell.view,
          .width = cell.width,
          .height = cell.height,
          .params = entries_of(cell.params)};
}

// What a time depends on beside the program: "Example CPU, 2 threads, llvmpipe, Mesa 22.3.6".
std::string machine_of(const Record& record, const CellRow& cell) {
  std::string words = fmt::format("{}, {} threads, {}", text_at(record.run, "/machine/cpu"),
                                  text_at(record.run, "/machine/lp_num_threads"), cell.device);
  const auto devices = record.run.find("devices");
  if (devices == record.run.end() || !devices->is_array()) return words;
  for (const Json& device : *devices)
    if (text_at(device, "/backend") == cell.backend) words += ", " + text_at(device, "/driver");
  return words;
}

bool is_release(const Record& record) { return text_at(record.run, "/build") == "release"; }

// What is not known is not there.
std::array<std::optional<double>, figures.size()> figures_of_cell(const Record& record, const CellRow& cell) {
  std::array<std::optional<double>, figures.size()> values;
  if (cell.failed) return values;
  if (const std::vector<double> samples = shown_samples_ms(record, cell); is_release(record) && !samples.empty()) {
    values[frame_ms] = median(samples);
    if (cell.ratio_to_baseline) values[ratio] = cell.ratio_to_baseline->median;
  }
  if (cell.fetches) values[fetches] = static_cast<double>(*cell.fetches);
  if (const auto& error = cell.error_covered) {
    values[ssim] = error->ssim;
    values[psnr] = error->psnr_db;
    values[flip] = error->flip;
  }
  if (cell.error_truth) values[psnr_to_truth] = cell.error_truth->psnr_db;
  return values;
}

// Puts the records in order and says by what.
std::string order(std::vector<HistoryRecord>& records) {
  const auto all_have = [&](const char* field) {
    return std::ranges::all_of(records, [&](const HistoryRecord& r) {
      return !text_at(r.record.run, field).empty() && text_at(r.record.run, field) != "null";
    });
  };
  const auto sort_by = [&](const char* field) {
    std::ranges::stable_sort(records, {}, [&](const HistoryRecord& r) { return text_at(r.record.run, field); });
  };
  const bool dated = all_have("/date");
  if (dated) sort_by("/date");
  if (all_have("/commit_date")) {
    sort_by("/commit_date");
    return "records are in the order of their commits' dates";
  }
  if (dated) return "records are in the order in which they were made, for not every one has its commit's date";
  return "records are in the order given, for not every one says when it was made";
}

std::vector<std::string> notes_of(const std::vector<HistoryRecord>& records) {
  std::vector<std::string> notes;
  std::map<std::string, size_t> scenes;
  for (const HistoryRecord& one : records) {
    if (const std::string cut = text_at(one.record.run, "/truncated"); !cut.empty())
      notes.push_back(fmt::format("{} is used as far as it goes: {}", one.name, cut));
    if (!is_release(one.record))
      notes.push_back(fmt::format("{}: the build is not 'release', so its times are left out", one.name));
    if (one.record.cells.empty()) notes.push_back(fmt::format("{} holds no cells", one.name));
    const auto failed = std::ranges::count_if(one.record.cells, &CellRow::failed);
    if (failed > 0)
      notes.push_back(fmt::format("{}: {} of {} cells failed and are left out", one.name, failed, one.record.cells.size()));
    std::set<std::string> own;
    for (const CellRow& cell : one.record.cells) own.insert(fmt::format("{} at {}x{}", cell.scene, cell.width, cell.height));
    for (const std::string& scene : own) ++scenes[scene];
  }
  if (scenes.size() > 1) {
    std::vector<std::string> words;
    for (const auto& [scene, count] : scenes)
      words.push_back(fmt::format("{} in {} of {} records", scene, count, records.size()));
    notes.push_back(fmt::format("scenes or sizes differ and are kept apart: {}", fmt::join(words, ", ")));
  }
  return notes;
}

// The series of one cell and figure, and where each point was measured.
struct Series {
  Trend trend;
  std::vector<std::string> machines;
};

void find_steps(Series& series) {
  Trend& trend = series.trend;
  std::vector<double> values;
  for (const Trend::Point& point : trend.points) values.push_back(point.value);
  const bool noisy = trend.figure->noisy;
  const std::vector<size_t> steps = noisy ? noisy_steps(values, trend.figure->tolerance * std::abs(median(values)))
                                          : exact_steps(values, trend.figure->tolerance);
  for (size_t i = 0; i < steps.size(); ++i) {
    const size_t at = steps[i], begin = i == 0 ? 0 : steps[i - 1], end = i + 1 < steps.size() ? steps[i + 1] : values.size();
    const std::span<const double> all = values;
    trend.steps.push_back({.point = at,
                           .before = noisy ? median(all.subspan(begin, at - begin)) : values[at - 1],
                           .after = noisy ? median(all.subspan(at, end - at)) : values[at],
                           .elsewhere = series.machines[at] != series.machines[at - 1]});
  }
}

}  // namespace

std::string commit_of(const HistoryRecord& record) {
  const std::string commit = text_at(record.record.run, "/commit");
  return commit.empty() ? "unknown" : commit;
}

std::string day_of(const HistoryRecord& record) {
  const std::string commit_date = text_at(record.record.run, "/commit_date");
  return (commit_date.empty() || commit_date == "null" ? text_at(record.record.run, "/date") : commit_date).substr(0, 10);
}

History make_history(std::vector<HistoryRecord> records) {
  if (records.size() < 2)
    throw Error(ErrorKind::bad_input, "history", "RECORD", "a trend needs two records or more; give more");
  History history;
  history.notes.push_back(order(records));
  for (std::string& note : notes_of(records)) history.notes.push_back(std::move(note));

  std::vector<TrendCell> cells;  // in order of appearance
  std::map<TrendCell, std::set<size_t>> records_of;
  std::map<std::tuple<TrendCell, size_t, std::string>, Series> all;
  for (size_t i = 0; i < records.size(); ++i)
    for (const CellRow& row : records[i].record.cells) {
      const TrendCell cell = cell_of(row);
      if (!records_of.contains(cell)) cells.push_back(cell);
      if (!records_of[cell].insert(i).second) {
        history.notes.push_back(fmt::format("{} holds {} on {}, view '{}', twice; the first is used", records[i].name,
                                            cell.variant, cell.backend, cell.view));
        continue;
      }
      const std::string machine = machine_of(records[i].record, row);
      const auto values = figures_of_cell(records[i].record, row);
      for (size_t figure = 0; figure < figures.size(); ++figure) {
        if (!values[figure]) continue;
        Series& series = all[{cell, figure, figure == frame_ms ? machine : ""}];
        series.trend.points.push_back({i, *values[figure]});
        series.machines.push_back(machine);
      }
    }

  const auto alone = std::ranges::count_if(cells, [&](const TrendCell& cell) { return records_of[cell].size() < 2; });
  if (static_cast<size_t>(alone) == cells.size())
    throw Error(ErrorKind::bad_input, "history", "no cell in common",
                "no scene, size, effect, variant, backend, view and parameters are in two of the records; give records of the "
                "same command");
  if (alone > 0)
    history.notes.push_back(fmt::format("{} of {} cells are in one record only and have no trend", alone, cells.size()));
  for (const TrendCell& cell : cells)
    for (size_t figure = 0; figure < figures.size(); ++figure)
      for (auto at = all.lower_bound({cell, figure, ""});
           at != all.end() && std::get<0>(at->first) == cell && std::get<1>(at->first) == figure; ++at) {
        Series& series = at->second;
        if (series.trend.points.size() < 2) continue;
        series.trend.cell = cell;
        series.trend.figure = &figures[figure];
        series.trend.machine = std::get<2>(at->first);
        find_steps(series);
        history.trends.push_back(std::move(series.trend));
      }
  if (history.trends.empty())
    throw Error(ErrorKind::bad_input, "history", "no figure in common",
                "cells are in two of the records, but none of their figures is known in both; see why they failed");
  history.records = std::move(records);
  return history;
}

History load_history(const std::vector<std::filesystem::path>& given) {
  std::vector<HistoryRecord> records;
  std::set<std::filesystem::path> seen;
  for (const std::filesystem::path& path : given) {
    const std::filesystem::path file = std::filesystem::is_directory(path) ? path / "record.jsonl" : path;
    Record record = read_record(file);
    if (!seen.insert(std::filesystem::canonical(file)).second)
      throw Error(ErrorKind::bad_input, "history", path.string(), "is given twice; a trend needs each record once");
    records.push_back({path.string(), std::move(record)});
  }
  return make_history(std::move(records));
}

}  // namespace lamina
