// SPDX-License-Identifier: Apache-2.0
// lamina stress from end to end.
#include <sstream>
#include <vector>

#include "tests/cli/program.h"

namespace lamina {
namespace {

class Stress : public ProgramTest {
 protected:
  std::vector<std::vector<std::string>> table() const {
    std::vector<std::vector<std::string>> rows;
    std::ifstream in(folder_ / "out/stress.csv");
    for (std::string line; std::getline(in, line);) {
      std::stringstream cells(line);
      rows.emplace_back();
      for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    }
    return rows;
  }
  std::string content(const std::string& name) const {
    std::stringstream text;
    text << std::ifstream(folder_ / name).rdbuf();
    return text.str();
  }
  Outcome stress(const std::string& arguments) {
    return lamina_program("stress " + arguments + " --out " + (folder_ / "out").string());
  }
};

// One radian each way: what three equal caps' worth of formula gives, to 120 digits cut to 17.
TEST_F(Stress, PointsOfAFileAreJudgedByTheAreasTheyBring) {
  const auto file =
      write("points.csv", "# by hand\nr0,r1,d,area\n1,1,1,1.2381525145977283\n1,1,3,0\n1,1,1,2.4763050291954566\n");
  const Outcome outcome = stress("caps --backend vulkan --variant exact_cap --points " + file.string());
  EXPECT_LE(outcome.status, 1) << outcome.output << "a busy machine can fail the timer's certificate";
  const auto rows = table();
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1][1], "exact_cap");
  EXPECT_EQ(rows[1][3], "3");
  EXPECT_NEAR(std::stod(rows[1][5]), -1.2381525145977283 / 2.8883657975136403, 1e-6) << "the last area is twice the right one";
  EXPECT_LT(std::stod(rows[1][4]), 4e-7);
  for (const FunctionTimeRow& time : record().function_times)
    if (time.ns_per_call) {
      EXPECT_EQ(time.ns.size(), 12u) << "a sample a round";
    }
}

// A record that is there keeps its lines; functions of an earlier run give way.
TEST_F(Stress, AddsToTheRecordAndReportThatAreThere) {
  const std::string kept =
      "{\"kind\":\"run\",\"schema\":1,\"build\":\"release\",\"commit\":\"kept\"}\n"
      "{\"kind\":\"phase\",\"backend\":\"vulkan\",\"effect\":\"e\",\"rounds\":1,\"wall_ms\":1,\"device_ms\":1}\n";
  std::filesystem::create_directories(folder_ / "out");
  write("out/record.jsonl", kept);
  const std::string points = write("points.csv", "1,1,1\n").string();
  for (const char* variant : {"linear_cap", "exact_cap"}) {
    const Outcome outcome = stress(std::string("caps --backend vulkan --variant ") + variant + " --points " + points);
    EXPECT_LE(outcome.status, 1) << outcome.output;
    EXPECT_SAYS(outcome.output, "report: ");
  }
  const std::string record = content("out/record.jsonl");
  EXPECT_EQ(record.substr(0, kept.size()), kept);
  EXPECT_EQ(record.find("linear_cap"), std::string::npos) << record;
  EXPECT_SAYS(record, "{\"kind\":\"function\",\"function\":\"cap_intersection\"");
  EXPECT_SAYS(record, "{\"kind\":\"function_time\"");
  EXPECT_SAYS(content("out/index.html"), "Functions: the area that two spherical caps share");
  EXPECT_SAYS(content("out/summary.md"), "| exact_cap |");
}

TEST_F(Stress, ARecordThatCannotBeReadIsRefusedBeforeTheWorkAndKept) {
  std::filesystem::create_directories(folder_ / "out");
  write("out/record.jsonl", "not a record\n");
  const Outcome outcome = stress("caps --count 4000000");
  EXPECT_EQ(outcome.status, 2) << outcome.output;
  EXPECT_SAYS(outcome.output, "record.jsonl:1");
  EXPECT_EQ(content("out/record.jsonl"), "not a record\n");
}

TEST_F(Stress, BadInputs) {
  const std::pair<std::string, std::string> cases[] = {{"r0,r1,d\n1,2\n", "points.csv:2: needs r0,r1,d"},
                                                       {"1,abc,2\n", "points.csv:1: 'abc' is not a finite number"},
                                                       {"1,nan,2\n", "points.csv:1: 'nan' is not a finite number"},
                                                       {"1,1,1\n1,-1,2\n", "points.csv:2: radii must lie above 0"},
                                                       {"0,1,1\n", "points.csv:1: radii must lie above 0"},
                                                       {"1,3.2,1\n", "points.csv:1: radii must lie above 0"},
                                                       {"# nothing\n", "points.csv: holds no points"}};
  for (const auto& [text, words] : cases) {
    const Outcome outcome = stress("caps --points " + write("points.csv", text).string());
    EXPECT_EQ(outcome.status, 2) << text;
    EXPECT_SAYS(outcome.output, words);
  }
  EXPECT_SAYS(stress("caps --points /no/such.csv").output, "/no/such.csv: cannot be read");
  EXPECT_SAYS(stress("caps --variant exact_cup").output, "exact_cup");
  EXPECT_EQ(stress("caps --count 5").status, 2);
  EXPECT_EQ(lamina_program("stress caps --count 1000 --out /proc/nothing").status, 2);
}

TEST_F(Stress, UnknownFamilies) {
  const Outcome near = stress("cups");
  EXPECT_EQ(near.status, 2);
  EXPECT_SAYS(near.output, "unknown family 'cups' (did you mean 'caps'?)");
  EXPECT_SAYS(stress("elephants").output, "caps");
  EXPECT_SAYS(stress("/no/such/family.toml").output, "/no/such/family.toml");
  const Outcome file = stress(write("family.toml", "[family]\nname = \"x\"\nfunctoin = \"y\"\n").string());
  EXPECT_EQ(file.status, 2);
  EXPECT_SAYS(file.output, "family.toml:1: 'function' is missing");
}

// The oracle by name is all that a family of one's own takes from the program.
TEST_F(Stress, AFamilyMayBeAFileOfOnesOwn) {
  write(
      "family.comp",
      "float always_two(float r0, float r1, float d) { return 2.0; }\n"
      "float common_area(float r0, float r1, float d) { return COMMON_AREA(r0, r1, d); }\n#include \"stress/function.glsl\"\n");
  std::string text =
      "[family]\nname = \"mine\"\nfunction = \"common_area\"\ntitle = \"what caps share\"\ndefinition = \"COMMON_AREA\"\n"
      "shader = \"family.comp\"\noracle = \"cap_intersection\"\nscale = \"the smaller cap\"\nvalue = \"area\"\n"
      "[functions.always_two]\nbaseline = true\nclaims = [{ over = 1, under = -1 }]\n";
  for (const char* input : {"r0", "r1", "d"})
    text += std::string("[inputs.") + input + "]\nunit = \"radians\"\nfrom = 0.5\nto = 1\n";
  for (const char* set : {"overlaps", "box", "large", "tiny", "tangent_outside", "tangent_inside", "equal", "hemispheres",
                          "nearly_whole", "covering"})
    text += std::string("[sets.") + set + "]\nwhat = \"some\"\n";
  const Outcome outcome = stress(write("family.toml", text).string() + " --backend vulkan --grid 2");
  EXPECT_LE(outcome.status, 1) << outcome.output << "a busy machine can fail the timer's certificate";
  const auto rows = table();
  ASSERT_EQ(rows.size(), 2u) << outcome.output;
  EXPECT_EQ(rows[1][1], "always_two");
  EXPECT_EQ(rows[1][3], "8");
  EXPECT_SAYS(content("out/record.jsonl"), "\"function\":\"common_area\"");
  EXPECT_SAYS(content("out/index.html"), "Functions: what caps share");
}

TEST_F(Stress, WithoutANameEveryFamilyRuns) {
  const Outcome outcome = stress("--backend vulkan --variant exact_cap --grid 3");
  EXPECT_LE(outcome.status, 1) << outcome.output << "a busy machine can fail the timer's certificate";
  EXPECT_SAYS(outcome.output, "caps: the area that two spherical caps share");
  EXPECT_SAYS(content("out/stress-caps.csv"), "vulkan,exact_cap,grid,27");
  EXPECT_SAYS(content("out/record.jsonl"), "\"function\":\"cap_intersection\"");
}

TEST_F(Stress, AGridHasItsNumberOfInputsCubed) {
  const Outcome outcome = stress("caps --backend vulkan --variant exact_cap --grid 5");
  EXPECT_LE(outcome.status, 1) << outcome.output << "a busy machine can fail the timer's certificate";
  const auto rows = table();
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1][2], "grid");
  EXPECT_EQ(rows[1][3], "125");
}

TEST_F(Stress, BadGrids) {
  for (const char* grid : {"1", "161", "-3", "many"}) EXPECT_EQ(stress(std::string("caps --grid ") + grid).status, 2) << grid;
  EXPECT_SAYS(stress("caps --grid 161").output, "--grid");
  for (const char* other : {"--points points.csv", "--count 1000"}) {
    const Outcome outcome = stress(std::string("caps --grid 5 ") + other);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_SAYS(outcome.output, "excludes --grid");
  }
}

TEST_F(Stress, NoDeviceIsStatusFour) {
  const Outcome outcome = stress("caps --count 1000 --device no_such_device");
  EXPECT_EQ(outcome.status, 4) << outcome.output;
}

}  // namespace
}  // namespace lamina
