// SPDX-License-Identifier: Apache-2.0
#include "harness/sweep/curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace lamina {

bool in_one_group(const Curve& a, const Curve& b) {
  return a.backend == b.backend && a.effect == b.effect && a.parameter == b.parameter && a.held == b.held;
}

const Metric* metric_named(std::string_view name) {
  const auto found = std::find_if(metrics.begin(), metrics.end(), [&](const Metric& metric) { return name == metric.name; });
  return found == metrics.end() ? nullptr : &*found;
}

namespace {

// Figures of a cell by the names of curves.h; NaN where it has none.
double figure(const CellRow& cell, std::string_view name) {
  if (cell.failed) return nan;
  if (name.starts_with("ratio")) {
    const std::optional<Interval>& ratio = cell.ratio_to_baseline;
    if (!ratio) return nan;
    return name == "ratio" ? ratio->median : name == "ratio.low" ? ratio->low : ratio->high;
  }
  const bool truth = name.starts_with("truth.");
  const std::optional<ErrorFigures>& error = truth ? cell.error_truth : cell.error_covered;
  return error ? *error.*metric_named(name)->figure : nan;
}

// One number of the views' figures; NaN where one of them is.
double over_views(std::string_view name, const std::vector<double>& figures) {
  if (figures.empty() || std::any_of(figures.begin(), figures.end(), [](double value) { return std::isnan(value); }))
    return nan;
  if (const Metric* metric = metric_named(name); metric && name != "ratio")
    return metric->more_is_better ? *std::min_element(figures.begin(), figures.end())
                                  : *std::max_element(figures.begin(), figures.end());
  double logs = 0;
  for (const double ratio : figures) logs += std::log(ratio);
  return std::exp(logs / static_cast<double>(figures.size()));
}

using Key = std::tuple<size_t, std::string, std::string, std::vector<double>,
                       std::string>;  // parameter, backend, effect, held, variant

}  // namespace

std::vector<Curve> curves_of(const Record& record) {
  if (record.sweeps.empty()) return {};
  const bool zip = record.sweeps.front().zip;
  const std::vector<SweepRow::Parameter>& swept = record.sweeps.front().parameters;
  std::vector<Curve> curves;
  for (size_t along = 0; along < (zip ? 1 : swept.size()); ++along) {
    if (swept[along].values.size() < 2) continue;
    std::map<Key, size_t> known;
    std::vector<Curve> found;
    std::vector<std::map<double, std::vector<const CellRow*>>> cells;  // beside found; by x
    for (const CellRow& cell : record.cells) {
      std::vector<double> held;
      for (size_t other = 0; !zip && other < swept.size(); ++other)
        if (other != along) held.push_back(cell.params.at(swept[other].path));
      const auto [entry, is_new] = known.try_emplace(Key(along, cell.backend, cell.effect, held, cell.variant), found.size());
      if (is_new) {
        Curve& curve = found.emplace_back();
        curve.backend = cell.backend, curve.effect = cell.effect, curve.variant = cell.variant;
        curve.baseline = cell.baseline;
        curve.parameter = swept[along].path, curve.unit = swept[along].unit;
        for (size_t other = 0, i = 0; !zip && other < swept.size(); ++other)
          if (other != along) curve.held.push_back({swept[other].path, swept[other].unit, held[i++]});
        cells.emplace_back();
      }
      cells[entry->second][cell.params.at(swept[along].path)].push_back(&cell);
    }
    for (size_t i = 0; i < found.size(); ++i)
      for (const auto& [x, views] : cells[i]) {
        found[i].x.push_back(x);
        const auto add = [&](const std::string& metric) {
          std::vector<double> figures;
          for (const CellRow* view : views) figures.push_back(figure(*view, metric));
          found[i].y[metric].push_back(over_views(metric, figures));
        };
        for (const Metric& metric : metrics) add(metric.name);
        add("ratio.low"), add("ratio.high");
      }
    std::move(found.begin(), found.end(), std::back_inserter(curves));
  }
  // Cells come by point, so variants of a group lie together only after sorting; stable, so that groups keep their order.
  const auto group = [&](const Curve& curve) { return std::tuple(curve.parameter, curve.backend, curve.effect, curve.held); };
  std::vector<decltype(group(curves.front()))> order;
  for (const Curve& curve : curves)
    if (std::find(order.begin(), order.end(), group(curve)) == order.end()) order.push_back(group(curve));
  std::stable_sort(curves.begin(), curves.end(), [&](const Curve& a, const Curve& b) {
    const auto at = [&](const Curve& curve) {
      return std::pair(std::find(order.begin(), order.end(), group(curve)) - order.begin(), !curve.baseline);
    };
    return at(a) < at(b);
  });
  return curves;
}

}  // namespace lamina
