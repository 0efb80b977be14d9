// SPDX-License-Identifier: Apache-2.0
// Pairs of frames whose times are made up: what is judged, how samples of several processes are joined, what is refused.
#include "harness/gate/pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "harness/core/error.h"
#include "tests/gate/limits_file.h"
#include "tests/record/read_back.h"

namespace lamina {
namespace {

// A pass that took these times in each of twelve rounds: before, after and before again, a strip a round.
PairedPass pass_of(const char* name, bool cut, double before, double after, double again) {
  PairedPass pass{name, cut, std::vector<bool>(3), {}, std::vector<std::vector<StripPair>>(3)};
  for (const double ms : {before, after, again}) pass.ms.emplace_back(12, ms);
  for (int round = 0; round < 12; ++round) {
    pass.strips[1].push_back({before, after, round % 2 == 0});
    pass.strips[2].push_back({before, again, round % 3 == 0});
  }
  return pass;
}

// In each of three processes: pass "small" takes 1 ms (not cut), "large" 10 ms a round (cut, 40 ms a frame).
std::vector<PairsRow> pairs(double small_ratio, double large_ratio, double again_ratio = 1) {
  std::vector<PairsRow> rows;
  for (size_t process = 0; process < 3; ++process)
    rows.push_back(
        {process,
         "vulkan",
         "layered_material",
         "light_map",
         "front",
         {"before", "after", "again"},
         {pass_of("small", false, 1, small_ratio, 1), pass_of("large", true, 10, 10 * large_ratio, 10 * again_ratio)}});
  return rows;
}

const VerdictRow* find(const TimeReport& report, const std::string& pass) {
  for (const VerdictRow& row : report.rows)
    if (row.pass == pass) return &row;
  return nullptr;
}

// 41 ms before, 45 ms after.
TEST(Pairs, AFrameKeepsToItsBoundInMilliseconds) {
  const auto too_long = [](const char* text) {
    const TimeReport report = judge_pairs(pairs(1, 1.1), limits_of(text), 0.05);
    return std::ranges::count_if(report.rows, [](const VerdictRow& row) {
      return row.what == "frame_ms" && row.verdict == Verdict::failed && row.pass.empty();
    });
  };
  EXPECT_EQ(too_long("[default]\nmax_frame_ms = 45.1\n"), 0);
  EXPECT_EQ(too_long("[default]\nmax_frame_ms = 44.9\n"), 1);
}

TEST(Pairs, FrameAndLargePassesAreJudgedSmallOnesWithinTheFrame) {
  const TimeReport report = judge_pairs(pairs(1, 1.1), {}, 0.05);
  ASSERT_TRUE(find(report, ""));
  ASSERT_TRUE(find(report, "large"));
  EXPECT_FALSE(find(report, "small")) << "1 of 41 ms, less than a tenth";
  EXPECT_EQ(find(report, "large")->verdict, Verdict::slower);
  EXPECT_NEAR(find(report, "large")->ratio->median, 1.1, 1e-12);
  EXPECT_NEAR(find(report, "")->ratio->median, 45.0 / 41, 1e-12) << "passes count by what they last as a whole";
  EXPECT_NEAR(*find(report, "large")->before, 40, 1e-12) << "the whole pass";
  EXPECT_NEAR(*find(report, "large")->after, 44, 1e-9);
  EXPECT_NEAR(*find(report, "")->before, 41, 1e-12);
  EXPECT_EQ(report.comparisons, 2u);
  EXPECT_EQ(report.rounds, 36u);
}

TEST(Pairs, AGateFileSaysHowSmallAPassIsJudgedByItself) {
  const LimitsFile limits = limits_of("[default]\nmin_pass_share = \"2%\"\n");
  ASSERT_TRUE(find(judge_pairs(pairs(1.1, 1), limits, 0.05), "small"));
  EXPECT_EQ(find(judge_pairs(pairs(1.1, 1), limits, 0.05), "small")->verdict, Verdict::slower);
}

// Five processes at 3.5% and half a percent or one to either side: the error of their mean, 0.35%, is 5.5 of them short of the
// margin, which by four degrees of freedom is too few for one of ten comparisons. That all ten scatter so makes it enough.
TEST(Pairs, ComparisonsTellTogetherHowProcessesDisagree) {
  const auto gate = [](size_t variants) {
    std::vector<PairsRow> rows;
    for (size_t variant = 0; variant < variants; ++variant)
      for (size_t process = 0; process < 5; ++process) {
        PairedPass pass{"composite", true, {false, false}, {{}, {}}, {{}, {}}};
        const double ratio = 1.035 * std::exp(0.005 * (static_cast<double>(process) - 2));
        for (int round = 0; round < 12; ++round) {
          pass.ms[0].push_back(10), pass.ms[1].push_back(10 * ratio);
          pass.strips[1].push_back({10, 10 * ratio * (round % 3 == 0 ? 1.001 : 0.9995), round % 2 == 0});
        }
        rows.push_back({process, "vulkan", "layered_material", std::to_string(variant), "front", {"before", "after"}, {pass}});
      }
    return judge_pairs(rows, {}, 0.05 * static_cast<double>(variants) / 10);  // each at the error of one of ten
  };
  EXPECT_EQ(gate(1).rows.front().verdict, Verdict::ambiguous);
  for (const VerdictRow& row : gate(10).rows) EXPECT_EQ(row.verdict, Verdict::slower);
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
  EXPECT_EQ(find(report, "large")->cause, Cause::arm_differs);
  EXPECT_EQ(find(report, "large")->details, std::vector<std::string>{"slower"}) << "by its figures";
  EXPECT_EQ(report.undecided, (std::set<TimedCell>{{"vulkan", "layered_material", "light_map"}}));
}

TEST(Pairs, TimesOfZeroAreRefused) {
  std::vector<PairsRow> rows = pairs(1, 1);
  rows[1].passes[1].strips[1][3].after = 0;
  EXPECT_THROW(judge_pairs(rows, {}, 0.05), Error);
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
    for (PairedPass& pass : row.passes) pass.ms.erase(pass.ms.begin() + 1), pass.strips.erase(pass.strips.begin() + 1);
  }
  const TimeReport report = judge_pairs(rows, {}, 0.05);
  EXPECT_TRUE(report.rows.empty());
  EXPECT_EQ(report.same_arms.size(), 1u);
}

TEST(Pairs, ComeBackFromTheirLine) {
  const PairsRow row = pairs(1.25, 1.5).front();
  const PairsRow back = read_back(row);
  EXPECT_EQ(back.frames, row.frames);
  EXPECT_EQ(back.passes[1].ms, row.passes[1].ms);
  ASSERT_EQ(back.passes[1].strips.size(), 3u);
  ASSERT_EQ(back.passes[1].strips[1].size(), 12u);
  for (size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(back.passes[1].strips[1][i].before, 10);
    EXPECT_EQ(back.passes[1].strips[1][i].after, 15);
    EXPECT_EQ(back.passes[1].strips[1][i].after_first, i % 2 == 0);
  }
  EXPECT_TRUE(back.passes[1].cut);
  EXPECT_EQ(back.variant, "light_map");
}

TEST(Estimates, ThoseOfPassesAreJoinedByTheirTimes) {
  PairsRow row = pairs(2, 1.1).front();
  EXPECT_NEAR(std::exp(estimate_of(row, "after", 1).log_ratio), 1.1, 1e-12);
  EXPECT_NEAR(std::exp(estimate_of(row, "after").log_ratio), (2 + 44) / 41.0, 1e-12);
  EXPECT_NEAR(std::exp(estimate_of(row, "again").log_ratio), 1, 1e-12);
  // An error of the large pass is one of the frame in the share of its time.
  for (size_t i = 0; i < 12; ++i) row.passes[1].strips[1][i].after *= i % 3 == 0 ? 1.05 : i % 3 == 1 ? 1 : 0.95;
  const double of_pass = estimate_of(row, "after", 1).error;
  EXPECT_GT(of_pass, 0.005);
  const double share = 40 * std::exp(estimate_of(row, "after", 1).log_ratio);
  EXPECT_NEAR(estimate_of(row, "after").error, of_pass * share / (2 + share), 1e-6);
  EXPECT_THROW(estimate_of(row, "before"), Error);
  EXPECT_THROW(estimate_of(row, "none"), Error);
}

TEST(Estimates, PassesOfOneFrameAloneCountWithTheirTimes) {
  PairsRow row = pairs(1, 1.1).front();
  row.passes[0].ms[0].clear(), row.passes[0].strips[1].clear();  // a pass that is new, of 1 ms
  EXPECT_NEAR(std::exp(estimate_of(row, "after").log_ratio), (44 + 1) / 40.0, 1e-12);
  row = pairs(1, 1.1).front();
  row.passes[0].ms[1].clear(), row.passes[0].strips[1].clear();  // one that is gone
  EXPECT_NEAR(std::exp(estimate_of(row, "after").log_ratio), 44 / 41.0, 1e-12);
}

// A pass whose code is the same was not run after: it counts as it was before, without an error, and is not judged.
TEST(Estimates, PassesThatAreTheSameCountAsBefore) {
  std::vector<PairsRow> rows = pairs(1, 1);
  for (PairsRow& row : rows) {
    PairedPass& large = row.passes[1];
    large.same[1] = true, large.ms[1].clear(), large.strips[1].clear();
    large.ms[0].resize(4);  // one whole frame tells how long it lasts
    for (StripPair& strip : row.passes[0].strips[1]) strip.after = 5;
    EXPECT_NEAR(std::exp(estimate_of(row, "after").log_ratio), (40 + 5) / 41.0, 1e-12);
    row.passes[0].ms[1].assign(12, 5);
  }
  const TimeReport report = judge_pairs(rows, {}, 0.05);
  ASSERT_TRUE(find(report, ""));
  EXPECT_EQ(find(report, "")->verdict, Verdict::slower);
  EXPECT_FALSE(find(report, "large"));
  const PairsRow back = read_back(rows[0]);
  EXPECT_EQ(back.passes[1].same, (std::vector<bool>{false, true, false}));
}

TEST(Estimates, TheWorstErrorIsOverTheMargin) {
  PairsRow row = pairs(1, 1).front();
  EXPECT_NEAR(worst_error(row, {}), 0, 1e-9);
  for (size_t i = 0; i < 12; ++i) row.passes[1].strips[1][i].after *= i % 3 == 0 ? 1.05 : i % 3 == 1 ? 1 : 0.95;
  EXPECT_NEAR(worst_error(row, {}), estimate_of(row, "after", 1).error / Limits().max_slowdown, 1e-12);
  row = pairs(1, 1).front();
  for (size_t i = 0; i < 12; ++i) row.passes[1].strips[2][i].after *= i % 3 == 0 ? 1.05 : i % 3 == 1 ? 1 : 0.95;
  EXPECT_NEAR(worst_error(row, {}), estimate_of(row, "again").error / Limits().max_slowdown, 1e-12);
}

// Cut: kinds of rounds lie over different strips, so the whole is the sum of the kinds' medians.
TEST(WholeTime, SumsTheKindsOfRounds) {
  PairedPass pass{"p", true, {false}, {{1, 2, 3, 4, 1, 2, 3, 40, 1, 2, 3, 4}}, {}};
  EXPECT_DOUBLE_EQ(*whole_ms(pass, 0), 10);
  pass.cut = false;
  EXPECT_DOUBLE_EQ(*whole_ms(pass, 0), 2.5);
  EXPECT_FALSE(whole_ms({"p", true, {false}, {{1, 2, 3}}, {}}, 0));
}

}  // namespace
}  // namespace lamina
