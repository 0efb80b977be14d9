// SPDX-License-Identifier: Apache-2.0
// A record taken up at every byte at which a run may have died, refused where it is of other inputs, and joined from shards.
#include "harness/sweep/sweep_record.h"

#include <gtest/gtest.h>

#include "harness/core/text.h"
#include "tests/folder.h"
#include "tests/sweep/sweep_cells.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

class SweepRecordTest : public InFolder<> {
 protected:
  // A shard's record of these points: two variants each.
  std::string shard_text(size_t index, size_t count, Json run = sweep_run_line(), double ssim = 0.9) {
    std::string text = run.dump() + "\n" + to_json(sweep_row(x_, index, count)).dump() + "\n";
    for (size_t point = 0; point < x_.size(); ++point)
      if (Shard{index, count}.has(point))
        for (const char* variant : {"light_map", "vertex_normal"})
          text += to_json(sweep_cell(variant, x_[point], ssim)).dump() + "\n";
    return text;
  }
  std::optional<Earlier> take_up(const std::filesystem::path& file, const Json& run = sweep_run_line()) {
    const SweepRow sweep = sweep_row(x_);
    return continue_record(file, run, sweep, points_of(sweep));
  }

  std::vector<double> x_ = {0, 1, 2.5, 4};
};

TEST_F(SweepRecordTest, WhateverByteARunDiedAtWholeLinesStay) {
  const std::string whole = shard_text(0, 1);
  for (size_t bytes = 0; bytes <= whole.size(); ++bytes) {
    const auto file = write("record.jsonl", whole.substr(0, bytes));
    const std::optional<Earlier> earlier = take_up(file);
    const std::string kept = whole.substr(0, bytes).substr(0, whole.substr(0, bytes).rfind('\n') + 1);
    const auto lines = static_cast<size_t>(std::count(kept.begin(), kept.end(), '\n'));
    ASSERT_EQ(earlier.has_value(), lines >= 2) << bytes;
    if (!earlier) continue;
    ASSERT_EQ(earlier->cells.size(), lines - 2) << bytes;
    ASSERT_EQ(earlier->cut_bytes, bytes - kept.size());
    ASSERT_EQ(read_file(file, "test"), kept) << bytes;
  }
}

TEST_F(SweepRecordTest, AnswersAreTakenOffToBeFoundAgain) {
  CrossoverRow row;
  row.metric = "ssim", row.sentence = "so it is";
  const std::string cells = shard_text(0, 1);
  const auto file = write("record.jsonl", cells + to_json(row).dump() + "\n" + to_json(row).dump() + "\n");
  const auto earlier = take_up(file);
  ASSERT_TRUE(earlier);
  EXPECT_TRUE(earlier->finished);
  EXPECT_EQ(earlier->cells.size(), 8u);
  EXPECT_EQ(read_file(file, "test"), cells);
}

TEST_F(SweepRecordTest, OtherInputsAreRefusedByName) {
  const auto file = write("record.jsonl", shard_text(0, 1));
  const auto refused = [&](const char* pointer, const Json& value, const char* named) {
    Json run = sweep_run_line();
    run[Json::json_pointer(pointer)] = value;
    try {
      take_up(file, run);
      ADD_FAILURE() << pointer;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
    }
  };
  refused("/settings/width", 128, "settings.width");
  refused("/inputs", "beef", "inputs");
  refused("/commit", "def", "commit");
  refused("/devices/0/device", "another", "devices.0.device");
  EXPECT_EQ(read_file(file, "test"), shard_text(0, 1)) << "what is refused stays as it is";
  Json elsewhere = sweep_run_line();
  elsewhere["machine"]["cpu"] = "Other";
  EXPECT_TRUE(take_up(file, elsewhere)) << "errors are the same on any machine";
  Json timed = sweep_run_line();
  timed["settings"]["time"] = "all";
  const auto timed_file = write("timed.jsonl", shard_text(0, 1, timed));
  timed["machine"]["cpu"] = "Other";
  EXPECT_THROW(take_up(timed_file, timed), Error) << "times are not";
  EXPECT_THROW(take_up(write("shard.jsonl", shard_text(1, 2))), Error) << "another shard";
}

// Answers are found again anyway, so a record goes on by other limits, which it then has.
TEST_F(SweepRecordTest, OtherLimitsAreTakenOver) {
  const std::string text = shard_text(0, 1);
  const auto file = write("record.jsonl", text);
  SweepRow row = sweep_row(x_);
  row.limits = {{"flip", 0.125}};
  const auto earlier = continue_record(file, sweep_run_line(), row, points_of(row));
  ASSERT_TRUE(earlier);
  EXPECT_EQ(earlier->cells.size(), 8u);
  const size_t second = text.find('\n') + 1, third = text.find('\n', second) + 1;
  EXPECT_EQ(read_file(file, "test"), text.substr(0, second) + to_json(row).dump() + "\n" + text.substr(third));
}

TEST_F(SweepRecordTest, OneFolderIsWrittenByOneRun) {
  {
    const FolderLock lock("sweep", folder_);
    try {
      const FolderLock second("merge", folder_);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_NE(std::string(error.what()).find("is writing here"), std::string::npos) << error.what();
    }
  }
  const FolderLock afterwards("sweep", folder_);
}

TEST_F(SweepRecordTest, DamageInTheMiddleIsRefused) {
  std::string text = shard_text(0, 1);
  const size_t third = text.find('\n', text.find('\n') + 1) + 1;
  EXPECT_THROW(take_up(write("record.jsonl", text.substr(0, third) + "{\"kind\":\n" + text.substr(third))), Error);
  const size_t fourth = text.find('\n', third) + 1;
  EXPECT_THROW(take_up(write("record.jsonl", text + text.substr(third, fourth - third))), Error) << "a cell twice";
}

TEST_F(SweepRecordTest, ShardsJoinToWhatOneRunLeaves) {
  const auto first = write("a.jsonl", shard_text(0, 2)), second = write("b.jsonl", shard_text(1, 2));
  const Joined joined = join_records({second, first});
  EXPECT_EQ(joined.cells, 8u);
  EXPECT_TRUE(joined.missing.empty());
  EXPECT_FALSE(joined.several_machines);
  std::string text;
  for (size_t i = 1; i < joined.lines.size(); ++i) text += Json(joined.lines[i]).dump() + "\n";
  std::string alone;
  std::istringstream lines(shard_text(0, 1));
  std::string line;
  for (size_t i = 0; std::getline(lines, line); ++i)
    if (i > 0) alone += Json::parse(line).dump() + "\n";
  EXPECT_EQ(text, alone);
}

TEST_F(SweepRecordTest, WhatNoShardHasIsMissing) {
  const Joined joined = join_records({write("a.jsonl", shard_text(0, 2))});
  ASSERT_EQ(joined.missing.size(), 2u);
  EXPECT_EQ(joined.missing[1],
            "layered_material/vertex_normal on vulkan: 2 of 4 points are missing: objects.heart.thickness 1; "
            "objects.heart.thickness 4");
}

TEST_F(SweepRecordTest, DuplicatesMustAgree) {
  const auto one = write("a.jsonl", shard_text(0, 1));
  EXPECT_EQ(join_records({one, write("b.jsonl", shard_text(0, 2))}).duplicates, 4u);
  try {
    join_records({one, write("b.jsonl", shard_text(0, 2, sweep_run_line(), 0.8))});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("disagrees with"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("vertex_normal on vulkan"), std::string::npos) << error.what();
  }
}

TEST_F(SweepRecordTest, OtherSweepsDoNotJoin) {
  Json other = sweep_run_line();
  other["inputs"] = "beef";
  EXPECT_THROW(join_records({write("a.jsonl", shard_text(0, 2)), write("b.jsonl", shard_text(1, 2, other))}), Error);
}

TEST_F(SweepRecordTest, TimesOfSeveralMachinesAreLeftOutAndRatiosStay) {
  const auto text = [&](size_t index, const std::string& cpu) {
    Json run = sweep_run_line();
    run["machine"]["cpu"] = cpu;
    std::string lines = run.dump() + "\n" + to_json(sweep_row({0, 1}, index, 2)).dump() + "\n";
    for (const char* variant : {"light_map", "vertex_normal"})
      lines += to_json(sweep_cell(variant, double(index), 0.9, index == 0 ? 0.5 : 0.25)).dump() + "\n";
    return lines;
  };
  const Joined joined = join_records({write("a.jsonl", text(0, "One")), write("b.jsonl", text(1, "Other"))});
  EXPECT_TRUE(joined.several_machines);
  size_t cells = 0;
  for (const Json line : joined.lines) {
    if (line.at("kind") != "cell") continue;
    ++cells;
    EXPECT_TRUE(line.at("median_ms").is_null());
    for (const Json& pass : line.at("passes")) EXPECT_TRUE(pass.at("ms").empty());
    EXPECT_EQ(line.at("ratio_to_baseline").is_null(), line.at("baseline").get<bool>());
  }
  EXPECT_EQ(cells, 4u);
  EXPECT_EQ(Json(joined.lines[0]).at("machines").size(), 2u);
}

}  // namespace
}  // namespace lamina
