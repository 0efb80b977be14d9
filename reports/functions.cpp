// SPDX-License-Identifier: Apache-2.0
// A record's function lines to one summary a function, backend and variant, and to words.
#include "reports/functions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "reports/frontier.h"

namespace lamina {
namespace {

// The element that `is` picks, added at the end where there is none.
template <class Element, class Is>
Element& find_or_add(std::vector<Element>& elements, Is is) {
  const auto known = std::ranges::find_if(elements, is);
  return known == elements.end() ? elements.emplace_back() : *known;
}

FunctionReport& report_of(std::vector<FunctionReport>& reports, const std::string& function) {
  return find_or_add(reports, [&](const FunctionReport& r) { return r.function == function; });
}

FunctionSummary& summary_of(std::vector<FunctionReport>& reports, const FunctionSubject& subject) {
  FunctionReport& report = report_of(reports, subject.function);
  report.function = subject.function;
  report.title = subject.title;
  if (subject.baseline) report.baseline = subject.variant;
  auto& place = find_or_add(report.backends, [&](const FunctionBackend& b) { return b.backend == subject.backend; });
  place.backend = subject.backend;
  place.device = subject.device;
  auto& summary = find_or_add(place.variants, [&](const FunctionSummary& s) { return s.variant == subject.variant; });
  summary.variant = subject.variant;
  summary.baseline = subject.baseline;
  return summary;
}

void add_set(std::vector<FunctionReport>& reports, const FunctionRow& row) {
  FunctionSummary& summary = summary_of(reports, row.subject);
  FunctionReport& report = report_of(reports, row.subject.function);
  if (report.main_set.empty()) report.main_set = row.set, report.main_what = row.what, report.scale = row.scale;
  if (row.set == report.main_set) summary.main_set = &row;
  summary.sets.push_back(&row);
}

void compare(FunctionBackend& backend) {
  std::ranges::stable_sort(backend.variants, [](const auto& a, const auto& b) { return a.baseline > b.baseline; });
  const FunctionSummary& first = backend.variants.front();
  const double baseline_ns = first.baseline && first.ns ? first.ns->median : 0;
  for (FunctionSummary& row : backend.variants) {
    if (row.main_set && row.main_set->nonfinite == 0 && row.main_set->max_over)
      row.error = std::max(*row.main_set->max_over, -*row.main_set->max_under);
    if (row.ns && baseline_ns > 0) row.ratio = row.ns->median / baseline_ns;
  }
  std::vector<Contender> contenders;
  for (const FunctionSummary& row : backend.variants) contenders.push_back({row.ns, row.error, row.samples});
  const std::vector<Place> places = places_of(contenders, as_fast);
  for (size_t i = 0; i < places.size(); ++i) {
    backend.variants[i].standing = places[i].standing;
    if (places[i].by != i) backend.variants[i].by = backend.variants[places[i].by].variant;
  }
}

uint64_t sum_of(const FunctionSummary& row, uint64_t FunctionRow::*count) {
  uint64_t sum = 0;
  for (const FunctionRow* set : row.sets) sum += set->*count;
  return sum;
}

// "0.5 on vulkan and 0.6 on osmesa", or just "0.5" where all the function's `backends` say the same.
using ByBackend = std::vector<std::pair<std::string, std::string>>;  // backend, words
std::string joined(const ByBackend& all, size_t backends) {
  const bool same =
      all.size() == backends && std::ranges::all_of(all, [&](const auto& one) { return one.second == all[0].second; });
  std::vector<std::string> parts;
  for (const auto& [backend, words] : all) parts.push_back(same ? words : words + " on " + backend);
  if (same) parts.resize(1);
  return fmt::format("{}", fmt::join(parts, " and "));
}

// Whether a variant is worth having on a backend, or why that is not known.
std::string verdict(const FunctionSummary& row, const FunctionBackend& backend) {
  if (!row.error) return "gives values that are not finite, so its greatest error is not known";
  if (!row.ns) return "was not timed";
  if (row.frontier()) return "is worth having: nothing closer is as fast";
  const FunctionSummary& other = *std::ranges::find(backend.variants, row.by, &FunctionSummary::variant);
  if (row.standing == Standing::not_told_apart)
    return fmt::format("is not told apart in time from {}, which errs by up to {:.3g}; more rounds would tell", row.by,
                       *other.error);
  const char* how = *other.error < *row.error ? "is no slower" : "is faster";
  return fmt::format("is beaten by {}, which errs by up to {:.3g} and {}", row.by, *other.error, how);
}

}  // namespace

std::string words_for_ns(double ns) { return fmt::format("{:.3g}", ns); }

std::string words_for_ns(const Interval& ns) {
  return fmt::format("{} [{}, {}]{}", words_for_ns(ns.median), words_for_ns(ns.low), words_for_ns(ns.high),
                     ns.coverage < report_confidence ? "*" : "");
}

std::string words_for_error(const std::optional<double>& figure, int digits) {
  return figure ? fmt::format("{:.{}g}", *figure, digits) : "-";
}

std::vector<FunctionReport> summarize_functions(const Record& record) {
  std::vector<FunctionReport> reports;
  for (const FunctionRow& row : record.functions) add_set(reports, row);
  for (const FunctionTimeRow& time : record.function_times) {
    FunctionSummary& row = summary_of(reports, time.subject);
    row.ns = time.ns_per_call;
    row.reason = time.reason;
    row.samples = time.ns;
  }
  for (const FunctionPictureRow& row : record.function_pictures) summary_of(reports, row.subject).pictures.push_back(&row);
  for (FunctionReport& report : reports)
    for (FunctionBackend& backend : report.backends) compare(backend);
  return reports;
}

std::vector<Headline> function_headlines(const FunctionReport& report) {
  struct Words {
    ByBackend verdicts, errors, times, faults;
  };
  std::vector<std::pair<std::string, Words>> variants;
  for (const FunctionBackend& backend : report.backends)
    for (const FunctionSummary& row : backend.variants) {
      auto& [variant, words] = find_or_add(variants, [&](const auto& known) { return known.first == row.variant; });
      variant = row.variant;
      words.verdicts.emplace_back(backend.backend, verdict(row, backend));
      if (row.error) words.errors.emplace_back(backend.backend, fmt::format("{:.3g}", *row.error));
      if (row.ns) {
        std::string time = fmt::format("{:.3g} ns", row.ns->median);
        if (row.ratio && !row.baseline)
          time += *row.ratio <= 1 ? fmt::format(" ({:.1f} times faster than {})", 1 / *row.ratio, report.baseline)
                                  : fmt::format(" ({:.1f} times slower than {})", *row.ratio, report.baseline);
        words.times.emplace_back(backend.backend, time);
      }
      if (const uint64_t negative = sum_of(row, &FunctionRow::negative), nonfinite = sum_of(row, &FunctionRow::nonfinite);
          negative + nonfinite > 0)
        words.faults.emplace_back(backend.backend, fmt::format("{} negative and {} non-finite values", negative, nonfinite));
    }
  std::vector<Headline> all;
  for (const auto& [variant, words] : variants) {
    std::string text = joined(words.verdicts, report.backends.size()) + ".";
    if (!words.errors.empty())
      text += fmt::format(" It errs by up to {} of {}", joined(words.errors, report.backends.size()), report.scale);
    if (!words.times.empty())
      text +=
          fmt::format("{} a call takes {}", words.errors.empty() ? " Here" : ";", joined(words.times, report.backends.size()));
    if (!text.ends_with('.')) text += ".";
    if (!words.faults.empty()) text += fmt::format(" Over all sets it gives {}.", joined(words.faults, report.backends.size()));
    all.push_back({.variant = variant, .words = text});
  }
  return all;
}

std::vector<std::string> function_cells(const FunctionSummary& row) {
  std::vector<std::string> cells = {row.variant, row.ns ? words_for_ns(*row.ns) : "not timed",
                                    row.baseline ? "baseline"
                                    : row.ratio  ? fmt::format("{:.3f}", *row.ratio)
                                                 : "-"};
  if (const FunctionRow* set = row.main_set)
    cells.insert(cells.end(),
                 {words_for_error(set->max_over, 3), words_for_error(set->max_under, 3), words_for_error(set->mean_absolute, 2),
                  words_for_error(set->rms, 2), std::to_string(set->negative), std::to_string(set->nonfinite)});
  else
    cells.insert(cells.end(), 6, "-");
  return cells;
}

Table function_table(const FunctionReport& report, const FunctionBackend& backend) {
  const auto with_set = std::ranges::find_if(backend.variants, [](const auto& row) { return row.main_set != nullptr; });
  const std::string points = with_set == backend.variants.end() ? "no" : std::to_string(with_set->main_set->points);
  Table table = {.caption = fmt::format("{}, {}: {} points of '{}', {}", backend.backend, backend.device, points,
                                        report.main_set, report.main_what),
                 .columns = {words_column("variant")}};
  for (const char* figure : {"ns a call [95%]", "ratio", "max over", "max under", "mean", "rms", "negative", "non-finite"})
    table.columns.push_back(number_column(figure));
  for (const FunctionSummary& row : backend.variants)
    table.rows.push_back(row_of(function_cells(row), row.baseline ? Mark::baseline : Mark::none));
  return table;
}

std::vector<std::string> function_notes(const FunctionReport& report) {
  std::vector<std::string> notes = {
      fmt::format("Errors are of {}: over is too much, under too little; mean of the absolute errors. Ratio: median time over "
                  "{}'s; under 1 is "
                  "faster. Negative and non-finite: how many values; errors leave out values that are not finite.",
                  report.scale, report.baseline.empty() ? "the baseline" : report.baseline)};
  for (const FunctionBackend& backend : report.backends)
    for (const FunctionSummary& row : backend.variants)
      if (!row.ns && !row.reason.empty()) {
        notes.push_back(fmt::format("No times are given on {}: {}.", backend.backend, row.reason));
        break;
      }
  return notes;
}

}  // namespace lamina
