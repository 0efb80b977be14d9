// SPDX-License-Identifier: Apache-2.0
// lamina diff: how far one picture is from another, for any two files that OpenImageIO reads. Needs no device and no scene.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstring>

#include "harness/cli/cell.h"
#include "harness/cli/commands.h"
#include "harness/cli/common.h"
#include "harness/cli/run_line.h"
#include "harness/core/error.h"
#include "harness/quality/quality.h"
#include "harness/quality/ssim_interior.h"
#include "harness/scene/textures.h"
#include "reports/reports.h"
#include "reports/words.h"

namespace lamina {
namespace {

struct DiffOptions {
  std::filesystem::path reference, test, mask, out;  // mask, out: may be empty
};

Image picture_of(const std::filesystem::path& file, bool colour) {
  const Texels texels = load_texels(file, colour);
  return image_of(texels);
}

[[noreturn]] void refuse_sizes(const std::filesystem::path& file, const Image& picture, const Image& reference) {
  throw Error(ErrorKind::bad_input, "diff", file.string(),
              fmt::format("is {} x {} pixels, the reference {} x {}; give pictures of one size", picture.width, picture.height,
                          reference.width, reference.height));
}

// Where the mask's red is not 0, a pixel counts; without a mask all do.
Mask mask_of(const DiffOptions& options, const Image& reference) {
  Mask mask{reference.width, reference.height, std::vector<uint8_t>(reference.rgba.size() / 4, 1)};
  if (options.mask.empty()) return mask;
  const Image picture = picture_of(options.mask, false);
  if (picture.width != mask.width || picture.height != mask.height) refuse_sizes(options.mask, picture, reference);
  for (size_t i = 0; i < mask.on.size(); ++i) mask.on[i] = picture.rgba[4 * i] > 0;
  if (count_on(mask) == 0)
    throw Error(ErrorKind::bad_input, "diff", options.mask.string(), "is black everywhere: no pixel counts");
  return mask;
}

std::string figure_line(const char* over, uint64_t pixels, const ErrorFigures& figures) {
  return fmt::format("{:<8} {:>9} pixels  PSNR {} dB  SSIM {:.6f}  FLIP {:.6f}  RMSE {:.6g}  max {:.6g}\n", over, pixels,
                     words_for_psnr(figures.psnr_db), figures.ssim, figures.flip, figures.rmse_linear, figures.max_linear);
}

// The two as cells of a record, so that the page shows them as it shows a baseline and a variant.
CellRow diff_cell(const std::string& name, bool baseline, const Image& picture, const Mask& mask, const KeepPicture& keep) {
  CellRow row;
  row.scene = "pictures", row.effect = "diff", row.backend = "files", row.view = "whole";
  row.variant = name, row.baseline = baseline, row.timed = false;
  row.width = picture.width, row.height = picture.height;
  row.params["scene.time"] = 0;
  row.covered_pixels = count_on(mask);
  fill_picture(row, picture, mask, keep);
  return row;
}

void write_diff_report(const DiffOptions& options, const std::string& typed, const Image& test, const Image& reference,
                       const Mask& mask, const ErrorReport& report) {
  make_run_folder("diff", options.out);
  RecordWriter record(options.out / "record.jsonl");
  nlohmann::ordered_json run = run_line(typed, {});
  run["settings"] = {{"width", reference.width}, {"height", reference.height}, {"difference_gain", difference_gain}};
  run["scene"] = "pictures";
  run["source"] = options.reference.string();
  run["warnings"] = nlohmann::json::array();
  record.append(run);
  const auto keep = [&](const std::string& name) {
    return [&, name](const std::string& suffix, const DisplayImage& image) {
      const std::string path = "images/" + name + suffix + ".png";
      write_png((options.out / path).string(), image);
      return path;
    };
  };
  const CellRow first = diff_cell("reference", true, reference, mask, keep("reference"));
  CellRow second = diff_cell("test", false, test, mask, keep("test"));
  fill_errors(second, report, test, reference, keep("test"));
  record.append(to_json(first)), record.append(to_json(second));
  fmt::print("report: {}\n", write_reports(options.out).string());
}

int run_diff(const DiffOptions& options, const std::string& typed) {
  const Image reference = picture_of(options.reference, true), test = picture_of(options.test, true);
  if (test.width != reference.width || test.height != reference.height) refuse_sizes(options.test, test, reference);
  const Mask mask = mask_of(options, reference);
  const ErrorReport report = measure_error(test, reference, mask);
  fmt::print(
      "{} x {} pixels; whole numbers are read as sRGB, floating-point ones as linear light.\n"
      "PSNR, SSIM and FLIP are taken on 8-bit sRGB, RMSE and max on linear light.\n",
      reference.width, reference.height);
  if (!options.mask.empty()) fmt::print("{}", figure_line("masked", count_on(mask), report.covered));
  fmt::print("{}", figure_line("whole", mask.on.size(), report.frame));
  if (const auto interior = ssim_interior(to_display(test), to_display(reference)))
    fmt::print("SSIM without the {} pixels at the border, as tools report that leave them out: {:.6f}\n", ssim_border_px,
               *interior);
  if (!options.out.empty()) write_diff_report(options, typed, test, reference, mask, report);
  return 0;
}

}  // namespace

Command add_diff(CLI::App& program) {
  auto options = std::make_shared<DiffOptions>();
  CLI::App& command = *program.add_subcommand("diff", "How far a picture is from another: every figure, maps, and a page");
  command.add_option("reference", options->reference, "Picture that is right")->type_name(placeholder::file)->required();
  command.add_option("test", options->test, "Picture that is held against it")->type_name(placeholder::file)->required();
  command.add_option("--mask", options->mask, "Picture whose red says which pixels count: not 0")->type_name(placeholder::file);
  command.add_option("--out", options->out, "Folder for record, report and maps; without it figures are printed alone")
      ->type_name(placeholder::directory);
  return {&command, [=](const std::string& typed) { return run_diff(*options, typed); }};
}

}  // namespace lamina
