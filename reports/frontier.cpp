// SPDX-License-Identifier: Apache-2.0
// Pareto's rule on figures that have intervals.
#include "reports/frontier.h"

namespace lamina {

bool beats(const Contender& a, const Contender& b) {
  if (!a.cost || !a.error || !b.cost || !b.error) return false;
  if (*a.error == *b.error) return a.cost->high < b.cost->low;
  return *a.error < *b.error && a.cost->low <= b.cost->high;
}

std::vector<size_t> beaten_by(std::span<const Contender> contenders) {
  std::vector<size_t> all;
  for (size_t i = 0; i < contenders.size(); ++i) {
    size_t best = i;
    for (size_t other = 0; other < contenders.size(); ++other)
      if (beats(contenders[other], contenders[i]) && (best == i || *contenders[other].error < *contenders[best].error))
        best = other;
    all.push_back(best);
  }
  return all;
}

Contender contender(const CostAndErrors& figures, Cost cost, const ErrorMetric& metric, Reference reference) {
  Contender it;
  if (cost == Cost::time)
    it.cost = figures.frame_ms;
  else if (const auto& fetches = figures.fetches_per_pixel)
    it.cost = Interval{.median = *fetches, .low = *fetches, .high = *fetches, .rounds = 1, .coverage = 1};
  if (const auto& errors = reference == Reference::baseline ? figures.to_baseline : figures.to_truth)
    it.error = metric.more_is_closer ? -(*errors.*metric.figure) : *errors.*metric.figure;
  return it;
}

std::vector<uint32_t> frontier_bits(std::span<const CostAndErrors> group) {
  std::vector<uint32_t> bits(group.size(), 0);
  uint32_t bit = 1;
  for (const Reference reference : {Reference::baseline, Reference::truth})
    for (const ErrorMetric& metric : error_metrics)
      for (const Cost cost : {Cost::time, Cost::fetches}) {
        std::vector<Contender> contenders;
        for (const CostAndErrors& figures : group) contenders.push_back(contender(figures, cost, metric, reference));
        const std::vector<size_t> by = beaten_by(contenders);
        for (size_t i = 0; i < group.size(); ++i)
          if (by[i] == i && contenders[i].cost && contenders[i].error) bits[i] |= bit;
        bit <<= 1;
      }
  return bits;
}

}  // namespace lamina
