// SPDX-License-Identifier: Apache-2.0
// The page's section on what the frame saves: a bar an effect, as long as what it costs in the frame of everything; filled is
// what it costs in the frame of what the scene calls for.
#include <fmt/format.h>

#include <algorithm>

#include "reports/html/html.h"

namespace lamina {
namespace {

std::string bar_row(const SavingBar& bar, double longest, bool timed) {
  const double all = std::max(bar.all, bar.culled);
  const auto words = [&](double value) { return timed ? words_for_ms(value) + " ms" : fmt::format("{:.3g}", value); };
  return fmt::format(
      "<div>{}</div><div class=\"saving\" role=\"img\" aria-label=\"{} of {}\"><span style=\"width:{:.2f}%\"><span "
      "style=\"width:{:.2f}%\"></span></span></div><small>{} of {}</small>\n",
      escaped_html(bar.effect + (bar.called_for ? "" : ", not called for")), words(bar.culled), words(bar.all),
      longest > 0 ? 100 * all / longest : 0, all > 0 ? 100 * bar.culled / all : 0, words(bar.culled), words(bar.all));
}

}  // namespace

std::string html_saving(const Record& record) {
  if (record.savings.empty()) return "";
  std::string html = "<h2>What is left out, and what that saves</h2>\n<ul class=\"headlines\">\n";
  for (const auto& [backend, words] : saving_headlines(record))
    html += fmt::format("<li><strong>{}</strong>: {}</li>\n", escaped_html(backend), escaped_html(words));
  html += "</ul>\n";
  for (const SavingBars& bars : saving_bars(record)) {
    double longest = 0;
    for (const SavingBar& bar : bars.bars) longest = std::max({longest, bar.all, bar.culled});
    html += "<figure class=\"chart\"><div class=\"savings\">\n";
    for (const SavingBar& bar : bars.bars) html += bar_row(bar, longest, bars.timed);
    html += fmt::format(
        "</div><figcaption>{}, {}: filled is what an effect costs in the frame of what the scene calls for, the whole bar what "
        "it "
        "costs where everything runs.</figcaption></figure>\n",
        escaped_html(bars.backend), bars.timed ? "milliseconds, medians" : "operations of a frame");
  }
  for (const Table& table : saving_tables(record)) html += html_table(table) + "\n";
  return html;
}

}  // namespace lamina
