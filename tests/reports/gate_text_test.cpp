// SPDX-License-Identifier: Apache-2.0
// What a gate's table, Markdown and JSON say, and when they must not say that it passed.
#include <gtest/gtest.h>

#include <algorithm>

#include "reports/gate/gate.h"
#include "reports/gate/reading.h"
#include "tests/reports/example_gate.h"

namespace lamina {
namespace {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

TEST(GateTable, AnswersInItsFirstLine) {
  EXPECT_EQ(first_line(gate_table(example_failed_gate(), false)),
            "gate FAILED: 6 checks: 2 regressed, 1 ambiguous, 1 not compared, 1 better, 1 the same");
  EXPECT_EQ(first_line(gate_table(example_passed_gate(), false)), "gate passed: 1 check: 1 the same");
  EXPECT_EQ(
      first_line(gate_table(example_gate(Verdict::ambiguous, 3, {example_verdict(Verdict::ambiguous, "time", "s")}), false)),
      "gate AMBIGUOUS: 1 check: 1 ambiguous");
}

TEST(GateTable, AnAmbiguousTimeSaysWhatSettlesIt) {
  const auto says = [](Verdict verdict, int status, const char* what) {
    return gate_table(example_gate(verdict, status, {example_verdict(verdict, what, "s")}), false).find("want more --budget") !=
           std::string::npos;
  };
  EXPECT_TRUE(says(Verdict::ambiguous, 3, "time"));
  EXPECT_FALSE(says(Verdict::ambiguous, 3, "timer"));
  EXPECT_FALSE(says(Verdict::slower, 1, "time"));
}

TEST(GateTable, SaysWhatRegressedWhereByHowMuchAndHowSure) {
  const std::string table = gate_table(example_failed_gate(), false);
  for (const char* part :
       {"slower", "composite", "10.00 -> 11.00 ms", "+10.0% [+8.0%, +12.0%]", "96.1% interval, 60 samples", "limit 0.03",
        "the composite pass takes 10% longer", "view front, pass composite, texture light_map_texture", "1300 -> 1400", "+7.7%",
        "exact", "one tap more", "the interval reaches over the margin", "not compared (1): another machine",
        "1 check is the same", "A/A vertex_normal on vulkan: 1.001 [0.997, 1.004], 60 samples: same",
        "against the main branch; 60 rounds in 3 processes, 41.2 s; margin 2%, confidence 95% over 12 comparisons",
        "vulkan: llvmpipe, Mesa 22.3.6"})
    EXPECT_TRUE(has(table, part)) << part << "\n" << table;
  EXPECT_LT(table.find("regressed\n"), table.find("ambiguous\n"));
  EXPECT_LT(table.find("ambiguous\n"), table.find("better\n"));
  EXPECT_LT(table.find("better\n"), table.find("1 check is the same"));
}

TEST(GateTable, SaysWhereNoTimesWereMeasured) {
  Record record = example_gate(Verdict::slower, 1, {example_fetches()});
  record.gates[0].rounds = record.gates[0].processes = 0;
  const std::string table = gate_table(record, false);
  EXPECT_TRUE(has(table, "against the main branch; no times were measured, 41.2 s\n")) << table;
}

TEST(GateTable, NamesTheEffectOnlyWhereThereAreSeveral) {
  Record record = example_failed_gate();
  EXPECT_FALSE(has(gate_table(record, false), "layered_material/"));
  record.verdicts[1].effect = "another";
  EXPECT_TRUE(has(gate_table(record, false), "another/vertex_normal"));
}

TEST(GateTable, HasColoursOnlyWhereAsked) {
  EXPECT_FALSE(has(gate_table(example_failed_gate(), false), "\x1b"));
  EXPECT_TRUE(gate_table(example_failed_gate(), true).starts_with("\x1b[31mgate FAILED"));
  EXPECT_TRUE(gate_table(example_passed_gate(), true).starts_with("\x1b[32mgate passed"));
}

TEST(GateTable, HoldsNoControlCharactersOfTheRecord) {
  Record record = example_failed_gate();
  record.verdicts[1].sentence = "two\nlines\x1b[2J";
  record.verdicts[1].variant = "a\tb";
  const std::string table = gate_table(record, false);
  EXPECT_TRUE(has(table, "two lines [2J"));
  EXPECT_TRUE(has(table, "a b"));
}

TEST(GateTable, WarnsOfAnArmThatDiffersFromItselfAndOfNone) {
  Record record = example_passed_gate();
  EXPECT_FALSE(has(gate_table(record, false), "unlike itself"));
  record.aas = {example_aa(Verdict::slower)};
  EXPECT_TRUE(has(gate_table(record, false), "unlike itself"));
  record.aas.clear();
  EXPECT_TRUE(has(gate_table(record, false), "no times were judged"));
  record.verdicts.push_back(example_verdict(Verdict::same, "time", "s"));
  record.verdicts.back().ratio = example_interval(1, 0.99, 1.01);
  EXPECT_TRUE(has(gate_table(record, false), "no A/A arm was run"));
  EXPECT_FALSE(has(gate_table(record, false), "no times were judged"));
}

// What must not be taken for a pass: the words of every report say so.
struct NoPass {
  const char* name;
  Record record;
  std::string words;
};
class NotAPass : public testing::TestWithParam<NoPass> {};

TEST_P(NotAPass, InNoReport) {
  const auto& [name, record, words] = GetParam();
  EXPECT_FALSE(reading_of(record).well);
  for (const std::string& text :
       {gate_table(record, false), gate_markdown(record), gate_junit(record), github_annotations(record)}) {
    EXPECT_TRUE(has(text, words)) << text;
    EXPECT_FALSE(has(text, "gate passed")) << text;
  }
  EXPECT_TRUE(has(gate_junit(record), "<error type=\"no answer\""));
  EXPECT_TRUE(has(github_annotations(record), "::error "));
}

Record without_an_answer() {
  Record record = example_passed_gate();
  record.gates.clear();
  return record;
}
Record cut_short() {
  Record record = example_passed_gate();
  record.run["truncated"] = "line 9 is cut short";
  return record;
}

INSTANTIATE_TEST_SUITE_P(
    Gate, NotAPass,
    testing::Values(
        NoPass{"died", without_an_answer(), "did not end"}, NoPass{"cut", cut_short(), "line 9 is cut short"},
        NoPass{"nothing", example_gate(Verdict::same, 0, {}), "nothing was compared"},
        NoPass{"all_left_out", example_gate(Verdict::same, 0, {example_verdict(Verdict::not_compared, "time", "s")}),
               "nothing was compared"},
        NoPass{"regressed", example_gate(Verdict::same, 0, {example_slower()}), "yet figures regressed"},
        NoPass{"ambiguous", example_gate(Verdict::faster, 0, {example_verdict(Verdict::ambiguous, "time", "s")}),
               "yet figures are ambiguous"},
        NoPass{"slower", example_gate(Verdict::slower, 0, {example_slower()}), "yet its status is 0"},
        NoPass{"status", example_gate(Verdict::failed, 1, {example_verdict(Verdict::same, "ssim", "s")}), "justifies it"}),
    [](const auto& test) { return test.param.name; });

TEST(GateMarkdown, FoldsTheWholeMatrixAway) {
  const std::string text = gate_markdown(example_failed_gate());
  EXPECT_TRUE(text.starts_with("### ❌ Lamina gate FAILED: 6 checks: 2 regressed"));
  const size_t fold = text.find("<details><summary>All 6 checks</summary>");
  ASSERT_NE(fold, std::string::npos);
  EXPECT_LT(text.find("one tap more"), fold);
  EXPECT_EQ(text.find("unchanged"), std::string::npos);  // sentences of what is the same are in gate.json
  EXPECT_NE(text.find("| same | ssim | picture |", fold), std::string::npos);
  EXPECT_TRUE(has(text, "\n</details>\n"));
  EXPECT_TRUE(gate_markdown(example_passed_gate()).starts_with("### ✅ Lamina gate passed"));
}

TEST(GateMarkdown, EscapesWhatTheRecordHolds) {
  Record record = example_failed_gate();
  record.verdicts[1].sentence = "a|b <script> [x](y) `c` *d* #1 @someone\n# title";
  const std::string text = gate_markdown(record);
  EXPECT_TRUE(has(text, "a\\|b &lt;script&gt; \\[x\\](y) \\`c\\` \\*d\\* \\#1 @<!-- -->someone \\# title")) << text;
}

TEST(GateMarkdown, StaysWithinACommentAndSaysWhatIsLeftOut) {
  std::vector<VerdictRow> verdicts(3000, example_slower());
  const std::string text = gate_markdown(example_gate(Verdict::slower, 1, verdicts));
  EXPECT_LT(text.size(), 65536u);
  EXPECT_TRUE(has(text, "are left out here; gate.json has all"));
  EXPECT_TRUE(text.ends_with("</details>\n"));
}

TEST(GateJson, IsTheLinesOfTheRecord) {
  const Record record = example_failed_gate();
  const nlohmann::json whole = nlohmann::json::parse(gate_json(record));
  EXPECT_EQ(whole.at("gate"), nlohmann::json(to_json(record.gates[0])));
  ASSERT_EQ(whole.at("aas").size(), 1u);
  EXPECT_EQ(whole["aas"][0], nlohmann::json(to_json(record.aas[0])));
  ASSERT_EQ(whole.at("verdicts").size(), record.verdicts.size());
  for (size_t i = 0; i < record.verdicts.size(); ++i)
    EXPECT_EQ(whole["verdicts"][i], nlohmann::json(to_json(record.verdicts[i])));
  EXPECT_TRUE(nlohmann::json::parse(gate_json(without_an_answer())).at("gate").is_null());
}

}  // namespace
}  // namespace lamina
