// SPDX-License-Identifier: Apache-2.0
// The record as a file: written line by line, read back, damaged in every way that a crash or a hand may damage it.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/record/record.h"
#include "tests/folder.h"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

class RecordFile : public InFolder<> {
 protected:
  void write(const std::string& content) { std::ofstream(file_, std::ios::binary) << content; }
  // Reads what must be refused: the error, for its subject and words.
  Error refusal(const std::string& content) {
    write(content);
    try {
      read_record(file_);
    } catch (const Error& error) {
      return error;
    }
    ADD_FAILURE() << "accepted: " << content;
    return Error(ErrorKind::failed, "", "", "");
  }
  std::string line(int number) const { return file_.string() + ":" + std::to_string(number); }

  const std::filesystem::path file_ = folder_ / "record.jsonl";
};

Json run_line() { return {{"kind", "run"}, {"schema", 1}, {"lamina", "0.1.0"}, {"build", "release"}}; }

CellRow cell_row() {
  CellRow cell;
  cell.scene = "heart";
  cell.effect = "layered_material";
  cell.variant = "light_map";
  cell.backend = "vulkan";
  cell.view = "front";
  cell.width = 8, cell.height = 8;
  cell.params = {{"scene.time", 0.25}};
  PassRow& pass = cell.passes.emplace_back();
  pass.name = "composite";
  pass.ms = {0.1, 0.2, 1.0 / 3.0};
  pass.by_texture = {{.texture = "t", .format = "rgba8_srgb", .filter = "trilinear", .fetches = 64}};
  cell.ratio_to_baseline = Interval{.median = 0.5, .low = 0.25, .high = 0.75, .rounds = 6, .coverage = 0.96875};
  cell.error_covered = cell.error_frame =
      ErrorFigures{.psnr_db = 30, .ssim = 0.9, .flip = 0.1, .rmse_linear = 0.1, .max_linear = 0.2};
  cell.covered_pixels = 64;
  cell.shader_hashes = {"aa"};
  return cell;
}
CellRow cell_row_with_truth() {
  CellRow cell = cell_row();
  cell.error_truth = cell.error_frame;
  cell.truth_image = "images/truth.png";
  cell.assumptions = {{.name = "intersection", .title = "t", .error = *cell.error_frame, .image = "images/i.png"},
                      {.name = "cosine", .title = "u", .error = *cell.error_frame, .image = ""}};
  return cell;
}
BakeRow bake_row() {
  return {.effect = "aperture_lighting", .object = "o", .what = "apertures", .points = 4, .rays = 256, .seconds = 0.5};
}
Json cell_line() { return to_json(cell_row()); }

std::string lines(std::initializer_list<Json> all) {
  std::string text;
  for (const Json& one : all) text += one.dump() + "\n";
  return text;
}

TEST_F(RecordFile, ReadsBackEveryKindExactly) {
  const Json timer = to_json(
      TimerRow{.backend = "vulkan", .ok = true, .linearity = {1, 1.1}, .additivity = 1, .attribution = 0, .reason = ""});
  const Json plan = to_json(PlanRow{{{.effect = "volume_fog", .reason = "the scene has no fog"}}});
  const Json phase = {{"kind", "phase"}, {"backend", "vulkan"}, {"effect", "layered_material"},
                      {"rounds", 9},     {"wall_ms", 110.5},    {"device_ms", 100.25}};
  {
    RecordWriter writer(file_);
    for (const Json& one : {run_line(), timer, plan, to_json(bake_row()), phase, cell_line(), to_json(cell_row_with_truth())})
      writer.append(one);
  }
  const Record record = read_record(file_);
  EXPECT_EQ(record.run, nlohmann::json(run_line()));
  ASSERT_EQ(record.timers.size(), 1u);
  EXPECT_EQ(to_json(record.timers[0]), timer);
  ASSERT_EQ(record.plans.size(), 1u);
  EXPECT_EQ(to_json(record.plans[0]), plan);
  ASSERT_EQ(record.phases.size(), 1u);
  EXPECT_EQ(to_json(record.phases[0]), phase);
  ASSERT_EQ(record.bakes.size(), 1u);
  EXPECT_EQ(to_json(record.bakes[0]), to_json(bake_row()));
  ASSERT_EQ(record.cells.size(), 2u);
  EXPECT_EQ(to_json(record.cells[0]).dump(), cell_line().dump());
  EXPECT_EQ(to_json(record.cells[1]).dump(), to_json(cell_row_with_truth()).dump());
  EXPECT_EQ(record.cells[0].passes[0].ms[2], 1.0 / 3.0);
}

TEST_F(RecordFile, EachLineIsOnDiskBeforeTheNext) {
  RecordWriter writer(file_);
  writer.append(run_line());
  EXPECT_EQ(read_record(file_).cells.size(), 0u);
  writer.append(cell_line());
  EXPECT_EQ(read_record(file_).cells.size(), 1u);
}

TEST_F(RecordFile, AWriterStartsAfresh) {
  write("leftover of another run\n");
  RecordWriter(file_).append(run_line());
  EXPECT_EQ(read_file(file_, "test"), run_line().dump() + "\n");
}

TEST_F(RecordFile, BytesThatAreNotUtf8DoNotLoseTheLine) {
  CellRow cell = cell_row();
  cell.reason = "driver said \xff!";
  RecordWriter writer(file_);
  writer.append(run_line());
  writer.append(to_json(cell));
  EXPECT_EQ(read_record(file_).cells.at(0).reason, "driver said \xef\xbf\xbd!");
}

TEST_F(RecordFile, AnUnwritableFolderThrows) {
  try {
    RecordWriter writer(folder_ / "missing" / "record.jsonl");
    FAIL() << "opened";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_EQ(error.subject(), (folder_ / "missing" / "record.jsonl").string());
    EXPECT_NE(error.message().find("No such file or directory"), std::string::npos) << error.what();
  }
  EXPECT_THROW(RecordWriter writer(folder_), Error);
}

TEST_F(RecordFile, AFullDiskThrowsAtTheLineAndEverAfter) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  RecordWriter writer("/dev/full");
  try {
    writer.append(run_line());
    FAIL() << "written to a full disk";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::failed);
    EXPECT_NE(error.message().find("No space left"), std::string::npos) << error.what();
  }
  EXPECT_THROW(writer.append(run_line()), Error);
}

TEST_F(RecordFile, ALastLineCutShortIsLeftOutAndSaidSo) {
  const std::string whole = lines({run_line(), cell_line()}), last = cell_line().dump();
  for (const size_t kept : {size_t{1}, last.size() / 2, last.size() - 1}) {
    write(whole + last.substr(0, kept));
    const Record record = read_record(file_);
    EXPECT_EQ(record.cells.size(), 1u);
    EXPECT_NE(record.run.at("truncated").get<std::string>().find("line 3"), std::string::npos) << record.run["truncated"];
  }
}

TEST_F(RecordFile, ALastLineThatLacksOnlyItsNewlineIsKept) {
  write(lines({run_line()}) + cell_line().dump());
  const Record record = read_record(file_);
  EXPECT_EQ(record.cells.size(), 1u);
  EXPECT_FALSE(record.run.contains("truncated"));
}

TEST_F(RecordFile, ADamagedLineInTheMiddleIsRefusedWithItsNumber) {
  const std::string cut = cell_line().dump().substr(0, 40);
  EXPECT_EQ(refusal(lines({run_line()}) + cut + "\n" + cell_line().dump() + "\n").subject(), line(2));
  EXPECT_EQ(refusal(lines({run_line(), cell_line()}) + "not json\n").subject(), line(3));
  EXPECT_EQ(refusal(lines({run_line()}) + "\n").subject(), line(2));
  EXPECT_EQ(refusal(lines({run_line()}) + "[1]\n").subject(), line(2));
  EXPECT_EQ(refusal(lines({run_line()}) + "{\"kind\":\"cell\",\"width\":1e999}\n").subject(), line(2));
}

TEST_F(RecordFile, TheFirstLineMustBeARunOfThisSchema) {
  EXPECT_EQ(refusal("").subject(), line(1));
  EXPECT_EQ(refusal("{\"kind\":\"run\",\"sche").subject(), line(1));
  EXPECT_EQ(refusal(lines({cell_line()})).subject(), line(1));
  EXPECT_NE(refusal("{\"kind\":\"run\"}\n").message().find("'schema' is missing"), std::string::npos);
  const Error other = refusal(lines({{{"kind", "run"}, {"schema", 2}}}));
  EXPECT_EQ(other.subject(), line(1));
  EXPECT_EQ(other.kind(), ErrorKind::bad_input);
  EXPECT_NE(other.message().find("schema is 2"), std::string::npos) << other.what();
}

TEST_F(RecordFile, UnknownKindsAndASecondRunAreRefused) {
  const Error typo = refusal(lines({run_line(), {{"kind", "cel"}}}));
  EXPECT_EQ(typo.subject(), line(2));
  EXPECT_NE(typo.message().find("did you mean 'cell'"), std::string::npos) << typo.what();
  EXPECT_EQ(refusal(lines({run_line(), cell_line(), run_line()})).subject(), line(3));
}

TEST_F(RecordFile, ALineWithoutAnyOneOfItsFieldsIsRefused) {
  for (const Json& whole : {cell_line(), to_json(bake_row())})
    for (const auto& [name, value] : whole.items()) {
      Json damaged = whole;
      damaged.erase(name);
      const Error error = refusal(lines({run_line(), damaged}));
      EXPECT_EQ(error.subject(), line(2));
      EXPECT_NE(error.message().find("'" + name + "'"), std::string::npos) << error.what();
    }
}

TEST_F(RecordFile, DamagedTruthsAreRefused) {
  const auto refused = [&](const char* pointer, Json value) {
    Json cell = to_json(cell_row_with_truth());
    cell[Json::json_pointer(pointer)] = std::move(value);
    return refusal(lines({run_line(), cell})).subject() == line(2);
  };
  EXPECT_TRUE(refused("/truth_image", 1));
  EXPECT_TRUE(refused("/error/truth/flip", "x"));
  EXPECT_TRUE(refused("/assumptions", nullptr));
  EXPECT_TRUE(refused("/assumptions/1", 3));
  EXPECT_TRUE(refused("/assumptions/1/title", nullptr));
  EXPECT_TRUE(refused("/assumptions/0/error", nullptr));
  EXPECT_TRUE(refused("/assumptions/0/error/ssim", nullptr));
  EXPECT_TRUE(refused("/assumptions/0/error/identical", true));  // yet its PSNR is a number
  Json cell = to_json(cell_row_with_truth());
  cell["assumptions"][0].erase("image");
  EXPECT_EQ(refusal(lines({run_line(), cell})).subject(), line(2));
}

TEST_F(RecordFile, FieldsOfTheWrongTypeAreRefused) {
  const auto damaged = [](const char* pointer, Json value) {
    Json cell = cell_line();
    cell[Json::json_pointer(pointer)] = std::move(value);
    return lines({run_line(), cell});
  };
  EXPECT_EQ(refusal(damaged("/view", 3)).subject(), line(2));
  EXPECT_EQ(refusal(damaged("/status", "fine")).subject(), line(2));
  EXPECT_EQ(refusal(damaged("/covered_pixels", -1)).subject(), line(2));
  EXPECT_EQ(refusal(damaged("/passes/0/ms/1", "x")).subject(), line(2));
  EXPECT_EQ(refusal(damaged("/passes/0/by_texture/0/fetches", nullptr)).subject(), line(2));
  EXPECT_EQ(refusal(damaged("/error/baseline/ssim", nullptr)).subject(), line(2));
  EXPECT_EQ(refusal(damaged("/error/baseline/psnr_db", nullptr)).subject(), line(2));  // null, yet not said to be identical
  EXPECT_EQ(refusal(damaged("/ratio_to_baseline/low", "x")).subject(), line(2));
  EXPECT_EQ(refusal(damaged("/params/scene.time", "noon")).subject(), line(2));
  Json bake = to_json(bake_row());
  bake["from_cache"] = "no";
  EXPECT_EQ(refusal(lines({run_line(), bake})).subject(), line(2));
}

TEST_F(RecordFile, PassesOfOneFrameWithUnequalRoundsAreRefused) {
  Json cell = cell_line();
  cell["passes"].push_back(cell["passes"][0]);
  cell["passes"][1]["ms"] = {1.0};
  EXPECT_EQ(refusal(lines({run_line(), cell})).subject(), line(2));
}

// A plan needs only what each effect is called for; what its variants' passes are came later.
TEST_F(RecordFile, APlanOfAnEarlierVersionIsRead) {
  write(lines({run_line()}) +
        R"({"kind":"plan","effects":[{"effect":"e","called_for":true,"reason":"r","variants":[{"variant":"v","passes":)"
        R"([{"pass":"p","runs":false}]}]}]})"
        "\n");
  const PlanRow plan = read_record(file_).plans.at(0);
  EXPECT_FALSE(plan.effects.at(0).variants.at(0).passes.at(0).runs);
  EXPECT_TRUE(plan.effects[0].features.empty());
  EXPECT_EQ(refusal(lines({run_line()}) + R"({"kind":"plan","effects":[{"effect":"e","called_for":true}]})" + "\n").subject(),
            line(2));
}

TEST_F(RecordFile, FieldsToComeAreNoError) {
  Json cell = cell_line();
  cell["shade_of_a_later_version"] = {{"x", 1}};
  write(lines({run_line(), cell}));
  EXPECT_EQ(read_record(file_).cells.size(), 1u);
}

TEST_F(RecordFile, AMissingFileIsRefusedByName) {
  try {
    read_record(folder_ / "nothing.jsonl");
    FAIL() << "read";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_EQ(error.subject(), (folder_ / "nothing.jsonl").string());
  }
}

Json ratio_interval() { return {{"median", 1.0}, {"low", 0.9}, {"high", 1.1}, {"rounds", 60}, {"coverage", 0.96}}; }
Json gate_line() {
  return {{"kind", "gate"},     {"mode", "against"}, {"against", "a stored record"},
          {"verdict", "same"},  {"status", 0},       {"processes", 3},
          {"rounds", 60},       {"wall_s", 41.2},    {"margin", 0.02},
          {"confidence", 0.95}, {"comparisons", 12}};
}
Json aa_line() {
  return {{"kind", "aa"},   {"backend", "vulkan"},       {"effect", "e"},
          {"variant", "v"}, {"ratio", ratio_interval()}, {"verdict", "same"}};
}
Json verdict_line() {
  return {{"kind", "verdict"}, {"backend", "vulkan"}, {"effect", "e"},    {"variant", "v"},
          {"view", ""},        {"what", "time"},      {"pass", ""},       {"texture", ""},
          {"verdict", "same"}, {"before", 1.5},       {"after", nullptr}, {"ratio", ratio_interval()},
          {"limit", nullptr},  {"sentence", "s"}};
}

TEST_F(RecordFile, AGatesLinesAreReadAndEveryFieldOfThemIsChecked) {
  write(lines({run_line(), gate_line(), aa_line(), verdict_line()}));
  const Record record = read_record(file_);
  EXPECT_EQ(record.gates.size(), 1u);
  EXPECT_EQ(record.aas.size(), 1u);
  EXPECT_EQ(record.verdicts.size(), 1u);
  for (const Json& whole : {gate_line(), aa_line(), verdict_line()})
    for (const auto& [name, unused] : whole.items()) {
      Json less = whole, other = whole;
      less.erase(name);
      other[name] = Json::array({"wrong"});
      for (const Json& damaged : {less, other}) EXPECT_EQ(refusal(lines({run_line(), damaged})).subject(), line(2)) << name;
    }
}

TEST_F(RecordFile, AWorstTileIsWrittenAndChecked) {
  CellRow row = cell_row();
  row.worst_tile = WorstTile{.x = 32, .y = 64, .flip = 0.5};
  Json cell = to_json(row);
  EXPECT_EQ(cell["worst_tile"], Json({{"x", 32}, {"y", 64}, {"size", 32}, {"flip", 0.5}}));
  cell["worst_tile"].erase("flip");
  EXPECT_EQ(refusal(lines({run_line(), cell})).subject(), line(2));
  EXPECT_FALSE(to_json(cell_row()).contains("worst_tile"));
}

}  // namespace
}  // namespace lamina
