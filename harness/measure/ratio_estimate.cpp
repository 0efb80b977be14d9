// SPDX-License-Identifier: Apache-2.0
#include "harness/measure/ratio_estimate.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "harness/core/error.h"
#include "harness/measure/statistics.h"

namespace lamina {
namespace {

// Where Huber's function bends, in deviations. The usual 1.345 is best for noise that is nearly normal; that of a shared
// machine has long tails, for which a bend nearer to the median takes a sixth to a third off the error.
constexpr double bend = 0.7;
constexpr size_t min_strips = 3;
constexpr size_t min_per_order = 4;  // fewer do not show what the order does
constexpr double median_to_sigma = 1.4826;
constexpr double mean_to_sigma = 1.2533;

struct Weighted {
  double log_ratio, weight;
  bool after_first;
};

std::vector<Weighted> log_ratios(std::span<const StripPair> strips) {
  if (strips.size() < min_strips)
    throw Error(ErrorKind::failed, "gate", "time",
                fmt::format("{} strips are too few to estimate their spread; measure at least {}", strips.size(), min_strips));
  std::vector<Weighted> ratios;
  double whole = 0;
  for (const auto& [before, after, after_first] : strips) {
    if (!(before > 0) || !(after > 0) || !std::isfinite(before) || !std::isfinite(after))
      throw Error(ErrorKind::failed, "gate", "time",
                  fmt::format("a strip took {} ms and {} ms: a time must be positive and finite", before, after));
    ratios.push_back({std::log(after / before), 2 / (1 / before + 1 / after), after_first});
    whole += ratios.back().weight;
  }
  for (Weighted& ratio : ratios) ratio.weight *= static_cast<double>(ratios.size()) / whole;
  return ratios;
}

template <typename Keep>
std::vector<double> values(const std::vector<Weighted>& ratios, Keep&& keep) {
  std::vector<double> kept;
  for (const Weighted& ratio : ratios)
    if (keep(ratio)) kept.push_back(ratio.log_ratio);
  return kept;
}

void take_out_order(std::vector<Weighted>& ratios) {
  const std::vector<double> first = values(ratios, [](const Weighted& ratio) { return ratio.after_first; });
  const std::vector<double> second = values(ratios, [](const Weighted& ratio) { return !ratio.after_first; });
  if (std::min(first.size(), second.size()) < min_per_order) return;
  const double half = (median(first) - median(second)) / 2;
  for (Weighted& ratio : ratios) ratio.log_ratio -= ratio.after_first ? half : -half;
}

double scale_around(double middle, const std::vector<Weighted>& ratios) {
  std::vector<double> away = values(ratios, [](const Weighted&) { return true; });
  double sum = 0;
  for (double& value : away) sum += value = std::abs(value - middle);
  const double scale = median_to_sigma * median(away);
  return scale > 0 ? scale : mean_to_sigma * sum / static_cast<double>(away.size());  // most are equal
}

}  // namespace

// A middle and an order's effect are taken from the strips.
double freedom_of(size_t strips) { return std::max(1.0, static_cast<double>(strips) - 2); }

RatioEstimate estimate_ratio(std::span<const StripPair> strips) {
  std::vector<Weighted> ratios = log_ratios(strips);
  take_out_order(ratios);
  RatioEstimate estimate{median(values(ratios, [](const Weighted&) { return true; })), 0, ratios.size(),
                         freedom_of(ratios.size())};
  const double scale = scale_around(estimate.log_ratio, ratios);
  if (scale == 0) return estimate;

  const auto away = [&](const Weighted& ratio) { return (ratio.log_ratio - estimate.log_ratio) / scale; };
  for (int step = 0; step < 100; ++step) {
    double pull = 0, weight = 0;
    for (const Weighted& ratio : ratios) {
      pull += ratio.weight * std::clamp(away(ratio), -bend, bend);
      weight += ratio.weight * bend / std::max(std::abs(away(ratio)), bend);
    }
    const double move = scale * pull / weight;
    estimate.log_ratio += move;
    if (std::abs(move) < 1e-9) break;
  }
  double slope = 0, square = 0, whole_square = 0;
  for (const Weighted& ratio : ratios) {
    square += std::pow(ratio.weight * std::clamp(away(ratio), -bend, bend), 2);
    whole_square += std::pow(ratio.weight * away(ratio), 2);
    if (std::abs(away(ratio)) <= bend) slope += ratio.weight;
  }
  // No strip is near the middle: there are two clusters, and the error of the mean describes them.
  estimate.error =
      scale * (slope > 0 ? std::sqrt(square) / slope : std::sqrt(whole_square) / static_cast<double>(ratios.size()));
  return estimate;
}

}  // namespace lamina
