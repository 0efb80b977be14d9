// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/calibration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/core/text.h"
#include "tests/folder.h"

namespace lamina {
namespace {

// Both ends p of Wilson's interval solve |hits / of - p| = z sqrt(p (1 - p) / of).
TEST(ShareInterval, EndsAreWhereTheShareIsJustLikely) {
  for (const auto& [hits, of] : {std::pair<size_t, size_t>{0, 200}, {1, 3}, {5, 10}, {39, 40}, {200, 200}}) {
    const auto [low, high] = share_interval(hits, of);
    const double n = static_cast<double>(of), share = static_cast<double>(hits) / n;
    for (const double end : {low, high}) {
      if (end < 1e-9 || end > 1 - 1e-9) continue;  // there both sides vanish
      EXPECT_NEAR(std::abs(share - end), 1.959964 * std::sqrt(end * (1 - end) / n), 1e-9) << hits << " of " << of;
    }
    EXPECT_LE(low, share);
    EXPECT_GE(high, share - 1e-12);
  }
  EXPECT_NEAR(share_interval(0, 200).second, 1.959964 * 1.959964 / (200 + 1.959964 * 1.959964), 1e-12);
}

// Three processes of 16 rounds of one pass, whose ratios are `ratio` and a little to either side.
std::vector<PairsRow> pairs_with(double ratio) {
  std::vector<PairsRow> rows;
  for (size_t process = 0; process < 3; ++process) {
    PairedPass pass{"composite", true, {false, false}, {{}, {}}, {{}, {}}};
    for (int round = 0; round < 16; ++round) {
      const double here = ratio * (round % 2 == 0 ? 1.001 : 0.999);
      pass.ms[0].push_back(10), pass.ms[1].push_back(10 * here);
      pass.strips[1].push_back({10, 10 * here, round % 4 < 2});
    }
    rows.push_back({process, "vulkan", "layered_material", "light_map", "front", {"before", "after"}, {pass}});
  }
  return rows;
}

TEST(Calibration, GatesAreJudgedByTheDefaultMargin) {
  EXPECT_EQ(judge_calibrated(0, pairs_with(1), 0.05, "composite").verdict, Verdict::same);
  EXPECT_EQ(judge_calibrated(0.1, pairs_with(1.1), 0.05, "composite").verdict, Verdict::slower);
  EXPECT_EQ(judge_calibrated(0, pairs_with(0.9), 0.05, "composite").verdict, Verdict::faster);
  EXPECT_EQ(judge_calibrated(0.015, pairs_with(1.015), 0.05, "composite").verdict, Verdict::ambiguous);
  const CalibratedGate gate = judge_calibrated(0.1, pairs_with(1.1), 0.05, "composite");
  ASSERT_EQ(gate.ratios.size(), 1u);
  EXPECT_NEAR(gate.ratios[0], 1.1, 1e-6);
  EXPECT_TRUE(judge_calibrated(0.1, pairs_with(1.1), 0.05, "light").ratios.empty());
}

TEST(Calibration, TheTableCountsEveryGateOnce) {
  const std::vector<CalibratedGate> gates = {{0, Verdict::same, {1.0}},       {0, Verdict::slower, {1.02}},
                                             {0, Verdict::faster, {0.98}},    {0, Verdict::ambiguous, {}},
                                             {0.03, Verdict::slower, {1.03}}, {0.03, Verdict::ambiguous, {1.01}},
                                             {0.01, Verdict::faster, {1.0}}};
  const std::string table = calibration_table(gates);
  EXPECT_NE(table.find("| none: false alarms | 4 | 50.0% (15.0 to 85.0) | 25.0% | 25.0% | 1.0000 |"), std::string::npos)
      << table;
  EXPECT_NE(table.find("| 3% | 2 | 50.0% (9.5 to 90.5) | 50.0% | 0.0% | 1.0200 |"), std::string::npos) << table;
  EXPECT_NE(table.find("| 1% | 1 | 0.0% (0.0 to 79.3) | 0.0% | 100.0% | 1.0000 |"), std::string::npos) << table;
  EXPECT_LT(table.find("| none"), table.find("| 1%"));
}

class CalibrationFile : public InFolder<> {
 protected:
  const std::filesystem::path file_ = folder_ / "calibration.jsonl";
};

TEST_F(CalibrationFile, IsReadBackUpToALineThatWasCutShort) {
  EXPECT_TRUE(read_calibration(file_).empty()) << "no file";
  const CalibratedGate gate{0.05, Verdict::ambiguous, {1.05, 1.04}};
  const std::string whole = "{\"kind\":\"calibration\"}\n" + to_json(gate).dump() + "\n";
  for (const std::string& torn : {std::string(), std::string("{\"slow"), to_json(gate).dump()}) {
    write_file_atomically(file_, whole + torn);
    const std::vector<nlohmann::json> lines = read_calibration(file_);
    ASSERT_EQ(lines.size(), 2u) << torn;
    const CalibratedGate back = calibrated_from_json(lines[1]);
    EXPECT_EQ(back.slow_down, gate.slow_down);
    EXPECT_EQ(back.verdict, gate.verdict);
    EXPECT_EQ(back.ratios, gate.ratios);
  }
}

TEST_F(CalibrationFile, WhatIsNoneIsRefusedWithItsLine) {
  const std::string first = "{\"kind\":\"calibration\"}\n";
  for (const auto& [text, line] : {std::pair<std::string, int>{"{\"kind\":\"run\"}\n", 1},
                                   {"nothing\n", 1},
                                   {"[1]\n", 1},
                                   {"{\"kind\":7}\n", 1},
                                   {first + "{\"slow_down\":0,\"verdict\":\"worse\",\"ratios\":[]}\n", 2},
                                   {first + "{\"slow_down\":0}\n", 2}}) {
    write_file_atomically(file_, text);
    try {
      read_calibration(file_);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_NE(std::string(error.what()).find(fmt::format(":{}", line)), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace lamina
