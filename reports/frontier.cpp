// SPDX-License-Identifier: Apache-2.0
// Pareto's rule on costs that are known by pairs.
// Sources: the interval of a pair's ratio is median_interval()'s (David and Nagaraja 2003), or Student's (Biometrika 6, 1908);
// one error rate over all pairs by C. E. Bonferroni, "Teoria statistica delle classi e calcolo delle probabilita", 1936.
#include "reports/frontier.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace lamina {
namespace {

constexpr size_t min_rounds_for_student = 5;  // fewer can agree by chance

// One cost over another, as far as it is known.
struct RatioBounds {
  double low = 0, high = std::numeric_limits<double>::infinity();
  bool less() const { return high < 1; }
  bool more() const { return low > 1; }
};

double over(double a, double b) {
  if (b == 0) return a == 0 ? 1 : std::numeric_limits<double>::infinity();
  return a / b;
}

// Student's interval of the mean log ratio, for rounds too few to promise so much without a distribution: ratios of rounds that
// agree well tell two apart even then.
RatioBounds student_bounds(std::span<const double> ratios, double confidence) {
  const size_t n = ratios.size();
  if (n < min_rounds_for_student) return {};
  double mean = 0, squares = 0;
  for (const double ratio : ratios) {
    if (!(ratio > 0)) return {};
    mean += std::log(ratio) / static_cast<double>(n);
  }
  for (const double ratio : ratios) squares += (std::log(ratio) - mean) * (std::log(ratio) - mean);
  const auto freedom = static_cast<double>(n - 1);
  const double error = std::sqrt(squares / freedom / static_cast<double>(n));
  const double width = error * boost::math::quantile(boost::math::students_t(freedom), 1 - (1 - confidence) / 2);
  return {std::exp(mean - width), std::exp(mean + width)};
}

RatioBounds cost_ratio(const Contender& a, const Contender& b, double confidence) {
  const size_t rounds = std::min(a.rounds.size(), b.rounds.size());
  if (rounds == 0) return {over(a.cost->low, b.cost->high), over(a.cost->high, b.cost->low)};
  std::vector<double> ratios(rounds);
  for (size_t round = 0; round < rounds; ++round) {
    if (!(b.rounds[round] > 0)) return {};
    ratios[round] = a.rounds[round] / b.rounds[round];
  }
  const Interval interval = widest_interval(ratios, confidence);
  return interval.coverage < confidence ? student_bounds(ratios, confidence) : RatioBounds{interval.low, interval.high};
}

// The ratios of all pairs of one chart, [a * n + b].
std::vector<RatioBounds> ratios_of(std::span<const Contender> all) {
  const auto known = static_cast<size_t>(std::ranges::count_if(all, [](const Contender& one) { return one.cost.has_value(); }));
  const size_t pairs = known > 1 ? known * (known - 1) / 2 : 1;
  const double confidence = 1 - (1 - chart_confidence) / static_cast<double>(pairs);
  std::vector<RatioBounds> ratios(all.size() * all.size());
  for (size_t a = 0; a < all.size(); ++a)
    for (size_t b = 0; b < a; ++b) {
      if (!all[a].cost || !all[b].cost) continue;
      const RatioBounds bounds = cost_ratio(all[a], all[b], confidence);
      ratios[a * all.size() + b] = bounds;
      ratios[b * all.size() + a] = {over(1, bounds.high), over(1, bounds.low)};
    }
  return ratios;
}

std::vector<Place> places_by(std::span<const Contender> all, const std::vector<RatioBounds>& ratios, double slack) {
  std::vector<Place> places;
  for (size_t i = 0; i < all.size(); ++i) {
    Place& place = places.emplace_back(Place{Standing::unknown, i});
    if (!all[i].cost || !all[i].error) continue;
    place.standing = Standing::on_frontier;
    for (size_t other = 0; other < all.size(); ++other) {
      if (other == i || !all[other].cost || !all[other].error || *all[other].error > *all[i].error) continue;
      const RatioBounds& ratio = ratios[other * all.size() + i];  // of what is closer, or as close
      const bool closer = *all[other].error < *all[i].error;
      Standing standing = Standing::not_told_apart;
      if (closer ? ratio.more() : !ratio.less()) continue;
      if (!closer || ratio.high <= slack) standing = Standing::dominated;
      const bool worse = standing == Standing::dominated && place.standing != Standing::dominated;
      const bool better_known = standing == place.standing && *all[other].error < *all[place.by].error;
      if (place.by == i || worse || better_known) place = {standing, other};
    }
    if (!all[i].acceptable) place = {Standing::beyond_limit, i};
  }
  return places;
}

double slack_of(Cost cost) { return cost == Cost::time ? as_fast : 1; }

}  // namespace

std::vector<Place> places_of(std::span<const Contender> contenders, double slack) {
  return places_by(contenders, ratios_of(contenders), slack);
}

std::vector<Contender> contenders_of(std::span<const CostAndErrors> group, Cost cost, const ErrorMetric& metric,
                                     Reference reference) {
  std::vector<Contender> all;
  std::optional<double> baseline_error;
  for (const CostAndErrors& figures : group) {
    Contender& it = all.emplace_back();
    if (cost == Cost::time) {
      it.cost = figures.frame_ms;
      it.rounds = figures.rounds_ms;
    } else if (const auto& fetches = figures.fetches_per_pixel) {
      it.cost = Interval{.median = *fetches, .low = *fetches, .high = *fetches, .rounds = 1, .coverage = 1};
    }
    if (const auto& errors = reference == Reference::baseline ? figures.to_baseline : figures.to_truth)
      it.error = metric.more_is_closer ? -(*errors.*metric.figure) : *errors.*metric.figure;
    if (figures.baseline) baseline_error = it.error;
  }
  for (size_t i = 0; i < all.size(); ++i) {
    const bool closer_to_truth =
        reference == Reference::truth && all[i].error && baseline_error && *all[i].error < *baseline_error;
    all[i].acceptable = !group[i].beyond_limit || closer_to_truth;
  }
  return all;
}

std::vector<Place> places_of(std::span<const CostAndErrors> group, Cost cost, const ErrorMetric& metric, Reference reference) {
  return places_of(contenders_of(group, cost, metric, reference), slack_of(cost));
}

std::vector<FrontierBits> frontier_bits(std::span<const CostAndErrors> group) {
  std::vector<FrontierBits> bits(group.size());
  // The ratios of costs are the same whatever stands for the error.
  const auto ratios = [&](Cost cost) {
    return ratios_of(contenders_of(group, cost, error_metrics.front(), Reference::baseline));
  };
  const std::vector<RatioBounds> by_time = ratios(Cost::time), by_fetches = ratios(Cost::fetches);
  uint32_t bit = 1;
  for (const Reference reference : {Reference::baseline, Reference::truth})
    for (const ErrorMetric& metric : error_metrics)
      for (const Cost cost : {Cost::time, Cost::fetches}) {
        const std::vector<Place> places =
            places_by(contenders_of(group, cost, metric, reference), cost == Cost::time ? by_time : by_fetches, slack_of(cost));
        for (size_t i = 0; i < group.size(); ++i) {
          if (places[i].standing == Standing::on_frontier) bits[i].on_frontier |= bit;
          if (places[i].standing == Standing::not_told_apart) bits[i].not_told_apart |= bit;
        }
        bit <<= 1;
      }
  return bits;
}

}  // namespace lamina
