// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/count_verdicts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace lamina {
namespace {

// Counts of a cell by what they count: a pass's invocations, and its fetches by texture.
struct Count {
  std::string what, pass, texture;
  auto operator<=>(const Count&) const = default;
};
std::map<Count, double> counts_of(const CellRow& cell) {
  std::map<Count, double> counts;
  for (const PassRow& pass : cell.passes) {
    counts[{"fragments", pass.name, ""}] += static_cast<double>(pass.fragments.value_or(0));
    counts[{"vertices", pass.name, ""}] += static_cast<double>(pass.vertices.value_or(0));
    for (const TextureFetches& fetched : pass.by_texture)
      counts[{"fetches", pass.name, fmt::format("{} ({}, {})", fetched.texture, fetched.format, fetched.filter)}] +=
          static_cast<double>(fetched.fetches);
  }
  return counts;
}

// By pass and class.
using OperationCounts = std::map<std::string, std::map<std::string, double>>;
OperationCounts operations_in(const CellRow& cell) {
  OperationCounts counts;
  for (const PassRow& pass : cell.passes)
    for (const auto& [operation, count] : pass.operations) counts[pass.name][operation] += static_cast<double>(count);
  return counts;
}

double sum_of(const std::map<std::string, double>& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0.0, [](double sum, const auto& each) { return sum + each.second; });
}

// Every key of either map with both values, 0 where a map lacks it.
template <class Key>
std::map<Key, std::pair<double, double>> side_by_side(const std::map<Key, double>& before, const std::map<Key, double>& after) {
  std::map<Key, std::pair<double, double>> both;
  for (const auto& [key, value] : before) both[key].first = value;
  for (const auto& [key, value] : after) both[key].second = value;
  return both;
}

void judge_operations(const VerdictSubject& subject, const CellRow& before, const CellRow& after,
                      std::set<std::string>& changed) {
  OperationCounts old_counts = operations_in(before), new_counts = operations_in(after);
  if (counts_operations(before) != counts_operations(after)) {
    changed.insert("operations");
    subject.add("operations", Verdict::not_compared, Cause::counted_once, after.view,
                {old_counts.empty() ? "before" : "after"});
    return;
  }
  std::set<std::string> passes;
  for (const OperationCounts* counts : {&old_counts, &new_counts})
    for (const auto& [pass, of_pass] : *counts) passes.insert(pass);
  for (const std::string& pass : passes) {
    std::vector<OperationChange> changes;
    bool more = false, fewer = false, too_many = false;
    for (const auto& [operation, both] : side_by_side(old_counts[pass], new_counts[pass])) {
      const auto [old_count, new_count] = both;
      if (old_count == new_count) continue;
      changes.push_back({operation, old_count, new_count});
      (new_count > old_count ? more : fewer) = true;
      too_many = too_many || new_count > old_count * (1 + subject.limits.max_extra_operations);
    }
    if (changes.empty()) continue;
    changed.insert("operations");
    const Verdict verdict = too_many && fewer ? Verdict::not_compared
                            : too_many        ? Verdict::worse
                            : more            ? Verdict::same
                                              : Verdict::better;
    VerdictRow& row = subject.add("operations", verdict, Cause::figures, after.view);
    row.pass = pass, row.operations = std::move(changes);
    row.before = sum_of(old_counts[pass]), row.after = sum_of(new_counts[pass]);
    if (too_many && !fewer) row.limit = *row.before * (1 + subject.limits.max_extra_operations);
  }
}

}  // namespace

void judge_counts(const VerdictSubject& subject, const CellRow& before, const CellRow& after, std::set<std::string>& changed) {
  for (const auto& [count, both] : side_by_side(counts_of(before), counts_of(after))) {
    const auto [old_count, new_count] = both;
    if (old_count == new_count) continue;
    changed.insert(count.what);
    const double allowed = old_count * (1 + subject.limits.max_extra_fetches);
    const Verdict verdict = new_count > allowed ? Verdict::worse : new_count > old_count ? Verdict::same : Verdict::better;
    VerdictRow& row = subject.add(count.what, verdict, Cause::figures, after.view);
    row.pass = count.pass, row.texture = count.texture;
    row.before = old_count, row.after = new_count, row.limit = allowed;
  }
  judge_operations(subject, before, after, changed);
}

bool counts_operations(const CellRow& cell) {
  return std::ranges::any_of(cell.passes, [](const PassRow& pass) { return !pass.operations.empty(); });
}

void judge_work_bounds(const VerdictSubject& subject, const CellRow& cell) {
  double operations = 0;
  for (const PassRow& pass : cell.passes)
    if (!pass.once)
      for (const auto& [operation, count] : pass.operations) operations += static_cast<double>(count);
  const auto check = [&](const char* what, const std::optional<double>& bound, std::optional<double> value) {
    if (!bound || (value && *value <= *bound)) return;
    VerdictRow& row = subject.add(what, Verdict::failed, value ? Cause::beyond_bound : Cause::not_counted, cell.view);
    row.after = value, row.limit = *bound;
  };
  const auto as_double = [](const std::optional<uint64_t>& value) {
    return value ? std::optional(static_cast<double>(*value)) : std::nullopt;
  };
  check("fetches", subject.limits.max_frame_fetches, as_double(cell.fetches));
  check("operations", subject.limits.max_frame_operations, operations > 0 ? std::optional(operations) : std::nullopt);
  check("target_bytes", subject.limits.max_target_bytes, as_double(cell.target_bytes));
}

}  // namespace lamina
