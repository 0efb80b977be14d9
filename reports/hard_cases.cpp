// SPDX-License-Identifier: Apache-2.0
// The hard cases of functions: whether each keeps its bounds on each set of inputs, and at which input it is worst.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "reports/functions.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

// "1.5 0.25 1.2", nothing for null. Nine digits distinguish any two binary32 numbers.
std::string input_words(const Json& input) {
  return input.is_array() ? fmt::format("{:.9g}", fmt::join(input.get<std::vector<double>>(), " ")) : "";
}

bool worst_is_over(const Json& row) { return row.at("max_over").get<double>() > -row.at("max_under").get<double>(); }

// Where the greatest error is; null where no value is finite or none errs.
Json worst_input(const Json& row) {
  if (row.at("max_over").is_null()) return nullptr;
  return row.at(worst_is_over(row) ? "worst_over" : "worst_under");
}

Json bounds_of(const Json& row) { return row.value("bounds", Json(nullptr)); }

std::string claim_words(const Json& row) {
  const Json bounds = bounds_of(row);
  if (bounds.is_null()) return "-";
  std::string words = fmt::format("{} to {}", words_for_error(bounds.at("under"), 3), words_for_error(bounds.at("over"), 3));
  if (!bounds.at("eps_kappa").is_null()) words += fmt::format(", eps kappa {}", words_for_error(bounds.at("eps_kappa"), 3));
  return words;
}

bool within_bounds(const Json& row) {
  const Json bounds = bounds_of(row);
  if (bounds.is_null() || row.at("max_over").is_null()) return true;
  const auto at_most = [&](const char* figure, const Json& bound) { return bound.is_null() || row.at(figure) <= bound; };
  return at_most("max_over", bounds.at("over")) && row.at("max_under") >= bounds.at("under") &&
         at_most("most_eps_kappa", bounds.at("eps_kappa"));
}

// "tiny (1521 negative, 428 not finite of 2000 values, the first at 1e-06 2e-06 3e-06)".
std::string failure_words(const Json& row) {
  std::vector<std::string> faults, parts;
  constexpr std::pair<const char*, const char*> counts[] = {
      {"negative", "negative"}, {"nonfinite", "not finite"}, {"not_zero", "not 0 where 0 is right"}};
  for (const auto& [count, words] : counts)
    if (row.at(count) > 0) faults.push_back(fmt::format("{} {}", row.at(count).dump(), words));
  if (!faults.empty()) {
    parts.push_back(fmt::format("{} of {} values", fmt::join(faults, ", "), row.at("points").dump()));
    if (const std::string at = input_words(row.value("first_fault", Json(nullptr))); !at.empty())
      parts.back() += ", the first at " + at;
  }
  if (!within_bounds(row))
    parts.push_back(fmt::format("errs by {} at {}, claims {}",
                                words_for_error(row.at(worst_is_over(row) ? "max_over" : "max_under"), 3),
                                input_words(worst_input(row)), claim_words(row)));
  return fmt::format("{} ({})", text_at(row, "/set"), fmt::join(parts, "; "));
}

}  // namespace

const char* const function_set_note =
    "Bounds hold where every value is finite, none is negative where the exact value is not, the value is 0 where 0 is exact, "
    "and no error is beyond what the function claims on that set; - means that the function claims nothing there. eps: the "
    "greatest error in units of 2^-23; eps kappa: the greatest error of the value itself, in units of 2^-23 times its "
    "condition number where that is above 1; not 0: values that should be exactly 0.";

Keeps keeps_bounds(const Json& row) {
  for (const char* fault : {"negative", "nonfinite", "not_zero"})
    if (row.at(fault) > 0) return Keeps::no;
  if (!within_bounds(row)) return Keeps::no;
  return bounds_of(row).is_null() ? Keeps::claims_none : Keeps::yes;
}

std::vector<const Json*> rows_by_set(const FunctionBackend& backend) {
  std::vector<const Json*> rows;
  std::map<std::string, size_t> place;  // of each set
  for (const FunctionSummary& variant : backend.variants)
    for (const Json* row : variant.sets) {
      place.try_emplace(row->at("set"), place.size());
      rows.push_back(row);
    }
  std::ranges::stable_sort(rows, [&](const Json* a, const Json* b) { return place.at(a->at("set")) < place.at(b->at("set")); });
  return rows;
}

std::vector<Headline> hard_case_headlines(const FunctionBackend& backend) {
  std::vector<Headline> all;
  for (const FunctionSummary& variant : backend.variants) {
    size_t hold = 0, none = 0;
    std::vector<std::string> failed;
    for (const Json* row : variant.sets) {
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

std::array<std::string, function_set_columns.size()> function_set_cells(const Json& row) {
  const Keeps keeps = keeps_bounds(row);
  return {row.at("variant"),
          keeps == Keeps::yes  ? "hold"
          : keeps == Keeps::no ? "FAIL"
                               : "-",
          claim_words(row),
          words_for_error(row.at("max_over"), 3),
          words_for_error(row.at("max_under"), 3),
          words_for_error(row.at("mean_absolute"), 2),
          words_for_error(row.at("rms"), 2),
          words_for_error(row.at("most_eps"), 3),
          words_for_error(row.at("most_eps_kappa"), 3),
          row.at("negative").dump(),
          row.at("nonfinite").dump(),
          row.at("not_zero").dump(),
          input_words(worst_input(row)),
          input_words(row.value("first_fault", Json(nullptr)))};
}

}  // namespace lamina
