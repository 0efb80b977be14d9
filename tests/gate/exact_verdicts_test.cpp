// SPDX-License-Identifier: Apache-2.0
// Counts, pictures and errors of cells made by hand: each kind of change alone, and nothing else, changes the verdict.
#include "harness/gate/exact_verdicts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "harness/gate/verdict.h"
#include "tests/reports/example_record.h"

namespace lamina {
namespace {

CellRow cell(const std::string& view = "front", const std::string& variant = "vertex_normal") {
  CellRow row = example_cell(variant, view, {});
  row.image_hash = "hash of " + view;
  return row;
}

// The rows for one variant of two views; `change` is made to the cells after.
template <class Change>
std::vector<VerdictRow> rows_after(Change&& change, const Limits& limits = {}, std::optional<double> changed_by = 0.0,
                                   const std::string& variant = "vertex_normal") {
  CellPair pair;
  for (const char* view : {"front", "side"}) {
    CellRow before = cell(view, variant), after = before;
    change(after);
    pair.before.push_back(before);
    pair.after.push_back(after);
    pair.changes.push_back(changed_by);
  }
  return judge_cells(pair, limits);
}

size_t count(const std::vector<VerdictRow>& rows, std::string_view what, Verdict verdict) {
  return static_cast<size_t>(std::count_if(rows.begin(), rows.end(),
                                           [&](const VerdictRow& row) { return row.what == what && row.verdict == verdict; }));
}
int status(const std::vector<VerdictRow>& rows) { return outcome_of(rows).status; }

TEST(ExactVerdicts, NothingChangedIsTheSameAndOneRowAKind) {
  const auto rows = rows_after([](CellRow&) {});
  EXPECT_EQ(status(rows), 0);
  EXPECT_EQ(outcome_of(rows).verdict, Verdict::same);
  for (const char* what : {"fetches", "errors", "nonfinite", "blank"}) EXPECT_EQ(count(rows, what, Verdict::same), 1u) << what;
  EXPECT_EQ(rows.size(), 4u);
}

TEST(ExactVerdicts, OneFetchMoreIsWorseAndOneLessBetter) {
  const auto more = rows_after([](CellRow& after) { after.passes[0].by_texture[1].fetches += 1; });
  EXPECT_EQ(count(more, "fetches", Verdict::worse), 2u) << "in each view";
  EXPECT_EQ(more[0].texture, "outer_albedo (rgba8_srgb, trilinear)");
  EXPECT_EQ(more[0].before, 200);
  EXPECT_EQ(more[0].after, 201);
  EXPECT_EQ(status(more), 1);
  const auto less = rows_after([](CellRow& after) { after.passes[0].by_texture[1].fetches -= 1; });
  EXPECT_EQ(count(less, "fetches", Verdict::better), 2u);
  EXPECT_EQ(status(less), 0);
}

TEST(ExactVerdicts, TheAllowanceIsAShareOfWhatThereWas) {
  Limits limits;
  limits.max_extra_fetches = 0.01;
  EXPECT_EQ(status(rows_after([](CellRow& after) { after.passes[0].by_texture[1].fetches = 202; }, limits)), 0);
  EXPECT_EQ(status(rows_after([](CellRow& after) { after.passes[0].by_texture[1].fetches = 203; }, limits)), 1);
}

// A cell whose first pass executes these operations before, and those after.
std::vector<VerdictRow> rows_of_operations(const std::map<std::string, uint64_t>& before,
                                           const std::map<std::string, uint64_t>& after, const Limits& limits = {}) {
  CellPair pair{{cell()}, {cell()}, {0.0}};
  pair.before[0]->passes[0].operations = before;
  pair.after[0]->passes[0].operations = after;
  return judge_cells(pair, limits);
}

TEST(ExactVerdicts, AnOperationMoreIsWorseAndOneLessBetter) {
  EXPECT_EQ(count(rows_of_operations({{"float_add", 100}}, {{"float_add", 100}}), "operations", Verdict::same), 1u);
  const auto more = rows_of_operations({{"float_add", 100}, {"exp", 7}}, {{"float_add", 101}, {"exp", 7}});
  ASSERT_EQ(count(more, "operations", Verdict::worse), 1u);
  EXPECT_EQ(more[0].before, 107);
  EXPECT_EQ(more[0].after, 108);
  ASSERT_EQ(more[0].operations.size(), 1u) << "exp is as before";
  EXPECT_EQ(more[0].operations[0].operation, "float_add");
  EXPECT_EQ(more[0].operations[0].before, 100);
  EXPECT_EQ(more[0].operations[0].after, 101);
  EXPECT_EQ(status(more), 1);
  EXPECT_EQ(count(rows_of_operations({{"float_add", 100}}, {{"float_add", 99}}), "operations", Verdict::better), 1u);
  Limits limits;
  limits.max_extra_operations = 0.01;
  EXPECT_EQ(status(rows_of_operations({{"float_add", 100}}, {{"float_add", 101}}, limits)), 0);
  EXPECT_EQ(status(rows_of_operations({{"float_add", 100}}, {{"float_add", 102}}, limits)), 1);
  EXPECT_EQ(status(rows_of_operations({{"float_add", 100}}, {{"float_add", 100}, {"exp", 1}}, limits)), 1) << "a new class";
}

// Two multiplications for a power: no count says which costs more.
TEST(ExactVerdicts, OperationsThatAreTradedAreForTimesToJudge) {
  const auto rows = rows_of_operations({{"pow", 100}}, {{"float_multiply", 200}});
  EXPECT_EQ(count(rows, "operations", Verdict::not_compared), 1u);
  EXPECT_EQ(status(rows), 0);
}

TEST(ExactVerdicts, ARecordWithoutOperationsIsNotComparedByThem) {
  EXPECT_EQ(count(rows_of_operations({}, {{"pow", 100}}), "operations", Verdict::not_compared), 1u);
  EXPECT_EQ(count(rows_of_operations({}, {}), "operations", Verdict::same), 0u);
}

TEST(ExactVerdicts, AFrameKeepsToItsBoundsOfWork) {
  Limits limits;
  limits.max_frame_operations = 100, limits.max_target_bytes = 4096;
  const auto with = [&](std::optional<uint64_t> operations, std::optional<uint64_t> bytes) {
    CellPair pair{{cell()}, {cell()}, {0.0}};
    for (std::optional<CellRow>* side : {&pair.before[0], &pair.after[0]}) {
      if (operations) (*side)->passes[0].operations = {{"float_add", *operations}};
      (*side)->target_bytes = bytes;
    }
    return judge_cells(pair, limits);
  };
  EXPECT_EQ(status(with(100, 4096)), 0);
  EXPECT_EQ(count(with(101, 4096), "operations", Verdict::failed), 1u);
  EXPECT_EQ(count(with(100, 4097), "target_bytes", Verdict::failed), 1u);
  EXPECT_EQ(count(with(std::nullopt, 4096), "operations", Verdict::failed), 1u) << "a bound on what nobody counted";
}

TEST(ExactVerdicts, AnotherFormatOrANewPassIsSeen) {
  EXPECT_EQ(status(rows_after([](CellRow& after) { after.passes[0].by_texture[0].format = "rgba32_float"; })), 1);
  EXPECT_EQ(status(rows_after([](CellRow& after) {
              PassRow extra;
              extra.name = "extra";
              extra.fragments = 10;
              after.passes.push_back(extra);
            })),
            1);
}

TEST(ExactVerdicts, ErrorsAreWorseBeyondTheirToleranceAlone) {
  const Limits limits;
  EXPECT_EQ(status(rows_after([](CellRow& after) { after.error_covered->ssim -= 0.00009; })), 0);
  EXPECT_EQ(count(rows_after([](CellRow& after) { after.error_covered->ssim -= 0.00011; }), "ssim", Verdict::worse), 2u);
  EXPECT_EQ(count(rows_after([](CellRow& after) { after.error_covered->ssim += 0.00011; }), "ssim", Verdict::better), 2u);
  EXPECT_EQ(count(rows_after([](CellRow& after) { after.error_covered->psnr_db -= 0.06; }), "psnr_db", Verdict::worse), 2u);
  EXPECT_EQ(count(rows_after([](CellRow& after) { after.error_covered->flip += 0.0002; }), "flip", Verdict::worse), 2u);
  EXPECT_EQ(
      count(rows_after([](CellRow& after) { after.error_covered->rmse_linear += 0.0002; }), "rmse_linear", Verdict::worse), 2u);
  EXPECT_EQ(count(rows_after([](CellRow& after) { after.error_covered->max_linear += 0.003; }), "max_linear", Verdict::worse),
            2u);
}

// Identical pictures have an infinite PSNR.
TEST(ExactVerdicts, FromIdenticalToNotIsWorseAndBackIsBetter) {
  CellRow same = cell(), other = cell();
  same.error_covered->psnr_db = std::numeric_limits<double>::infinity();
  CellPair pair{{same}, {other}, {0.0}};
  EXPECT_EQ(count(judge_cells(pair, {}), "psnr_db", Verdict::worse), 1u);
  std::swap(pair.before, pair.after);
  EXPECT_EQ(count(judge_cells(pair, {}), "psnr_db", Verdict::better), 1u);
}

TEST(ExactVerdicts, BoundsOfTheGateFileHoldWhateverWasBefore) {
  Limits limits;
  limits.baseline.min_ssim = 0.91;  // both have 0.9
  const auto rows = rows_after([](CellRow&) {}, limits);
  EXPECT_EQ(count(rows, "ssim", Verdict::failed), 2u);
  EXPECT_EQ(status(rows), 1);
}

// What is new has nothing to be compared with, but what holds for every picture holds for it.
TEST(ExactVerdicts, ANewVariantKeepsToBoundsAndShowsSomethingFinite) {
  const auto rows_of_new = [](auto&& change, const Limits& limits = {}) {
    CellPair pair{{std::nullopt, std::nullopt}, {}, {}};
    for (const char* view : {"front", "side"}) {
      CellRow after = cell(view);
      change(after);
      pair.after.push_back(after);
    }
    return judge_cells(pair, limits);
  };
  const auto nothing = [](CellRow&) {};
  const auto good = rows_of_new(nothing);
  EXPECT_EQ(good.size(), 1u);
  EXPECT_EQ(count(good, "cell", Verdict::not_compared), 1u);
  EXPECT_EQ(status(good), 3) << "nothing was compared";
  Limits limits;
  limits.baseline.min_ssim = 0.91;  // it has 0.9
  EXPECT_EQ(count(rows_of_new(nothing, limits), "ssim", Verdict::failed), 2u);
  EXPECT_EQ(count(rows_of_new([](CellRow& row) { row.nonfinite_pixels = 1; }), "nonfinite", Verdict::failed), 2u);
  EXPECT_EQ(count(rows_of_new([](CellRow& row) { row.covered_pixels = 0; }), "blank", Verdict::failed), 1u);
  EXPECT_EQ(status(rows_of_new([](CellRow& row) { row.covered_pixels = row.view == "side" ? 0 : 100; })), 3)
      << "a view may look elsewhere";
}

// A cell that failed before tells as little as none.
TEST(ExactVerdicts, AfterAFailureOnlyBoundsHold) {
  CellRow before = cell();
  before.failed = true, before.reason = "no device memory";
  before.error_covered.reset();
  CellRow after = cell();
  const auto rows = [&] { return judge_cells({{before}, {after}, {}}, {}); };
  EXPECT_EQ(count(rows(), "cell", Verdict::not_compared), 1u);
  EXPECT_EQ(status(rows()), 3) << "nothing was compared";
  after.nonfinite_pixels = 3;
  EXPECT_EQ(count(rows(), "nonfinite", Verdict::failed), 1u);
}

TEST(ExactVerdicts, ErrorsToTheTruthAreJudgedApart) {
  const ErrorFigures good{30, 0.9, 0.1, 0.02, 0.3}, bad{30, 0.8, 0.1, 0.02, 0.3};
  CellRow before = cell(), after = cell();
  before.error_truth = good, after.error_truth = bad;
  const CellPair pair{{before}, {after}, {}};
  EXPECT_EQ(count(judge_cells(pair, {}), "ssim to truth", Verdict::worse), 1u);
}

TEST(ExactVerdicts, NonFinitePixelsBlankPicturesAndLostCoverFail) {
  EXPECT_EQ(count(rows_after([](CellRow& after) { after.nonfinite_pixels = 1; }), "nonfinite", Verdict::failed), 2u);
  EXPECT_EQ(count(rows_after([](CellRow& after) { after.range_linear = 0; }), "blank", Verdict::failed), 2u) << "one colour";
  EXPECT_EQ(count(rows_after([](CellRow& after) { after.covered_pixels = 0; }), "blank", Verdict::failed), 2u);
}

TEST(ExactVerdicts, ViewsThatShowOnePictureAreStale) {
  const auto rows = rows_after([](CellRow& after) { after.image_hash = "one"; });
  EXPECT_EQ(count(rows, "stale", Verdict::failed), 1u);
}

TEST(ExactVerdicts, APictureMayChangeWhereItsErrorsGetBetter) {
  const auto change = [](CellRow& after) { after.image_hash += "x"; };
  EXPECT_EQ(count(rows_after(change, {}, 0.01), "picture", Verdict::worse), 2u);
  EXPECT_EQ(status(rows_after(change, {}, 0.001)), 0) << "rounding";
  EXPECT_EQ(status(rows_after(
                [&](CellRow& after) {
                  change(after);
                  after.error_covered->ssim += 0.01;
                },
                {}, 0.01)),
            0);
  EXPECT_EQ(status(rows_after(
                [&](CellRow& after) {
                  change(after);
                  after.error_covered->ssim += 0.01, after.error_covered->flip += 0.01;
                },
                {}, 0.01)),
            1)
      << "one error better, one worse";
}

TEST(ExactVerdicts, ABaselinesPictureIsHeldToWhatItWas) {
  const auto rows = rows_after([](CellRow& after) { after.image_hash += "x"; }, {}, 0.01, "light_map");
  EXPECT_EQ(count(rows, "picture", Verdict::worse), 2u);
}

TEST(ExactVerdicts, HashesDecideWhereTheyAreAskedToOrTell) {
  Limits limits;
  limits.same_image = true;
  const auto change = [](CellRow& after) { after.image_hash += "x"; };
  EXPECT_EQ(count(rows_after(change, limits, 0.0), "image_hash", Verdict::failed), 2u);
  CellRow before = cell(), after = cell();
  change(after);
  CellPair pair{{before}, {after}, {}};
  EXPECT_EQ(status(judge_cells(pair, {})), 0) << "another driver may round otherwise";
  pair.hashes_tell = true;
  EXPECT_EQ(count(judge_cells(pair, {}), "picture", Verdict::worse), 1u);
}

TEST(ExactVerdicts, WhatVanishedOrFailedIsNeverAPass) {
  const CellRow here = cell();
  CellRow failed = cell();
  failed.failed = true, failed.reason = "no device memory";
  EXPECT_EQ(status(judge_cells({{here}, {std::nullopt}, {}}, {})), 1) << "vanished";
  EXPECT_EQ(status(judge_cells({{here}, {failed}, {}}, {})), 1) << "failed";
  EXPECT_EQ(status(judge_cells({{std::nullopt}, {here}, {}}, {})), 3) << "new: nothing was compared";
  EXPECT_EQ(status(judge_cells({{failed}, {here}, {}}, {})), 3) << "failed before";
}

TEST(MaxChange, IsOverColoursUnlessAlphaCounts) {
  Image before{2, 1, {0.1f, 0.2f, 0.3f, 0, 0.1f, 0.2f, 0.3f, 1}}, after = before;
  EXPECT_EQ(max_change(after, before, false), 0);
  after.rgba[4] = 0.6f, after.rgba[7] = 9;
  EXPECT_NEAR(max_change(after, before, false), 0.5, 1e-6);
  EXPECT_NEAR(max_change(after, before, true), 8, 1e-6);
  const Image larger{2, 2, std::vector<float>(16, 0.0f)};
  EXPECT_THROW(max_change(larger, before, false), Error);
}

TEST(GateOutcome_, ComesFromTheWorstRow) {
  const auto outcome = [](std::vector<Verdict> verdicts) {
    std::vector<VerdictRow> rows;
    for (const Verdict verdict : verdicts) rows.emplace_back().verdict = verdict;
    return outcome_of(rows).status;
  };
  EXPECT_EQ(outcome({Verdict::same, Verdict::faster, Verdict::better}), 0);
  EXPECT_EQ(outcome({Verdict::same, Verdict::ambiguous}), 3);
  EXPECT_EQ(outcome({Verdict::ambiguous, Verdict::slower}), 1);
  EXPECT_EQ(outcome({Verdict::same, Verdict::worse}), 1);
  EXPECT_EQ(outcome({Verdict::same, Verdict::failed}), 1);
  EXPECT_EQ(outcome({Verdict::not_compared}), 3) << "nothing was compared";
  EXPECT_EQ(outcome({Verdict::same, Verdict::not_compared}), 0);
  EXPECT_EQ(outcome({}), 3);
}

}  // namespace
}  // namespace lamina
