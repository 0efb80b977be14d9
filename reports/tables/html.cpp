// SPDX-License-Identifier: Apache-2.0
#include "reports/html/html.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/tables/table.h"

namespace lamina {
namespace {

std::string attribute(const char* name, std::string_view value) {
  return value.empty() ? "" : fmt::format(" {}=\"{}\"", name, escaped_html(value));
}

std::string content_of(const Cell& cell, bool whole) {
  if (!cell.html.empty()) return cell.html;
  std::string html = escaped_html(cell.text);
  for (size_t at = whole ? html.find(' ') : std::string::npos; at != std::string::npos; at = html.find(' ', at + 1))
    if (html[at + 1] != '(' && html[at + 1] != '[') html.replace(at, 1, "&nbsp;");
  if (cell.items.empty()) return html;
  html += "<ul class=\"shares\">";
  for (const std::string& item : cell.items) html += fmt::format("<li>{}</li>", escaped_html(item));
  return html + "</ul>";
}

std::string html_row(const Table& table, const Row& row) {
  std::string html = fmt::format("<tr{}><th scope=\"row\">{}</th>",
                                 attribute("class", row.mark == Mark::bad        ? "bad"
                                                    : row.mark == Mark::baseline ? "baseline"
                                                                                 : ""),
                                 content_of(row.cells[0], false));
  for (size_t i = 1; i < row.cells.size(); ++i) {
    const Cell& cell = row.cells[i];
    const size_t rest = i + 1 == row.cells.size() ? table.columns.size() - i : 1;
    html += fmt::format("<td{}{}>{}</td>", attribute("class", cell.html_class ? cell.html_class : table.columns[i].html_class),
                        attribute("colspan", rest > 1 ? std::to_string(rest) : ""), content_of(cell, table.columns[i].whole));
  }
  return html + "</tr>\n";
}

}  // namespace

std::string html_table(const Table& table) {
  std::string html = fmt::format("<table{}>", attribute("class", table.html_class));
  if (!table.caption.empty()) html += fmt::format("<caption>{}</caption>", escaped_html(table.caption));
  if (std::ranges::any_of(table.columns, [](const Column& column) { return !column.heading.empty(); })) {
    html += "<thead><tr>";
    for (const Column& column : table.columns)
      html += fmt::format("<th scope=\"col\"{}>{}</th>",
                          attribute("class", std::string_view(column.html_class) == "num" ? "num" : ""),
                          escaped_html(column.heading));
    html += "</tr></thead>";
  }
  html += "<tbody>\n";
  for (size_t i = 0; i < table.rows.size(); ++i) {
    const Row& row = table.rows[i];
    if (!table.grouped_by.empty() && (i == 0 || row.group != table.rows[i - 1].group))
      html += fmt::format("<tr class=\"group\"><th scope=\"rowgroup\" colspan=\"{}\">{}</th></tr>\n", table.columns.size(),
                          escaped_html(row.group_words));
    html += html_row(table, row);
  }
  html += "</tbody></table>";
  // A table that scrolls has to take the keyboard's focus, else no key moves it.
  const std::string& label = table.label.empty() ? table.caption : table.label;
  return label.empty() ? html
                       : fmt::format("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">{}</div>",
                                     escaped_html(label), html);
}

}  // namespace lamina
