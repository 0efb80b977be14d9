// SPDX-License-Identifier: Apache-2.0
// A model fitted to times that are made of known weights gives these weights back, and tells frames that it has not seen.
#include "harness/cost/cost_model.h"

#include <gtest/gtest.h>

#include <random>

#include "harness/core/error.h"
#include "harness/cost/nonnegative_fit.h"

namespace lamina {
namespace {

TEST(NonnegativeFit, SolvesWhatHasASolution) {
  const std::vector<std::vector<double>> rows = {{1, 0, 0}, {0, 2, 0}, {1, 0, 4}, {0.5, 0.5, 1}};
  // x = (1, .5, 0): rows give 1, 1, 1, .75; the last asks for 1, so the least squares differ from it.
  const std::vector<double> x = fit_nonnegative(rows, std::vector<double>(4, 1));
  // The gradient vanishes where x is above 0 and is not negative where it is 0 (Kuhn and Tucker).
  for (size_t j = 0; j < 3; ++j) {
    double gradient = 0;
    for (const auto& row : rows) gradient += row[j] * (row[0] * x[0] + row[1] * x[1] + row[2] * x[2] - 1);
    EXPECT_GE(x[j], 0);
    if (x[j] > 0)
      EXPECT_NEAR(gradient, 0, 1e-8) << j;
    else
      EXPECT_GE(gradient, -1e-12) << j;
  }
}

TEST(NonnegativeFit, NoWeightIsNegativeAndAnEmptyColumnIsZero) {
  // Without a bound the best is (2, -1).
  const std::vector<double> x =
      fit_nonnegative(std::vector<std::vector<double>>{{1, 1, 0}, {0.5, 0, 0}, {1, 1.0, 0}}, std::vector<double>(3, 1));
  EXPECT_GE(x[1], 0);
  EXPECT_EQ(x[1], 0);
  EXPECT_NEAR(x[0], 2.5 / 2.25, 1e-9) << "least squares in the first column alone";
  EXPECT_EQ(x[2], 0);
  EXPECT_THROW(fit_nonnegative({}, {}), Error);
  EXPECT_THROW(fit_nonnegative(std::vector<std::vector<double>>{{std::nan("")}}, std::vector{1.0}), Error);
  EXPECT_THROW(fit_nonnegative(std::vector<std::vector<double>>{{1}}, {}), Error);
}

// Random problems, columns that say the same among them: Kuhn's and Tucker's conditions tell the least.
TEST(NonnegativeFit, MeetsTheConditionsOfTheLeastOnRandomRows) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (int problem = 0; problem < 60; ++problem) {
    const size_t columns = 1 + random() % 20, count = 1 + random() % 60;
    std::vector<std::vector<double>> rows(count, std::vector<double>(columns));
    std::vector<double> targets(count);
    for (size_t i = 0; i < count; ++i) {
      for (size_t j = 0; j < columns; ++j)
        rows[i][j] = j % 5 == 4 ? 2 * rows[i][j - 1]
                                : std::pow(10.0, static_cast<double>(j % 3)) *
                                      (problem % 2 == 0 ? normal(random) : std::abs(normal(random)));
      targets[i] = normal(random);
    }
    const std::vector<double> x = fit_nonnegative(rows, targets);
    for (size_t j = 0; j < columns; ++j) {
      double gradient = 0, length = 0;
      for (size_t i = 0; i < count; ++i) {
        double error = -targets[i];
        for (size_t k = 0; k < columns; ++k) error += rows[i][k] * x[k];
        gradient += rows[i][j] * error, length += rows[i][j] * rows[i][j];
      }
      gradient /= std::sqrt(length) + 1e-300;
      EXPECT_GE(x[j], 0);
      EXPECT_GE(gradient, -1e-7) << problem << " " << j;
      if (x[j] > 0) {
        EXPECT_LE(gradient, 1e-7) << problem << " " << j;
      }
    }
  }
}

TEST(LeastAbsoluteFit, IsTheMedianAndLeavesAFewThatAreFarOff) {
  const std::vector<std::vector<double>> ones(5, {1.0});
  EXPECT_NEAR(fit_least_absolute(ones, std::vector<double>{1, 2, 3, 70, 900}, 1e-6, 0)[0], 3, 0.01);
  std::vector<std::vector<double>> rows;
  std::vector<double> targets;
  for (int i = 1; i <= 30; ++i) {
    const double first = i, second = i * i % 7;
    rows.push_back({first, second});
    targets.push_back((2 * first + 3 * second) * (i % 6 == 0 ? 20 : 1));
  }
  const std::vector<double> x = fit_least_absolute(rows, targets, 1e-6, 0);
  EXPECT_NEAR(x[0], 2, 1e-3);
  EXPECT_NEAR(x[1], 3, 1e-3);
}

TEST(RankCorrelation, IsSpearmans) {
  EXPECT_DOUBLE_EQ(rank_correlation(std::vector{1.0, 2.0, 3.0}, std::vector{10.0, 20.0, 900.0}), 1);
  EXPECT_DOUBLE_EQ(rank_correlation(std::vector{1.0, 2.0, 3.0}, std::vector{3.0, 2.0, 1.0}), -1);
  // Ranks 0, 1.5, 1.5, 3 against 0, 1, 2, 3: covariance 4.5, variances 4.5 and 5.
  EXPECT_NEAR(rank_correlation(std::vector{1.0, 2.0, 2.0, 3.0}, std::vector{1.0, 2.0, 3.0, 4.0}), 4.5 / std::sqrt(22.5), 1e-12);
  EXPECT_EQ(rank_correlation(std::vector{1.0, 1.0}, std::vector{1.0, 2.0}), 0);
}

PassRow pass(uint64_t fragments, uint64_t adds, uint64_t issued_adds, uint64_t fetches, double ms) {
  PassRow row;
  row.name = "draw";
  row.fragments = fragments, row.vertices = 3;
  row.operations = {{"add", adds}};
  row.issued = {{"add", issued_adds}};
  row.by_texture = {{.texture = "t", .format = "rgba8_unorm", .filter = "linear", .fetches = fetches, .issued = fetches}};
  row.ms = {ms, ms, ms};
  return row;
}

// Frames of 40 variants on a device that takes 0.2 ms a pass, 2 ns a fragment, 0.5 ns an addition that is issued and 7 ns a
// fetch, exactly.
std::vector<CellRow> cells() {
  std::mt19937_64 random(3);
  std::vector<CellRow> rows;
  for (int variant = 0; variant < 40; ++variant) {
    const uint64_t fragments = 1000 + random() % 100000, a_pixel = 1 + random() % 60, taps = random() % 30;
    CellRow& row = rows.emplace_back();
    row.effect = "e";
    row.variant = "v" + std::to_string(variant);
    const uint64_t adds = fragments * a_pixel, issued = adds * (1 + random() % 5), fetches = fragments * taps;
    const double ms = 0.2 + 2e-6 * static_cast<double>(fragments) + 0.5e-6 * static_cast<double>(issued) +
                      7e-6 * static_cast<double>(fetches);
    row.passes = {pass(fragments, adds, issued, fetches, ms)};
    PassRow once = pass(9, 9, 9, 9, 1000);
    once.once = true;
    row.passes.push_back(once);
  }
  return rows;
}

TEST(CostModel, GivesBackTheWeightsThatTheTimesAreMadeOf) {
  const std::vector<CellRow> rows = cells();
  const CostModel model = fit_cost_model(timed_frames(rows));
  EXPECT_EQ(model.counted, CountedWork::issued) << "what is executed does not tell these times";
  // The three vertices are in every pass: their weight and the pass's cannot be told apart, their sum can.
  // The ridge shrinks what is in all passes by a few thousandths.
  EXPECT_NEAR(model.weights.at("run").ns + 3 * model.weights.at("vertex").ns, 0.2e6, 1000);
  EXPECT_NEAR(model.weights.at("fragment").ns, 2, 0.02);
  EXPECT_NEAR(model.weights.at("operation").ns, 0.5, 0.005);
  EXPECT_NEAR(model.weights.at("fetch, of 8 bits").ns + model.weights.at("fetch, linear").ns, 7, 0.07) << "always together";
  EXPECT_LE(model.weights.at("operation").low, model.weights.at("operation").high);
  EXPECT_NEAR(model.weights.at("operation").low, 0.5, 0.01);
  EXPECT_LT(model.judged.mean_error, 0.001);
  EXPECT_GT(model.judged.rank_correlation, 0.999);
  EXPECT_EQ(model.judged.variants, 40u);
  EXPECT_GT(judge_cost_model(timed_frames(rows), CountedWork::executed).mean_error, 0.1);
}

TEST(CostModel, PredictsAPassItHasNotSeenAndNamesWhatItDoesNotKnow) {
  CostModel model = fit_cost_model(timed_frames(cells()));
  PassRow other = pass(5000, 10, 20000, 15000, 0);
  other.by_texture.push_back({.texture = "u", .format = "r32_float", .filter = "nearest", .fetches = 3, .issued = 3});
  std::vector<std::string> unknown;
  EXPECT_NEAR(predicted_ms(model, std::vector{other}, &unknown), 0.2 + 0.01 + 0.01 + 0.105, 0.001);
  EXPECT_EQ(unknown, (std::vector<std::string>{"fetch, nearest", "fetch, of floats"}));
  const CostModel again = cost_model_from_json(nlohmann::json::parse(to_json(model).dump()), "file");
  EXPECT_EQ(to_json(again).dump(), to_json(model).dump());
}

TEST(PassWork, ChargesWholeBlocksAndVerticesApart) {
  PassRow row = pass(1000, 5000, 6000, 400, 1);
  row.issued_fragments = 4000, row.runs = 3, row.triangles = 70;
  row.issued["exp"] = 100;
  row.vertex_issued = {{"add", 2000}, {"exp", 100}};
  const PassWork work = work_of(row, CountedWork::issued);
  EXPECT_EQ(work.at("run"), 3);
  EXPECT_EQ(work.at("fragment"), 4000);
  EXPECT_EQ(work.at("triangle"), 70);
  EXPECT_EQ(work.at("operation"), 4 * (6000 - 2000) + 2 * (2000 + 6 * 100)) << "four are issued for each that is seen";
  EXPECT_FALSE(work.contains("exponential")) << "all of them the vertices'";
  EXPECT_EQ(work.at("fetch, linear"), 4 * 400);
}

TEST(PassWork, ChargesFetchesByKindLevelsAndBytes) {
  PassRow row = pass(1000, 1, 1, 3000, 1);
  row.by_texture[0].unfiltered = 1000;
  row.by_texture[0].size = {64, 32};
  row.by_texture[0].levels = {0, 3000, 1500, 1};
  const PassWork work = work_of(row, CountedWork::executed);
  EXPECT_DOUBLE_EQ(work.at("fetch, linear"), 2000);
  EXPECT_DOUBLE_EQ(work.at("fetch, a texel"), 1000);
  EXPECT_DOUBLE_EQ(work.at("fetch, of 8 bits"), 3000);
  EXPECT_DOUBLE_EQ(work.at("fetch, a second level"), 1501);
  EXPECT_DOUBLE_EQ(work.at("byte of textures"), 32 * 16 * 4 + 16 * 8 * 4 + 64) << "whole levels, and one line of the last";
}

TEST(PassWork, ChargesWhatIsWritten) {
  PassRow row = pass(1000, 1, 1, 0, 1);
  row.written = {
      {"rgba16_float", "clear", "alpha", 100}, {"r32_float", "discard", "none", 100}, {"d32_float", "keep", "test", 100}};
  const PassWork work = work_of(row, CountedWork::executed);
  EXPECT_EQ(work.at("byte of targets, clear"), 800);
  EXPECT_EQ(work.at("byte of targets, keep"), 400);
  EXPECT_EQ(work.at("fragment, to rgba16_float"), 1000);
  EXPECT_EQ(work.at("fragment, to r32_float"), 1000);
  EXPECT_EQ(work.at("fragment, blended"), 1000);
  EXPECT_EQ(work.at("fragment, depth test"), 1000);
  row.written = {{"rgba16_float", "mips", "none", 25}};
  EXPECT_EQ(work_of(row, CountedWork::executed).at("byte of targets, mips"), 200);
}

TEST(CostModel, RefusesWhatTellsNothing) {
  std::vector<CellRow> rows = cells();
  for (CellRow& row : rows) row.timed = false;
  EXPECT_TRUE(timed_frames(rows).empty()) << "no certificate, no times";
  EXPECT_THROW(fit_cost_model(timed_frames(rows)), Error);
  rows = cells();
  rows[0].failed = true;
  rows[1].passes[0].fragments.reset();
  rows[2].passes[0].issued.clear();
  EXPECT_EQ(timed_frames(rows).size(), 37u) << "failed, not counted, of a record of before";
  rows.resize(9);
  EXPECT_THROW(fit_cost_model(timed_frames(rows)), Error);
  EXPECT_THROW(cost_model_from_json({{"kind", "cost_model"}}, "file"), Error);
  EXPECT_THROW(cost_model_from_json({{"kind", "cell"}}, "file"), Error);
}

}  // namespace
}  // namespace lamina
