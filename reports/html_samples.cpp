// SPDX-License-Identifier: Apache-2.0
// Every round's frame time behind the intervals of a table of cells: a strip plot of the record's own samples, which needs no
// script. The script's larger one ("Every sample") shows the same.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/html.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

// The strip's own units: whole numbers of them keep a page of thousands of cells small, and are finer than the screen's pixels.
constexpr int units_wide = 2000, units_high = 100;

int across(double ms, double end_ms) { return static_cast<int>(std::lround(units_wide * ms / end_ms)); }

// The interval as a box, the median as a line, and a dot a round from the bottom up; a dot is a stroke one unit long.
std::string strip(const std::vector<double>& samples_ms, double end_ms, const std::string& label) {
  const Interval interval = interval_or_range(samples_ms);
  const int low = across(interval.low, end_ms), high = across(interval.high, end_ms);
  // From dot to dot by how far it is, which is shorter than where it is.
  std::string dots;
  int x = 0, y = 0;
  for (size_t i = 0; i < samples_ms.size(); ++i) {
    const int to_x = across(samples_ms[i], end_ms);
    const int to_y = static_cast<int>(
        std::lround(units_high * (0.9 - 0.8 * (static_cast<double>(i) + 0.5) / static_cast<double>(samples_ms.size()))));
    dots += fmt::format("m{}{}{}h1", to_x - x, to_y < y ? "" : " ", to_y - y);
    x = to_x + 1, y = to_y;
  }
  return fmt::format(
      "<svg viewBox=\"0 0 {} {}\" preserveAspectRatio=\"none\" role=\"img\" aria-label=\"{}\"><path class=\"interval\" "
      "d=\"M{} 0H{}V{}H{}z\"/><path d=\"M{} 0V{}\"/><path class=\"dots\" d=\"{}\"/></svg>",
      units_wide, units_high, label, low, std::max(high, low + 1), units_high, low, across(interval.median, end_ms), units_high,
      dots);
}

}  // namespace

std::string html_samples(const Record& record, const std::vector<const Json*>& cells) {
  std::vector<std::vector<double>> samples_ms;
  double end_ms = 0;
  for (const Json* cell : cells) {
    samples_ms.push_back(shown_samples_ms(record, *cell));
    for (const double ms : samples_ms.back()) end_ms = std::max(end_ms, ms);
  }
  if (end_ms <= 0) return "";
  std::string html;
  for (size_t i = 0; i < cells.size(); ++i) {
    if (samples_ms[i].empty()) continue;
    const auto [least, most] = std::ranges::minmax(samples_ms[i]);
    html += fmt::format("<span>{}</span>{}\n", escaped_html(cells[i]->at("variant").get<std::string>()),
                        strip(samples_ms[i], end_ms,
                              fmt::format("{} round{}, {} to {} ms", samples_ms[i].size(), samples_ms[i].size() == 1 ? "" : "s",
                                          words_for_ms(least), words_for_ms(most))));
  }
  return fmt::format("<div class=\"rounds\"><span></span><small>every round, 0 to {} ms</small>\n{}</div>\n",
                     words_for_ms(end_ms), html);
}

}  // namespace lamina
