// SPDX-License-Identifier: Apache-2.0
// The page: what was found in words, the table, the pictures, the passes, and what was run.
#include <fmt/format.h>

#include "reports/functions.h"
#include "reports/html.h"

namespace lamina {
namespace {

std::string summary_table(const std::vector<SummaryRow>& rows) {
  std::string html;
  bool truth = false;
  for (size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || rows[i].effect != rows[i - 1].effect) {
      truth = has_truth(rows, rows[i].effect);
      html +=
          fmt::format("{}<div class=\"scroll\"><table{}><caption>{}</caption><thead><tr>",
                      i == 0 ? "" : "</tbody></table></div>\n", truth ? " class=\"wide\"" : "", escaped_html(rows[i].effect));
      const std::vector<std::string> columns = summary_columns(truth);
      for (size_t column = 0; column < columns.size(); ++column)
        html += fmt::format("<th scope=\"col\"{}>{}</th>", column >= 2 && column + 1 < columns.size() ? " class=\"num\"" : "",
                            columns[column]);
      html += "</tr></thead><tbody>\n";
    }
    const auto cells = summary_cells(rows[i], truth);
    html += fmt::format("<tr{}><th scope=\"row\">{}</th><td>{}</td>", rows[i].baseline ? " class=\"baseline\"" : "",
                        escaped_html(cells[0]), escaped_html(cells[1]));
    for (size_t column = 2; column + 1 < cells.size(); ++column)
      html += fmt::format("<td class=\"num\">{}</td>", escaped_html(cells[column]));
    html += fmt::format("<td>{}</td></tr>\n", escaped_html(cells.back()));
  }
  if (!rows.empty()) html += "</tbody></table></div>\n";
  for (const SummaryRow& row : rows)
    if (const std::string trouble = trouble_of(row); !trouble.empty())
      html += fmt::format("<p class=\"note bad\"><strong>{} on {}</strong> {}</p>\n", escaped_html(row.variant),
                          escaped_html(row.backend), escaped_html(trouble));
  for (const std::string& note : summary_notes(rows)) html += fmt::format("<p class=\"note\">{}</p>\n", escaped_html(note));
  return html;
}

std::string passes_table(const std::vector<PassSummary>& passes) {
  std::string html =
      "<div class=\"scroll\"><table><caption>Means over views; fetches per pixel that the effect covers.</caption>"
      "<thead><tr><th scope=\"col\">variant</th><th scope=\"col\">backend</th><th scope=\"col\">pass</th><th "
      "scope=\"col\">done</th>"
      "<th scope=\"col\" class=\"num\">ms</th><th scope=\"col\" class=\"num\">fragments</th>"
      "<th scope=\"col\" class=\"num\">fetches/px</th><th scope=\"col\">by texture, format and "
      "filter</th></tr></thead><tbody>\n";
  for (const PassSummary& pass : passes) {
    std::string shares;
    for (const PassSummary::Share& share : pass.shares)
      shares += fmt::format("<li>{}</li>", escaped_html(words_for_share(share)));
    html += fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td class=\"num\">{}</td><td class=\"num\">{}</td>"
        "<td class=\"num\">{}</td><td><ul class=\"shares\">{}</ul></td></tr>\n",
        escaped_html(pass.variant), escaped_html(pass.backend), escaped_html(pass.name), pass.once ? "once" : "each frame",
        pass.ms ? words_for_ms(*pass.ms) : "-", words_for_fragments(pass),
        pass.fetches_per_pixel ? fmt::format("{:.1f}", *pass.fetches_per_pixel) : "-", shares);
  }
  return html + "</tbody></table></div>\n";
}

std::string list(const std::vector<std::string>& lines) {
  std::string html = "<ul>\n";
  for (const std::string& line : lines) html += fmt::format("<li>{}</li>\n", escaped_html(line));
  return html + "</ul>\n";
}

std::string timer_section(const Record& record) {
  if (certificates(record).empty()) return "";
  std::string html = "<h2>Timer</h2>\n<ul>\n";
  for (const Certificate& certificate : certificates(record))
    html += fmt::format("<li{}>{}</li>\n", certificate.ok ? "" : " class=\"bad\"", escaped_html(certificate.words));
  for (const std::string& line : phase_lines(record)) html += fmt::format("<li>{}</li>\n", escaped_html(line));
  return html + "</ul>\n";
}

std::string run_section(const Record& record) {
  std::string html = "<h2>What was run</h2>\n<dl class=\"facts\">\n";
  for (const auto& [label, value] : run_facts(record))
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped_html(label), escaped_html(value));
  return html + "</dl>\n";
}

std::string failures_section(const Record& record) {
  const auto failed = failures(record);
  if (failed.empty()) return "";
  std::string html =
      "<h2>Failures</h2>\n<div class=\"scroll\"><table><caption>Cells that failed; the others are not touched by it."
      "</caption><thead><tr><th scope=\"col\">cell</th><th scope=\"col\">reason</th></tr></thead><tbody>\n";
  for (const auto& [cell, reason] : failed)
    html +=
        fmt::format("<tr><th scope=\"row\">{}</th><td class=\"wrap\">{}</td></tr>\n", escaped_html(cell), escaped_html(reason));
  return html + "</tbody></table></div>\n";
}

}  // namespace

std::string escaped_html(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  return out;
}

// RFC 3986, section 2.3: what is not unreserved is written as %XX; the slash stays, to part the folders.
std::string picture_url(std::string_view path) {
  std::string url = "./";
  for (const char c : path) {
    const bool unreserved = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                            std::string_view("-._~/").find(c) != std::string_view::npos;
    url += unreserved ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return url;
}

std::string html_report(const Record& record) {
  const std::vector<SummaryRow> rows = summarize(record);
  const std::string title = escaped_html(title_of(record));
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Lamina: {}</title>\n<style>{}</style>\n"
      "</head>\n<body>\n<main>\n<h1>{}</h1>\n",
      title, html_style, title);
  for (const std::string& warning : warnings_of(record))
    html += fmt::format("<p class=\"warning\"><strong>Warning:</strong> {}</p>\n", escaped_html(warning));
  html += "<ul class=\"headlines\">\n";
  for (const Headline& headline : headlines(rows))
    html += fmt::format("<li><strong>{}</strong> {}</li>\n", escaped_html(headline.variant), escaped_html(headline.words));
  html += "</ul>\n" + (rows.empty() ? "" : summary_table(rows));
  const std::string functions = html_functions(record);
  html += html_assumptions(record) + functions;
  if (!record.cells.empty())
    html +=
        "<h2>Pictures</h2>\n<p class=\"note\">Click a variant's picture to see the baseline in its place, or press the key b "
        "to do "
        "so for all. Differences are of the display values. In the strips, each dot is one round's frame time, the first round "
        "at "
        "the bottom.</p>\n" +
        html_gallery(record) + "<h2>Passes</h2>\n" + passes_table(summarize_passes(record));
  if (const auto baked = bake_lines(record); !baked.empty()) html += "<h2>What is done once</h2>\n" + list(baked);
  if (const auto plan = plan_lines(record); !plan.empty()) html += "<h2>What the scene calls for</h2>\n" + list(plan);
  html += failures_section(record) + timer_section(record) + run_section(record);
  html += fmt::format("</main>\n<script>{}</script>\n", html_script);
  if (functions.find("<figure class=\"chart\">") != std::string::npos)
    html += fmt::format("<script>{}</script>\n<script>{}</script>\n", chart_library, chart_script);
  return html + "</body>\n</html>\n";
}

}  // namespace lamina
