// SPDX-License-Identifier: Apache-2.0
// The strips behind a gate's times: what belongs together, what each process says, and what tells nothing.
#include <gtest/gtest.h>

#include <cmath>

#include "reports/gate/strips.h"
#include "reports/html/html.h"
#include "tests/reports/example_gate.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

using Strips = std::vector<StripPair>;

// Strips that took `ratio` times as long after as before, with nothing else between them.
Strips strips_of(double ratio, int count = 8) {
  Strips strips;
  for (int i = 0; i < count; ++i) strips.push_back({5.0 + i, (5 + i) * ratio, i % 2 == 1});
  return strips;
}

PairsRow pairs_of(size_t process, Strips after, Strips again, const std::string& backend = "vulkan") {
  PairedPass pass{"composite", true, {false, false, false}, {{}, {}, {}}, {{}, std::move(after), std::move(again)}};
  return {process, backend, "layered_material", "vertex_normal", "", {"before", "after", "again"}, {std::move(pass)}};
}

Record gate_with(std::vector<PairsRow> pairs) {
  Record record = example_gate(Verdict::slower, 1, {example_slower()});
  record.pairs = std::move(pairs);
  return record;
}

TEST(GateStrips, AreGroupedByWhatWasComparedAndHoldEveryProcess) {
  const Record record =
      gate_with({pairs_of(0, strips_of(1.1), strips_of(1)), pairs_of(0, strips_of(1.2), strips_of(1), "osmesa"),
                 pairs_of(1, strips_of(1.3), strips_of(0.9))});
  const std::vector<GateStrips> all = gate_strips(record);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(words_for_comparison(all[0]), "vertex_normal on vulkan, view , pass composite");
  EXPECT_EQ(words_for_comparison(all[1]), "A/A vertex_normal on vulkan, view , pass composite");
  EXPECT_EQ(all[2].backend, "osmesa");
  ASSERT_EQ(all[0].processes.size(), 2u);
  EXPECT_EQ(all[0].processes[1].number, 1u);
  EXPECT_NEAR(std::exp(all[0].processes[0].estimate.log_ratio), 1.1, 1e-12);
  EXPECT_NEAR(std::exp(all[0].processes[1].estimate.log_ratio), 1.3, 1e-12);
  EXPECT_NEAR(std::exp(all[1].processes[1].estimate.log_ratio), 0.9, 1e-12);
  EXPECT_EQ(all[0].processes[0].strips.size(), 8u);
  EXPECT_TRUE(all[0].processes[0].strips[1].after_first);
}

TEST(GateStrips, HaveTheVerdictOnTheirPassAndNoOther) {
  const std::vector<PairsRow> pairs = {pairs_of(0, strips_of(1.1), strips_of(1)),
                                       pairs_of(0, strips_of(1.2), strips_of(1), "osmesa")};
  const Record record = gate_with(pairs);
  const std::vector<GateStrips> all = gate_strips(record);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].verdict, &record.verdicts[0]);
  EXPECT_EQ(all[1].verdict, nullptr) << "an A/A arm";
  EXPECT_EQ(all[2].verdict, nullptr) << "another backend";
  for (const auto field :
       {&VerdictRow::effect, &VerdictRow::variant, &VerdictRow::view, &VerdictRow::pass, &VerdictRow::what}) {
    Record other = gate_with(pairs);
    other.verdicts[0].*field = "another";
    EXPECT_EQ(gate_strips(other)[0].verdict, nullptr);
  }
}

TEST(GateStrips, AProcessThatTellsNoRatioIsLeftOut) {
  const Strips zero = {{5, 0, false}, {5, 5, true}, {5, 5, false}, {5, 5, true}};
  const Record record = gate_with({pairs_of(0, strips_of(1.1, 2), zero), pairs_of(1, strips_of(1.1), {})});
  const std::vector<GateStrips> all = gate_strips(record);
  ASSERT_EQ(all.size(), 1u);
  ASSERT_EQ(all[0].processes.size(), 1u);
  EXPECT_EQ(all[0].processes[0].number, 1u);
  EXPECT_TRUE(gate_strips(gate_with({})).empty());
}

TEST(GateStrips, ThePageHoldsTheirRatiosAndTheInterval) {
  const Json data = page_data({gate_with({pairs_of(3, strips_of(1.1), strips_of(1))})}).at("strips");
  ASSERT_EQ(data.size(), 2u);
  EXPECT_EQ(data[0].at("words"), "vertex_normal on vulkan, view , pass composite");
  EXPECT_EQ(data[0].at("verdict"), "slower");
  EXPECT_EQ(data[0].at("interval")[0], 1.1);
  EXPECT_EQ(data[0].at("margin"), 0.03) << "the verdict's limit";
  EXPECT_EQ(data[0].at("processes")[0].at("number"), 3);
  EXPECT_EQ(data[0].at("processes")[0].at("ratio"), 1.1);
  EXPECT_EQ(data[0].at("processes")[0].at("strips"), Json(std::vector<double>(8, 1.1)));
  EXPECT_FALSE(data[1].contains("interval"));
  EXPECT_EQ(data[1].at("margin"), 0.02) << "the gate's";
  EXPECT_TRUE(page_data({gate_with({})}).at("strips").empty());
}

TEST(GateStrips, TheTableSaysWhatEachProcessMeasured) {
  const std::string html =
      html_gate(gate_with({pairs_of(0, strips_of(1.1), strips_of(1)), pairs_of(1, strips_of(0.95), strips_of(1))}));
  EXPECT_NE(html.find("<td>+10.0% [+8.0%, +12.0%]</td><td class=\"wrap\">+10.00% &plusmn; 0.00%, -5.00% &plusmn; 0.00%</td>"),
            std::string::npos)
      << html;
  EXPECT_EQ(html_gate(gate_with({})).find("each process"), std::string::npos);
}

}  // namespace
}  // namespace lamina
