// SPDX-License-Identifier: Apache-2.0
// Which variants are worth having: those that no other dominates in cost and error. One rule for words, charts and tables.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "harness/measure/statistics.h"
#include "harness/quality/quality.h"

namespace lamina {

// The figures that may stand for the error, in the order of the page's data.
struct ErrorMetric {
  const char *name, *words;  // the record's field; for people
  bool more_is_closer;
  double ErrorFigures::*figure;
};
inline constexpr std::array<ErrorMetric, 5> error_metrics = {
    {{"ssim", "SSIM", true, &ErrorFigures::ssim},
     {"psnr_db", "PSNR, dB", true, &ErrorFigures::psnr_db},
     {"flip", "FLIP", false, &ErrorFigures::flip},
     {"max_linear", "max, linear", false, &ErrorFigures::max_linear},
     {"rmse_linear", "RMSE, linear", false, &ErrorFigures::rmse_linear}}};
enum class Cost { time, fetches };
enum class Reference { baseline, truth };

// One of those that are weighed against each other.
struct Contender {
  std::optional<Interval> cost;
  std::optional<double> error;  // less is closer
};
// Whether `a` dominates `b`: it has a smaller error and is not measurably more expensive (the intervals overlap, or it is
// cheaper), or the same error and is measurably cheaper. Never where a figure is not known.
bool beats(const Contender& a, const Contender& b);
// For each contender the index of the one that dominates it (of several, the one with the smallest error), or its own index
// where none does: it is then worth having if both its figures are known.
std::vector<size_t> beaten_by(std::span<const Contender> contenders);

// What a variant costs and errs by, over all views or in one.
struct CostAndErrors {
  std::optional<Interval> frame_ms;
  std::optional<double> fetches_per_pixel;
  std::optional<ErrorFigures> to_baseline, to_truth;
};
Contender contender(const CostAndErrors& figures, Cost cost, const ErrorMetric& metric, Reference reference);
// For each of a group, the axes on which it is worth having, one bit each: bit (5 reference + metric) 2 + cost, as numbered
// above.
std::vector<uint32_t> frontier_bits(std::span<const CostAndErrors> group);
// The figures of a picture against itself, which a baseline has against the baseline.
inline constexpr ErrorFigures no_error = {
    .psnr_db = std::numeric_limits<double>::infinity(), .ssim = 1, .flip = 0, .rmse_linear = 0, .max_linear = 0};

}  // namespace lamina
