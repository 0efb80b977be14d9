// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/stored.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "harness/core/error.h"
#include "harness/gate/exact_verdicts.h"
#include "harness/gate/verdict_rows.h"
#include "harness/record/record.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

struct VariantKey {
  std::string backend, effect, variant;
  auto operator<=>(const VariantKey&) const = default;
};
VariantKey key_of(const CellRow& cell) { return {cell.backend, cell.effect, cell.variant}; }

bool has_times(const CellRow& cell) { return cell.timed && !frame_samples_ms(cell.passes).empty(); }

const Json* device_of(const Record& record, const std::string& backend) {
  if (!record.run.contains("devices")) return nullptr;
  for (const Json& device : record.run.at("devices"))
    if (device.at("backend") == backend) return &device;
  return nullptr;
}

std::string text_of(const Json& object, const char* first, const char* second = nullptr) {
  const Json* value = object.contains(first) ? &object.at(first) : nullptr;
  if (value && second) value = value->contains(second) ? &value->at(second) : nullptr;
  return !value ? "unknown" : value->is_string() ? value->get<std::string>() : value->dump();
}

// The cells of both, by variant and backend, views in the order of the record and then of the run.
std::map<VariantKey, CellPair> pairs_of(const Record& stored, const Record& run) {
  std::map<VariantKey, std::vector<std::string>> views;
  for (const Record* record : {&stored, &run})
    for (const CellRow& cell : record->cells) {
      std::vector<std::string>& of_key = views[key_of(cell)];
      if (std::find(of_key.begin(), of_key.end(), cell.view) == of_key.end()) of_key.push_back(cell.view);
    }
  const auto find = [](const Record& record, const VariantKey& key, const std::string& view) -> std::optional<CellRow> {
    for (const CellRow& cell : record.cells)
      if (key_of(cell) == key && cell.view == view) return cell;
    return std::nullopt;
  };
  std::map<VariantKey, CellPair> pairs;
  for (const auto& [key, names] : views)
    for (const std::string& view : names) {
      pairs[key].before.push_back(find(stored, key, view));
      pairs[key].after.push_back(find(run, key, view));
    }
  return pairs;
}

// A ratio of two things that were measured apart.
struct Quotient {
  Interval ratio;
  Verdict verdict = Verdict::ambiguous;
};
Quotient quotient(const Interval& now, const Interval& then, double margin) {
  Quotient result;
  result.ratio = {now.median / then.median, now.low / then.high, now.high / then.low, std::min(now.rounds, then.rounds),
                  now.coverage + then.coverage - 1};
  if (result.ratio.low > 1 + margin) result.verdict = Verdict::slower;
  if (result.ratio.high < 1 / (1 + margin)) result.verdict = Verdict::faster;
  if (result.ratio.low >= 1 / (1 + margin) && result.ratio.high <= 1 + margin) result.verdict = Verdict::same;
  return result;
}

struct Judge {
  double confidence;  // of each of the two intervals
  std::vector<VerdictRow>& rows;

  VerdictRow& add(const CellRow& cell, const char* what, const std::string& pass, Cause cause) {
    VerdictRow& row = rows.emplace_back();
    row.cause = cause;
    const VariantKey key = key_of(cell);
    row.backend = key.backend, row.effect = key.effect, row.variant = key.variant;
    row.view = cell.view, row.what = what, row.pass = pass;
    return row;
  }

  void compare(const CellRow& cell, const char* what, const std::string& pass, const Interval& now, const Interval& then,
               double margin) {
    const auto [ratio, verdict] = quotient(now, then, margin);
    VerdictRow& row = add(cell, what, pass, Cause::against_record);
    row.verdict = verdict, row.ratio = ratio, row.before = then.median, row.after = now.median, row.limit = margin;
  }

  // Samples that are not positive are refused: neither a record nor a run may pass by having measured nothing. Too few samples,
  // as on a busy machine, decide nothing.
  std::optional<Interval> interval_in(const CellRow& cell, const char* whose, const std::string& pass,
                                      const std::vector<double>& ms) {
    const bool are_times = !ms.empty() && std::all_of(ms.begin(), ms.end(), [](double each) { return each > 0; });
    if (are_times && ms.size() >= min_rounds_for_95) return widest_interval(ms, confidence);
    VerdictRow& row = add(cell, "time", pass, Cause::too_few_samples);
    row.verdict = are_times ? Verdict::ambiguous : Verdict::failed;
    row.details = {whose, std::to_string(ms.size()), std::to_string(min_rounds_for_95)};
    return std::nullopt;
  }

  void times(const CellRow& before, const CellRow& after, double margin) {
    const auto then = interval_in(before, "before", "", frame_samples_ms(before.passes));
    const auto now = interval_in(after, "after", "", frame_samples_ms(after.passes));
    if (then && now) compare(after, "time", "", *now, *then, margin);
  }

  void bound(const CellRow& cell, const std::optional<double>& max_ms) {
    if (!max_ms) return;
    const double ms = median(frame_samples_ms(cell.passes));
    if (ms <= *max_ms) return;
    fail_frame_ms(add(cell, "frame_ms", "", Cause::beyond_bound), ms, *max_ms);
  }

  void ratio(const CellRow& before, const CellRow& after, double margin) {
    const std::optional<Interval>&then = before.ratio_to_baseline, &now = after.ratio_to_baseline;
    if (!then || !now) return;
    if (!(then->low > 0) || !(now->low > 0)) {
      add(after, "ratio", "", Cause::ratio_of_zero).verdict = Verdict::failed;
      return;
    }
    compare(after, "ratio", "", *now, *then, margin);
  }
};

}  // namespace

std::string difference_of_machines(const Record& stored, const Record& run, const std::string& backend) {
  const Json *then = device_of(stored, backend), *now = device_of(run, backend);
  if (!then || !now) return "the record does not say on which device it ran";
  std::string words;
  const auto compare = [&](const char* what, const std::string& was, const std::string& is) {
    if (was != is) words += fmt::format("{}{} was {}, is {}", words.empty() ? "" : "; ", what, was, is);
  };
  for (const char* what : {"cpu", "threads", "lp_num_threads"})
    compare(what, text_of(stored.run, "machine", what), text_of(run.run, "machine", what));
  for (const char* what : {"device", "driver"}) compare(what, text_of(*then, what), text_of(*now, what));
  compare("build", text_of(stored.run, "build"), text_of(run.run, "build"));
  return words;
}

void check_comparable(const Record& stored, const Record& run, const std::filesystem::path& file) {
  const auto refuse = [&](std::string message) {
    throw Error(ErrorKind::bad_input, "gate", file.string(), std::move(message));
  };
  constexpr const char* make_again = "make it again with --update";
  if (stored.run.contains("truncated"))
    refuse(fmt::format("{}; a record that lost cells is no baseline: {}", stored.run.at("truncated").get<std::string>(),
                       make_again));
  if (stored.cells.empty()) refuse(fmt::format("holds no cells; {}", make_again));
  const auto differ = [&](const char* what, const std::string& was, const std::string& is) {
    if (was != is) refuse(fmt::format("is of {} {}, this run of {}; compare like with like, or {}", what, was, is, make_again));
  };
  differ("scene", text_of(stored.run, "scene"), text_of(run.run, "scene"));
  differ("moment", text_of(stored.run, "time_s"), text_of(run.run, "time_s"));
  differ("width", text_of(stored.run, "settings", "width"), text_of(run.run, "settings", "width"));
  differ("height", text_of(stored.run, "settings", "height"), text_of(run.run, "settings", "height"));
  std::set<VariantKey> known;
  for (const CellRow& cell : stored.cells) known.insert(key_of(cell));
  if (std::none_of(run.cells.begin(), run.cells.end(), [&](const CellRow& cell) { return known.contains(key_of(cell)); }))
    refuse("has no cell in common with this run: no variant on the same backend");
}

std::vector<VerdictRow> judge_stored(const Record& stored, const Record& run, const LimitsFile& limits, double family_error) {
  std::map<VariantKey, CellPair> pairs = pairs_of(stored, run);
  std::vector<VerdictRow> rows;
  // Two intervals a comparison, at most two comparisons a pair. Bonferroni, since a stored interval's confidence is fixed.
  Judge judge{1 - family_error / (4 * static_cast<double>(std::max<size_t>(pairs.size(), 1))), rows};
  std::map<std::string, std::string> differences;
  for (auto& [key, pair] : pairs) {
    if (!differences.contains(key.backend)) {
      const std::string words = differences[key.backend] = difference_of_machines(stored, run, key.backend);
      if (!words.empty()) {
        VerdictRow& row = rows.emplace_back();
        row.backend = key.backend, row.what = "time", row.verdict = Verdict::not_compared;
        row.cause = Cause::another_machine, row.details = {words};
      }
    }
    const bool same_machine = differences[key.backend].empty();
    const Limits cell_limits = limits.of(key.effect, key.variant, key.backend);
    pair.hashes_tell = same_machine;
    for (VerdictRow& row : judge_cells(pair, cell_limits)) rows.push_back(std::move(row));
    for (size_t view = 0; view < pair.after.size(); ++view) {
      const std::optional<CellRow>&before = pair.before[view], &after = pair.after[view];
      if (!before || !after || before->failed || after->failed) continue;
      const bool was_timed = has_times(*before), is_timed = has_times(*after);
      if (!was_timed && !is_timed) continue;
      if (was_timed != is_timed) {
        VerdictRow& row = judge.add(*after, "time", "", Cause::timed_once);
        row.verdict = was_timed && !after->timed ? Verdict::ambiguous : Verdict::not_compared;
        row.details = {was_timed ? "before" : "after"};
        continue;
      }
      judge.ratio(*before, *after, cell_limits.max_ratio_drift);
      if (same_machine) judge.times(*before, *after, cell_limits.max_drift);
      judge.bound(*after, cell_limits.max_frame_ms);
    }
  }
  return rows;
}

}  // namespace lamina
