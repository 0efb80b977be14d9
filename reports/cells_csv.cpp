// SPDX-License-Identifier: Apache-2.0
// Cells as comma-separated values (Shafranovich, "Common Format and MIME Type for CSV Files", RFC 4180, 2005).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/words.h"

namespace lamina {
namespace {

// As JSON writes them; nothing for what is not known, "inf" for the PSNR of identical pictures.
std::string csv_words(const std::string& text) { return text; }
std::string csv_words(bool is) { return is ? "true" : "false"; }
std::string csv_words(int value) { return std::to_string(value); }
std::string csv_words(uint64_t value) { return std::to_string(value); }
std::string csv_words(double value) { return std::isinf(value) ? "inf" : nlohmann::json(value).dump(); }
template <class T>
std::string csv_words(const std::optional<T>& value) {
  return value ? csv_words(*value) : "";
}

template <auto member>
std::string of_cell(const CellRow& cell) {
  return csv_words(cell.*member);
}
template <auto member, auto figure>
std::string in_cell(const CellRow& cell) {
  return cell.*member ? csv_words((*(cell.*member)).*figure) : "";
}

// By class, over the passes that are not done once.
std::map<std::string, uint64_t> operations_of_frame(const CellRow& cell) {
  std::map<std::string, uint64_t> sum;
  for (const PassRow& pass : cell.passes)
    if (!pass.once)
      for (const auto& [operation, times] : pass.operations) sum[operation] += times;
  return sum;
}

// Of the fetches of a frame: what `count` takes of each texture's; nothing where some texture does not tell.
std::string fetches_of_frame(const CellRow& cell, std::optional<uint64_t> (*count)(const TextureFetches&)) {
  uint64_t sum = 0;
  for (const PassRow& pass : cell.passes)
    for (const TextureFetches& texture : pass.by_texture) {
      if (pass.once) continue;
      const std::optional<uint64_t> counted = count(texture);
      if (!counted) return "";
      sum += *counted;
    }
  return cell.fetches ? csv_words(sum) : "";
}
std::string mean_level_of_frame(const CellRow& cell) {
  std::vector<uint64_t> sum;
  for (const PassRow& pass : cell.passes)
    for (const TextureFetches& texture : pass.by_texture) {
      if (pass.once) continue;
      if (texture.levels.empty() && texture.fetches > 0) return "";
      sum.resize(std::max(sum.size(), texture.levels.size()));
      for (size_t level = 0; level < texture.levels.size(); ++level) sum[level] += texture.levels[level];
    }
  return csv_words(mean_level(sum));
}

// Whether a column is a time of the device, which only a good certificate lets out.
struct CsvColumn {
  const char* name;
  std::string (*words)(const CellRow&);
  bool device_time = false;
};
constexpr CsvColumn csv_columns[] = {
    {"scene", of_cell<&CellRow::scene>},
    {"effect", of_cell<&CellRow::effect>},
    {"variant", of_cell<&CellRow::variant>},
    {"baseline", of_cell<&CellRow::baseline>},
    {"backend", of_cell<&CellRow::backend>},
    {"device", of_cell<&CellRow::device>},
    {"width", of_cell<&CellRow::width>},
    {"height", of_cell<&CellRow::height>},
    {"view", of_cell<&CellRow::view>},
    {"status", [](const CellRow& cell) { return std::string(cell.failed ? "failed" : "ok"); }},
    {"reason", of_cell<&CellRow::reason>},
    {"timed", of_cell<&CellRow::timed>},
    {"median_ms", of_cell<&CellRow::median_ms>, true},
    {"once_ms", of_cell<&CellRow::once_ms>, true},
    {"cold_ms", of_cell<&CellRow::cold_ms>},
    {"ratio_to_baseline.median", in_cell<&CellRow::ratio_to_baseline, &Interval::median>, true},
    {"ratio_to_baseline.low", in_cell<&CellRow::ratio_to_baseline, &Interval::low>, true},
    {"ratio_to_baseline.high", in_cell<&CellRow::ratio_to_baseline, &Interval::high>, true},
    {"ratio_to_baseline.rounds", in_cell<&CellRow::ratio_to_baseline, &Interval::rounds>, true},
    {"ratio_to_baseline.coverage", in_cell<&CellRow::ratio_to_baseline, &Interval::coverage>, true},
    {"fetches", of_cell<&CellRow::fetches>},
    {"fetches_per_pixel", of_cell<&CellRow::fetches_per_pixel>},
    {"fetches.unfiltered",
     [](const CellRow& cell) { return fetches_of_frame(cell, [](const TextureFetches& of) { return of.unfiltered; }); }},
    {"fetches.3d",
     [](const CellRow& cell) {
       return fetches_of_frame(cell, [](const TextureFetches& of) {
         return of.dimensions ? std::optional(*of.dimensions == 3 ? of.fetches : 0) : std::nullopt;
       });
     }},
    {"fetches.mean_level", mean_level_of_frame},
    {"error.baseline.psnr_db", in_cell<&CellRow::error_covered, &ErrorFigures::psnr_db>},
    {"error.baseline.ssim", in_cell<&CellRow::error_covered, &ErrorFigures::ssim>},
    {"error.baseline.flip", in_cell<&CellRow::error_covered, &ErrorFigures::flip>},
    {"error.baseline.rmse_linear", in_cell<&CellRow::error_covered, &ErrorFigures::rmse_linear>},
    {"error.baseline.max_linear", in_cell<&CellRow::error_covered, &ErrorFigures::max_linear>},
    {"error.frame.psnr_db", in_cell<&CellRow::error_frame, &ErrorFigures::psnr_db>},
    {"error.frame.ssim", in_cell<&CellRow::error_frame, &ErrorFigures::ssim>},
    {"error.frame.flip", in_cell<&CellRow::error_frame, &ErrorFigures::flip>},
    {"error.frame.rmse_linear", in_cell<&CellRow::error_frame, &ErrorFigures::rmse_linear>},
    {"error.frame.max_linear", in_cell<&CellRow::error_frame, &ErrorFigures::max_linear>},
    {"error.truth.psnr_db", in_cell<&CellRow::error_truth, &ErrorFigures::psnr_db>},
    {"error.truth.ssim", in_cell<&CellRow::error_truth, &ErrorFigures::ssim>},
    {"error.truth.flip", in_cell<&CellRow::error_truth, &ErrorFigures::flip>},
    {"error.truth.rmse_linear", in_cell<&CellRow::error_truth, &ErrorFigures::rmse_linear>},
    {"error.truth.max_linear", in_cell<&CellRow::error_truth, &ErrorFigures::max_linear>},
    {"nonfinite_pixels", of_cell<&CellRow::nonfinite_pixels>},
    {"covered_pixels", of_cell<&CellRow::covered_pixels>},
    {"image", of_cell<&CellRow::image>},
    {"difference", of_cell<&CellRow::difference>},
    {"flip", of_cell<&CellRow::flip>},
    {"truth_image", of_cell<&CellRow::truth_image>},
    {"worst_tile.x", in_cell<&CellRow::worst_tile, &WorstTile::x>},
    {"worst_tile.y", in_cell<&CellRow::worst_tile, &WorstTile::y>},
    {"worst_tile.size", in_cell<&CellRow::worst_tile, &WorstTile::size>},
    {"worst_tile.flip", in_cell<&CellRow::worst_tile, &WorstTile::flip>},
    {"image_hash", of_cell<&CellRow::image_hash>}};

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

std::string cells_csv(const Record& record) {
  std::set<std::string> params, operations;
  for (const CellRow& cell : record.cells) {
    for (const auto& [path, value] : cell.params) params.insert(path);
    for (const auto& [operation, times] : operations_of_frame(cell)) operations.insert(operation);
  }

  std::string csv = "build";
  for (const CsvColumn& column : csv_columns) csv += fmt::format(",{}", column.name);
  for (const std::string& path : params) csv += "," + csv_field("params." + path);
  for (const std::string& operation : operations) csv += "," + csv_field("operations." + operation);
  csv += "\r\n";
  for (const CellRow& cell : record.cells) {
    const bool shown = times_shown(record, cell.backend);
    csv += csv_field(text_at(record.run, "/build"));
    for (const CsvColumn& column : csv_columns)
      csv += "," + (column.device_time && !shown ? "" : csv_field(column.words(cell)));
    for (const std::string& path : params) {
      const auto value = cell.params.find(path);
      csv += "," + (value == cell.params.end() ? "" : csv_words(value->second));
    }
    const std::map<std::string, uint64_t> done = operations_of_frame(cell);
    for (const std::string& operation : operations) {
      const auto times = done.find(operation);
      // A class that a counted frame does not have is 0; a frame that was not counted has no figure.
      csv += "," + (times != done.end() ? csv_words(times->second) : done.empty() ? "" : "0");
    }
    csv += "\r\n";
  }
  return csv;
}

}  // namespace lamina
