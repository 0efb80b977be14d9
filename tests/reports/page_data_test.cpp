// SPDX-License-Identifier: Apache-2.0
// What the page's script is given.
#include <gtest/gtest.h>

#include "harness/sweep/answers.h"
#include "reports/html/html.h"
#include "tests/reports/example_record.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

TEST(PageData, HoldsTheRecordsNumbers) {
  const Json data = page_data({example_record(example_cells())});
  ASSERT_EQ(data["cells"].size(), 4u);
  const Json& cell = data["cells"][2];
  EXPECT_EQ(data["variants"][cell["variant"].get<size_t>()], "vertex_normal");
  EXPECT_EQ(cell["samples"], Json({4, 4, 4, 4, 4, 4}));
  EXPECT_EQ(cell["ms"][0], 4);
  EXPECT_EQ(cell["fetches"], 15);
  EXPECT_EQ(cell["baseline"], Json({0.9, 30, 0.1, 0.3, 0.02}));  // SSIM, PSNR, FLIP, max, RMSE
  EXPECT_EQ(data["cells"][0]["baseline"], Json({1, nullptr, 0, 0, 0}));
  EXPECT_EQ(data["cells"][0]["is_baseline"], true);
  EXPECT_EQ(cell["is_baseline"], false);
  ASSERT_EQ(data["rows"].size(), 2u);
  EXPECT_EQ(data["rows"][1]["ratio"][0], 0.5);
  EXPECT_EQ(data["records"][0]["gain"], "8");
  EXPECT_EQ(data["passes"][0]["ns_per_fetch"], 6666.67);  // 20 ms over 3000 fetches
  ASSERT_EQ(data["passes"][0]["shares"].size(), 2u);
  EXPECT_EQ(data["passes"][0]["shares"][0]["texture"], "light_map_texture");
  EXPECT_EQ(data["passes"][0]["shares"][0]["per_pixel"], 13);
}

// On paper: against the baseline light_map is closest and as cheap in fetches, so worth having by all ten choices;
// vertex_normal is faster, so worth having by the five of time, which are the even bits.
TEST(PageData, SaysByWhichAxesEachIsWorthHaving) {
  const Json data = page_data({example_record(example_cells())});
  for (const char* list : {"rows", "cells"}) {
    size_t baselines = 0;
    for (const Json& one : data[list]) {
      const bool baseline = one["is_baseline"];
      baselines += baseline;
      EXPECT_EQ(one["frontier"], baseline ? 0b1111111111 : 0b0101010101) << list << " " << one.dump();
    }
    EXPECT_GT(baselines, 0u);
    EXPECT_EQ(data[list].size(), 2 * baselines) << "each baseline's, and one beside it";
  }
}

TEST(PageData, ACellHasItsPicturesItsWorstTileItsPointItsTruthAndWhyItFailed) {
  std::vector<CellRow> cells = example_cells();
  cells[2].worst_tile = WorstTile{.x = 32, .y = 16, .flip = 0.25};
  cells[2].params["scene.time"] = 1.5;
  cells[2].error_truth = ErrorFigures{.psnr_db = 20, .ssim = 0.75, .flip = 0.25, .rmse_linear = 0.125, .max_linear = 0.5};
  cells[2].truth_image = "images/truth.png";
  cells[3].failed = true;
  cells[3].reason = "it does not compile";
  const Json data = page_data({example_record(cells)});
  const Json& cell = data["cells"][2];
  EXPECT_EQ(cell["image"], "images/vertex_normal-front.png");
  EXPECT_EQ(cell["difference"], "images/vertex_normal-front-difference.png");
  EXPECT_EQ(cell["flip"], "images/vertex_normal-front-flip.png");
  EXPECT_EQ(cell["truth_image"], "images/truth.png");
  EXPECT_EQ(cell["truth"], Json({0.75, 20, 0.25, 0.5, 0.125}));
  EXPECT_EQ(cell["worst_tile"]["x"], 32);
  EXPECT_EQ(cell["worst_tile"]["flip"], 0.25);
  EXPECT_EQ(cell["size"], Json({64, 32}));
  EXPECT_FALSE(cell.contains("failed"));
  EXPECT_EQ(data["points"][cell["point"].get<size_t>()]["scene.time"], 1.5);
  EXPECT_EQ(data["points"][data["cells"][0]["point"].get<size_t>()]["scene.time"], 0.5);
  EXPECT_EQ(data["cells"][3]["failed"], "it does not compile");
  EXPECT_TRUE(data["cells"][3]["ms"].is_null());
  EXPECT_FALSE(data["cells"][0].contains("difference"));
  EXPECT_FALSE(data["cells"][0].contains("truth"));
}

TEST(PageData, EachOfSeveralRecordsHasItsNumber) {
  Record record = example_record(example_cells());
  record.sweeps.emplace_back().parameters = {{"scene.time", "s", {0, 1}}};
  CrossoverRow& crossover = record.crossovers.emplace_back();
  crossover.parameter = "scene.time", crossover.sentence = "they meet";
  const Json data = page_data({record, record});
  for (const char* list : {"rows", "cells", "passes", "sweeps", "crossovers"}) {
    const Json& all = data[list];
    ASSERT_FALSE(all.empty()) << list;
    EXPECT_EQ(all.front()["record"], 0) << list;
    EXPECT_EQ(all.back()["record"], 1) << list;
  }
  EXPECT_EQ(data["records"][1]["name"], "B: abc1234");
}

// A grid's crossovers belong to one value of the other parameter each.
TEST(PageData, ACrossoverSaysWhatWasHeld) {
  Record record = example_record({});
  for (const double time : {0, 1})
    for (const double gain : {2, 4}) {
      CellRow cell = example_cell("vertex_normal", "front", {1});
      cell.params = {{"scene.time", time}, {"lights.key.gain", gain}};
      cell.error_covered->ssim = 1 - 0.01 * time * gain;
      record.cells.push_back(read_back(cell));
    }
  record.sweeps.emplace_back().parameters = {{"scene.time", "s", {0, 1}}, {"lights.key.gain", "", {2, 4}}};
  record.sweeps[0].limits = {{"ssim", 0.99}};
  record.crossovers = answers(curves_of(record), record.sweeps[0].limits);
  std::vector<Json> of_time;
  const Json data = page_data({record});
  for (const Json& crossover : data["crossovers"])
    if (crossover["parameter"] == "scene.time") of_time.push_back(crossover);
  ASSERT_EQ(of_time.size(), 2u);
  EXPECT_EQ(of_time[0]["held"], Json({{"lights.key.gain", 2}})) << of_time[0];
  EXPECT_EQ(of_time[0]["at"], 0.5);
  EXPECT_EQ(of_time[1]["held"], Json({{"lights.key.gain", 4}}));
  EXPECT_EQ(of_time[1]["at"], 0.25);
  // A record of before rows said so: what was held is found again, but not for what the curves do not say.
  for (CrossoverRow& row : record.crossovers) row.held.clear(), row.claim.clear(), row.remark.clear();
  EXPECT_EQ(page_data({record}), data);
  record.crossovers[0].sentence = "they meet";
  EXPECT_EQ(page_data({record})["crossovers"][0]["held"], Json::object());
}

TEST(PageData, WithoutACertificateThereIsNoTimeAndNoRatio) {
  std::vector<CellRow> cells = example_cells();
  cells[2].ratio_to_baseline = Interval{.median = 0.5, .low = 0.4, .high = 0.6, .rounds = 6, .coverage = 0.97};
  EXPECT_EQ(page_data({example_record(cells)})["cells"][2]["ratio"][0], 0.5);
  const Json data = page_data({example_record(cells, {example_timer("vulkan", false)})});
  EXPECT_TRUE(data["cells"][2]["ratio"].is_null());
  EXPECT_TRUE(data["cells"][2]["ms"].is_null());
  EXPECT_TRUE(data["cells"][2]["samples"].empty());
  EXPECT_TRUE(data["rows"][1]["ratio"].is_null());
}

TEST(PageData, WithoutAnyCostNoChartOffersOne) {
  const std::string section = "<section class=\"drawn\" id=\"pareto\">";
  std::vector<CellRow> cells = example_cells();
  EXPECT_TRUE(has(html_charts({example_record(cells)}), section));
  for (CellRow& cell : cells) cell.timed = false;
  EXPECT_TRUE(has(html_charts({example_record(cells)}), section)) << "fetches are a cost";
  for (CellRow& cell : cells) cell.fetches.reset();
  EXPECT_FALSE(has(html_charts({example_record(cells)}), section));
}

TEST(PageData, SixDigitsAreEnoughAndNoTagBeginsInIt) {
  std::vector<CellRow> cells = example_cells();
  cells[0].passes[0].ms.assign(6, 1.23456789);
  cells[0].effect = "</script>\xff";
  const std::string text = for_script(page_data({example_record(cells)}));
  EXPECT_TRUE(has(text, "[1.23457,1.23457"));
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_TRUE(has(text, "\\u003c/script>"));
}

}  // namespace
}  // namespace lamina
