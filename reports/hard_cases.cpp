// SPDX-License-Identifier: Apache-2.0
// The hard cases of functions: whether each keeps its bounds on each set of inputs, and at which input it is worst.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>

#include "reports/functions.h"

namespace lamina {
namespace {

// "1.5 0.25 1.2", nothing for none. Nine digits distinguish any two binary32 numbers.
std::string input_words(const std::vector<double>& input) { return fmt::format("{:.9g}", fmt::join(input, " ")); }

bool worst_is_over(const FunctionRow& row) { return *row.max_over > -*row.max_under; }

// Where the greatest error is; none where no value is finite or none errs.
std::vector<double> worst_input(const FunctionRow& row) {
  if (!row.max_over) return {};
  return worst_is_over(row) ? row.worst_over : row.worst_under;
}

std::string claim_words(const FunctionRow& row) {
  if (!row.bounds) return "-";
  std::string words = fmt::format("{} to {}", words_for_error(row.bounds->under, 3), words_for_error(row.bounds->over, 3));
  if (row.bounds->eps_kappa) words += fmt::format(", eps kappa {}", words_for_error(row.bounds->eps_kappa, 3));
  return words;
}

bool within_bounds(const FunctionRow& row) {
  if (!row.bounds || !row.max_over) return true;
  const FunctionBounds& bounds = *row.bounds;
  return *row.max_over <= bounds.over && *row.max_under >= bounds.under &&
         (!bounds.eps_kappa || *row.max_eps_kappa <= *bounds.eps_kappa);
}

// What no value may be.
constexpr std::array<std::pair<uint64_t FunctionRow::*, const char*>, 3> kinds_of_faults = {
    {{&FunctionRow::negative, "negative"},
     {&FunctionRow::nonfinite, "not finite"},
     {&FunctionRow::not_zero, "not 0 where 0 is right"}}};

// "tiny (1521 negative, 428 not finite of 2000 values, the first at 1e-06 2e-06 3e-06)".
std::string failure_words(const FunctionRow& row) {
  std::vector<std::string> faults, parts;
  for (const auto& [count, words] : kinds_of_faults)
    if (row.*count > 0) faults.push_back(fmt::format("{} {}", row.*count, words));
  if (!faults.empty()) {
    parts.push_back(fmt::format("{} of {} values", fmt::join(faults, ", "), row.points));
    if (!row.first_fault.empty()) parts.back() += ", the first at " + input_words(row.first_fault);
  }
  if (!within_bounds(row))
    parts.push_back(fmt::format("errs by {} at {}, claims {}",
                                words_for_error(worst_is_over(row) ? row.max_over : row.max_under, 3),
                                input_words(worst_input(row)), claim_words(row)));
  return fmt::format("{} ({})", row.set, fmt::join(parts, "; "));
}

constexpr const char* function_set_note =
    "Bounds hold where every value is finite, none is negative where the exact value is not, the value is 0 where 0 is exact, "
    "and no error is beyond what the function claims on that set; - means that the function claims nothing there. eps: the "
    "greatest error in units of 2^-23; eps kappa: the greatest error of the value itself, in units of 2^-23 times its "
    "condition number where that is above 1; not 0: values that should be exactly 0.";

std::vector<const FunctionRow*> rows_by_set(const FunctionBackend& backend) {
  std::vector<const FunctionRow*> rows;
  std::map<std::string, size_t> place;  // of each set
  for (const FunctionSummary& variant : backend.variants)
    for (const FunctionRow* row : variant.sets) {
      place.try_emplace(row->set, place.size());
      rows.push_back(row);
    }
  std::ranges::stable_sort(rows,
                           [&](const FunctionRow* a, const FunctionRow* b) { return place.at(a->set) < place.at(b->set); });
  return rows;
}

}  // namespace

Keeps keeps_bounds(const FunctionRow& row) {
  for (const auto& [count, unused] : kinds_of_faults)
    if (row.*count > 0) return Keeps::no;
  if (!within_bounds(row)) return Keeps::no;
  return row.bounds ? Keeps::yes : Keeps::claims_none;
}

std::vector<Headline> hard_case_headlines(const FunctionBackend& backend) {
  std::vector<Headline> all;
  for (const FunctionSummary& variant : backend.variants) {
    size_t hold = 0, none = 0;
    std::vector<std::string> failed;
    for (const FunctionRow* row : variant.sets) {
      const Keeps keeps = keeps_bounds(*row);
      hold += keeps == Keeps::yes, none += keeps == Keeps::claims_none;
      if (keeps == Keeps::no) failed.push_back(failure_words(*row));
    }
    if (variant.sets.empty()) continue;
    std::vector<std::string> parts;
    if (hold > 0) parts.push_back(fmt::format("holds its bounds on {} of {} sets", hold, variant.sets.size()));
    if (none > 0)
      parts.push_back(fmt::format("claims nothing on {}, where its values are finite and none is wrongly negative", none));
    if (!failed.empty()) parts.push_back(fmt::format("FAILS on {}: {}", failed.size(), fmt::join(failed, "; ")));
    all.push_back({.variant = variant.variant, .words = fmt::format("{}.", fmt::join(parts, "; "))});
  }
  return all;
}

std::vector<std::string> function_set_cells(const FunctionRow& row) {
  const Keeps keeps = keeps_bounds(row);
  return {row.subject.variant,
          keeps == Keeps::yes  ? "hold"
          : keeps == Keeps::no ? "FAIL"
                               : "-",
          claim_words(row),
          words_for_error(row.max_over, 3),
          words_for_error(row.max_under, 3),
          words_for_error(row.mean_absolute, 2),
          words_for_error(row.rms, 2),
          words_for_error(row.max_eps, 3),
          words_for_error(row.max_eps_kappa, 3),
          std::to_string(row.negative),
          std::to_string(row.nonfinite),
          std::to_string(row.not_zero),
          input_words(worst_input(row)),
          input_words(row.first_fault)};
}

Table function_sets_table(const FunctionBackend& backend) {
  Table table = {.caption = function_set_note,
                 .columns = {words_column("variant"), words_column("bounds"), words_column("claims")},
                 .label = "every function and set on " + backend.backend,
                 .html_class = "wide",
                 .grouped_by = "set"};
  for (const char* figure : {"max over", "max under", "mean", "rms", "eps", "eps kappa", "negative", "non-finite", "not 0"})
    table.columns.push_back(number_column(figure));
  for (const char* input : {"worst at", "first fault at"}) table.columns.push_back(words_column(input));
  for (const FunctionRow* row : rows_by_set(backend)) {
    Row& added =
        table.rows.emplace_back(row_of(function_set_cells(*row), keeps_bounds(*row) == Keeps::no ? Mark::bad : Mark::none));
    added.group = row->set;
    added.group_words = fmt::format("{}: {} ({} points)", row->set, row->what, row->points);
  }
  return table;
}

}  // namespace lamina
