// SPDX-License-Identifier: Apache-2.0
// Records made by hand, small enough to work out every figure of a report on paper.
#pragma once

#include <string>
#include <vector>

#include "harness/record/record.h"
#include "reports/reports.h"
#include "tests/record/example_timer.h"
#include "tests/record/read_back.h"

namespace lamina {

inline size_t count_of(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// A cell of 100 covered pixels whose frame is one pass with these times, ms.
inline CellRow example_cell(std::string variant, std::string view, std::vector<double> ms, std::string backend = "vulkan") {
  CellRow cell;
  cell.scene = "heart";
  cell.effect = "layered_material";
  cell.variant = std::move(variant);
  cell.baseline = cell.variant == "light_map";
  cell.backend = std::move(backend);
  cell.device = "llvmpipe";
  cell.view = std::move(view);
  cell.width = 64, cell.height = 32;
  cell.params = {{"scene.time", 0.5}};
  PassRow& pass = cell.passes.emplace_back();
  pass.name = "composite";
  pass.ms = std::move(ms);
  pass.fragments = 120;
  pass.fetches = 1500;
  pass.by_texture = {{.texture = "light_map_texture", .format = "rgba16_float", .filter = "linear", .fetches = 1300},
                     {.texture = "outer_albedo", .format = "rgba8_srgb", .filter = "trilinear", .fetches = 200}};
  cell.fetches = 1500;
  cell.nonfinite_pixels = 0;
  cell.covered_pixels = 100;
  cell.range_linear = 0.7;
  cell.fetches_per_pixel = 15;
  cell.image = "images/" + cell.variant + "-" + cell.view + ".png";
  if (!cell.baseline) {
    cell.error_covered = cell.error_frame =
        ErrorFigures{.psnr_db = 30, .ssim = 0.9, .flip = 0.1, .rmse_linear = 0.02, .max_linear = 0.3};
    cell.difference = "images/" + cell.variant + "-" + cell.view + "-difference.png";
    cell.flip = "images/" + cell.variant + "-" + cell.view + "-flip.png";
  }
  cell.image_hash = "0123456789abcdef";
  return cell;
}

inline Record example_record(const std::vector<CellRow>& cells, const std::vector<TimerRow>& timers = {example_timer("vulkan")},
                             const std::string& build = "release") {
  Record record;
  record.run = {{"kind", "run"},
                {"schema", 1},
                {"lamina", "0.1.0"},
                {"commit", "abc1234"},
                {"build", build},
                {"command", "lamina compare heart"},
                {"scene", "heart"},
                {"machine", {{"cpu", "Example CPU"}, {"threads", 2}, {"lp_num_threads", "2"}}},
                {"settings", {{"width", 64}, {"height", 32}, {"rounds", 6}, {"seed", 1}, {"difference_gain", 8}}},
                {"warnings", nlohmann::json::array()}};
  record.run["devices"] = nlohmann::json::array(
      {{{"backend", "vulkan"}, {"device", "llvmpipe"}, {"driver", "Mesa 22.3.6"}, {"api_version", "1.3.230"}}});
  record.timers = read_back(timers);
  record.cells = read_back(cells);
  return record;
}

// Two views, six rounds: the variant takes 4 of the baseline's 8 ms in one, 6 of its 12 ms in the other.
inline std::vector<CellRow> example_cells() {
  return {
      example_cell("light_map", "front", {8, 8, 8, 8, 8, 8}), example_cell("light_map", "grazing", {12, 12, 12, 12, 12, 12}),
      example_cell("vertex_normal", "front", {4, 4, 4, 4, 4, 4}), example_cell("vertex_normal", "grazing", {6, 6, 6, 6, 6, 6})};
}

// The page without its library and script.
inline std::string page_of(const Record& record) {
  std::string page = html_report({record});
  const size_t begin = page.find("<script>"), end = page.rfind("</script>");
  return begin == std::string::npos ? page : page.erase(begin, end + std::string("</script>").size() - begin);
}

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace lamina
