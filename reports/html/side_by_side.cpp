// SPDX-License-Identifier: Apache-2.0
// Two or more records on one page: what they differ in, and each variant's figures beside each other.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "reports/html/html.h"

namespace lamina {
namespace {

// Without rows; a column a record.
Table side_by_side_table(const std::string& caption, const std::vector<Record>& records) {
  Table table = {.caption = caption, .columns = {words_column("")}, .html_class = "wide"};
  for (size_t i = 0; i < records.size(); ++i) table.columns.push_back(words_column(record_name(records, i), "wrap"));
  return table;
}

void add_row(Table& table, const std::string& name, const std::vector<std::string>& words) {
  Row& row = table.rows.emplace_back(row_of(words));
  row.cells.insert(row.cells.begin(), name);
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
  Table table = side_by_side_table("What the records differ in", records);
  for (const std::string& label : labels)
    if (std::set<std::string>(values[label].begin(), values[label].end()).size() > 1) add_row(table, label, values[label]);
  return table.rows.empty() ? "<p>The records say the same of where and how they were run.</p>\n" : html_table(table) + "\n";
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
  Table table = side_by_side_table("Frame time [95%], fetches a pixel, SSIM and FLIP to each record's own baseline", records);
  for (const std::string& key : order) {
    figures[key].resize(records.size(), "-");
    add_row(table, key, figures[key]);
  }
  return what_differs(records) +
         (table.rows.empty()
              ? ""
              : html_table(table) +
                    "\n<p class=\"note\">Times of different machines, drivers or moments are set side by side here, not "
                    "compared: what was not timed in one run, interleaved, has no ratio.</p>\n");
}

}  // namespace lamina
