// SPDX-License-Identifier: Apache-2.0
#include "harness/sweep/answers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <tuple>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/sweep/crossings.h"

namespace lamina {
namespace {

// "fov_y_degrees" of "views.front.fov_y_degrees", "position.x" of "lights.rim.position.x", and "key.intensity" of
// "lights.key.intensity" where the curve has "lights.rim.intensity" too.
std::string short_name(const std::string& path, const Curve& curve) {
  static const std::vector<std::string> parts = {"x", "y", "z", "red", "green", "blue"};
  const auto before = [&](size_t dot) {
    return dot == 0 || dot == std::string::npos ? std::string::npos : path.rfind('.', dot - 1);
  };
  size_t dot = path.rfind('.');
  if (dot != std::string::npos && std::find(parts.begin(), parts.end(), path.substr(dot + 1)) != parts.end()) dot = before(dot);
  const auto is_of_another = [&](const std::string& end) {
    const auto has = [&](const std::string& other) { return other != path && other.ends_with(end); };
    return has(curve.parameter) || std::ranges::any_of(curve.held, [&](const Held& held) { return has(held.path); });
  };
  while (dot != std::string::npos && is_of_another(path.substr(dot))) dot = before(dot);
  return dot == std::string::npos ? path : path.substr(dot + 1);
}

// How a parameter of the curve is named, and the unit behind its values. A unit such as " degrees" is then cut from the name.
struct Named {
  std::string name, unit;
};
Named named(const std::string& path, const std::string& unit, const Curve& curve) {
  std::string name = short_name(path, curve);
  if (name.ends_with("_" + unit)) name.resize(name.size() - unit.size() - 1);
  return {name, unit.empty() ? "" : " " + unit};
}

// Four digits are more than any tolerance carries.
std::string words(double value) { return fmt::format("{:.4g}", value); }

class Sentence {
 public:
  explicit Sentence(const Curve& curve) : x_(named(curve.parameter, curve.unit, curve)) {}
  std::string at(const Crossing& crossing) const {
    return fmt::format("{} {}{} (within {:.2g})", x_.name, words(crossing.at), x_.unit, crossing.tolerance);
  }
  std::string range(double from, double to) const {
    return from == to ? fmt::format("{} {}{}", x_.name, words(from), x_.unit)
                      : fmt::format("{} {} to {}{}", x_.name, words(from), words(to), x_.unit);
  }

 private:
  Named x_;
};

CrossoverRow start(const Curve& curve, const std::string& other, const std::string& metric) {
  CrossoverRow row;
  row.parameter = curve.parameter, row.backend = curve.backend, row.effect = curve.effect, row.variant = curve.variant;
  row.other = other, row.metric = metric;
  for (const Held& held : curve.held) row.held[held.path] = held.value;
  return row;
}

void tell(CrossoverRow& row, const Curve& curve, const std::string& claim, const std::string& remark) {
  row.claim = claim + place_words(curve);
  row.remark = remark;
  row.sentence = fmt::format("{} on {}{}", row.claim, row.backend, row.remark);
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
  const std::string remark = missing > 0 ? fmt::format("; {} of {} points are missing", missing, y.size()) : "";
  const auto add = [&](const std::string& text, const Crossing* crossing) {
    CrossoverRow row = start(curve, "", limit.metric);
    row.limit = limit.value;
    if (crossing) row.at = crossing->at, row.tolerance = crossing->tolerance;
    tell(row, curve, curve.variant + " " + text, remark);
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
    add(found[i].rising ? fmt::format("keeps {} from {} upwards", bound, at)
        : i == 0        ? fmt::format("keeps {} up to {}", bound, at)
                        : fmt::format("no longer keeps {} from {} upwards", bound, at),
        &found[i]);
  }
}

// By how much one is better or cheaper (above 0) than the other, sample by sample. NaN where that is not known and where they
// are alike, so that a crossing is looked for only between samples that differ.
struct Advantage {
  std::vector<double> y;
  size_t alike = 0, compared = 0;  // samples
  bool everywhere() const { return alike == 0; }
};

Advantage better_by(const Curve& one, const Curve& other, const Metric& metric) {
  Advantage advantage;
  for (size_t i = 0; i < one.x.size(); ++i) {
    const double ours = one.y.at(metric.name)[i], theirs = other.y.at(metric.name)[i];
    advantage.alike += ours == theirs;
    advantage.compared += !std::isnan(ours) && !std::isnan(theirs);
    advantage.y.push_back(ours == theirs ? nan : (metric.more_is_better ? 1 : -1) * (ours - theirs));
  }
  return advantage;
}

// Alike are those whose ratios' intervals overlap. The baseline's ratio is 1 by definition.
Advantage cheaper_by(const Curve& one, const Curve& other) {
  Advantage advantage;
  const auto ratio = [](const Curve& curve, const char* which, size_t i) { return curve.baseline ? 1 : curve.y.at(which)[i]; };
  for (size_t i = 0; i < one.x.size(); ++i) {
    const bool apart = ratio(one, "ratio.high", i) < ratio(other, "ratio.low", i) ||
                       ratio(other, "ratio.high", i) < ratio(one, "ratio.low", i);
    const bool timed = !std::isnan(ratio(one, "ratio", i)) && !std::isnan(ratio(other, "ratio", i));
    advantage.compared += timed;
    advantage.alike += timed && !apart;
    advantage.y.push_back(apart ? ratio(other, "ratio", i) - ratio(one, "ratio", i) : nan);
  }
  return advantage;
}

// Where one is ahead: between two crossings, or from the first or to the last sample that is not NaN.
struct Stretch {
  double from = 0, to = 0;
  std::optional<Crossing> begin, end;
};

std::vector<Stretch> stretches_ahead(const std::vector<double>& x, const Advantage& advantage) {
  std::vector<Stretch> stretches;
  const Known known(x, advantage.y);
  if (known.x.empty()) return stretches;
  if (known.y.front() > 0) stretches.push_back({known.x.front(), known.x.back(), {}, {}});
  for (const Crossing& crossing : crossings(known.x, known.y, 0)) {
    if (crossing.rising)
      stretches.push_back({crossing.at, known.x.back(), crossing, {}});
    else
      stretches.back().to = crossing.at, stretches.back().end = crossing;
  }
  return stretches;
}

// Where both are ahead.
std::vector<Stretch> common(const std::vector<Stretch>& a, const std::vector<Stretch>& b) {
  std::vector<Stretch> both;
  for (const Stretch& one : a)
    for (const Stretch& other : b) {
      const Stretch &late = one.from < other.from ? other : one, &early = one.to < other.to ? one : other;
      if (late.from <= early.to && (late.from < early.to || (!late.begin && !early.end)))
        both.push_back({late.from, early.to, late.begin, early.end});
    }
  return both;
}

// "from thickness 9.1 texels (within 0.2) upwards".
std::string words_of(const Stretch& stretch, const Curve& curve, bool everywhere) {
  const Sentence sentence(curve);
  const bool from_first = stretch.from == curve.x.front(), to_last = stretch.to == curve.x.back();
  if (!stretch.begin && !stretch.end)
    return (everywhere && from_first && to_last ? "over all of "
            : stretch.from == stretch.to        ? "at "
                                                : "over ") +
           sentence.range(stretch.from, stretch.to);
  const std::string from = stretch.begin ? sentence.at(*stretch.begin) : sentence.range(stretch.from, stretch.from);
  const std::string to = stretch.end ? sentence.at(*stretch.end) : sentence.range(stretch.to, stretch.to);
  if (!stretch.begin && from_first) return "up to " + to;
  return "from " + from + (!stretch.end && to_last ? " upwards" : " to " + to);
}

// An answer about two variants, and whether the first is nowhere behind the second.
struct PairAnswer {
  CrossoverRow row;
  bool in_order = false;
};

class Pairs {
 public:
  Pairs(std::span<const Curve> curves, const Metric& metric) : metric_(metric) {
    for (const Curve& one : curves)
      for (const Curve& other : curves)
        if (&one != &other && one.x == other.x) add(one, other);  // else a record that is not whole
  }

  // An answer that follows from two others is left out: a against c, where a is nowhere behind b, and b nowhere behind c.
  std::vector<CrossoverRow> rows() const {
    std::vector<CrossoverRow> rows;
    for (const PairAnswer& answer : answers_) {
      const auto follows_by = [&](const PairAnswer& first) {
        return first.row.variant == answer.row.variant && first.row.metric == answer.row.metric &&
               first.row.other != answer.row.other && ahead_.contains({first.row.metric, first.row.variant, first.row.other}) &&
               ahead_.contains({first.row.metric, first.row.other, answer.row.other});
      };
      if (!answer.in_order || std::none_of(answers_.begin(), answers_.end(), follows_by)) rows.push_back(answer.row);
    }
    return rows;
  }

 private:
  // From where on one is better, cheaper, or both, than the other.
  void add(const Curve& one, const Curve& other) {
    const Advantage cost = cheaper_by(one, other);
    const std::vector<Stretch> cheap = stretches_ahead(one.x, cost);
    const std::string overlap =
        cost.everywhere() ? "" : fmt::format("; at {} of {} timed points their intervals overlap", cost.alike, cost.compared);
    add_stretches(one, other, "ratio", "cheaper", told_once(one, other, cheap), cost.everywhere(), cost.everywhere(), overlap);
    // Nothing is better than what errors are measured against.
    if ((one.baseline || other.baseline) && !std::string_view(metric_.name).starts_with("truth.")) return;
    const Advantage quality = better_by(one, other, metric_);
    const std::vector<Stretch> good = stretches_ahead(one.x, quality);
    const std::string equal =
        quality.everywhere() ? "" : fmt::format("; at {} of {} points they are equal", quality.alike, quality.compared);
    add_stretches(one, other, metric_.name, fmt::format("better by {}", metric_.words), told_once(one, other, good),
                  quality.everywhere(), quality.compared == one.x.size(), equal);
    add_stretches(one, other, fmt::format("{},ratio", metric_.name),
                  fmt::format("both cheaper and better by {}", metric_.words), common(good, cheap),
                  cost.everywhere() && quality.everywhere(), cost.everywhere() && quality.everywhere(), equal + overlap);
  }

  // Where one is ahead up to a crossing, the other is ahead from there on. Only one of the two is reported: the variant where
  // the other is the baseline, else the later one.
  static std::vector<Stretch> told_once(const Curve& one, const Curve& other, std::vector<Stretch> stretches) {
    std::erase_if(stretches, [&](const Stretch& stretch) {
      return !other.baseline && (one.baseline ? stretch.begin || stretch.end : !stretch.begin && stretch.end);
    });
    return stretches;
  }

  void add_stretches(const Curve& one, const Curve& other, const std::string& metric, const std::string& what,
                     const std::vector<Stretch>& stretches, bool everywhere, bool in_order, const std::string& remark) {
    for (const Stretch& stretch : stretches) {
      PairAnswer& answer = answers_.emplace_back();
      answer.row = start(one, other.variant, metric);
      if (const std::optional<Crossing>& told = stretch.begin ? stretch.begin : stretch.end)
        answer.row.at = told->at, answer.row.tolerance = told->tolerance;
      tell(answer.row, one,
           fmt::format("{} is {} than {} {}", one.variant, what, other.variant, words_of(stretch, one, everywhere)), remark);
      answer.in_order = in_order && !stretch.begin && !stretch.end && !one.baseline && !other.baseline;
      if (answer.in_order) ahead_.insert({metric, one.variant, other.variant});
    }
  }

  const Metric& metric_;
  std::vector<PairAnswer> answers_;
  std::set<std::tuple<std::string, std::string, std::string>> ahead_;  // metric, one, other: of those in order
};

}  // namespace

Limit parse_limit(const std::string& stage, const std::string& text) {
  const size_t equals = text.find('=');
  std::vector<std::string> names;
  for (const Metric& metric : metrics)
    if (std::string_view(metric.name) != "ratio") names.emplace_back(metric.name);
  Limit limit;
  limit.metric = text.substr(0, equals);
  if (std::find(names.begin(), names.end(), limit.metric) == names.end())
    throw Error(ErrorKind::bad_input, stage, "--limit " + text, unknown_name("metric", limit.metric, names));
  char rest = 0;
  if (equals == std::string::npos || std::sscanf(text.c_str() + equals + 1, "%lf%c", &limit.value, &rest) != 1 ||
      !std::isfinite(limit.value))
    throw Error(ErrorKind::bad_input, stage, "--limit " + text, "takes METRIC=NUMBER, as in ssim=0.98");
  return limit;
}

std::string place_words(const Curve& curve) {
  std::string place;
  for (const Held& held : curve.held) {
    const Named other = named(held.path, held.unit, curve);
    place += fmt::format(", at {} {}{}", other.name, words(held.value), other.unit);
  }
  return place;
}

std::vector<CrossoverRow> answers(const std::vector<Curve>& curves, const std::vector<Limit>& limits) {
  std::vector<CrossoverRow> rows;
  for (size_t begin = 0, end = 0; begin < curves.size(); begin = end) {
    while (end < curves.size() && in_one_group(curves[begin], curves[end])) ++end;
    for (size_t i = begin; i < end; ++i)
      for (const Limit& limit : limits)
        if (!curves[i].baseline || limit.metric.starts_with("truth.")) add_limit(curves[i], limit, rows);
    if (limits.empty()) continue;
    const Pairs pairs(std::span<const Curve>(curves).subspan(begin, end - begin), *metric_named(limits.front().metric));
    for (CrossoverRow& row : pairs.rows()) rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<CrossoverRow> crossovers_of(const Record& record) {
  std::vector<CrossoverRow> rows = record.crossovers;
  if (record.sweeps.empty() || std::ranges::none_of(rows, [](const CrossoverRow& row) { return row.claim.empty(); }))
    return rows;
  std::vector<Limit> limits = record.sweeps.front().limits;
  std::erase_if(limits, [](const Limit& limit) { return limit.metric == "ratio" || !metric_named(limit.metric); });
  const std::vector<CrossoverRow> again = answers(curves_of(record), limits);
  for (CrossoverRow& row : rows) {
    const auto same = std::ranges::find_if(again, [&](const CrossoverRow& found) {
      return std::tie(found.parameter, found.backend, found.effect, found.sentence) ==
             std::tie(row.parameter, row.backend, row.effect, row.sentence);
    });
    if (row.claim.empty() && same != again.end()) row.held = same->held, row.claim = same->claim, row.remark = same->remark;
  }
  return rows;
}

}  // namespace lamina
