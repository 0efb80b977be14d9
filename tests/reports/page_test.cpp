// SPDX-License-Identifier: Apache-2.0
// What the page's script is given, records side by side, pictures inside or beside, the gate's lines.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "reports/html.h"
#include "tests/reports/example_record.h"

namespace lamina {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

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
  ASSERT_EQ(data["rows"].size(), 2u);
  EXPECT_EQ(data["rows"][1]["ratio"][0], 0.5);
  EXPECT_EQ(data["passes"][0]["ns_per_fetch"], 6666.67);  // 20 ms over 3000 fetches
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

Json gate_verdict(const char* verdict) {
  return {{"backend", "vulkan"},
          {"effect", "layered_material"},
          {"variant", "vertex_normal"},
          {"view", "front"},
          {"what", "time"},
          {"pass", "composite"},
          {"texture", ""},
          {"verdict", verdict},
          {"before", 4},
          {"after", 4.5},
          {"ratio", nullptr},
          {"limit", nullptr},
          {"sentence", "it takes 12% more <time>"}};
}

Record gated() {
  Record record = example_record(example_cells());
  record.gates.push_back({{"mode", "against"},
                          {"against", "commit 1<2"},
                          {"verdict", "slower"},
                          {"status", 1},
                          {"processes", 3},
                          {"rounds", 60},
                          {"wall_s", 41.2},
                          {"margin", 0.02},
                          {"confidence", 0.95},
                          {"comparisons", 12}});
  record.aas.push_back({{"backend", "vulkan"},
                        {"effect", "layered_material"},
                        {"variant", "light_map"},
                        {"verdict", "same"},
                        {"ratio", {{"median", 1.0}, {"low", 0.99}, {"high", 1.01}, {"rounds", 60}, {"coverage", 0.96}}}});
  record.verdicts = {gate_verdict("slower"), gate_verdict("same")};
  return record;
}

TEST(Gate, ItsVerdictComesFirstAndWhatMovedBeforeWhatDidNot) {
  const std::string page = page_of(gated());
  EXPECT_LT(
      page.find(
          "The gate says slower: something got slower; against commit 1&lt;2, 12 comparisons in 60 rounds of 3 processes"),
      page.find("<ul class=\"headlines\">"));
  EXPECT_TRUE(has(page, "it takes 12% more &lt;time&gt;"));
  EXPECT_TRUE(has(page, "<summary>As it was: 1 figure</summary>"));
  EXPECT_TRUE(has(page, "A/A: light_map, layered_material, vulkan against itself: same, ratio 1.000 [0.990, 1.010]"));
  const std::string markdown = markdown_summary(gated());
  EXPECT_TRUE(has(markdown,
                  "| vertex_normal, layered_material, vulkan, view front, pass composite | time | slower | 4 | 4.5 | - | - |"));
  EXPECT_FALSE(has(page_of(example_record(example_cells())), "gate says"));
}

class Reports : public testing::Test {
 protected:
  Reports()
      : folder_(fs::temp_directory_path() /
                (std::string("lamina_reports_") + testing::UnitTest::GetInstance()->current_test_info()->name() +
                 std::to_string(::getpid()))) {}
  ~Reports() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& commit, std::vector<CellRow> cells = example_cells()) {
    const fs::path run = folder_ / name;
    fs::create_directories(run / "images");
    Record record = example_record(cells);
    record.run["commit"] = commit;
    std::ofstream lines(run / "record.jsonl");
    lines << record.run.dump() << '\n' << record.timers[0].dump() << '\n';
    for (const Json& cell : record.cells) {
      lines << cell.dump() << '\n';
      for (const char* field : {"image", "difference", "flip"})
        if (cell[field] != "" && fs::path(cell[field].get<std::string>()).is_relative())
          std::ofstream(run / cell[field].get<std::string>()) << "png of " + commit;
    }
    return run;
  }
  fs::path folder_;
};

TEST_F(Reports, OneFileHoldsItsPictures) {
  const fs::path run = write("a", "abc");
  write_reports({run}, {.single_file = true, .out = {}});
  const std::string page = read_file(run / "index.html", "test");
  EXPECT_TRUE(has(page, "src=\"data:image/png;base64,cG5nIG9mIGFiYw==\""));  // "png of abc"
  EXPECT_FALSE(has(page, "src=\"./"));
  EXPECT_FALSE(fs::exists(run / "images/light_map-front.png.js"));
}

TEST_F(Reports, PicturesBesideThePageAreThereAsScriptsToo) {
  const fs::path run = write("a", "abc");
  write_reports(run);
  EXPECT_EQ(read_file(run / "images/light_map-front.png.js", "test"),
            "lamina_pixels(\"images/light_map-front.png\", \"data:image/png;base64,cG5nIG9mIGFiYw==\")\n");
}

TEST_F(Reports, TwoRecordsStandSideBySideInAFolderThatIsWhole) {
  const fs::path a = write("one", "abc"), b = write("two", "def"), out = folder_ / "both";
  write_reports({a, b}, {.single_file = false, .out = out});
  const std::string page = read_file(out / "index.html", "test");
  EXPECT_TRUE(has(page, "<h1>2 records side by side</h1>"));
  EXPECT_TRUE(has(page, "What the records differ in"));
  EXPECT_TRUE(has(page, "<th scope=\"row\">Commit</th><td class=\"wrap\">abc</td><td class=\"wrap\">def</td>"));
  EXPECT_TRUE(has(page, "src=\"./b/images/vertex_normal-front.png\""));
  EXPECT_EQ(read_file(out / "b/images/vertex_normal-front.png", "test"), "png of def");
  EXPECT_TRUE(fs::exists(out / "a/cells.csv"));
  write_reports({a, b}, {.single_file = false, .out = folder_ / "again"});
  EXPECT_EQ(page, read_file(folder_ / "again/index.html", "test"));
}

TEST_F(Reports, APictureOutsideTheRunsFolderIsRefused) {
  std::vector<CellRow> cells = example_cells();
  cells[0].image = "../../secret.png";
  const fs::path run = write("a", "abc", cells);
  for (const ReportOptions& options : {ReportOptions{}, ReportOptions{.single_file = true, .out = {}},
                                       ReportOptions{.single_file = false, .out = folder_ / "out"}}) {
    try {
      write_reports({run}, options);
      ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.subject(), "../../secret.png");
      EXPECT_TRUE(has(error.message(), "out of the run's folder"));
    }
  }
}

TEST_F(Reports, AMissingPictureIsNamedWhereItIsNeeded) {
  const fs::path run = write("a", "abc");
  fs::remove(run / "images/vertex_normal-front.png");
  EXPECT_NO_THROW(write_reports(run));
  EXPECT_THROW(write_reports({run}, {.single_file = true, .out = {}}), Error);
}

}  // namespace
}  // namespace lamina
