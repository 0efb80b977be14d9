// SPDX-License-Identifier: Apache-2.0
// Lines of a gate as the reader takes and refuses them, and the dates of a run.
#include <gtest/gtest.h>

#include <fstream>

#include "harness/core/error.h"
#include "harness/record/record.h"
#include "tests/folder.h"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

Json run() { return {{"kind", "run"}, {"schema", 1}, {"date", "2026-01-31T23:59:59Z"}, {"commit_date", nullptr}}; }
Json gate() {
  return {{"kind", "gate"}, {"mode", "against"},  {"against", "main"}, {"verdict", "slower"},
          {"status", 1},    {"processes", 3},     {"rounds", 60},      {"wall_s", 41.25},
          {"margin", 0.02}, {"confidence", 0.95}, {"comparisons", 12}};
}
Json interval() { return {{"median", 1.5}, {"low", 1.25}, {"high", 1.75}, {"rounds", 60}, {"coverage", 0.96}}; }
Json aa() {
  return {{"kind", "aa"}, {"backend", "vulkan"}, {"effect", "e"}, {"variant", "v"}, {"ratio", interval()}, {"verdict", "same"}};
}
Json verdict() {
  return {{"kind", "verdict"}, {"backend", "vulkan"}, {"effect", "e"},    {"variant", "v"},      {"view", ""},
          {"what", "time"},    {"pass", "composite"}, {"texture", ""},    {"verdict", "slower"}, {"before", 1.0},
          {"after", nullptr},  {"ratio", interval()}, {"limit", nullptr}, {"sentence", "slower"}};
}

class GateLines : public InFolder<> {
 protected:
  Record read(const std::vector<Json>& lines) {
    {
      std::ofstream stream(file_);
      for (const Json& line : lines) stream << line.dump() << '\n';
    }
    return read_record(file_);
  }
  void expect_refused(const std::vector<Json>& lines, const std::string& words) {
    try {
      read(lines);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_EQ(error.subject(), file_.string() + ":" + std::to_string(lines.size()));
      EXPECT_NE(error.message().find(words), std::string::npos) << error.what();
      return;
    }
    ADD_FAILURE() << "accepted: " << lines.back();
  }
  const std::filesystem::path file_ = folder_ / "record.jsonl";
};

TEST_F(GateLines, AreReadBackExactly) {
  const Record record = read({run(), aa(), verdict(), gate()});
  ASSERT_EQ(record.gates.size(), 1u);
  ASSERT_EQ(record.aas.size(), 1u);
  ASSERT_EQ(record.verdicts.size(), 1u);
  EXPECT_EQ(to_json(record.gates[0]), gate());
  EXPECT_EQ(to_json(record.aas[0]), aa());
  EXPECT_EQ(to_json(record.verdicts[0]), verdict());
}

TEST_F(GateLines, HoldWhatACauseNames) {
  Json doubted = verdict();
  doubted["cause"] = "arm_differs", doubted["details"] = {"slower"};
  doubted["operations"] = {{{"operation", "exp"}, {"before", 1.0}, {"after", 2.0}}};
  doubted["counts_hold"] = true;
  const Record record = read({run(), doubted, gate()});
  EXPECT_EQ(record.verdicts.at(0).cause, Cause::arm_differs);
  EXPECT_EQ(nlohmann::json(to_json(record.verdicts.at(0))), nlohmann::json(doubted));
}

TEST_F(GateLines, WithoutAnyOneOfTheirFieldsAreRefused) {
  for (const Json& whole : {gate(), aa(), verdict()})
    for (const auto& [name, value] : whole.items()) {
      Json damaged = whole;
      damaged.erase(name);
      expect_refused({run(), damaged}, "'" + name + "'");
    }
}

TEST_F(GateLines, WithAWordOrTypeThatIsNoneOfThoseKnownAreRefused) {
  const auto refused = [&](Json line, const char* field, Json value) {
    line[field] = std::move(value);
    expect_refused({run(), line}, std::string("'") + field);
  };
  refused(gate(), "verdict", "fine");
  refused(gate(), "verdict", "better");
  refused(gate(), "mode", "both");
  refused(gate(), "status", 5);
  refused(gate(), "status", -1);
  refused(gate(), "wall_s", nullptr);
  refused(aa(), "verdict", "failed");
  refused(aa(), "ratio", nullptr);
  refused(aa(), "ratio", {{"median", 1}});
  refused(verdict(), "verdict", "wrose");
  refused(verdict(), "before", "1");
  refused(verdict(), "ratio", 1.5);
  refused(verdict(), "ratio", {{"median", 1}});
  refused(verdict(), "sentence", nullptr);
  refused(verdict(), "cause", "bad luck");
  refused(verdict(), "details", {1});
  refused(verdict(), "operations", {{{"operation", "exp"}, {"before", 1}}});
}

Json pairs() {
  const Json ms = {{1.5, 1.6}, {1.4, 1.7}}, strips = {Json::array(), {{1.5, 1.4, 0}, {1.6, 1.7, 1}}};
  return {{"kind", "pairs"},
          {"process", 0},
          {"backend", "vulkan"},
          {"effect", "e"},
          {"variant", "v"},
          {"view", "front"},
          {"frames", {"before", "after"}},
          {"passes", {{{"name", "p"}, {"cut", true}, {"same", {false, false}}, {"ms", ms}, {"strips", strips}}}}};
}

TEST_F(GateLines, PairsOfTimesAreReadAndEveryFieldOfThemIsChecked) {
  EXPECT_EQ(to_json(read({run(), pairs()}).pairs.at(0)), pairs());
  for (const char* field : {"process", "backend", "effect", "variant", "view", "frames", "passes"}) {
    Json damaged = pairs();
    damaged.erase(field);
    expect_refused({run(), damaged}, std::string("'") + field + "'");
  }
  const auto refused = [&](const char* field, Json value, const std::string& words) {
    Json line = pairs();
    line["passes"][0][field] = std::move(value);
    expect_refused({run(), line}, words);
  };
  refused("cut", 1, "'passes.cut'");
  refused("same", Json::array({false}), "'same' of 1 frames");
  refused("same", {false, 1}, "'passes.same'");
  refused("ms", {{1.5}}, "'ms' of 1 frames");
  refused("ms", {{1.5}, {"x"}}, "'passes.ms'");
  refused("strips", Json::array({Json::array()}), "'strips' of 1 frames");
  refused("strips", {Json::array(), {{1.5, 1.4}}}, "'passes.strips'");
  refused("strips", {Json::array(), {{1.5, "x", 0}}}, "'passes.strips'");
  refused("strips", {Json::array(), {1.5}}, "'passes.strips'");
}

TEST_F(GateLines, DatesOfARunAreMomentsInUtcOrNotThere) {
  EXPECT_EQ(read({run()}).run.at("date"), "2026-01-31T23:59:59Z");
  EXPECT_FALSE(read({{{"kind", "run"}, {"schema", 1}}}).run.contains("date"));
  const auto refused = [&](const char* field, Json value) {
    Json line = run();
    line[field] = std::move(value);
    expect_refused({line}, std::string("'") + field);
  };
  refused("date", nullptr);
  refused("date", "2026-01-31");
  refused("date", "2026-01-31T23:59:59+01");
  refused("date", "2026-01-31 23:59:59Z");
  refused("date", "2026-01-31T23:59:5xZ");
  refused("commit_date", "yesterday");
  refused("commit_date", 20260131);
}

}  // namespace
}  // namespace lamina
