// SPDX-License-Identifier: Apache-2.0
// Rows of a record to JSON, and a cell's passes back.
#include <cmath>

#include "harness/core/error.h"
#include "harness/record/finite.h"
#include "harness/record/record.h"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

std::string name_of(const CellRow& cell) {
  return fmt::format("cell {}/{} on {}, view '{}'", cell.effect, cell.variant, cell.backend, cell.view);
}

Json figures_to_json(const std::optional<ErrorFigures>& figures, const std::string& owner) {
  if (!figures) return nullptr;
  const bool identical = std::isinf(figures->psnr_db) && figures->psnr_db > 0;
  return {{"psnr_db", identical ? Json(nullptr) : finite(figures->psnr_db, owner, "psnr_db")},
          {"identical", identical},
          {"ssim", finite(figures->ssim, owner, "ssim")},
          {"flip", finite(figures->flip, owner, "flip")},
          {"rmse_linear", finite(figures->rmse_linear, owner, "rmse_linear")},
          {"max_linear", finite(figures->max_linear, owner, "max_linear")}};
}

Json median_or_null(const std::vector<double>& samples) { return samples.empty() ? Json(nullptr) : Json(median(samples)); }

// Work that is done once has no rounds to pair by: each such pass counts with its own median. No such pass costs nothing, which
// is known; one without samples makes the sum unknown.
Json once_ms(const CellRow& cell) {
  double sum_ms = 0;
  for (const PassRow& pass : cell.passes) {
    if (!pass.once) continue;
    if (pass.ms.empty()) return nullptr;
    sum_ms += median(pass.ms);
  }
  return sum_ms;
}

}  // namespace

Json finite(double value, const std::string& owner, std::string_view what) {
  if (!std::isfinite(value))
    throw Error(ErrorKind::failed, "record", owner, fmt::format("{} is not a finite number; record a failure instead", what));
  return value;
}

Json interval_to_json(const std::optional<Interval>& interval, const std::string& owner, std::string_view what) {
  if (!interval) return nullptr;
  const auto number = [&](double value, const char* field) { return finite(value, owner, fmt::format("{}.{}", what, field)); };
  return {{"median", number(interval->median, "median")},
          {"low", number(interval->low, "low")},
          {"high", number(interval->high, "high")},
          {"rounds", interval->rounds},
          {"coverage", number(interval->coverage, "coverage")}};
}

std::optional<Interval> interval_of(const nlohmann::json& interval) {
  if (interval.is_null()) return std::nullopt;
  return Interval{.median = interval.at("median"),
                  .low = interval.at("low"),
                  .high = interval.at("high"),
                  .rounds = interval.at("rounds"),
                  .coverage = interval.at("coverage")};
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

Json to_json(const CellRow& cell) {
  const std::string owner = name_of(cell);
  const auto count = [&](uint64_t value) { return cell.failed && value == 0 ? Json(nullptr) : Json(value); };
  const auto counted = [&](Json value) { return cell.counted ? std::move(value) : Json(nullptr); };

  Json passes = Json::array();
  for (const PassRow& pass : cell.passes) {
    const std::vector<double> ms = cell.timed ? pass.ms : std::vector<double>{};
    for (const double sample_ms : ms) finite(sample_ms, owner, fmt::format("a sample of pass '{}'", pass.name));
    Json by_texture = Json::array();
    for (const TextureFetches& fetched : pass.by_texture)
      by_texture.push_back(
          {{"texture", fetched.texture}, {"format", fetched.format}, {"filter", fetched.filter}, {"fetches", fetched.fetches}});
    passes.push_back({{"name", pass.name},
                      {"once", pass.once},
                      {"ms", ms},
                      {"median_ms", median_or_null(ms)},
                      {"fragments", count(pass.fragments)},
                      {"vertices", count(pass.vertices)},
                      {"fetches", count(pass.fetches)},
                      {"early_tests", pass.early_tests},
                      {"by_texture", std::move(by_texture)}});
  }
  Json params = Json::object();
  for (const auto& [path, value] : cell.params) params[path] = finite(value, owner, path);

  const bool has_times = cell.timed && !cell.failed;
  Json line;
  line["kind"] = "cell";
  line["scene"] = cell.scene;
  line["effect"] = cell.effect;
  line["variant"] = cell.variant;
  line["baseline"] = cell.baseline;
  line["backend"] = cell.backend;
  line["device"] = cell.device;
  line["width"] = cell.width;
  line["height"] = cell.height;
  line["view"] = cell.view;
  line["params"] = std::move(params);
  if (!cell.words.empty()) line["words"] = cell.words;
  line["status"] = cell.failed ? "failed" : "ok";
  line["reason"] = cell.reason;
  line["timed"] = cell.timed;
  line["passes"] = std::move(passes);
  line["median_ms"] = has_times ? median_or_null(frame_samples_ms(cell.passes)) : Json(nullptr);
  line["once_ms"] = has_times ? once_ms(cell) : Json(nullptr);
  line["cold_ms"] = cell.cold_ms > 0 ? finite(cell.cold_ms, owner, "cold_ms") : Json(nullptr);
  line["ratio_to_baseline"] = has_times ? interval_to_json(cell.ratio_to_baseline, owner, "ratio_to_baseline") : Json(nullptr);
  line["fetches"] = counted(count(cell.fetches));
  line["fetches_per_pixel"] =
      counted(cell.covered_pixels == 0 ? Json(nullptr) : finite(cell.fetches_per_pixel, owner, "fetches_per_pixel"));
  line["error"] = {{"baseline", figures_to_json(cell.error_covered, owner)},
                   {"frame", figures_to_json(cell.error_frame, owner)},
                   {"truth", figures_to_json(cell.error_truth, owner)}};
  line["nonfinite_pixels"] = count(cell.nonfinite_pixels);
  line["covered_pixels"] = count(cell.covered_pixels);
  if (cell.range_linear) line["range_linear"] = finite(*cell.range_linear, owner, "range_linear");
  line["image"] = cell.image;
  line["difference"] = cell.difference;
  line["flip"] = cell.flip;
  if (!cell.truth_image.empty()) line["truth_image"] = cell.truth_image;
  if (cell.worst_tile)
    line["worst_tile"] = {{"x", cell.worst_tile->x},
                          {"y", cell.worst_tile->y},
                          {"size", worst_tile_px},
                          {"flip", finite(cell.worst_tile->flip, owner, "worst_tile.flip")}};
  for (const AssumptionRow& row : cell.assumptions)
    line["assumptions"].push_back(
        {{"name", row.name}, {"title", row.title}, {"error", figures_to_json(row.error, owner)}, {"image", row.image}});
  line["image_hash"] = cell.image_hash;
  line["shader_hashes"] = cell.shader_hashes;
  return line;
}

Json to_json(const TimerRow& timer) {
  const std::string owner = fmt::format("timer certificate of {}", timer.backend);
  const bool measured = !timer.linearity.empty();
  for (const double factor : timer.linearity) finite(factor, owner, "linearity");
  return {{"kind", "timer"},
          {"backend", timer.backend},
          {"ok", timer.ok},
          {"linearity", timer.linearity},
          {"one_ms", measured ? finite(timer.one_ms, owner, "one_ms") : Json(nullptr)},
          {"additivity", measured ? finite(timer.additivity, owner, "additivity") : Json(nullptr)},
          {"attribution", measured ? finite(timer.attribution, owner, "attribution") : Json(nullptr)},
          {"reason", timer.reason}};
}

Json to_json(const BakeRow& bake) {
  const std::string owner = fmt::format("bake of {} of {}", bake.what, bake.object);
  const bool cast = !bake.from_cache && bake.seconds > 0;
  return {{"kind", "bake"},
          {"effect", bake.effect},
          {"object", bake.object},
          {"what", bake.what},
          {"points", bake.points},
          {"rays", bake.rays},
          {"seconds", finite(bake.seconds, owner, "seconds")},
          {"rays_per_second", cast ? Json(static_cast<double>(bake.rays) / bake.seconds) : Json(nullptr)},
          {"from_cache", bake.from_cache}};
}

std::vector<PassRow> passes_of(const nlohmann::json& cell) {
  // Null stands for a count that is not known, in failed cells alone.
  const auto count = [](const nlohmann::json& value) { return value.is_null() ? uint64_t{0} : value.get<uint64_t>(); };
  std::vector<PassRow> passes;
  for (const nlohmann::json& from : cell.at("passes")) {
    PassRow pass;
    pass.name = from.at("name");
    pass.once = from.at("once");
    pass.ms = from.at("ms").get<std::vector<double>>();
    pass.fragments = count(from.at("fragments"));
    pass.vertices = count(from.at("vertices"));
    pass.fetches = count(from.at("fetches"));
    pass.early_tests = from.at("early_tests");
    for (const nlohmann::json& fetched : from.at("by_texture"))
      pass.by_texture.push_back({.texture = fetched.at("texture"),
                                 .format = fetched.at("format"),
                                 .filter = fetched.at("filter"),
                                 .fetches = count(fetched.at("fetches"))});
    passes.push_back(std::move(pass));
  }
  return passes;
}

}  // namespace lamina
