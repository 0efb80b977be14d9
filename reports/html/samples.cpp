// SPDX-License-Identifier: Apache-2.0
// Every round's sample behind the intervals of a table, of frames or of functions: a strip plot of the record's own samples,
// which needs no script. The script's larger one of frames ("Every sample") shows the same.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/html/html.h"

namespace lamina {
namespace {

// The strip's own units: whole numbers of them keep a page of thousands of cells small, and are finer than the screen's pixels.
constexpr int units_wide = 2000, units_high = 100;

struct Axis {
  double begin = 0, end = 0;
  bool logarithmic = false;
  int across(double sample) const {
    const double share = logarithmic ? std::log(sample / begin) / std::log(end / begin) : (sample - begin) / (end - begin);
    return static_cast<int>(std::lround(units_wide * share));
  }
};

// The interval as a box, the median as a line, and a dot a round from the bottom up; a dot is a stroke one unit long.
std::string strip(const std::vector<double>& samples, const Axis& axis, const std::string& label) {
  const Interval interval = interval_or_range(samples);
  const int low = axis.across(interval.low), high = axis.across(interval.high);
  // From dot to dot by how far it is, which is shorter than where it is.
  std::string dots;
  int x = 0, y = 0;
  for (size_t i = 0; i < samples.size(); ++i) {
    const int to_x = axis.across(samples[i]);
    const int to_y = static_cast<int>(
        std::lround(units_high * (0.9 - 0.8 * (static_cast<double>(i) + 0.5) / static_cast<double>(samples.size()))));
    dots += fmt::format("m{}{}{}h1", to_x - x, to_y < y ? "" : " ", to_y - y);
    x = to_x + 1, y = to_y;
  }
  return fmt::format(
      "<svg viewBox=\"0 0 {} {}\" preserveAspectRatio=\"none\" role=\"img\" aria-label=\"{}\"><path class=\"interval\" "
      "d=\"M{} 0H{}V{}H{}z\"/><path d=\"M{} 0V{}\"/><path class=\"dots\" d=\"{}\"/></svg>",
      units_wide, units_high, label, low, std::max(high, low + 1), units_high, low, axis.across(interval.median), units_high,
      dots);
}

}  // namespace

std::string html_rounds(const std::vector<SampleRow>& rows, SampleAxis kind, std::string (*words)(double), const char* unit) {
  std::vector<double> all;
  for (const SampleRow& row : rows) all.insert(all.end(), row.samples.begin(), row.samples.end());
  if (all.empty()) return "";
  const auto [least, most] = std::ranges::minmax(all);
  if (most <= 0) return "";
  const bool logarithmic = kind == SampleAxis::logarithmic && least > 0 && most > least;
  const Axis axis = {logarithmic ? least : std::min(least, 0.0), most, logarithmic};
  std::string html;
  for (const auto& [name, samples] : rows) {
    if (samples.empty()) continue;
    const auto [low, high] = std::ranges::minmax(samples);
    html += fmt::format("<span>{}</span>{}\n", escaped_html(name),
                        strip(samples, axis,
                              fmt::format("{} round{}, {} to {} {}", samples.size(), samples.size() == 1 ? "" : "s", words(low),
                                          words(high), unit)));
  }
  return fmt::format("<div class=\"rounds\"><span></span><small>every round, {} to {} {}{}</small>\n{}</div>\n",
                     axis.begin == 0 ? "0" : words(axis.begin), words(axis.end), unit, logarithmic ? " (log scale)" : "", html);
}

std::string html_samples(const Record& record, const std::vector<const CellRow*>& cells) {
  std::vector<SampleRow> rows;
  for (const CellRow* cell : cells) rows.push_back({cell->variant, shown_samples_ms(record, *cell)});
  return html_rounds(rows, SampleAxis::from_zero, words_for_ms, "ms");
}

}  // namespace lamina
