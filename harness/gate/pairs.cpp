// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/pairs.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "harness/gate/time_verdicts.h"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::ptrdiff_t whole_frame = -1;

std::optional<size_t> index_of(const PairsRow& row, std::string_view frame) {
  const auto found = std::find(row.frames.begin(), row.frames.end(), frame);
  if (found == row.frames.end()) return std::nullopt;
  return static_cast<size_t>(found - row.frames.begin());
}

double sum_ms(const PairsRow& row, size_t frame, std::ptrdiff_t only) {
  double sum = 0;
  for (size_t pass = 0; pass < row.passes.size(); ++pass)
    if (only == whole_frame || static_cast<size_t>(only) == pass) sum += whole_ms(row.passes[pass], frame).value_or(0);
  return sum;
}

struct Key {
  std::string backend, effect, variant, view;
  auto operator<=>(const Key&) const = default;
};

// The passes that are judged by themselves: those of the frame before and after that take enough of it.
std::vector<std::ptrdiff_t> judged_parts(const PairsRow& row) {
  const size_t before = *index_of(row, frame_before), after = *index_of(row, frame_after);
  const double whole = sum_ms(row, before, whole_frame);
  std::vector<std::ptrdiff_t> parts;
  for (size_t pass = 0; pass < row.passes.size(); ++pass) {
    const auto part = static_cast<std::ptrdiff_t>(pass);
    if (row.passes[pass].ms[before].empty() || row.passes[pass].ms[after].empty()) continue;
    if (std::max(sum_ms(row, before, part), sum_ms(row, after, part)) >= least_judged_share * whole) parts.push_back(part);
  }
  // A frame of one pass is that pass.
  if (row.passes.size() > 1) parts.insert(parts.begin(), whole_frame);
  return parts;
}

std::string percent(double ratio) { return fmt::format("{:+.1f}%", (ratio - 1) * 100); }

std::string sentence_of(const VerdictRow& row) {
  const std::string of = row.pass.empty() ? "the frame" : "pass " + row.pass;
  const char* words = row.verdict == Verdict::slower   ? "is slower"
                      : row.verdict == Verdict::faster ? "is faster"
                      : row.verdict == Verdict::same   ? "takes as long as before"
                                                       : "may or may not take as long as before";
  return fmt::format("{} on {}: {} {}: {} [{}, {}], margin {:.1f}%", row.variant, row.backend, of, words,
                     percent(row.ratio->median), percent(row.ratio->low), percent(row.ratio->high), *row.limit * 100);
}

}  // namespace

std::vector<double> ratios_of(const PairsRow& row, std::string_view frame, std::ptrdiff_t pass) {
  const std::optional<size_t> at = index_of(row, frame);
  if (!at || *at == 0) return {};
  return pass == whole_frame ? frame_ratios(row.passes, *at) : row.passes[static_cast<size_t>(pass)].ratio[*at];
}

TimeReport judge_pairs(const std::vector<PairsRow>& pairs, const LimitsFile& limits, double family_error) {
  std::map<Key, std::vector<const PairsRow*>> by_cell;
  TimeReport report;
  for (const PairsRow& row : pairs) {
    by_cell[{row.backend, row.effect, row.variant, row.view}].push_back(&row);
    size_t rounds = 0;  // of the first frame, any of whose passes is in each of them
    for (const PairedPass& pass : row.passes) rounds = std::max(rounds, pass.ms.front().size());
    report.rounds += rounds;
  }
  std::vector<TimeComparison> comparisons, same_comparisons;
  const auto add_comparison = [](std::vector<TimeComparison>& to, const std::vector<const PairsRow*>& processes, double margin,
                                 std::string_view frame, std::ptrdiff_t part) {
    TimeComparison& comparison = to.emplace_back();
    comparison.margin = margin;
    for (const PairsRow* process : processes) comparison.ratios.push_back(ratios_of(*process, frame, part));
  };
  for (const auto& [key, processes] : by_cell) {
    const PairsRow& first = *processes.front();
    const double margin = limits.of(key.effect, key.variant, key.backend).max_slowdown;
    if (index_of(first, frame_again)) {
      report.same_arms.push_back({key.backend, key.effect, key.variant, {}, Verdict::same});
      add_comparison(same_comparisons, processes, margin, frame_again, whole_frame);
    }
    if (!index_of(first, frame_after)) continue;
    for (const std::ptrdiff_t part : judged_parts(first)) {
      VerdictRow& row = report.rows.emplace_back();
      row.backend = key.backend, row.effect = key.effect, row.variant = key.variant, row.view = key.view, row.what = "time";
      if (part != whole_frame) row.pass = first.passes[static_cast<size_t>(part)].name;
      row.before = sum_ms(first, *index_of(first, frame_before), part);
      row.after = sum_ms(first, *index_of(first, frame_after), part);
      row.limit = margin;
      add_comparison(comparisons, processes, margin, frame_after, part);
    }
  }
  const std::vector<TimeVerdict> verdicts = judge_times(comparisons, family_error);
  const std::vector<TimeVerdict> same_verdicts = judge_times(same_comparisons, family_error);
  bool believable = true;
  for (size_t i = 0; i < same_verdicts.size(); ++i) {
    report.same_arms[i].verdict = same_verdicts[i].verdict, report.same_arms[i].ratio = same_verdicts[i].ratio;
    believable = believable && same_verdicts[i].verdict != Verdict::slower && same_verdicts[i].verdict != Verdict::faster;
  }
  for (size_t i = 0; i < verdicts.size(); ++i) {
    VerdictRow& row = report.rows[i];
    row.verdict = verdicts[i].verdict, row.ratio = verdicts[i].ratio;
    row.sentence = sentence_of(row);
    if (!believable && row.verdict != Verdict::same) {
      row.verdict = Verdict::ambiguous;
      row.sentence += "; but equal frames differ as much in this run, so it is not believed";
    }
    if (row.verdict == Verdict::ambiguous) report.undecided.insert(row.backend);
  }
  report.comparisons = comparisons.size();
  report.precision = worst_precision(comparisons, verdicts);
  return report;
}

Json to_json(const PairsRow& row) {
  Json passes = Json::array();
  for (const PairedPass& pass : row.passes)
    passes.push_back({{"name", pass.name}, {"cut", pass.cut}, {"ms", pass.ms}, {"ratio", pass.ratio}});
  return {{"kind", "pairs"},        {"process", row.process}, {"backend", row.backend}, {"effect", row.effect},
          {"variant", row.variant}, {"view", row.view},       {"frames", row.frames},   {"passes", passes}};
}

PairsRow pairs_from_json(const nlohmann::json& line) {
  PairsRow row;
  row.process = line.at("process");
  row.backend = line.at("backend"), row.effect = line.at("effect"), row.variant = line.at("variant"),
  row.view = line.at("view");
  row.frames = line.at("frames").get<std::vector<std::string>>();
  for (const nlohmann::json& pass : line.at("passes"))
    row.passes.push_back({pass.at("name"), pass.at("cut"), pass.at("ms").get<std::vector<std::vector<double>>>(),
                          pass.at("ratio").get<std::vector<std::vector<double>>>()});
  return row;
}

}  // namespace lamina
