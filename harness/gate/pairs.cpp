// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/pairs.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "harness/gate/time_verdicts.h"
#include "harness/gate/verdict_rows.h"
#include "harness/measure/statistics.h"

namespace lamina {
namespace {

using Part = std::optional<size_t>;  // a pass by its place, or the whole frame
constexpr Part whole_frame = std::nullopt;

std::optional<size_t> index_of(const PairsRow& row, std::string_view frame) {
  const auto found = std::find(row.frames.begin(), row.frames.end(), frame);
  if (found == row.frames.end()) return std::nullopt;
  return static_cast<size_t>(found - row.frames.begin());
}

double sum_ms(const PairsRow& row, size_t frame, Part part) {
  double sum = 0;
  for (size_t pass = 0; pass < row.passes.size(); ++pass)
    if (!part || *part == pass) sum += whole_ms(row.passes[pass], frame).value_or(0);
  return sum;
}

struct ViewKey {
  std::string backend, effect, variant, view;
  auto operator<=>(const ViewKey&) const = default;
};

// The passes that are judged: those in both frames that take enough of the frame and may differ.
std::vector<Part> judged_parts(const PairsRow& row, std::string_view frame, const Limits& limits) {
  const size_t before = *index_of(row, frame_before), after = *index_of(row, frame);
  const double whole = sum_ms(row, before, whole_frame);
  std::vector<Part> parts;
  for (size_t pass = 0; pass < row.passes.size(); ++pass) {
    if (row.passes[pass].ms[before].empty() || row.passes[pass].ms[after].empty()) continue;
    if (std::max(sum_ms(row, before, pass), sum_ms(row, after, pass)) >= limits.min_pass_share * whole) parts.push_back(pass);
  }
  // A frame of one pass is that pass.
  if (row.passes.size() > 1) parts.insert(parts.begin(), whole_frame);
  return parts;
}

// A time with its error, ms.
struct TimeEstimate {
  double ms = 0, error = 0;
};

// A pass that only one of the frames has: by the rounds' spread.
TimeEstimate time_alone(const PairedPass& pass, size_t frame) {
  std::vector<StripPair> rounds;
  for (const double ms : pass.ms[frame]) rounds.push_back({1, ms});
  const double ms = whole_ms(pass, frame).value_or(0);
  return {ms, ms * estimate_ratio(rounds).error};
}

// A row for each frame that takes longer than its bound.
void judge_frame_ms(std::vector<VerdictRow>& rows, const std::map<ViewKey, std::vector<const PairsRow*>>& by_cell,
                    const LimitsFile& limits) {
  std::vector<VerdictRow> too_long;
  for (const VerdictRow& row : rows) {
    const std::optional<double> bound = limits.of(row.effect, row.variant, row.backend).max_frame_ms;
    const bool is_frame =
        row.pass.empty() || by_cell.at({row.backend, row.effect, row.variant, row.view}).front()->passes.size() == 1;
    if (!bound || !is_frame || *row.after <= *bound) continue;
    VerdictRow& longer = too_long.emplace_back(row);
    longer.ratio.reset();
    fail_frame_ms(longer, *row.after, *bound);
  }
  rows.insert(rows.end(), too_long.begin(), too_long.end());
}

}  // namespace

RatioEstimate estimate_of(const PairsRow& row, std::string_view frame, Part pass) {
  const std::optional<size_t> at = index_of(row, frame);
  if (!at || *at == 0)
    throw Error(ErrorKind::failed, "gate", row.variant, fmt::format("has no times of frame '{}' beside another", frame));
  if (pass) return estimate_ratio(row.passes.at(*pass).strips[*at]);
  double before = 0, after = 0, square = 0;
  size_t strips = 0;
  for (const PairedPass& each : row.passes) {
    const bool in_before = !each.ms[0].empty(), in_after = !each.ms[*at].empty() || each.same[*at];
    TimeEstimate here;
    if (each.same[*at]) {
      here.ms = whole_ms(each, 0).value_or(0);
    } else if (in_before && in_after) {
      const RatioEstimate ratio = estimate_ratio(each.strips[*at]);
      here.ms = whole_ms(each, 0).value_or(0) * std::exp(ratio.log_ratio);
      here.error = here.ms * ratio.error;
      strips += ratio.strips;
    } else if (in_before || in_after) {
      here = time_alone(each, in_after ? *at : 0);
    }
    if (in_before) before += whole_ms(each, 0).value_or(0);
    if (in_after) after += here.ms;
    square += here.error * here.error;
  }
  if (!(before > 0) || !(after > 0))
    throw Error(ErrorKind::failed, "gate", row.variant, "has too few rounds to make up a whole frame");
  return {std::log(after / before), std::sqrt(square) / after, strips, freedom_of(strips)};
}

double worst_error(const PairsRow& row, const LimitsFile& limits) {
  double worst = 0;
  if (index_of(row, frame_again)) worst = estimate_of(row, frame_again).error;
  const Limits allowed = limits.of(row.effect, row.variant, row.backend);
  if (index_of(row, frame_after))
    for (const Part part : judged_parts(row, frame_after, allowed))
      worst = std::max(worst, estimate_of(row, frame_after, part).error);
  return worst / allowed.max_slowdown;
}

size_t rounds_in(const std::vector<PairsRow>& pairs) {
  size_t all = 0;
  for (const PairsRow& row : pairs) {
    size_t rounds = 0;  // of the first frame, any of whose passes is in each of them
    for (const PairedPass& pass : row.passes) rounds = std::max(rounds, pass.ms.front().size());
    all += rounds;
  }
  return all;
}

TimeReport judge_pairs(const std::vector<PairsRow>& pairs, const LimitsFile& limits, double family_error) {
  std::map<ViewKey, std::vector<const PairsRow*>> by_cell;
  TimeReport report;
  report.rounds = rounds_in(pairs);
  for (const PairsRow& row : pairs) by_cell[{row.backend, row.effect, row.variant, row.view}].push_back(&row);

  std::vector<TimeComparison> comparisons, same_comparisons;
  std::vector<PooledRatio> passes;  // a whole frame adds nothing to its passes
  const auto ratios_of = [](const std::vector<const PairsRow*>& processes, std::string_view frame, Part part) {
    std::vector<RatioEstimate> ratios;
    for (const PairsRow* process : processes) ratios.push_back(estimate_of(*process, frame, part));
    return ratios;
  };
  for (const auto& [key, processes] : by_cell) {
    const PairsRow& first = *processes.front();
    const Limits allowed = limits.of(key.effect, key.variant, key.backend);
    const double margin = allowed.max_slowdown;
    if (index_of(first, frame_again)) {
      report.same_arms.push_back({key.backend, key.effect, key.variant, {}, Verdict::same});
      same_comparisons.push_back({ratios_of(processes, frame_again, whole_frame), margin});
      for (const Part part : judged_parts(first, frame_again, allowed))
        if (part) passes.push_back(pool(ratios_of(processes, frame_again, part)));
    }
    if (!index_of(first, frame_after)) continue;
    for (const Part part : judged_parts(first, frame_after, allowed)) {
      VerdictRow& row = report.rows.emplace_back();
      row.backend = key.backend, row.effect = key.effect, row.variant = key.variant, row.view = key.view, row.what = "time";
      if (part) row.pass = first.passes[*part].name;
      std::vector<double> wholes;
      for (const PairsRow* process : processes) wholes.push_back(sum_ms(*process, *index_of(*process, frame_before), part));
      row.before = median(wholes);
      row.limit = margin;
      comparisons.push_back({ratios_of(processes, frame_after, part), margin});
      if (part) passes.push_back(pool(comparisons.back().processes));
    }
  }
  const SharedDisagreement shared = shared_disagreement(passes);
  const std::vector<TimeVerdict> verdicts = judge_times(comparisons, shared, family_error);
  const std::vector<TimeVerdict> same_verdicts = judge_times(same_comparisons, shared, family_error);
  bool believable = true;
  for (size_t i = 0; i < same_verdicts.size(); ++i) {
    report.same_arms[i].verdict = same_verdicts[i].verdict, report.same_arms[i].ratio = same_verdicts[i].ratio;
    believable = believable && same_verdicts[i].verdict != Verdict::slower && same_verdicts[i].verdict != Verdict::faster;
  }
  for (size_t i = 0; i < verdicts.size(); ++i) {
    VerdictRow& row = report.rows[i];
    row.verdict = verdicts[i].verdict, row.ratio = verdicts[i].ratio;
    row.after = *row.before * row.ratio->median;
    row.cause = Cause::figures;
    if (!believable && row.verdict != Verdict::same) {
      row.cause = Cause::arm_differs, row.details = {std::string(name_of(row.verdict))};
      row.verdict = Verdict::ambiguous;
    }
    if (row.verdict == Verdict::ambiguous) report.undecided.insert({row.backend, row.effect, row.variant});
  }
  if (!report.undecided.empty())
    for (const SameArmRow& arm : report.same_arms)
      if (arm.verdict != Verdict::same) report.undecided.insert({arm.backend, arm.effect, arm.variant});
  judge_frame_ms(report.rows, by_cell, limits);
  report.comparisons = comparisons.size();
  return report;
}

}  // namespace lamina
