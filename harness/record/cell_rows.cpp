// SPDX-License-Identifier: Apache-2.0
#include "harness/record/cell_rows.h"

#include <cmath>
#include <limits>

#include "harness/core/error.h"
#include "harness/record/fields.h"
#include "harness/record/record.h"
#include "harness/record/timer_row.h"

namespace lamina {
namespace {

using namespace lines;

// PSNR of identical pictures is infinite, for which JSON has no number.
struct Psnr {
  static std::string words() { return "a number or null"; }
  static bool fits(const Json& value) { return value.is_null() || value.is_number(); }
  static Line write(double psnr_db, const At& at) {
    return std::isinf(psnr_db) && psnr_db > 0 ? Line(nullptr) : finite(psnr_db, at);
  }
  static double read(const Json& value, const At&) {
    return value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
  }
};
bool are_identical(const ErrorFigures& figures) { return std::isinf(figures.psnr_db) && figures.psnr_db > 0; }

struct Status {
  static std::string words() { return "\"ok\" or \"failed\""; }
  static bool fits(const Json& value) { return value == "ok" || value == "failed"; }
  static Line write(bool failed, const At&) { return failed ? "failed" : "ok"; }
  static bool read(const Json& value, const At&) { return value == "failed"; }
};

std::optional<double> median_of(const std::vector<double>& samples) {
  return samples.empty() ? std::nullopt : std::optional(median(samples));
}

// Work that is done once has no rounds to pair by: each such pass counts with its own median. No such pass costs nothing, which
// is known; one without samples makes the sum unknown.
std::optional<double> once_ms(const std::vector<PassRow>& passes) {
  double sum_ms = 0;
  for (const PassRow& pass : passes) {
    if (!pass.once) continue;
    if (pass.ms.empty()) return std::nullopt;
    sum_ms += median(pass.ms);
  }
  return sum_ms;
}

}  // namespace

constexpr auto fields(const TextureFetches*) {
  return std::tuple(field("texture", &TextureFetches::texture), field("format", &TextureFetches::format),
                    field("filter", &TextureFetches::filter), field("fetches", &TextureFetches::fetches));
}

constexpr auto fields(const PassRow*) {
  return std::tuple(field("name", &PassRow::name), field("once", &PassRow::once), field("ms", &PassRow::ms),
                    field("median_ms", &PassRow::median_ms), field("fragments", &PassRow::fragments),
                    field("vertices", &PassRow::vertices), field("fetches", &PassRow::fetches),
                    field("early_tests", &PassRow::early_tests), field("by_texture", &PassRow::by_texture));
}

constexpr auto fields(const ErrorFigures*) {
  return std::tuple(field<Psnr>("psnr_db", &ErrorFigures::psnr_db),
                    derived("identical", are_identical, "'{}psnr_db' must be null for identical pictures and for no others"),
                    field("ssim", &ErrorFigures::ssim), field("flip", &ErrorFigures::flip),
                    field("rmse_linear", &ErrorFigures::rmse_linear), field("max_linear", &ErrorFigures::max_linear));
}

constexpr auto fields(const WorstTile*) {
  return std::tuple(field("x", &WorstTile::x), field("y", &WorstTile::y), field("size", &WorstTile::size),
                    field("flip", &WorstTile::flip));
}

constexpr auto fields(const AssumptionRow*) {
  return std::tuple(field("name", &AssumptionRow::name), field("title", &AssumptionRow::title),
                    field("error", &AssumptionRow::error), field("image", &AssumptionRow::image));
}

constexpr auto fields(const CellRow*) {
  return std::tuple(
      field("scene", &CellRow::scene), field("effect", &CellRow::effect), field("variant", &CellRow::variant),
      field("baseline", &CellRow::baseline), field("backend", &CellRow::backend), field("device", &CellRow::device),
      field("width", &CellRow::width), field("height", &CellRow::height), field("view", &CellRow::view),
      field("params", &CellRow::params), left_out("words", &CellRow::words), field<Status>("status", &CellRow::failed),
      field("reason", &CellRow::reason), field("timed", &CellRow::timed), field("passes", &CellRow::passes),
      field("median_ms", &CellRow::median_ms), field("once_ms", &CellRow::once_ms), field("cold_ms", &CellRow::cold_ms),
      field("ratio_to_baseline", &CellRow::ratio_to_baseline), field("fetches", &CellRow::fetches),
      field("fetches_per_pixel", &CellRow::fetches_per_pixel),
      group("error", field("baseline", &CellRow::error_covered), field("frame", &CellRow::error_frame),
            field("truth", &CellRow::error_truth)),
      field("nonfinite_pixels", &CellRow::nonfinite_pixels), field("covered_pixels", &CellRow::covered_pixels),
      left_out("range_linear", &CellRow::range_linear), field("image", &CellRow::image),
      field("difference", &CellRow::difference), field("flip", &CellRow::flip), left_out("truth_image", &CellRow::truth_image),
      left_out("worst_tile", &CellRow::worst_tile), left_out("assumptions", &CellRow::assumptions),
      field("image_hash", &CellRow::image_hash), field("shader_hashes", &CellRow::shader_hashes),
      left_out("before_image", &CellRow::before_image));
}

void check(const CellRow& row, const At& at) {
  if (row.failed) return;
  try {
    frame_samples_ms(row.passes);
  } catch (const Error& error) {
    refuse(at, fmt::format("{} {}", error.subject(), error.message()));
  }
}

constexpr auto fields(const BakeRow*) {
  return std::tuple(field("effect", &BakeRow::effect), field("object", &BakeRow::object), field("what", &BakeRow::what),
                    field("points", &BakeRow::points), field("rays", &BakeRow::rays), field("seconds", &BakeRow::seconds),
                    field("rays_per_second", &BakeRow::rays_per_second), field("from_cache", &BakeRow::from_cache));
}

constexpr auto fields(const PhaseRow*) {
  return std::tuple(field("backend", &PhaseRow::backend), field("effect", &PhaseRow::effect),
                    field("rounds", &PhaseRow::rounds), field("wall_ms", &PhaseRow::wall_ms),
                    field("device_ms", &PhaseRow::device_ms));
}

constexpr auto fields(const TimerRow*) {
  return std::tuple(field("backend", &TimerRow::backend), field("ok", &TimerRow::ok), field("linearity", &TimerRow::linearity),
                    field("one_ms", &TimerRow::one_ms), field("additivity", &TimerRow::additivity),
                    field("attribution", &TimerRow::attribution), field("reason", &TimerRow::reason));
}

constexpr auto fields(const FunctionTimerRow*) {
  return std::tuple(part(&FunctionTimerRow::timer), field("function", &FunctionTimerRow::function));
}

std::vector<double> frame_samples_ms(std::span<const PassRow> passes) {
  std::vector<double> sum_ms;
  const PassRow* first = nullptr;
  for (const PassRow& pass : passes) {
    if (pass.once) continue;
    if (!first) {
      first = &pass;
      sum_ms = pass.ms;
      continue;
    }
    if (pass.ms.size() != sum_ms.size())
      throw Error(ErrorKind::failed, "record", fmt::format("pass '{}'", pass.name),
                  fmt::format("has {} samples where pass '{}' has {}; every pass of a frame needs one a round", pass.ms.size(),
                              first->name, sum_ms.size()));
    for (size_t round = 0; round < sum_ms.size(); ++round) sum_ms[round] += pass.ms[round];
  }
  return sum_ms;
}

Line to_json(const CellRow& measured) {
  CellRow row = measured;
  if (!row.fetches || row.covered_pixels.value_or(0) == 0) row.fetches_per_pixel.reset();
  const auto forget_zero = [&](std::optional<uint64_t>& count) {
    if (row.failed && count == 0) count.reset();
  };
  for (PassRow& pass : row.passes) {
    if (!row.timed) pass.ms.clear();
    pass.median_ms = median_of(pass.ms);
    forget_zero(pass.fragments), forget_zero(pass.vertices), forget_zero(pass.fetches);
  }
  forget_zero(row.fetches), forget_zero(row.nonfinite_pixels), forget_zero(row.covered_pixels);
  const bool has_times = row.timed && !row.failed;
  row.median_ms = has_times ? median_of(frame_samples_ms(row.passes)) : std::nullopt;
  row.once_ms = has_times ? once_ms(row.passes) : std::nullopt;
  if (!has_times) row.ratio_to_baseline.reset();
  return line_of("cell", row, fmt::format("cell {}/{} on {}, view '{}'", row.effect, row.variant, row.backend, row.view));
}

Line to_json(const BakeRow& baked) {
  BakeRow row = baked;
  const bool cast = !row.from_cache && row.seconds > 0;
  row.rays_per_second = cast ? std::optional(static_cast<double>(row.rays) / row.seconds) : std::nullopt;
  return line_of("bake", row, fmt::format("bake of {} of {}", row.what, row.object));
}

Line to_json(const PhaseRow& row) { return line_of("phase", row, fmt::format("rounds of {} on {}", row.effect, row.backend)); }
Line to_json(const TimerRow& row) { return line_of("timer", row, "timer certificate of " + row.backend); }
Line to_json(const FunctionTimerRow& row) {
  return line_of("function_timer", row, "timer certificate of " + row.timer.backend);
}

template CellRow row_of(const Json& line, const std::string& where);
template BakeRow row_of(const Json& line, const std::string& where);
template PhaseRow row_of(const Json& line, const std::string& where);
template TimerRow row_of(const Json& line, const std::string& where);
template FunctionTimerRow row_of(const Json& line, const std::string& where);

}  // namespace lamina
