// SPDX-License-Identifier: Apache-2.0
// Field names of the record, and what is null in it.
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "harness/core/error.h"
#include "harness/record/record.h"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::set<std::string> names_of(const Json& object) {
  std::set<std::string> names;
  for (const auto& [name, value] : object.items()) names.insert(name);
  return names;
}

PassRow pass(std::string name, std::vector<double> ms, bool once = false) {
  PassRow row;
  row.name = std::move(name);
  row.once = once;
  row.ms = std::move(ms);
  row.fragments = 100;
  row.vertices = 36;
  row.fetches = 1300;
  row.early_tests = false;
  row.by_texture = {{.texture = "light_map", .format = "rgba16_float", .filter = "linear", .fetches = 1300}};
  row.operations = {{"add", 5000000000}, {"root", 7}};
  return row;
}

CellRow good_cell() {
  CellRow cell;
  cell.scene = "heart";
  cell.effect = "layered_material";
  cell.variant = "vertex_normal";
  cell.backend = "vulkan";
  cell.device = "llvmpipe";
  cell.view = "front";
  cell.width = 64, cell.height = 32;
  cell.params = {{"scene.time", 0.5}};
  cell.passes = {pass("bake", {7, 9}, true), pass("light", {1, 2, 3}), pass("composite", {10, 30, 20})};
  cell.cold_ms = 40;
  cell.ratio_to_baseline = Interval{.median = 0.5, .low = 0.4, .high = 0.6, .rounds = 3, .coverage = 0.75};
  cell.fetches = 2600;
  cell.fetches_per_pixel = 26;
  cell.error_covered = ErrorFigures{.psnr_db = 30, .ssim = 0.9, .flip = 0.1, .rmse_linear = 0.02, .max_linear = 0.3};
  cell.error_frame = ErrorFigures{.psnr_db = 36, .ssim = 0.95, .flip = 0.05, .rmse_linear = 0.01, .max_linear = 0.3};
  cell.covered_pixels = 100;
  cell.image = "images/a.png";
  cell.image_hash = "0123456789abcdef";
  return cell;
}

TEST(CellToJson, HasTheFieldsThatTheDesignFixes) {
  const Json line = to_json(good_cell());
  const std::set<std::string> fixed = {"kind",
                                       "scene",
                                       "effect",
                                       "variant",
                                       "baseline",
                                       "backend",
                                       "device",
                                       "width",
                                       "height",
                                       "view",
                                       "params",
                                       "status",
                                       "reason",
                                       "passes",
                                       "median_ms",
                                       "fetches",
                                       "error",
                                       "ratio_to_baseline",
                                       "fetches_per_pixel",
                                       "nonfinite_pixels",
                                       "image",
                                       "covered_pixels"};
  const std::set<std::string> added = {"timed", "once_ms", "cold_ms", "difference", "flip", "image_hash", "shader_hashes"};
  std::set<std::string> all = fixed;
  all.insert(added.begin(), added.end());
  EXPECT_EQ(names_of(line), all);
  EXPECT_EQ(names_of(line["passes"][0]), (std::set<std::string>{"name", "once", "ms", "median_ms", "fragments", "vertices",
                                                                "fetches", "early_tests", "by_texture", "operations"}));
  EXPECT_EQ(names_of(line["passes"][0]["by_texture"][0]),
            (std::set<std::string>{"texture", "format", "filter", "fetches", "issued"}));
  EXPECT_EQ(names_of(line["ratio_to_baseline"]), (std::set<std::string>{"median", "low", "high", "rounds", "coverage"}));
  EXPECT_EQ(names_of(line["error"]), (std::set<std::string>{"baseline", "frame", "truth"}));
  EXPECT_EQ(names_of(line["error"]["baseline"]),
            (std::set<std::string>{"psnr_db", "identical", "ssim", "flip", "rmse_linear", "max_linear"}));
  EXPECT_EQ(line["kind"], "cell");
  EXPECT_EQ(line["status"], "ok");
  EXPECT_TRUE(line["error"]["truth"].is_null());
}

TEST(CellToJson, SumsTheFramesPassesByRoundBeforeTheMedian) {
  const Json line = to_json(good_cell());
  EXPECT_EQ(line["median_ms"], 23);  // of 11, 32, 23; the sum of the medians would be 22
  EXPECT_EQ(line["once_ms"], 8);     // the bake is apart
  EXPECT_EQ(line["passes"][2]["median_ms"], 20);
  EXPECT_EQ(line["passes"][2]["ms"], Json({10, 30, 20}));
}

TEST(CellToJson, NothingDoneOnceCostsNothing) {
  CellRow cell = good_cell();
  cell.passes.erase(cell.passes.begin());
  EXPECT_EQ(to_json(cell)["once_ms"], 0);
}

TEST(CellToJson, IdenticalPicturesHaveNullPsnr) {
  CellRow cell = good_cell();
  cell.error_covered->psnr_db = infinity;
  const Json error = to_json(cell)["error"];
  EXPECT_TRUE(error["baseline"]["psnr_db"].is_null());
  EXPECT_EQ(error["baseline"]["identical"], true);
  EXPECT_EQ(error["frame"]["psnr_db"], 36);
  EXPECT_EQ(error["frame"]["identical"], false);
}

CellRow cell_with_truth() {
  CellRow cell = good_cell();
  cell.error_truth = ErrorFigures{.psnr_db = 28, .ssim = 0.85, .flip = 0.2, .rmse_linear = 0.04, .max_linear = 0.5};
  cell.truth_image = "images/truth.png";
  cell.assumptions = {{.name = "cosine", .title = "one cosine", .error = *cell.error_truth, .image = "images/cosine.png"}};
  cell.assumptions[0].error.psnr_db = infinity;
  return cell;
}

TEST(CellToJson, WhatATruthAdds) {
  const Json plain = to_json(good_cell()), line = to_json(cell_with_truth());
  EXPECT_FALSE(plain.contains("truth_image"));
  EXPECT_FALSE(plain.contains("assumptions"));
  EXPECT_EQ(line["truth_image"], "images/truth.png");
  EXPECT_EQ(line["error"]["truth"]["psnr_db"], 28);
  EXPECT_EQ(line["error"]["truth"]["rmse_linear"], 0.04);
  EXPECT_EQ(names_of(line["error"]["truth"]), names_of(line["error"]["baseline"]));
  ASSERT_EQ(line["assumptions"].size(), 1u);
  EXPECT_EQ(names_of(line["assumptions"][0]), (std::set<std::string>{"name", "title", "error", "image"}));
  EXPECT_EQ(line["assumptions"][0]["title"], "one cosine");
  EXPECT_TRUE(line["assumptions"][0]["error"]["psnr_db"].is_null());
  EXPECT_EQ(line["assumptions"][0]["error"]["identical"], true);
  EXPECT_EQ(line["assumptions"][0]["error"]["flip"], 0.2);
}

TEST(CellToJson, AFailedCellHasNullsWhereNothingIsKnown) {
  CellRow cell;
  cell.failed = true;
  cell.reason = "shader: skin.frag:12: syntax error";
  cell.passes.emplace_back().name = "light";
  const Json line = to_json(cell);
  EXPECT_EQ(line["status"], "failed");
  EXPECT_EQ(line["reason"], "shader: skin.frag:12: syntax error");
  for (const char* name : {"median_ms", "once_ms", "cold_ms", "ratio_to_baseline", "fetches", "fetches_per_pixel",
                           "nonfinite_pixels", "covered_pixels"})
    EXPECT_TRUE(line[name].is_null()) << name;
  for (const char* name : {"baseline", "frame", "truth"}) EXPECT_TRUE(line["error"][name].is_null()) << name;
  for (const char* name : {"median_ms", "fragments", "vertices", "fetches"})
    EXPECT_TRUE(line["passes"][0][name].is_null()) << name;
}

TEST(CellToJson, AFailedCellKeepsWhatIsKnown) {
  CellRow cell = good_cell();
  cell.failed = true;
  cell.nonfinite_pixels = 5;
  cell.passes[1].ms = {1};  // it failed in its second round, between two passes
  const Json line = to_json(cell);
  EXPECT_EQ(line["nonfinite_pixels"], 5);
  EXPECT_EQ(line["covered_pixels"], 100);
  EXPECT_TRUE(line["median_ms"].is_null());
}

TEST(CellToJson, AnUntimedCellHasNoTimesButItsFigures) {
  CellRow cell = good_cell();
  cell.timed = false;
  const Json line = to_json(cell);
  EXPECT_TRUE(line["median_ms"].is_null());
  EXPECT_TRUE(line["once_ms"].is_null());
  EXPECT_TRUE(line["ratio_to_baseline"].is_null());
  EXPECT_EQ(line["passes"][1]["ms"], Json::array());
  EXPECT_TRUE(line["passes"][1]["median_ms"].is_null());
  EXPECT_EQ(line["fetches_per_pixel"], 26);
  EXPECT_EQ(line["error"]["baseline"]["ssim"], 0.9);
}

TEST(CellToJson, NoCoveredPixelMeansNoFetchesAPixel) {
  CellRow cell = good_cell();
  cell.covered_pixels = 0;
  cell.fetches_per_pixel = nan;
  const Json line = to_json(cell);
  EXPECT_TRUE(line["fetches_per_pixel"].is_null());
  EXPECT_EQ(line["covered_pixels"], 0);
}

TEST(CellToJson, RefusesNumbersThatAreNotFinite) {
  CellRow cell = good_cell();
  cell.passes[1].ms[0] = nan;
  EXPECT_THROW(to_json(cell), Error);
  cell = good_cell();
  cell.error_covered->ssim = nan;
  EXPECT_THROW(to_json(cell), Error);
  cell = good_cell();
  cell.error_covered->psnr_db = -infinity;
  EXPECT_THROW(to_json(cell), Error);
  cell = good_cell();
  cell.ratio_to_baseline->high = infinity;
  EXPECT_THROW(to_json(cell), Error);
  cell = cell_with_truth();
  cell.error_truth->flip = nan;
  EXPECT_THROW(to_json(cell), Error);
  cell = cell_with_truth();
  cell.assumptions[0].error.rmse_linear = nan;
  EXPECT_THROW(to_json(cell), Error);
}

TEST(FrameSamples, RefusesPassesWithDifferentNumbersOfRounds) {
  CellRow cell = good_cell();
  cell.passes[1].ms.pop_back();
  try {
    frame_samples_ms(cell.passes);
    FAIL() << "no exception";
  } catch (const Error& error) {
    EXPECT_NE(error.subject().find("composite"), std::string::npos) << error.what();
  }
}

TEST(FrameSamples, AreNoneWhereAllIsDoneOnce) {
  EXPECT_TRUE(frame_samples_ms(std::vector{pass("bake", {1, 2}, true)}).empty());
}

TEST(TimerToJson, HasTheFieldsThatTheDesignFixes) {
  const Json line = to_json(
      TimerRow{.backend = "osmesa", .ok = true, .linearity = {1, 1.01}, .additivity = 0.98, .attribution = 0.01, .reason = ""});
  EXPECT_EQ(names_of(line),
            (std::set<std::string>{"kind", "backend", "ok", "linearity", "one_ms", "additivity", "attribution", "reason"}));
  EXPECT_EQ(line["kind"], "timer");
  EXPECT_EQ(line["linearity"], Json({1, 1.01}));
  EXPECT_EQ(line["additivity"], 0.98);
}

TEST(TimerToJson, ACertificateThatNeverMeasuredHasNoFigures) {
  TimerRow timer;
  timer.reason = "device lost";
  const Json line = to_json(timer);
  EXPECT_EQ(line["ok"], false);
  EXPECT_TRUE(line["additivity"].is_null());
  EXPECT_TRUE(line["attribution"].is_null());
}

TEST(BakeToJson, GivesRaysASecondOnlyWhereRaysWereCast) {
  BakeRow bake = {
      .effect = "aperture_lighting", .object = "ground", .what = "apertures", .points = 10, .rays = 600, .seconds = 3};
  const Json line = to_json(bake);
  EXPECT_EQ(names_of(line), (std::set<std::string>{"kind", "effect", "object", "what", "points", "rays", "seconds",
                                                   "rays_per_second", "from_cache"}));
  EXPECT_EQ(line["kind"], "bake");
  EXPECT_EQ(line["points"], 10);
  EXPECT_EQ(line["rays_per_second"], 200);
  bake.from_cache = true;
  EXPECT_TRUE(to_json(bake)["rays_per_second"].is_null());
  bake.from_cache = false, bake.seconds = 0;
  EXPECT_TRUE(to_json(bake)["rays_per_second"].is_null());
  bake.seconds = nan;
  EXPECT_THROW(to_json(bake), Error);
}

TEST(RowOf, GivesBackThePassesThatWereWritten) {
  const CellRow cell = good_cell();
  const std::vector<PassRow> back = row_of<CellRow>(nlohmann::json::parse(to_json(cell).dump()), "test").passes;
  ASSERT_EQ(back.size(), 3u);
  EXPECT_EQ(back[0].name, "bake");
  EXPECT_TRUE(back[0].once);
  EXPECT_EQ(back[2].ms, cell.passes[2].ms);
  EXPECT_EQ(back[2].fragments, 100u);
  EXPECT_EQ(back[2].vertices, 36u);
  EXPECT_EQ(back[2].fetches, 1300u);
  EXPECT_FALSE(back[2].early_tests);
  ASSERT_EQ(back[2].by_texture.size(), 1u);
  EXPECT_EQ(back[2].by_texture[0].texture, "light_map");
  EXPECT_EQ(back[2].by_texture[0].format, "rgba16_float");
  EXPECT_EQ(back[2].by_texture[0].filter, "linear");
  EXPECT_EQ(back[2].by_texture[0].fetches, 1300u);
  EXPECT_EQ(back[2].operations, (std::map<std::string, uint64_t>{{"add", 5000000000}, {"root", 7}}));
  EXPECT_TRUE(back[2].by_texture[0].levels.empty()) << "not counted";
  EXPECT_FALSE(back[2].by_texture[0].unfiltered || back[2].by_texture[0].dimensions || back[2].runs || back[2].triangles ||
               back[2].issued_fragments);
}

TEST(RowOf, GivesBackWhatPassesReadAndAreMadeOf) {
  CellRow cell = good_cell();
  PassRow& pass = cell.passes[1];
  TextureFetches& texture = pass.by_texture[0];
  texture.unfiltered = 0, texture.dimensions = 3, texture.size = {64, 32, 8}, texture.levels = {0, 700, 1300};
  pass.vertex_issued = {{"add", 12}};
  pass.runs = 2, pass.triangles = 0, pass.issued_fragments = 4096;
  pass.written = {{"rgba16_float", "clear", "alpha", 8192}};
  const Json line = to_json(cell);
  const PassRow back = row_of<CellRow>(nlohmann::json::parse(line.dump()), "test").passes[1];
  EXPECT_EQ(back.by_texture[0].unfiltered, 0u);
  EXPECT_EQ(back.by_texture[0].dimensions, 3u);
  EXPECT_EQ(back.by_texture[0].size, texture.size);
  EXPECT_EQ(back.by_texture[0].levels, texture.levels);
  EXPECT_EQ(back.vertex_issued, pass.vertex_issued);
  EXPECT_EQ(back.runs, 2u);
  EXPECT_EQ(back.triangles, 0u);
  EXPECT_EQ(back.issued_fragments, 4096u);
  ASSERT_EQ(back.written.size(), 1u);
  EXPECT_EQ(back.written[0].format, "rgba16_float");
  EXPECT_EQ(back.written[0].load, "clear");
  EXPECT_EQ(back.written[0].combine, "alpha");
  EXPECT_EQ(back.written[0].texels, 8192u);
  EXPECT_EQ(to_json(row_of<CellRow>(nlohmann::json::parse(line.dump()), "test")).dump(), line.dump());
}

}  // namespace
}  // namespace lamina
