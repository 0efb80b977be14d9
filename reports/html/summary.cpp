// SPDX-License-Identifier: Apache-2.0
// The page's tables of figures: the variants' and the passes'.
#include <fmt/format.h>

#include "reports/html/html.h"

namespace lamina {
namespace {

// A cell of figures may break between a mean and its worst or its interval, and nowhere else.
std::string figures_cell(const std::string& words) {
  std::string html = escaped_html(words);
  for (size_t at = html.find(' '); at != std::string::npos; at = html.find(' ', at + 1))
    if (html[at + 1] != '(' && html[at + 1] != '[') html.replace(at, 1, "&nbsp;");
  return html;
}

template <class Cells>
std::string figures_row(const Cells& cells, size_t names, size_t last_names, const char* attributes = "") {
  std::string html = fmt::format("<tr{}>", attributes);
  for (size_t i = 0; i < cells.size(); ++i)
    html += i == 0                           ? fmt::format("<th scope=\"row\">{}</th>", escaped_html(cells[i]))
            : i < names                      ? fmt::format("<td>{}</td>", escaped_html(cells[i]))
            : i + last_names >= cells.size() ? fmt::format("<td class=\"name\">{}</td>", escaped_html(cells[i]))
                                             : fmt::format("<td class=\"num\">{}</td>", figures_cell(cells[i]));
  return html + "</tr>\n";
}

std::string summary_table(const std::string& caption, const std::string& head, const std::string& body, bool wide) {
  // A table that scrolls has to take the keyboard's focus, else no key moves it.
  return fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
      "aria-label=\"{}\"><table{}><caption>{}</caption>{}<tbody>\n{}</tbody>"
      "</table></div>\n",
      caption, wide ? " class=\"wide\"" : "", caption, head, body);
}

}  // namespace

std::string header_row(std::span<const char* const> columns, size_t names, size_t last_names) {
  std::string html = "<thead><tr>";
  for (size_t i = 0; i < columns.size(); ++i)
    html += fmt::format("<th scope=\"col\"{}>{}</th>", i < names || i + last_names >= columns.size() ? "" : " class=\"num\"",
                        columns[i]);
  return html + "</tr></thead>";
}

std::string html_list(const std::vector<std::string>& lines) {
  std::string html = "<ul>\n";
  for (const std::string& line : lines) html += fmt::format("<li>{}</li>\n", escaped_html(line));
  return html + "</ul>\n";
}

std::string html_summary(const std::vector<SummaryRow>& rows) {
  std::string html;
  for (size_t i = 0; i < rows.size();) {
    const std::string& effect = rows[i].effect;
    const bool truth = has_truth(rows, effect);
    const std::vector<std::string> columns = summary_columns(truth);
    std::vector<const char*> heads;
    for (const std::string& column : columns) heads.push_back(column.c_str());
    std::string body;
    for (; i < rows.size() && rows[i].effect == effect; ++i)
      body += figures_row(summary_cells(rows[i], truth), 2, 1, rows[i].baseline ? " class=\"baseline\"" : "");
    html += summary_table(escaped_html(effect), header_row(heads, 2, 1), body, true);
  }
  for (const SummaryRow& row : rows)
    if (const std::string trouble = trouble_of(row); !trouble.empty())
      html += fmt::format("<p class=\"note bad\"><strong>{} on {}</strong> {}</p>\n", escaped_html(row.variant),
                          escaped_html(row.backend), escaped_html(trouble));
  for (const std::string& note : summary_notes(rows)) html += fmt::format("<p class=\"note\">{}</p>\n", escaped_html(note));
  return html;
}

std::string html_passes(const Record& record) {
  const std::vector<PassSummary> passes = summarize_passes(record);
  if (passes.empty()) return "";
  std::string body;
  for (const PassSummary& pass : passes) {
    std::string shares;
    for (const PassSummary::Share& share : pass.shares)
      shares += fmt::format("<li>{}</li>", escaped_html(words_for_share(share)));
    const auto cells = pass_cells(pass);
    std::string row = figures_row(cells, 4, 0);
    row.insert(row.rfind("</tr>"), fmt::format("<td><ul class=\"shares\">{}</ul></td>", shares));
    body += row;
  }
  std::vector<const char*> heads(pass_columns.begin(), pass_columns.end());
  return summary_table(
      "Means over views; fetches per pixel that the effect covers; ns per fetch: the pass's whole time over its fetches",
      header_row(heads, 4, 1), body, true);
}

}  // namespace lamina
