// SPDX-License-Identifier: Apache-2.0
#include "harness/sweep/curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace lamina {

const Metric* metric_named(std::string_view name) {
  const auto found = std::find_if(metrics.begin(), metrics.end(), [&](const Metric& metric) { return name == metric.name; });
  return found == metrics.end() ? nullptr : &*found;
}

namespace {

using Json = nlohmann::json;

// The metric's figure in a cell; NaN where it has none.
double figure(const Json& cell, std::string_view metric) {
  if (cell.at("status") == "failed") return nan;
  if (metric.starts_with("ratio")) {
    const Json& ratio = cell.at("ratio_to_baseline");
    return ratio.is_null() ? nan : ratio.at(metric == "ratio" ? "median" : std::string(metric.substr(6))).get<double>();
  }
  const bool truth = metric.starts_with("truth.");
  const Json& figures = cell.at("error").at(truth ? "truth" : "baseline");
  if (figures.is_null()) return nan;
  const Json& value = figures.at(std::string(truth ? metric.substr(6) : metric));
  return value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();  // PSNR of identical pictures
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

struct Swept {
  std::string path, unit;
};

std::vector<Swept> swept_by(const Record& record) {
  std::vector<Swept> swept;
  for (const Json& parameter : record.sweeps.front().at("parameters"))
    swept.push_back({parameter.at("path"), parameter.at("unit")});
  return swept;
}

using Key = std::tuple<size_t, std::string, std::string, std::vector<double>,
                       std::string>;  // parameter, backend, effect, held, variant

}  // namespace

std::vector<Curve> curves_of(const Record& record) {
  if (record.sweeps.empty()) return {};
  const bool zip = record.sweeps.front().at("zip");
  const std::vector<Swept> swept = swept_by(record);
  std::vector<Curve> curves;
  for (size_t along = 0; along < (zip ? 1 : swept.size()); ++along) {
    if (record.sweeps.front().at("parameters")[along].at("values").size() < 2) continue;
    std::map<Key, size_t> known;
    std::vector<Curve> found;
    std::vector<std::map<double, std::vector<const Json*>>> cells;  // beside found; by x
    for (const Json& cell : record.cells) {
      std::vector<double> held;
      for (size_t other = 0; !zip && other < swept.size(); ++other)
        if (other != along) held.push_back(cell.at("params").at(swept[other].path));
      const auto [entry, is_new] =
          known.try_emplace(Key(along, cell.at("backend"), cell.at("effect"), held, cell.at("variant")), found.size());
      if (is_new) {
        Curve& curve = found.emplace_back();
        curve.backend = cell.at("backend"), curve.effect = cell.at("effect"), curve.variant = cell.at("variant");
        curve.baseline = cell.at("baseline");
        curve.parameter = swept[along].path, curve.unit = swept[along].unit;
        for (size_t other = 0, i = 0; !zip && other < swept.size(); ++other)
          if (other != along) curve.held.push_back({swept[other].path, swept[other].unit, held[i++]});
        cells.emplace_back();
      }
      cells[entry->second][cell.at("params").at(swept[along].path)].push_back(&cell);
    }
    for (size_t i = 0; i < found.size(); ++i)
      for (const auto& [x, views] : cells[i]) {
        found[i].x.push_back(x);
        const auto add = [&](const std::string& metric) {
          std::vector<double> figures;
          for (const Json* view : views) figures.push_back(figure(*view, metric));
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
