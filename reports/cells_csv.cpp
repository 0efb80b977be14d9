// SPDX-License-Identifier: Apache-2.0
// Cells as comma-separated values (Shafranovich, "Common Format and MIME Type for CSV Files", RFC 4180, 2005).
#include <set>

#include "reports/words.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

std::string scalar(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

// Whether a column is a time of the device, which only a good certificate lets out.
struct Column {
  const char* pointer;
  bool device_time = false;
};
constexpr Column csv_columns[] = {{"/scene"},
                                  {"/effect"},
                                  {"/variant"},
                                  {"/baseline"},
                                  {"/backend"},
                                  {"/device"},
                                  {"/width"},
                                  {"/height"},
                                  {"/view"},
                                  {"/status"},
                                  {"/reason"},
                                  {"/timed"},
                                  {"/median_ms", true},
                                  {"/once_ms", true},
                                  {"/cold_ms"},
                                  {"/ratio_to_baseline/median", true},
                                  {"/ratio_to_baseline/low", true},
                                  {"/ratio_to_baseline/high", true},
                                  {"/ratio_to_baseline/rounds", true},
                                  {"/ratio_to_baseline/coverage", true},
                                  {"/fetches"},
                                  {"/fetches_per_pixel"},
                                  {"/error/baseline/psnr_db"},
                                  {"/error/baseline/ssim"},
                                  {"/error/baseline/flip"},
                                  {"/error/baseline/rmse_linear"},
                                  {"/error/baseline/max_linear"},
                                  {"/error/frame/psnr_db"},
                                  {"/error/frame/ssim"},
                                  {"/error/frame/flip"},
                                  {"/error/frame/rmse_linear"},
                                  {"/error/frame/max_linear"},
                                  {"/error/truth/psnr_db"},
                                  {"/error/truth/ssim"},
                                  {"/error/truth/flip"},
                                  {"/error/truth/rmse_linear"},
                                  {"/error/truth/max_linear"},
                                  {"/nonfinite_pixels"},
                                  {"/covered_pixels"},
                                  {"/image"},
                                  {"/difference"},
                                  {"/flip"},
                                  {"/truth_image"},
                                  {"/worst_tile/x"},
                                  {"/worst_tile/y"},
                                  {"/worst_tile/size"},
                                  {"/worst_tile/flip"},
                                  {"/image_hash"}};

std::string value_at(const Json& cell, const std::string& pointer) {
  const Json::json_pointer path(pointer);
  if (!cell.contains(path)) return "";
  const Json& value = cell.at(path);
  if (value.is_null() && path.back() == "psnr_db" && cell.at(path.parent_pointer()).at("identical") == true) return "inf";
  return scalar(value);
}

// "/error/frame/ssim" is the column "error.frame.ssim".
std::string name_of(std::string pointer) {
  pointer.erase(0, 1);
  for (char& c : pointer)
    if (c == '/') c = '.';
  return pointer;
}

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

std::string cells_csv(const Record& record) {
  std::set<std::string> params;
  for (const Json& cell : record.cells)
    for (const auto& [path, value] : cell.at("params").items()) params.insert(path);

  std::string csv = "build";
  for (const Column& column : csv_columns) csv += "," + name_of(column.pointer);
  for (const std::string& path : params) csv += "," + csv_field("params." + path);
  csv += "\r\n";
  for (const Json& cell : record.cells) {
    const bool shown = times_shown(record, cell.at("backend").get<std::string>());
    csv += csv_field(text_at(record.run, "/build"));
    for (const Column& column : csv_columns)
      csv += "," + (column.device_time && !shown ? "" : csv_field(value_at(cell, column.pointer)));
    for (const std::string& path : params) {
      const auto value = cell.at("params").find(path);
      csv += "," + (value == cell.at("params").end() ? "" : scalar(*value));
    }
    csv += "\r\n";
  }
  return csv;
}

}  // namespace lamina
