// SPDX-License-Identifier: Apache-2.0
#include "harness/sweep/answers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/sweep/crossings.h"

namespace lamina {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// "thickness" of "objects.heart.thickness", "position.x" of "lights.rim.position.x".
std::string short_name(const std::string& path) {
  static const std::vector<std::string> parts = {"x", "y", "z", "red", "green", "blue"};
  size_t dot = path.rfind('.');
  if (dot != std::string::npos && dot > 0 && std::find(parts.begin(), parts.end(), path.substr(dot + 1)) != parts.end())
    dot = path.rfind('.', dot - 1);
  return dot == std::string::npos ? path : path.substr(dot + 1);
}

// Four digits are more than any tolerance carries.
std::string words(double value) { return fmt::format("{:.4g}", value); }

class Sentence {
 public:
  explicit Sentence(const Curve& curve)
      : name_(short_name(curve.parameter)), unit_(curve.unit.empty() ? "" : " " + curve.unit) {
    for (const auto& [path, value] : curve.held) tail_ += fmt::format(", at {} {}", short_name(path), words(value));
    tail_ += " on " + curve.backend;
  }
  std::string at(const Crossing& crossing) const {
    return fmt::format("{} {}{} (within {:.2g})", name_, words(crossing.at), unit_, crossing.tolerance);
  }
  std::string range(double from, double to) const { return fmt::format("{} {} to {}{}", name_, words(from), words(to), unit_); }
  const std::string& tail() const { return tail_; }

 private:
  std::string name_, unit_, tail_;
};

CrossoverRow start(const Curve& curve, const std::string& other, const std::string& metric) {
  CrossoverRow row;
  row.parameter = curve.parameter, row.backend = curve.backend, row.effect = curve.effect, row.variant = curve.variant;
  row.other = other, row.metric = metric;
  return row;
}

// A curve without the samples that are not known.
struct Known {
  std::vector<double> x, y;
  explicit Known(const std::vector<double>& all_x, const std::vector<double>& all_y) {
    for (size_t i = 0; i < all_x.size(); ++i)
      if (!std::isnan(all_y[i])) x.push_back(all_x[i]), y.push_back(all_y[i]);
  }
};

// How far one variant keeps within one limit.
void add_limit(const Curve& curve, const Limit& limit, std::vector<CrossoverRow>& rows) {
  const Metric& metric = *metric_named(limit.metric);
  std::vector<double> y = curve.y.at(limit.metric);
  const size_t missing = static_cast<size_t>(std::count_if(y.begin(), y.end(), [](double value) { return std::isnan(value); }));
  if (missing == y.size()) return;
  const double sign = metric.more_is_better ? 1 : -1;
  for (double& value : y) value *= sign;  // so that at or above the limit is within it
  const Known known(curve.x, y);
  const Sentence sentence(curve);
  const std::string bound =
      fmt::format("{} at {} {}", metric.words, metric.more_is_better ? "least" : "most", words(limit.value));
  std::string tail = sentence.tail();
  if (missing > 0) tail += fmt::format("; {} of {} points are missing", missing, y.size());
  const auto add = [&](const std::string& text, const Crossing* crossing) {
    CrossoverRow row = start(curve, "", limit.metric);
    row.limit = limit.value;
    if (crossing) row.at = crossing->at, row.tolerance = crossing->tolerance;
    row.sentence = fmt::format("{} {}{}", curve.variant, text, tail);
    rows.push_back(row);
  };
  const std::vector<Crossing> found = crossings(curve.x, y, sign * limit.value);
  if (found.empty()) {
    const bool within = known.y.front() >= sign * limit.value && known.y.back() >= sign * limit.value;
    const std::string range = sentence.range(known.x.front(), known.x.back());
    add(within ? fmt::format("keeps {} over all of {}", bound, range) : fmt::format("does not keep {} over {}", bound, range),
        nullptr);
  }
  for (size_t i = 0; i < found.size(); ++i) {
    const std::string at = sentence.at(found[i]);
    add(found[i].rising ? fmt::format("keeps {} from {} on", bound, at)
        : i == 0        ? fmt::format("keeps {} up to {}", bound, at)
                        : fmt::format("no longer keeps {} from {} on", bound, at),
        &found[i]);
  }
}

// How much better (above 0) one is than the other, sample by sample; NaN where that is not known, and where they are equal, so
// that a crossing is looked for between samples that say something.
std::vector<double> advantage(const Curve& one, const Curve& other, const Metric& metric) {
  std::vector<double> difference;
  for (size_t i = 0; i < one.x.size(); ++i) {
    const double value = (metric.more_is_better ? 1 : -1) * (one.y.at(metric.name)[i] - other.y.at(metric.name)[i]);
    difference.push_back(value == 0 ? nan : value);
  }
  return difference;
}

// How much cheaper one is, where the intervals of the ratios do not overlap. The baseline's ratio is 1 by definition.
std::vector<double> saving(const Curve& one, const Curve& other) {
  const auto ratio = [](const Curve& curve, const char* which, size_t i) { return curve.baseline ? 1 : curve.y.at(which)[i]; };
  std::vector<double> difference;
  for (size_t i = 0; i < one.x.size(); ++i) {
    const bool apart = ratio(one, "ratio.high", i) < ratio(other, "ratio.low", i) ||
                       ratio(other, "ratio.high", i) < ratio(one, "ratio.low", i);
    difference.push_back(apart ? ratio(other, "ratio", i) - ratio(one, "ratio", i) : nan);
  }
  return difference;
}

// Where a difference is above 0, from `begin` (a crossing, or none where it is so from the first sample on) to `end`.
struct Stretch {
  std::optional<Crossing> begin, end;
};

std::vector<Stretch> stretches_above(const Known& known) {
  std::vector<Stretch> stretches;
  if (known.x.empty()) return stretches;
  bool above = known.y.front() > 0;
  if (above) stretches.push_back({});
  for (const Crossing& crossing : crossings(known.x, known.y, 0)) {
    above = crossing.rising;
    if (above)
      stretches.push_back({crossing, {}});
    else
      stretches.back().end = crossing;
  }
  return stretches;
}

// Where both are.
std::vector<Stretch> common(const std::vector<Stretch>& a, const std::vector<Stretch>& b) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto at = [](const std::optional<Crossing>& crossing, double open) { return crossing ? crossing->at : open; };
  std::vector<Stretch> both;
  for (const Stretch& one : a)
    for (const Stretch& other : b) {
      const Stretch overlap{at(one.begin, -infinity) < at(other.begin, -infinity) ? other.begin : one.begin,
                            at(one.end, infinity) < at(other.end, infinity) ? one.end : other.end};
      if (at(overlap.begin, -infinity) < at(overlap.end, infinity)) both.push_back(overlap);
    }
  return both;
}

void add_stretches(const Curve& one, const Curve& other, const std::string& metric, const std::string& what, const Known& known,
                   const std::vector<Stretch>& stretches, std::vector<CrossoverRow>& rows) {
  const Sentence sentence(one);
  for (const Stretch& stretch : stretches) {
    CrossoverRow row = start(one, other.variant, metric);
    std::string where = "over all of " + sentence.range(known.x.front(), known.x.back());
    if (const std::optional<Crossing>& told = stretch.begin ? stretch.begin : stretch.end) {
      row.at = told->at, row.tolerance = told->tolerance;
      where = stretch.begin ? "from " + sentence.at(*stretch.begin) + (stretch.end ? "" : " on") : "";
      if (stretch.end) where += (stretch.begin ? " to " : "up to ") + sentence.at(*stretch.end);
    }
    row.sentence = fmt::format("{} is {} than {} {}{}", one.variant, what, other.variant, where, sentence.tail());
    rows.push_back(row);
  }
}

// From where on one is better, cheaper, or both, than the other.
void add_pair(const Curve& one, const Curve& other, const Metric& metric, std::vector<CrossoverRow>& rows) {
  if (one.x != other.x) return;  // one lacks points that the other has: a record that is not whole
  const Known cheaper(one.x, saving(one, other));
  const std::vector<Stretch> cheap = stretches_above(cheaper);
  add_stretches(one, other, "ratio", "cheaper", cheaper, cheap, rows);
  if (one.baseline || other.baseline) return;  // nothing is better than what errors are measured against
  const Known better(one.x, advantage(one, other, metric));
  const std::vector<Stretch> good = stretches_above(better);
  add_stretches(one, other, metric.name, fmt::format("better by {}", metric.words), better, good, rows);
  if (!cheaper.x.empty())
    add_stretches(one, other, fmt::format("{},ratio", metric.name), fmt::format("both cheaper and better by {}", metric.words),
                  better, common(good, cheap), rows);
}

bool one_group(const Curve& a, const Curve& b) {
  return a.backend == b.backend && a.effect == b.effect && a.parameter == b.parameter && a.held == b.held;
}

}  // namespace

Limit parse_limit(const std::string& text) {
  const size_t equals = text.find('=');
  std::vector<std::string> names;
  for (const Metric& metric : metrics)
    if (std::string_view(metric.name) != "ratio") names.emplace_back(metric.name);
  Limit limit;
  limit.metric = text.substr(0, equals);
  if (std::find(names.begin(), names.end(), limit.metric) == names.end())
    throw Error(ErrorKind::bad_input, "sweep", "--limit " + text, unknown_name("metric", limit.metric, names));
  char rest = 0;
  if (equals == std::string::npos || std::sscanf(text.c_str() + equals + 1, "%lf%c", &limit.value, &rest) != 1 ||
      !std::isfinite(limit.value))
    throw Error(ErrorKind::bad_input, "sweep", "--limit " + text, "takes METRIC=NUMBER, as in ssim=0.98");
  return limit;
}

std::vector<CrossoverRow> answers(const std::vector<Curve>& curves, const std::vector<Limit>& limits) {
  std::vector<CrossoverRow> rows;
  for (size_t begin = 0, end = 0; begin < curves.size(); begin = end) {
    while (end < curves.size() && one_group(curves[begin], curves[end])) ++end;
    for (size_t i = begin; i < end; ++i)
      for (const Limit& limit : limits)
        if (!curves[i].baseline) add_limit(curves[i], limit, rows);
    for (size_t i = begin; i < end && !limits.empty(); ++i)
      for (size_t other = begin; other < end; ++other)
        if (other != i) add_pair(curves[i], curves[other], *metric_named(limits.front().metric), rows);
  }
  return rows;
}

}  // namespace lamina
