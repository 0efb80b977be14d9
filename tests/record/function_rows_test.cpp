// SPDX-License-Identifier: Apache-2.0
// Lines on functions: their fields, what is null, what is refused, and how they get into a record that is there.
#include "tests/record/function_rows.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <limits>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/record/record.h"
#include "tests/folder.h"
#include "tests/record/example_timer.h"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

const Json release_run = {{"kind", "run"}, {"schema", 1}, {"build", "release"}};

class FunctionLines : public InFolder<> {
 protected:
  void write(const std::string& content) { std::ofstream(file_, std::ios::binary) << content; }
  std::string content() { return read_file(file_, "test"); }

  const std::filesystem::path file_ = folder_ / "record.jsonl";
};

Json phase() {
  return {{"kind", "phase"}, {"backend", "vulkan"}, {"effect", "e"}, {"rounds", 9}, {"wall_ms", 110.5}, {"device_ms", 100.25}};
}

std::vector<Json> every_kind() {
  return {to_json(example_function(example_subject(), 0.5)), to_json(example_time(example_subject(), 2)),
          to_json(example_picture(example_subject())), to_json(FunctionTimerRow{example_timer("vulkan"), "cap_intersection"})};
}

TEST(FunctionToJson, HoldsWhatTheRowHolds) {
  const Json line = to_json(example_function(example_subject("exact_cap"), 0.5));
  EXPECT_EQ(line["kind"], "function");
  EXPECT_EQ(line["function"], "cap_intersection");
  EXPECT_EQ(line["variant"], "exact_cap");
  EXPECT_EQ(line["baseline"], true);
  EXPECT_EQ(line["backend"], "vulkan");
  EXPECT_EQ(line["device"], "llvmpipe");
  EXPECT_EQ(line["set"], "overlaps");
  EXPECT_EQ(line["points"], 1000);
  EXPECT_EQ(line["max_over"], 0.5);
  EXPECT_EQ(line["max_under"], -0.25);
  EXPECT_EQ(line["mean_absolute"], 0.125);
  EXPECT_EQ(line["rms"], 0.5 / 3);
  EXPECT_EQ(line["most_eps"], 0x1p22);
  EXPECT_EQ(line["most_eps_kappa"], 7);
  EXPECT_EQ(line["negative"], 0);
  EXPECT_EQ(line["nonfinite"], 0);
  EXPECT_EQ(line["not_zero"], 3);
  EXPECT_EQ(line["worst_over"], Json({0.5, 0.25, 0.125}));
  EXPECT_EQ(line["worst_under"], Json({1, 2, 3}));
  EXPECT_FALSE(line.contains("first_fault"));
  EXPECT_FALSE(line.contains("bounds"));
}

TEST(FunctionToJson, HoldsTheFirstFaultAndTheBoundsWhereThereAreAny) {
  const Json line = to_json(with_bounds(example_function(example_subject(), 0.5)));
  EXPECT_EQ(line["first_fault"], Json({3, 2, 1}));
  EXPECT_EQ(line["bounds"], Json({{"over", 0.25}, {"under", -0.25}, {"eps_kappa", nullptr}}));
  FunctionRow row = with_bounds(example_function(example_subject(), 0.5));
  row.bounds->eps_kappa = 4;
  EXPECT_EQ(to_json(row)["bounds"]["eps_kappa"], 4);
}

TEST(FunctionToJson, WhatIsNotKnownIsNull) {
  FunctionRow row = example_function(example_subject(), 0.5);
  row.max_under = 0;
  EXPECT_TRUE(to_json(row)["worst_under"].is_null());
  EXPECT_FALSE(to_json(row)["max_under"].is_null());
  row.nonfinite = row.points;
  for (const char* name : {"max_over", "max_under", "mean_absolute", "rms", "most_eps", "most_eps_kappa", "worst_over"})
    EXPECT_TRUE(to_json(row)[name].is_null()) << name;
  FunctionTimeRow time = example_time(example_subject(), 2);
  EXPECT_EQ(to_json(time)["ns_per_call"]["median"], 2);
  time.ns_per_call.reset();
  EXPECT_TRUE(to_json(time)["ns_per_call"].is_null());
}

TEST(FunctionToJson, ATimeKeepsEveryRoundToSixDigits) {
  const Json line = to_json(with_samples(example_time(example_subject(), 10)));
  ASSERT_EQ(line["ns"].size(), 12u);
  EXPECT_EQ(line["ns"][0], 9);
  EXPECT_EQ(line["ns"][11], 12.3457);
  EXPECT_FALSE(to_json(example_time(example_subject(), 10)).contains("ns"));
}

TEST(FunctionToJson, RefusesNumbersThatAreNotFinite) {
  FunctionRow row = example_function(example_subject(), 0.5);
  row.rms = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(to_json(row), Error);
  FunctionTimeRow time = example_time(example_subject(), 2);
  time.ns_per_call->high = std::numeric_limits<double>::infinity();
  EXPECT_THROW(to_json(time), Error);
  FunctionTimeRow sampled = with_samples(example_time(example_subject(), 2));
  sampled.ns[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(to_json(sampled), Error);
}

TEST_F(FunctionLines, AreReadBackExactly) {
  replace_function_lines(file_, "cap_intersection", release_run, every_kind());
  const Record record = read_record(file_);
  ASSERT_EQ(record.functions.size(), 1u);
  ASSERT_EQ(record.function_times.size(), 1u);
  ASSERT_EQ(record.function_pictures.size(), 1u);
  EXPECT_EQ(to_json(record.functions[0]), every_kind()[0]);
  EXPECT_EQ(to_json(record.function_times[0]), every_kind()[1]);
  EXPECT_EQ(to_json(record.function_pictures[0]), every_kind()[2]);
  ASSERT_EQ(record.function_timers.size(), 1u);
  EXPECT_EQ(to_json(record.function_timers[0]), every_kind()[3]);
  EXPECT_TRUE(record.timers.empty()) << "which are those of frames";
  EXPECT_EQ(record.run, nlohmann::json(release_run));
}

// A function may have one input or many.
TEST_F(FunctionLines, PointsHaveAsManyInputsAsTheFunction) {
  FunctionRow row = with_bounds(example_function(example_subject(), 0.5));
  row.worst_over = {0.5};
  row.worst_under = {1, 2, 3, 4, 5, 6, 7, 8};
  row.first_fault = {2, 1};
  replace_function_lines(file_, "cap_intersection", release_run, {to_json(row)});
  const FunctionRow back = read_record(file_).functions.at(0);
  EXPECT_EQ(back.worst_over, row.worst_over);
  EXPECT_EQ(back.worst_under, row.worst_under);
  EXPECT_EQ(back.first_fault, row.first_fault);
}

TEST_F(FunctionLines, RoundsAreReadBackAndARecordOfBeforeThemOpens) {
  const Json sampled = to_json(with_samples(example_time(example_subject(), 2)));
  replace_function_lines(file_, "cap_intersection", release_run, {sampled, every_kind()[1]});
  const Record record = read_record(file_);
  ASSERT_EQ(record.function_times.size(), 2u);
  EXPECT_EQ(to_json(record.function_times[0]), sampled);
  EXPECT_TRUE(record.function_times[1].ns.empty());
}

TEST_F(FunctionLines, WithoutAFieldOrWithAWrongOneAreRefusedWithFileAndLine) {
  const auto refused = [&](const Json& line, const std::string& words) {
    write(release_run.dump() + "\n" + line.dump() + "\n");
    try {
      read_record(file_);
    } catch (const Error& error) {
      EXPECT_EQ(error.subject(), file_.string() + ":2");
      EXPECT_NE(error.message().find(words), std::string::npos) << error.what();
      return;
    }
    ADD_FAILURE() << "accepted: " << line.dump();
  };
  for (const Json& whole : every_kind())
    for (const auto& [name, value] : whole.items()) {
      Json damaged = whole;
      damaged.erase(name);
      refused(damaged, "'" + name + "'");
    }
  const auto with = [](size_t kind, const char* pointer, Json value) {
    Json line = every_kind()[kind];
    line[Json::json_pointer(pointer)] = std::move(value);
    return line;
  };
  refused(with(0, "/points", -1), "'points'");
  refused(with(0, "/rms", "x"), "'rms'");
  refused(with(0, "/rms", nullptr), "'rms' must be null where");
  refused(with(0, "/nonfinite", 1000), "must be null where");
  refused(with(0, "/worst_over", Json::array()), "'worst_over'");
  refused(with(0, "/worst_under", {1, 2, "x"}), "'worst_under'");
  refused(with(0, "/first_fault", {1, "x"}), "'first_fault'");
  refused(with(0, "/first_fault", 1), "'first_fault'");
  refused(with(0, "/bounds", 1), "'bounds'");
  refused(with(0, "/bounds", {{"over", 1}, {"under", -1}}), "'bounds.eps_kappa'");
  refused(with(0, "/bounds", {{"over", 1}, {"under", "x"}, {"eps_kappa", nullptr}}), "'bounds.under'");
  refused(with(1, "/ns_per_call", 3), "'ns_per_call'");
  refused(with(1, "/ns_per_call/low", nullptr), "'ns_per_call.low'");
  refused(with(1, "/ns", "x"), "'ns' is not an array of numbers");
  refused(with(1, "/ns", {1, "x"}), "'ns' is not an array of numbers");
  refused(with(1, "/ns", {1, 2}), "'ns' must hold a number for each round of 'ns_per_call'");
  Json untimed = to_json(with_samples(example_time(example_subject(), 2)));
  untimed["ns_per_call"] = nullptr;
  refused(untimed, "'ns' must hold a number for each round");
  refused(with(2, "/image", 1), "'image'");
  refused(with(3, "/ok", 1), "'ok'");
  refused(with(3, "/function", 1), "'function'");
}

TEST_F(FunctionLines, TakeThePlaceOfTheFunctionsOldOnesAndTouchNoOther) {
  FunctionSubject other = example_subject();
  other.function = "another";
  const std::string kept = release_run.dump() + "\n" +
                           R"({"backend" : "vulkan", "kind":"phase", "effect":"e","rounds":1,"wall_ms":1,"device_ms":1})" +
                           "\n" + to_json(example_time(other, 1)).dump() + "\n";
  const std::string old = to_json(example_time(example_subject("old_cap"), 1)).dump() + "\n";
  write(kept + old);
  replace_function_lines(file_, "cap_intersection", {{"kind", "run"}, {"schema", 1}, {"build", "not used"}}, {every_kind()[1]});
  EXPECT_EQ(content(), kept + every_kind()[1].dump() + "\n");
  replace_function_lines(file_, "cap_intersection", release_run, every_kind());
  EXPECT_EQ(content(), kept + every_kind()[0].dump() + "\n" + every_kind()[1].dump() + "\n" + every_kind()[2].dump() + "\n" +
                           every_kind()[3].dump() + "\n");
}

TEST_F(FunctionLines, ALastLineWithoutItsNewlineIsKept) {
  write(release_run.dump() + "\n" + phase().dump());
  replace_function_lines(file_, "cap_intersection", release_run, {every_kind()[1]});
  EXPECT_EQ(content(), release_run.dump() + "\n" + phase().dump() + "\n" + every_kind()[1].dump() + "\n");
}

TEST_F(FunctionLines, ALineCutShortGoesAndTheRecordStillSaysSo) {
  write(release_run.dump() + "\n" + phase().dump() + "\n" + phase().dump().substr(0, 20));
  replace_function_lines(file_, "cap_intersection", release_run, {every_kind()[1]});
  const Record record = read_record(file_);
  EXPECT_EQ(record.phases.size(), 1u);
  EXPECT_EQ(record.function_times.size(), 1u);
  EXPECT_NE(record.run.at("truncated").get<std::string>().find("line 3"), std::string::npos);
}

TEST_F(FunctionLines, ADamagedRecordIsRefusedAndLeftAsItIs) {
  const std::string damaged = release_run.dump() + "\nnot json\n";
  write(damaged);
  EXPECT_THROW(replace_function_lines(file_, "cap_intersection", release_run, every_kind()), Error);
  EXPECT_EQ(content(), damaged);
}

}  // namespace
}  // namespace lamina
