// SPDX-License-Identifier: Apache-2.0
// Records of sweeps made by hand: one view, one backend, a baseline and variants whose errors and ratios are given.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "harness/record/record.h"
#include "tests/record/read_back.h"

namespace lamina {

inline const char* const thickness = "objects.heart.thickness";

inline CellRow sweep_cell(const std::string& variant, double x, double ssim, std::optional<double> ratio = std::nullopt) {
  CellRow cell;
  cell.scene = "heart", cell.effect = "layered_material", cell.variant = variant, cell.backend = "vulkan", cell.view = "front";
  cell.device = "llvmpipe", cell.width = 64, cell.height = 64;
  cell.baseline = variant == "light_map";
  cell.params = {{"scene.time", 0}, {thickness, x}};
  cell.timed = ratio.has_value();
  if (ratio) {
    PassRow& pass = cell.passes.emplace_back();
    pass.name = "composite";
    pass.ms = std::vector<double>(6, 10 * *ratio);
  }
  if (!cell.baseline) {
    cell.error_covered = cell.error_frame =
        ErrorFigures{.psnr_db = 40, .ssim = ssim, .flip = 1 - ssim, .rmse_linear = 0.01, .max_linear = 0.1};
    if (ratio) cell.ratio_to_baseline = Interval{*ratio, *ratio * 0.999, *ratio * 1.001, 6, 0.96};
  }
  cell.image_hash = "0123456789abcdef";
  return cell;
}

inline nlohmann::json sweep_run_line() {
  return {{"kind", "run"},
          {"schema", 1},
          {"lamina", "0.1.0"},
          {"commit", "abc"},
          {"build", "release"},
          {"command", "lamina sweep heart"},
          {"scene", "heart"},
          {"source", "heart"},
          {"machine", {{"cpu", "Example"}, {"threads", 2}}},
          {"inputs", "f00d"},
          {"warnings", nlohmann::json::array()},
          {"settings",
           {{"width", 64},
            {"height", 64},
            {"time", "none"},
            {"backends", {"vulkan"}},
            {"effects", {"layered_material"}},
            {"views", {"front"}},
            {"variants", {"layered_material/light_map", "layered_material/vertex_normal"}}}},
          {"devices", nlohmann::json::array({{{"backend", "vulkan"}, {"device", "llvmpipe"}}})}};
}

inline SweepRow sweep_row(std::vector<double> x, size_t index = 0, size_t count = 1) {
  SweepRow row;
  row.points = x.size();
  row.parameters = {{thickness, "texels", std::move(x)}};
  row.shard_index = index, row.shard_count = count;
  row.limits = {{"ssim", 0.98}};
  return row;
}

inline Record sweep_record(const std::vector<double>& x, const std::vector<CellRow>& cells) {
  Record record;
  record.run = sweep_run_line();
  record.sweeps = {sweep_row(x)};
  record.cells = read_back(cells);
  return record;
}

}  // namespace lamina
