// SPDX-License-Identifier: Apache-2.0
// Which variants are worth having: those that no other dominates in cost and error. One rule for words, charts and tables.
// Costs are compared pair by pair, by the ratio of the two in each round, since what slows a round down slows both; so the
// answer is one of three: on the frontier, dominated, not told apart.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "harness/measure/statistics.h"
#include "harness/quality/error_metrics.h"

namespace lamina {

enum class Cost { time, fetches };
enum class Reference { baseline, truth };

// One of those that are weighed against each other.
struct Contender {
  std::optional<Interval> cost;
  std::optional<double> error;   // less is closer
  std::vector<double> rounds{};  // the cost of each round, paired with the others'; empty: the interval is all that is known
  bool acceptable = true;        // false: beyond a limit, so that no cost makes it worth having
};
enum class Standing {
  unknown,         // a figure is not known
  on_frontier,     // it costs less than everything that is closer, and nothing as close is known to cost less
  dominated,       // something closer costs no more, or something as close costs less
  not_told_apart,  // something closer may cost no more: more rounds would tell
  beyond_limit,    // not acceptable
};
struct Place {
  Standing standing = Standing::unknown;
  size_t by = 0;  // what dominates it, or what it is not told from (of several, the one with the smallest error); else itself
};

// All decisions of one chart are right together with this confidence: each pair gets an equal share of the error (Bonferroni).
inline constexpr double chart_confidence = 0.95;
// What is closer dominates where it takes at most this many times as long; two costs that are equal are never told apart.
inline constexpr double as_fast = 1.02;

// `slack` is as_fast for times, 1 for counts. Intervals are used where two have no rounds in common.
std::vector<Place> places_of(std::span<const Contender> contenders, double slack);

// What a variant costs and errs by, over all views or in one.
struct CostAndErrors {
  std::optional<Interval> frame_ms;
  std::optional<double> fetches_per_pixel;
  std::optional<ErrorFigures> to_baseline, to_truth;
  std::vector<double> rounds_ms{};  // as Contender::rounds
  bool baseline = false;
  bool beyond_limit = false;  // in its error to the baseline
};
// The group as contenders. What is beyond a limit in its error to the baseline is acceptable against the truth only where it is
// closer to it than the baseline is.
std::vector<Contender> contenders_of(std::span<const CostAndErrors> group, Cost cost, const ErrorMetric& metric,
                                     Reference reference);
std::vector<Place> places_of(std::span<const CostAndErrors> group, Cost cost, const ErrorMetric& metric, Reference reference);
// For each of a group, the axes on which it is worth having, and those on which it is not told apart, one bit each: bit
// (5 reference + metric) 2 + cost, as numbered above.
struct FrontierBits {
  uint32_t on_frontier = 0, not_told_apart = 0;
};
std::vector<FrontierBits> frontier_bits(std::span<const CostAndErrors> group);
// The figures of a picture against itself, which a baseline has against the baseline.
inline constexpr ErrorFigures no_error = {
    .psnr_db = std::numeric_limits<double>::infinity(), .ssim = 1, .flip = 0, .rmse_linear = 0, .max_linear = 0};

}  // namespace lamina
