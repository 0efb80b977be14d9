// SPDX-License-Identifier: Apache-2.0
// Pairs of frames whose times are made up: what is judged, how samples of several processes are joined, what is refused.
#include "harness/gate/pairs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/core/error.h"

namespace lamina {
namespace {

// Twelve rounds in each of three processes: pass "small" takes 1 ms (not cut), "large" 10 ms a round (cut, 40 ms a frame).
std::vector<PairsRow> pairs(double small_ratio, double large_ratio, double again_ratio = 1) {
  std::vector<PairsRow> rows;
  for (size_t process = 0; process < 3; ++process) {
    PairsRow row{process, "vulkan", "layered_material", "light_map", "front", {"before", "after", "again"}, {}};
    const auto rounds = [](double ms) { return std::vector<double>(12, ms); };
    row.passes.push_back({"small", false, {rounds(1), rounds(small_ratio), rounds(1)}, {{}, rounds(small_ratio), rounds(1)}});
    row.passes.push_back({"large",
                          true,
                          {rounds(10), rounds(10 * large_ratio), rounds(10 * again_ratio)},
                          {{}, rounds(large_ratio), rounds(again_ratio)}});
    rows.push_back(row);
  }
  return rows;
}

const VerdictRow* find(const TimeReport& report, const std::string& pass) {
  for (const VerdictRow& row : report.rows)
    if (row.pass == pass) return &row;
  return nullptr;
}

TEST(Pairs, FrameAndLargePassesAreJudgedSmallOnesWithinTheFrame) {
  const TimeReport report = judge_pairs(pairs(1, 1.1), {}, 0.05);
  ASSERT_TRUE(find(report, ""));
  ASSERT_TRUE(find(report, "large"));
  EXPECT_FALSE(find(report, "small")) << "1 of 41 ms";
  EXPECT_EQ(find(report, "large")->verdict, Verdict::slower);
  EXPECT_NEAR(find(report, "large")->ratio->median, 1.1, 1e-12);
  // A round of the frame: 10 ms of strips and a fourth of the 1 ms that is run whole.
  EXPECT_NEAR(find(report, "")->ratio->median, (11 + 0.25) / (10 + 0.25), 1e-12);
  EXPECT_NEAR(*find(report, "large")->before, 40, 1e-12) << "the whole pass";
  EXPECT_NEAR(*find(report, "")->before, 41, 1e-12);
  EXPECT_EQ(report.comparisons, 2u);
  EXPECT_EQ(report.rounds, 36u);
}

TEST(Pairs, ASmallPassThatGrewIsJudged) {
  const TimeReport report = judge_pairs(pairs(5, 1), {}, 0.05);
  ASSERT_TRUE(find(report, "small"));
  EXPECT_EQ(find(report, "small")->verdict, Verdict::slower);
}

TEST(Pairs, EqualFramesThatDifferTakeTheTrustAway) {
  EXPECT_EQ(judge_pairs(pairs(1, 1.1), {}, 0.05).same_arms.front().verdict, Verdict::same);
  const TimeReport report = judge_pairs(pairs(1, 1.1, 1.1), {}, 0.05);
  EXPECT_EQ(report.same_arms.front().verdict, Verdict::slower);
  EXPECT_EQ(find(report, "large")->verdict, Verdict::ambiguous);
  EXPECT_NE(find(report, "large")->sentence.find("not believed"), std::string::npos);
  EXPECT_EQ(report.undecided, std::set<std::string>{"vulkan"});
}

TEST(Pairs, TimesOfZeroAreRefused) {
  std::vector<PairsRow> rows = pairs(1, 1);
  rows[1].passes[1].ratio[1][3] = 0;
  EXPECT_THROW(judge_pairs(rows, {}, 0.05), Error);
  EXPECT_THROW(trimmed_ratio({{1, 1}, {0, 1}}), Error);
  EXPECT_THROW(trimmed_ratio({{1, 0}}), Error);
  EXPECT_THROW(trimmed_ratio({}), Error);
}

TEST(Pairs, AFrameOfOnePassIsJudgedOnce) {
  std::vector<PairsRow> rows = pairs(1, 1);
  for (PairsRow& row : rows) row.passes.erase(row.passes.begin());
  EXPECT_EQ(judge_pairs(rows, {}, 0.05).comparisons, 1u);
}

TEST(Pairs, OnlyEqualFramesGiveNoVerdictButTheirOwn) {
  std::vector<PairsRow> rows = pairs(1, 1);
  for (PairsRow& row : rows) {
    row.frames = {"before", "again"};
    for (PairedPass& pass : row.passes) pass.ms.erase(pass.ms.begin() + 1), pass.ratio.erase(pass.ratio.begin() + 1);
  }
  const TimeReport report = judge_pairs(rows, {}, 0.05);
  EXPECT_TRUE(report.rows.empty());
  EXPECT_EQ(report.same_arms.size(), 1u);
}

TEST(Pairs, ComeBackFromTheirLine) {
  const PairsRow row = pairs(1.25, 1.5).front();
  const PairsRow back = pairs_from_json(nlohmann::json::parse(to_json(row).dump()));
  EXPECT_EQ(back.frames, row.frames);
  EXPECT_EQ(back.passes[1].ms, row.passes[1].ms);
  EXPECT_EQ(back.passes[1].ratio, row.passes[1].ratio);
  EXPECT_TRUE(back.passes[1].cut);
  EXPECT_EQ(back.variant, "light_map");
}

TEST(TrimmedRatio, IsTheRatioOfEqualStripsAndOfTheirTimesTurnedRound) {
  EXPECT_NEAR(trimmed_ratio({{2, 3}, {4, 6}, {1, 1.5}}), 1.5, 1e-12);
  const std::vector<StripPair> strips = {{2, 3}, {4, 5}, {1, 1.2}, {7, 7.1}}, turned = {{3, 2}, {5, 4}, {1.2, 1}, {7.1, 7}};
  EXPECT_NEAR(trimmed_ratio(strips) * trimmed_ratio(turned), 1, 1e-12);
}

// One strip in ten met something else that ran: its ratio does not count.
TEST(TrimmedRatio, StripsThatMetAnotherProcessDoNotCount) {
  std::vector<StripPair> strips(10, {2, 2.2});
  strips[4].after = 3.0;
  EXPECT_NEAR(trimmed_ratio(strips), 1.1, 1e-12);
  strips[4] = {2.6, 2.2};
  EXPECT_NEAR(trimmed_ratio(strips), 1.1, 1e-12);
}

// Half of the weight is slower by 1.5: half of the middle 60% is, which gives the geometric mean of 1 and 1.5. A tenth does not
// show.
TEST(TrimmedRatio, AChangeOfPartOfThePictureShowsInPart) {
  std::vector<StripPair> strips(10, {1, 1});
  for (size_t i = 0; i < 5; ++i) strips[i] = {1 / std::sqrt(1.5), std::sqrt(1.5)};  // a weight of 1
  EXPECT_NEAR(trimmed_ratio(strips), std::sqrt(1.5), 1e-12);
  for (size_t i = 1; i < 5; ++i) strips[i] = {1, 1};
  EXPECT_NEAR(trimmed_ratio(strips), 1, 1e-12);
}

TEST(FrameRatios, PassesCountByTheirTimesAndNewOnesWithTheirs) {
  const PairedPass both{"both", true, {{10, 10}, {11, 12}}, {{}, {1.1, 1.2}}};
  const PairedPass fresh{"fresh", false, {{}, {4, 4}}, {{}, {}}};
  const std::vector<double> ratios = frame_ratios({both, fresh}, 1);
  ASSERT_EQ(ratios.size(), 2u);
  EXPECT_NEAR(ratios[0], (11 + 1.0) / 10, 1e-12) << "4 ms run whole in each of four rounds";
  EXPECT_NEAR(ratios[1], (12 + 1.0) / 10, 1e-12);
  const PairedPass gone{"gone", true, {{10, 10}, {}}, {{}, {}}};
  EXPECT_NEAR(frame_ratios({both, gone}, 1)[0], 11.0 / 20, 1e-12);
}

// Cut: kinds of rounds lie over different strips, so the whole is the sum of the kinds' medians.
TEST(WholeTime, SumsTheKindsOfRounds) {
  PairedPass pass{"p", true, {{1, 2, 3, 4, 1, 2, 3, 40, 1, 2, 3, 4}}, {}};
  EXPECT_DOUBLE_EQ(*whole_ms(pass, 0), 10);
  pass.cut = false;
  EXPECT_DOUBLE_EQ(*whole_ms(pass, 0), 2.5);
  EXPECT_FALSE(whole_ms({"p", true, {{1, 2, 3}}, {}}, 0));
}

}  // namespace
}  // namespace lamina
