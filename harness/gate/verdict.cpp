// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/verdict.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace lamina {
namespace {

bool is_good(Verdict verdict) { return verdict == Verdict::same || verdict == Verdict::better; }
bool is_count(const VerdictRow& row) {
  return row.what == "fetches" || row.what == "operations" || row.what == "fragments" || row.what == "vertices";
}
bool is_bad(Verdict verdict) { return verdict == Verdict::worse || verdict == Verdict::failed; }

// What the exact rows of a variant on a backend say.
struct Counted {
  bool same_code = false, fetches = false, operations = false, against = false;
  bool decides() const { return same_code || (fetches && operations && !against); }
};

}  // namespace

GateOutcome outcome_of(std::span<const VerdictRow> rows) {
  const auto any = [&](auto... verdicts) {
    return std::any_of(rows.begin(), rows.end(), [&](const VerdictRow& row) { return ((row.verdict == verdicts) || ...); });
  };
  if (any(Verdict::failed, Verdict::worse, Verdict::slower)) return {Verdict::failed, 1};
  if (any(Verdict::ambiguous) || !any(Verdict::same, Verdict::faster, Verdict::better)) return {Verdict::ambiguous, 3};
  return {any(Verdict::faster) ? Verdict::faster : Verdict::same, 0};
}

void let_counts_decide(std::vector<VerdictRow>& rows, const LimitsFile& limits) {
  std::map<std::tuple<std::string, std::string, std::string>, Counted> by_variant;
  for (const VerdictRow& row : rows) {
    if (row.variant.empty()) continue;
    Counted& counted = by_variant[{row.backend, row.effect, row.variant}];
    if (row.what == "code") counted.same_code = is_good(row.verdict);
    if (row.what == "fetches") counted.fetches = counted.fetches || is_good(row.verdict);
    if (row.what == "operations") counted.operations = counted.operations || is_good(row.verdict);
    const bool counts_disagree = row.what == "operations" && row.verdict == Verdict::not_compared;
    // Of a pass, a row is there because its count changed: one that is good enough and not better is more, and allowed.
    const bool more = is_count(row) && row.verdict == Verdict::same && !row.pass.empty();
    counted.against = counted.against || is_bad(row.verdict) || counts_disagree || more;
  }
  const auto may_stay_open = [&](const VerdictRow& row) {
    return !limits.of(row.effect, row.variant, row.backend).times_must_decide;
  };
  for (VerdictRow& row : rows) {
    if (row.what == "timer" && row.verdict == Verdict::ambiguous) {
      const bool all_decide = std::ranges::all_of(by_variant, [&](const auto& entry) {
        const auto& [backend, effect, variant] = entry.first;
        return backend != row.backend || (entry.second.decides() && !limits.of(effect, variant, backend).times_must_decide);
      });
      if (!all_decide) continue;
      row.verdict = Verdict::time_open, row.counts_hold = true;
    }
    if (row.what != "time" && row.what != "ratio") continue;
    if (const auto counted = by_variant.find({row.backend, row.effect, row.variant});
        counted == by_variant.end() || !counted->second.decides())
      continue;
    row.counts_hold = true;
    if (row.verdict == Verdict::ambiguous && may_stay_open(row)) row.verdict = Verdict::time_open;
  }
}

}  // namespace lamina
