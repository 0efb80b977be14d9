// SPDX-License-Identifier: Apache-2.0
// Writes the pages that the browser tests open, from records made by code: make_pages FOLDER.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "harness/core/text.h"
#include "harness/sweep/answers.h"
#include "reports/pictures.h"
#include "tests/record/function_rows.h"
#include "tests/reports/example_gate.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;

constexpr int width = 64, height = 48;

// A picture whose pixel (x, y) is (x, y, blue): tests know every value.
void paint(const fs::path& file, int blue) {
  if (fs::exists(file)) return;
  fs::create_directories(file.parent_path());
  DisplayImage image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int value : {x, y, blue}) image.rgb.push_back(static_cast<uint8_t>(value));
  write_png(file.string(), image);
}

struct Cost {
  const char* variant;
  double ms, ssim;
};
constexpr Cost costs[] = {{"light_map", 8, 1}, {"normal_map_taps", 9, 0.95}, {"vertex_normal", 4, 0.9}};

// A cell of `rounds` samples a bit apart, whose SSIM falls with `loss`.
CellRow cell_of(const Cost& cost, const std::string& view, const std::string& backend, size_t rounds, double loss = 1) {
  std::vector<double> ms;
  for (size_t i = 0; i < rounds; ++i) ms.push_back(cost.ms * (1 + 0.01 * std::sin(static_cast<double>(7 * i + view.size()))));
  CellRow cell = example_cell(cost.variant, view, ms, backend);
  cell.width = width, cell.height = height;
  cell.image_hash = fmt::format("{:016x}", std::hash<std::string>{}(cell.image) % 1000);
  PassRow& second = cell.passes.emplace_back(cell.passes[0]);
  second.name = "light";
  for (double& sample : second.ms) sample /= 4;
  second.by_texture = {{.texture = "albedo", .format = "rgba8_srgb", .filter = "linear", .fetches = 300}};
  second.fetches = 300;
  cell.fetches = 1800, cell.fetches_per_pixel = cost.ms * 2;
  if (cell.baseline) return cell;
  const double ssim = 1 - (1 - cost.ssim) * loss;
  cell.error_covered = cell.error_frame =
      ErrorFigures{.psnr_db = 20 + 20 * ssim, .ssim = ssim, .flip = (1 - ssim) / 2, .rmse_linear = 0.02, .max_linear = 0.3};
  cell.ratio_to_baseline = Interval{
      .median = cost.ms / 8, .low = cost.ms / 8 * 0.99, .high = cost.ms / 8 * 1.01, .rounds = rounds, .coverage = 0.97};
  cell.worst_tile = WorstTile{.x = 32, .y = 0, .flip = 0.25};
  return cell;
}

void name_pictures(CellRow& cell, const std::string& name) {
  cell.image = "images/" + name + ".png";
  if (cell.baseline) return;
  cell.difference = "images/" + name + "-difference.png";
  cell.flip = "images/" + name + "-flip.png";
}

Record compare_record(const std::string& commit) {
  std::vector<CellRow> cells;
  for (const std::string backend : {"vulkan", "osmesa"})
    for (const std::string view : {"front", "grazing"})
      for (const Cost& cost : costs) {
        cells.push_back(cell_of(cost, view, backend, 12));
        name_pictures(cells.back(), fmt::format("{}-{}-{}", cost.variant, backend, view));
        PassRow& once = cells.back().passes.emplace_back(cells.back().passes[0]);
        once.name = "seeds", once.once = true;
      }
  CellRow failed = cells.back();
  failed.variant = "broken";
  failed.failed = true;
  failed.reason = "the shader does not compile: line 3: \"<b>\" is no type";
  cells.push_back(failed);
  Record record = example_record(cells, {example_timer("vulkan"), example_timer("osmesa")});
  record.run["commit"] = commit;
  record.plans.push_back({{{.effect = "layered_material", .called_for = true, .reason = "heart has layers"},
                           {.effect = "aperture_lighting", .reason = "no object has apertures"}}});
  record.gates = {example_gate_row(Verdict::slower, 1)};
  record.aas = {example_aa(Verdict::same)};
  record.verdicts = {example_slower(), example_verdict(Verdict::same, "ssim", "vertex_normal on vulkan: ssim as before")};
  return record;
}

// `points` thicknesses, two variants and the baseline, one view; pictures for each cell where `pictures`.
Record sweep_record(size_t points, size_t views, bool pictures) {
  std::vector<CellRow> cells;
  std::vector<double> values;
  size_t picture_cells = 0;
  for (size_t point = 0; point < points; ++point) {
    values.push_back(static_cast<double>(point));
    for (size_t view = 0; view < views; ++view)
      for (const Cost& cost : costs) {
        CellRow& cell = cells.emplace_back(cell_of(cost, fmt::format("view{}", view), "vulkan", 20,
                                                   0.1 * static_cast<double>(point) / static_cast<double>(points) * 10));
        cell.params["objects.heart.thickness"] = static_cast<double>(point);
        if (pictures && picture_cells < 600) {
          name_pictures(cell, fmt::format("{}-{}-{}", cost.variant, view, point));
          picture_cells += cell.baseline ? 1 : 3;
        } else {
          cell.image = cell.difference = cell.flip = "";
          cell.worst_tile.reset();
        }
      }
  }
  Record record = example_record(cells);
  SweepRow& sweep = record.sweeps.emplace_back();
  sweep.parameters = {{"objects.heart.thickness", "texels", values}};
  sweep.points = points;
  const double at = static_cast<double>(points) * 0.4;
  record.crossovers.push_back({"objects.heart.thickness", "vulkan", "layered_material", "normal_map_taps", "", "ssim", 0.98, at,
                               0.1, fmt::format("normal_map_taps keeps SSIM at least 0.98 up to thickness {:.3g} texels", at)});
  // No cell has a truth: no chart is of this.
  CrossoverRow to_truth = record.crossovers[0];
  to_truth.metric = "truth.ssim", to_truth.at = 3;
  to_truth.sentence = "normal_map_taps keeps SSIM to the truth at least 0.98 up to 3";
  record.crossovers.push_back(to_truth);
  return record;
}

// A grid of two parameters: over the thickness SSIM meets the limit at 8 for a gain of 1, at 4 for one of 2.
Record grid_record() {
  Record record = sweep_record(12, 1, false);
  const std::vector<CellRow> cells = std::move(record.cells);
  record.cells.clear();
  for (CellRow cell : cells)
    for (const double gain : {1, 2}) {
      cell.params["lights.key.gain"] = gain;
      if (!cell.baseline) cell.error_covered->ssim = 1 - 0.0025 * gain * cell.params.at("objects.heart.thickness");
      record.cells.push_back(cell);
    }
  record.sweeps[0].parameters.push_back({"lights.key.gain", "", {1, 2}});
  record.crossovers = answers(curves_of(record), {{"ssim", 0.98}});
  return record;
}

// A sweep that timed nothing, and counted nothing unless `counted`.
Record untimed_record(bool counted) {
  Record record = sweep_record(4, 1, false);
  for (CellRow& cell : record.cells) {
    cell.timed = false;
    if (!counted) cell.fetches_per_pixel.reset();
    for (PassRow& pass : cell.passes) {
      pass.ms.clear();
      if (!counted) pass.fetches.reset(), pass.by_texture.clear();
    }
  }
  return record;
}

Record evil_record() {
  const std::string evil = "<script>window.evil=1</script>\"'&<img src=x onerror=window.evil=1>";
  std::vector<CellRow> cells;
  for (const Cost& cost : costs) {
    CellRow& cell = cells.emplace_back(cell_of(cost, evil, "vulkan" + evil, 8));
    cell.effect = evil;
    cell.variant += evil;
    cell.passes[0].name = evil;
    cell.passes[0].by_texture[0].texture = evil;
    cell.params[evil] = 1;
    name_pictures(cell, cost.variant);
  }
  cells.push_back(cells.back());
  cells.back().failed = true;
  cells.back().reason = evil;
  Record record = example_record(cells, {example_timer("vulkan" + evil)});
  record.run["command"] = evil;
  return record;
}

// Cells with a truth, to which the fast variant is closer than the others, and a function of three variants on two backends, of
// which one breaks its bounds.
Record truth_and_functions_record() {
  std::vector<CellRow> cells;
  for (const Cost& cost : costs) {
    CellRow& cell = cells.emplace_back(cell_of(cost, "front", "vulkan", 12));
    name_pictures(cell, cost.variant);
    cell.truth_image = "images/truth.png";
    cell.fetches_per_pixel = cell.baseline ? 220 : cost.ms - 1;  // over more than two decades
    const double ssim = 1.75 - cost.ssim;
    cell.error_truth =
        ErrorFigures{.psnr_db = 40 * ssim, .ssim = ssim, .flip = 1 - ssim, .rmse_linear = 0.05, .max_linear = 0.5};
  }
  Record record = example_record(cells);
  for (const std::string backend : {"vulkan", "osmesa"})
    for (const auto& [variant, error, ns] :
         {std::tuple{"exact_cap", 1e-6, 40.0}, {"fitted_cap", 0.02, 4.0}, {"naive_cap", 0.3, 10.0}}) {
      const FunctionSubject subject = example_subject(variant, backend);
      record.functions.push_back(read_back(with_bounds(example_function(subject, error))));
      record.function_times.push_back(read_back(with_samples(example_time(subject, ns))));
      record.function_pictures.push_back(example_picture(subject));
    }
  return record;
}

// A gate over two trees: what normal_map_taps looked like before is there too.
Record gate_record() {
  Record record = compare_record("abc1234");
  for (CellRow& cell : record.cells)
    if (cell.variant == "normal_map_taps")
      cell.before_image = "images/before-light_map.png";  // painted like the baseline, so that tests know its pixels
  record.verdicts[0].view = "front";
  // Two processes of eight strips, of which the new tree's take 1.09 and 1.11 times the old one's; A/A as long.
  for (const size_t process : {0, 1}) {
    PairedPass pass{"composite", true, {false, false, false}, {{}, {}, {}}, {{}, {}, {}}};
    for (int strip = 0; strip < 8; ++strip) {
      const double before = 5 + 0.1 * strip, wiggle = strip % 2 == 0 ? 1.001 : 0.999;
      pass.strips[1].push_back({before, before * (process == 0 ? 1.09 : 1.11) * wiggle, strip / 2 % 2 == 1});
      pass.strips[2].push_back({before, before * wiggle, strip / 2 % 2 == 1});
      for (std::vector<double>& of_frame : pass.ms) of_frame.push_back(before);
    }
    record.pairs.push_back(
        {process, "vulkan", "layered_material", "vertex_normal", "front", {"before", "after", "again"}, {pass}});
  }
  return record;
}

// A pass that computes: the same time for a tenth of the fetches.
Record computing_record() {
  Record record = sweep_record(1, 1, false);
  record.sweeps.clear(), record.crossovers.clear();
  for (CellRow& cell : record.cells) {
    cell.params.clear();
    if (cell.variant == "vertex_normal") cell.passes[1].fetches = 30, cell.passes[1].by_texture[0].fetches = 30;
  }
  return record;
}

void paint_pictures(Record& record, const fs::path& folder) {
  for_each_picture(record, [&](const std::string& path) {
    paint(folder / path, path.find("-difference") != std::string::npos ? 0
                         : path.find("light_map") != std::string::npos ? 10
                                                                       : 200);
  });
}

void write_record(Record& record, const fs::path& folder) {
  fs::create_directories(folder);
  paint_pictures(record, folder);
  std::string lines = record.run.dump() + '\n';
  const auto add = [&](const auto&... rows) {
    const auto add_each = [&](const auto& part) {
      for (const auto& row : part) lines += to_json(row).dump() + '\n';
    };
    (add_each(rows), ...);
  };
  add(record.timers, record.plans, record.cells, record.gates, record.pairs, record.aas, record.verdicts, record.functions,
      record.function_times, record.function_pictures);
  write_file_atomically(folder / "record.jsonl", lines);
}

void write_page(Record& record, const fs::path& folder) {
  fs::create_directories(folder);
  paint_pictures(record, folder);
  write_file_atomically(folder / "index.html", html_report({record}));
}

void make_pages(const fs::path& out) {
  fs::remove_all(out);
  for (const auto& [name, commit] : {std::pair{"compare", "abc1234"}, {"compare2", "def5678"}}) {
    Record record = compare_record(commit);
    write_record(record, out / name);
    write_reports(out / name);
  }
  write_reports({out / "compare", out / "compare2"}, {.single_file = false, .out = out / "two"});
  write_reports({out / "compare"}, {.single_file = true, .out = out / "single"});
  Record sweep = sweep_record(12, 2, true), large = sweep_record(500, 2, true), evil = evil_record(), gate = gate_record(),
         truth = truth_and_functions_record(), counted = untimed_record(true), grid = grid_record(),
         errors = untimed_record(false), computing = computing_record();
  write_page(sweep, out / "sweep");
  write_page(grid, out / "grid");
  write_page(counted, out / "counted");
  write_page(errors, out / "errors");
  write_page(computing, out / "computing");
  write_page(large, out / "large");
  write_page(evil, out / "evil");
  for (const auto& [record, name] : {std::pair{&gate, "gate"}, {&truth, "truth"}}) {
    write_record(*record, out / name);
    write_reports(out / name);
  }
}

}  // namespace
}  // namespace lamina

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: make_pages FOLDER\n");
    return 2;
  }
  lamina::make_pages(argv[1]);
}
