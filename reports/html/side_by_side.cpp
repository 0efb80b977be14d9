// SPDX-License-Identifier: Apache-2.0
// Two or more records on one page: what they differ in, and each variant's figures beside each other.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "reports/html/html.h"

namespace lamina {
namespace {

std::string cells_of_row(const std::string& head, const std::vector<std::string>& cells) {
  std::string html = fmt::format("<tr><th scope=\"row\">{}</th>", escaped_html(head));
  for (const std::string& cell : cells) html += fmt::format("<td class=\"wrap\">{}</td>", escaped_html(cell));
  return html + "</tr>\n";
}

std::string side_by_side_table(const std::string& caption, const std::vector<Record>& records, const std::string& body) {
  std::string head = "<th scope=\"col\"></th>";
  for (size_t i = 0; i < records.size(); ++i)
    head += fmt::format("<th scope=\"col\">{}</th>", escaped_html(record_name(records, i)));
  return fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\"><table class=\"wide\"><caption>{}</caption>"
      "<thead><tr>{}</tr></thead><tbody>\n{}</tbody></table></div>\n",
      caption, caption, head, body);
}

// Facts that are not the same in all, in the order of the record that has most to say first.
std::string what_differs(const std::vector<Record>& records) {
  std::vector<std::string> labels;
  std::map<std::string, std::vector<std::string>> values;
  for (size_t i = 0; i < records.size(); ++i)
    for (const auto& [label, value] : run_facts(records[i])) {
      if (!values.contains(label)) labels.push_back(label);
      values[label].resize(records.size());
      values[label][i] = value;
    }
  std::string body;
  for (const std::string& label : labels)
    if (std::set<std::string>(values[label].begin(), values[label].end()).size() > 1)
      body += cells_of_row(label, values[label]);
  return body.empty() ? "<p>The records say the same of where and how they were run.</p>\n"
                      : side_by_side_table("What the records differ in", records, body);
}

}  // namespace

std::string html_side_by_side(const std::vector<Record>& records) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<std::string>> figures;
  for (size_t i = 0; i < records.size(); ++i)
    for (const SummaryRow& row : summarize(records[i])) {
      const std::string key = fmt::format("{} on {} ({})", row.variant, row.backend, row.effect);
      if (!figures.contains(key)) order.push_back(key);
      figures[key].resize(records.size(), "-");
      std::string words = row.frame_ms ? words_for_ms(*row.frame_ms) + " ms" : row.reason.empty() ? "not timed" : "failed";
      if (row.fetches_per_pixel) words += fmt::format(", {:.1f} fetches/px", *row.fetches_per_pixel);
      if (row.mean) words += fmt::format(", SSIM {:.4f}, FLIP {:.4f}", row.mean->ssim, row.mean->flip);
      figures[key][i] = words;
    }
  std::string body;
  for (const std::string& key : order) {
    figures[key].resize(records.size(), "-");
    body += cells_of_row(key, figures[key]);
  }
  return what_differs(records) +
         (body.empty() ? ""
                       : side_by_side_table("Frame time [95%], fetches a pixel, SSIM and FLIP to each record's own baseline",
                                            records, body) +
                             "<p class=\"note\">Times of different machines, drivers or moments are set side by side here, not "
                             "compared: what was not timed in one run, interleaved, has no ratio.</p>\n");
}

}  // namespace lamina
