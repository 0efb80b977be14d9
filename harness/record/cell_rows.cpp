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
  static Line schema() { return or_null({{"type", "number"}}); }
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
  static Line schema() { return {{"enum", {"ok", "failed"}}}; }
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
  using Row = TextureFetches;
  return std::tuple(field("texture", &Row::texture), field("format", &Row::format), field("filter", &Row::filter),
                    field("fetches", &Row::fetches), may_lack("issued", &Row::issued), left_out("unfiltered", &Row::unfiltered),
                    left_out("dimensions", &Row::dimensions), left_out("size", &Row::size), left_out("levels", &Row::levels));
}

constexpr auto fields(const WrittenTexels*) {
  using Row = WrittenTexels;
  return std::tuple(field("format", &Row::format), field("load", &Row::load), field("combine", &Row::combine),
                    field("texels", &Row::texels));
}

constexpr auto fields(const LineRow*) {
  using Row = LineRow;
  return std::tuple(field("file", &Row::file), field("line", &Row::line), field("fetches", &Row::fetches),
                    field("operations", &Row::operations));
}

constexpr auto fields(const PassRow*) {
  using Row = PassRow;
  return std::tuple(
      field("name", &Row::name), field("once", &Row::once), field("ms", &Row::ms), field("median_ms", &Row::median_ms),
      field("fragments", &Row::fragments), field("vertices", &Row::vertices), field("fetches", &Row::fetches),
      field("early_tests", &Row::early_tests), field("by_texture", &Row::by_texture), left_out("operations", &Row::operations),
      left_out("issued", &Row::issued), left_out("lines", &Row::lines), left_out("vertex_issued", &Row::vertex_issued),
      left_out("runs", &Row::runs), left_out("triangles", &Row::triangles),
      left_out("issued_fragments", &Row::issued_fragments), left_out("written", &Row::written));
}

constexpr auto fields(const ErrorFigures*) {
  using Row = ErrorFigures;
  return std::tuple(field<Psnr>("psnr_db", &Row::psnr_db),
                    derived("identical", are_identical, "'{}psnr_db' must be null for identical pictures and for no others"),
                    field("ssim", &Row::ssim), field("flip", &Row::flip), field("rmse_linear", &Row::rmse_linear),
                    field("max_linear", &Row::max_linear));
}

constexpr auto fields(const WorstTile*) {
  using Row = WorstTile;
  return std::tuple(field("x", &Row::x), field("y", &Row::y), field("size", &Row::size), field("flip", &Row::flip));
}

constexpr auto fields(const AssumptionRow*) {
  using Row = AssumptionRow;
  return std::tuple(field("name", &Row::name), field("title", &Row::title), field("error", &Row::error),
                    field("image", &Row::image));
}

constexpr auto fields(const CellRow*) {
  using Row = CellRow;
  return std::tuple(field("scene", &Row::scene), field("effect", &Row::effect), field("variant", &Row::variant),
                    field("baseline", &Row::baseline), field("backend", &Row::backend), field("device", &Row::device),
                    field("width", &Row::width), field("height", &Row::height), field("view", &Row::view),
                    field("params", &Row::params), left_out("words", &Row::words), field<Status>("status", &Row::failed),
                    field("reason", &Row::reason), left_out("notes", &Row::notes), field("timed", &Row::timed),
                    field("passes", &Row::passes), field("median_ms", &Row::median_ms), field("once_ms", &Row::once_ms),
                    field("cold_ms", &Row::cold_ms), field("ratio_to_baseline", &Row::ratio_to_baseline),
                    field("fetches", &Row::fetches), field("fetches_per_pixel", &Row::fetches_per_pixel),
                    left_out("target_bytes", &Row::target_bytes),
                    group("error", field("baseline", &Row::error_covered), field("frame", &Row::error_frame),
                          field("truth", &Row::error_truth)),
                    left_out("max_alpha", &Row::max_alpha), field("nonfinite_pixels", &Row::nonfinite_pixels),
                    field("covered_pixels", &Row::covered_pixels), left_out("range_linear", &Row::range_linear),
                    field("image", &Row::image), field("difference", &Row::difference), field("flip", &Row::flip),
                    left_out("truth_image", &Row::truth_image), left_out("worst_tile", &Row::worst_tile),
                    left_out("assumptions", &Row::assumptions), field("image_hash", &Row::image_hash),
                    field("shader_hashes", &Row::shader_hashes), left_out("before_image", &Row::before_image));
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
  using Row = BakeRow;
  return std::tuple(field("effect", &Row::effect), field("object", &Row::object), field("what", &Row::what),
                    field("points", &Row::points), field("rays", &Row::rays), field("seconds", &Row::seconds),
                    field("rays_per_second", &Row::rays_per_second), field("from_cache", &Row::from_cache));
}

constexpr auto fields(const PhaseRow*) {
  using Row = PhaseRow;
  return std::tuple(field("backend", &Row::backend), field("effect", &Row::effect), field("rounds", &Row::rounds),
                    field("wall_ms", &Row::wall_ms), field("device_ms", &Row::device_ms));
}

constexpr auto fields(const TimerRow*) {
  using Row = TimerRow;
  return std::tuple(field("backend", &Row::backend), field("ok", &Row::ok), field("linearity", &Row::linearity),
                    field("one_ms", &Row::one_ms), left_out("fixed_share", &Row::fixed_share),
                    field("additivity", &Row::additivity), field("attribution", &Row::attribution),
                    left_out("age_s", &Row::age_s), field("reason", &Row::reason));
}

constexpr auto fields(const FunctionTimerRow*) {
  using Row = FunctionTimerRow;
  return std::tuple(part(&Row::timer), field("function", &Row::function));
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
template nlohmann::ordered_json schema_of<CellRow>();
template BakeRow row_of(const Json& line, const std::string& where);
template nlohmann::ordered_json schema_of<BakeRow>();
template PhaseRow row_of(const Json& line, const std::string& where);
template nlohmann::ordered_json schema_of<PhaseRow>();
template TimerRow row_of(const Json& line, const std::string& where);
template nlohmann::ordered_json schema_of<TimerRow>();
template FunctionTimerRow row_of(const Json& line, const std::string& where);
template nlohmann::ordered_json schema_of<FunctionTimerRow>();

}  // namespace lamina
