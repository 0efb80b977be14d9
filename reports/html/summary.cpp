// SPDX-License-Identifier: Apache-2.0
// The page's tables of figures: the variants' and the passes'.
#include <fmt/format.h>

#include "reports/html/html.h"

namespace lamina {
std::string html_list(const std::vector<std::string>& lines) {
  std::string html = "<ul>\n";
  for (const std::string& line : lines) html += fmt::format("<li>{}</li>\n", escaped_html(line));
  return html + "</ul>\n";
}

std::string html_summary(const std::vector<SummaryRow>& rows) {
  std::string html;
  for (const Table& table : summary_tables(rows, true)) html += html_table(table) + "\n";
  for (const SummaryRow& row : rows)
    if (const std::string trouble = trouble_of(row); !trouble.empty())
      html += fmt::format("<p class=\"note bad\"><strong>{} on {}</strong> {}</p>\n", escaped_html(row.variant),
                          escaped_html(row.backend), escaped_html(trouble));
  for (const std::string& note : summary_notes(rows)) html += fmt::format("<p class=\"note\">{}</p>\n", escaped_html(note));
  return html;
}

std::string html_passes(const Record& record) {
  const std::vector<PassSummary> passes = summarize_passes(record);
  return passes.empty() ? "" : html_table(passes_table(passes)) + "\n";
}

}  // namespace lamina
