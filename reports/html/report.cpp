// SPDX-License-Identifier: Apache-2.0
// The page: the answer in words, the tables, the charts, the pictures, and what was run.
#include <fmt/format.h>

#include <algorithm>

#include "reports/functions.h"
#include "reports/html/html.h"

namespace lamina {
namespace {

std::string warnings(const Record& record) {
  std::string html;
  for (const std::string& warning : warnings_of(record))
    html += fmt::format("<p class=\"warning\"><strong>Warning:</strong> {}</p>\n", escaped_html(warning));
  return html;
}

// What a reader wants first.
std::string findings(const Record& record, const std::vector<SummaryRow>& rows) {
  const auto list = [](const std::vector<Headline>& all, const char* after) {
    std::string html;
    for (const Headline& one : all)
      html += one.variant.empty() ? fmt::format("<li>{}</li>\n", escaped_html(one.words))
                                  : fmt::format("<li><strong>{}</strong>{} {}</li>\n", escaped_html(one.variant), after,
                                                escaped_html(one.words));
    return html.empty() ? "" : "<ul class=\"headlines\">\n" + html + "</ul>\n";
  };
  // A sweep was made for its crossovers, which come before figures that are means over all its points.
  std::string html = list(worth_having(rows), ":") + html_gate_answer(record) + list(crossover_headlines(record), ":") +
                     list(failure_headlines(rows), "");
  for (const Table& table : choices_tables(rows)) html += html_table(table) + "\n";
  return html;
}

std::string one_record(const Record& record, const std::string& name, const PictureUrl& url, const std::string& charts) {
  const std::vector<SummaryRow> rows = summarize(record);
  std::string html = name.empty() ? "" : fmt::format("<h2>{}</h2>\n", escaped_html(name));
  html += warnings(record) + findings(record, rows) + html_summary(rows);
  if (!record.pairs.empty())
    html +=
        "<p class=\"note\">A gate times the same pass of two trees strip by strip, not whole frames: its times are below, "
        "before and after the change.</p>\n";
  html += html_saving(record) + html_gate(record) + charts;
  if (const std::string passes = html_passes(record); !passes.empty()) html += "<h2>Every pass</h2>\n" + passes;
  html += html_assumptions(record, url) + html_functions(record, name, url) + html_gallery(record, url);
  return html + html_run(record);
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

std::string picture_tag(const std::string& path, const std::string& alt, const PictureUrl& url, const std::string& width,
                        const std::string& height) {
  const std::string size = width.empty() ? "" : fmt::format(" width=\"{}\" height=\"{}\"", width, height);
  return fmt::format("<img loading=\"lazy\" src=\"{}\" data-picture=\"{}\"{} alt=\"{}\">", url ? url(path) : picture_url(path),
                     escaped_html(path), size, escaped_html(alt));
}

std::string html_charts(const std::vector<Record>& records) {
  if (std::ranges::all_of(records, [](const Record& record) { return record.cells.empty(); })) return "";
  const bool sweeps = std::ranges::any_of(records, [](const Record& record) { return !record.sweeps.empty(); });
  const nlohmann::json data = page_data(records);
  const bool costs = std::ranges::any_of(
      data.at("cells"), [](const nlohmann::json& cell) { return !cell.at("ms").is_null() || !cell.at("fetches").is_null(); });
  struct Section {
    const char *name, *title, *without_script;
    bool shown = true;
  };
  const Section sections[] = {
      {"pareto", "Cost against error", "This chart is drawn by a script; the table of the variants holds its figures.", costs},
      {"passes", "Where the time goes", "These charts are drawn by a script; the table of every pass holds their figures."},
      {"sweeps", "Over the parameter", "These curves are drawn by a script; the tables of all figures hold their points.",
       sweeps},
      {"pictures", "Pictures", "This viewer needs a script; all pictures stand under \"All figures and pictures\"."},
      {"samples", "Every sample",
       "This chart is drawn by a script; every sample stands under the tables of \"All figures and pictures\" too."},
      {"strips", "Every strip of the gate",
       "This chart is drawn by a script; record.jsonl holds every strip, and the table of what each process measured their "
       "ratios.",
       !data.at("strips").empty()}};
  std::string html;
  for (const Section& section : sections)
    if (section.shown)
      html +=
          fmt::format("<section class=\"drawn\" id=\"{}\"><h2>{}</h2><noscript><p class=\"note\">{}</p></noscript></section>\n",
                      section.name, section.title, escaped_html(section.without_script));
  return html + fmt::format("<script type=\"application/json\" id=\"page-data\">{}</script>\n", for_script(data));
}

std::string html_report(const std::vector<Record>& records, const PictureUrl& url, const std::string& history) {
  const std::string title =
      escaped_html(records.size() == 1 ? title_of(records[0]) : fmt::format("{} records side by side", records.size()));
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>"
      "Lamina: {}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n<h1>{}</h1>\n",
      title, page_style, title);
  const std::string charts = html_charts(records);
  if (records.size() == 1) {
    html += one_record(records[0], "", url, charts);
  } else {
    html += html_side_by_side(records) + history + charts;
    for (size_t i = 0; i < records.size(); ++i) html += one_record(records[i], record_name(records, i), url, "");
  }
  html += "</main>\n";
  if (html.find("type=\"application/json\"") != std::string::npos)
    html += fmt::format("<script>{}</script>\n<script>{}</script>\n", page_library, page_script);
  return html + "</body>\n</html>\n";
}

}  // namespace lamina
