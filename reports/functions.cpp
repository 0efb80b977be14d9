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

using Json = nlohmann::json;

// The element that `is` picks, added at the end where there is none.
template <class Element, class Is>
Element& find_or_add(std::vector<Element>& elements, Is is) {
  const auto known = std::ranges::find_if(elements, is);
  return known == elements.end() ? elements.emplace_back() : *known;
}

FunctionSummary& summary_of(std::vector<FunctionReport>& reports, const Json& line) {
  const std::string function = line.at("function"), backend = line.at("backend"), variant = line.at("variant");
  auto& report = find_or_add(reports, [&](const FunctionReport& r) { return r.function == function; });
  report.function = function;
  report.title = line.at("title");
  if (line.at("baseline").get<bool>()) report.baseline = variant;
  auto& place = find_or_add(report.backends, [&](const FunctionBackend& b) { return b.backend == backend; });
  place.backend = backend;
  place.device = line.at("device");
  auto& summary = find_or_add(place.variants, [&](const FunctionSummary& s) { return s.variant == variant; });
  summary.variant = variant;
  summary.baseline = line.at("baseline");
  if (line.at("kind") == "function" && report.main_set.empty()) {
    report.main_set = line.at("set");
    report.main_what = line.at("what");
    report.scale = line.at("scale");
  }
  if (line.at("kind") == "function" && line.at("set") == report.main_set) summary.main_set = &line;
  return summary;
}

bool beats(const FunctionSummary& a, const FunctionSummary& b) { return beats({a.ns, a.error}, Contender{b.ns, b.error}); }

void compare(FunctionBackend& backend) {
  std::ranges::stable_sort(backend.variants, [](const auto& a, const auto& b) { return a.baseline > b.baseline; });
  const FunctionSummary& first = backend.variants.front();
  const double baseline_ns = first.baseline && first.ns ? first.ns->median : 0;
  for (FunctionSummary& row : backend.variants) {
    if (row.main_set && row.main_set->at("nonfinite") == 0)
      row.error = std::max(row.main_set->at("max_over").get<double>(), -row.main_set->at("max_under").get<double>());
    if (row.ns && baseline_ns > 0) row.ratio = row.ns->median / baseline_ns;
  }
  for (FunctionSummary& row : backend.variants)
    row.frontier = row.ns && row.error &&
                   std::ranges::none_of(backend.variants, [&](const FunctionSummary& other) { return beats(other, row); });
}

uint64_t sum_of(const FunctionSummary& row, const char* count) {
  uint64_t sum = 0;
  for (const Json* set : row.sets) sum += set->at(count).get<uint64_t>();
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
  if (row.frontier) return "is worth having: nothing closer is as fast";
  const FunctionSummary* better = nullptr;  // of what beats it, what errs the least
  for (const FunctionSummary& other : backend.variants)
    if (beats(other, row) && (!better || *other.error < *better->error)) better = &other;
  return fmt::format("is beaten by {}, which errs by up to {:.3g} and is not measurably slower", better->variant,
                     *better->error);
}

}  // namespace

std::string words_for_ns(double ns) { return fmt::format("{:.3g}", ns); }

std::string words_for_ns(const Interval& ns) {
  return fmt::format("{} [{}, {}]{}", words_for_ns(ns.median), words_for_ns(ns.low), words_for_ns(ns.high),
                     ns.coverage < report_confidence ? "*" : "");
}

std::string words_for_error(const Json& figure, int digits) {
  return figure.is_null() ? "-" : fmt::format("{:.{}g}", figure.get<double>(), digits);
}

std::vector<FunctionReport> summarize_functions(const Record& record) {
  std::vector<FunctionReport> reports;
  for (const Json& line : record.functions) summary_of(reports, line).sets.push_back(&line);
  for (const Json& line : record.function_times) {
    FunctionSummary& row = summary_of(reports, line);
    row.ns = interval_of(line.at("ns_per_call"));
    row.reason = line.at("reason");
    if (line.contains("ns")) row.samples = line.at("ns").get<std::vector<double>>();
  }
  for (const Json& line : record.function_pictures) summary_of(reports, line).pictures.push_back(&line);
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
      if (const uint64_t negative = sum_of(row, "negative"), nonfinite = sum_of(row, "nonfinite"); negative + nonfinite > 0)
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

std::array<std::string, function_columns.size()> function_cells(const FunctionSummary& row) {
  std::array<std::string, function_columns.size()> cells;
  cells.fill("-");
  cells[0] = row.variant;
  cells[1] = row.ns ? words_for_ns(*row.ns) : "not timed";
  cells[2] = row.baseline ? "baseline" : row.ratio ? fmt::format("{:.3f}", *row.ratio) : "-";
  if (!row.main_set) return cells;
  constexpr std::pair<const char*, int> figures[] = {{"max_over", 3}, {"max_under", 3}, {"mean_absolute", 2}, {"rms", 2}};
  for (size_t i = 0; i < std::size(figures); ++i)
    cells[3 + i] = words_for_error(row.main_set->at(figures[i].first), figures[i].second);
  cells[7] = row.main_set->at("negative").dump();
  cells[8] = row.main_set->at("nonfinite").dump();
  return cells;
}

std::string function_caption(const FunctionReport& report, const FunctionBackend& backend) {
  const auto with_set = std::ranges::find_if(backend.variants, [](const auto& row) { return row.main_set != nullptr; });
  const std::string points = with_set == backend.variants.end() ? "no" : with_set->main_set->at("points").dump();
  return fmt::format("{}, {}: {} points of '{}', {}", backend.backend, backend.device, points, report.main_set,
                     report.main_what);
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
