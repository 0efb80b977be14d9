// SPDX-License-Identifier: Apache-2.0
// Counts decide, times confirm: rows made by hand, and what a gate makes of them.
#include "harness/gate/verdict.h"

#include <gtest/gtest.h>

#include "harness/core/text.h"
#include "tests/gate/limits_file.h"

namespace lamina {
namespace {

VerdictRow row(const char* what, Verdict verdict, const char* variant = "march") {
  VerdictRow made;
  made.backend = "vulkan", made.effect = "wax", made.variant = variant;
  made.what = what, made.verdict = verdict;
  return made;
}

Verdict time_after(std::vector<VerdictRow> rows, const LimitsFile& limits = {}) {
  let_counts_decide(rows, limits);
  return rows.back().verdict;
}

const VerdictRow same_fetches = row("fetches", Verdict::same), same_operations = row("operations", Verdict::same);
const VerdictRow unsure = row("time", Verdict::ambiguous);

TEST(CountsDecide, ATimeThatNoCountSpeaksAgainstStaysOpen) {
  EXPECT_EQ(time_after({same_fetches, same_operations, unsure}), Verdict::time_open);
  EXPECT_EQ(time_after({same_fetches, row("operations", Verdict::better), unsure}), Verdict::time_open);
  EXPECT_EQ(time_after({same_fetches, same_operations, row("ratio", Verdict::ambiguous)}), Verdict::time_open);
}

TEST(CountsDecide, OpenTimesAreNoFailureAndNoPassByThemselves) {
  std::vector<VerdictRow> rows = {same_fetches, same_operations, unsure};
  EXPECT_EQ(outcome_of(rows).status, 3);
  let_counts_decide(rows, {});
  EXPECT_EQ(outcome_of(rows).status, 0);
  EXPECT_EQ(outcome_of(rows).verdict, Verdict::same);
  EXPECT_EQ(outcome_of(std::vector{rows.back()}).status, 3) << "nothing else was compared";
}

TEST(CountsDecide, MoreOfAnythingOrAnotherPictureLeavesTimesAmbiguous) {
  for (const VerdictRow& against :
       {row("fetches", Verdict::worse), row("operations", Verdict::worse), row("vertices", Verdict::worse),
        row("ssim", Verdict::worse), row("picture", Verdict::worse), row("nonfinite", Verdict::failed),
        row("operations", Verdict::not_compared)})
    EXPECT_EQ(time_after({same_fetches, same_operations, against, unsure}), Verdict::ambiguous) << against.what;
}

TEST(CountsDecide, MoreThatIsAllowedIsMore) {
  for (const char* what : {"fetches", "operations", "vertices", "fragments"}) {
    VerdictRow allowed = row(what, Verdict::same);
    allowed.pass = "composite", allowed.before = 100, allowed.after = 101;
    EXPECT_EQ(time_after({same_fetches, same_operations, allowed, unsure}), Verdict::ambiguous) << what;
  }
}

TEST(CountsDecide, WhatWasNotCountedDecidesNothing) {
  EXPECT_EQ(time_after({unsure}), Verdict::ambiguous);
  EXPECT_EQ(time_after({same_fetches, unsure}), Verdict::ambiguous);
  EXPECT_EQ(time_after({same_operations, unsure}), Verdict::ambiguous);
  EXPECT_EQ(time_after({row("fetches", Verdict::same, "other"), row("operations", Verdict::same, "other"), unsure}),
            Verdict::ambiguous)
      << "another variant's counts";
}

TEST(CountsDecide, TheGateFileMayAskThatTimesDecide) {
  const LimitsFile limits =
      limits_of("[[limit]]\nvariant = \"march\"\ntimes = \"must_decide\"\n", {{"wax"}, {"march"}, {"vulkan"}});
  EXPECT_EQ(time_after({same_fetches, same_operations, unsure}, limits), Verdict::ambiguous);
  const VerdictRow timer = [] {
    VerdictRow made;
    made.backend = "vulkan", made.what = "timer", made.verdict = Verdict::ambiguous;
    return made;
  }();
  EXPECT_EQ(time_after({same_fetches, same_operations, timer}, limits), Verdict::ambiguous);
  EXPECT_EQ(time_after({same_fetches, same_operations, timer}), Verdict::time_open);
  EXPECT_EQ(time_after({same_fetches, timer}), Verdict::ambiguous);
}

TEST(CountsDecide, ASlowerTimeStaysSlowerAndSaysThatCountsDoNotExplainIt) {
  std::vector<VerdictRow> rows = {same_fetches, same_operations, row("time", Verdict::slower)};
  let_counts_decide(rows, {});
  EXPECT_EQ(rows.back().verdict, Verdict::slower);
  EXPECT_EQ(rows.back().counts_hold, true);
  rows = {same_fetches, row("operations", Verdict::worse), row("time", Verdict::slower)};
  let_counts_decide(rows, {});
  EXPECT_FALSE(rows.back().counts_hold) << "counts explain it";
}

}  // namespace
}  // namespace lamina
