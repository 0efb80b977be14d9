// SPDX-License-Identifier: Apache-2.0
// The page's section on assumptions: for each backend and view the baseline's, and folded away those of each variant.
#include <fmt/format.h>

#include <algorithm>

#include "reports/html/html.h"

namespace lamina {
namespace {

std::string assumption_cards(const CellRow& cell, const std::string& difference, const PictureUrl& url) {
  std::string html = fmt::format("<p>{}</p>\n<div class=\"shots\">\n", escaped_html(costliest_assumption(cell)));
  for (const AssumptionRow& assumption : cell.assumptions) {
    html += fmt::format("<article class=\"shot\"><h4>{}</h4>\n", escaped_html(assumption.title));
    if (!assumption.image.empty())
      html += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n",
                          picture_tag(assumption.image,
                                      fmt::format("difference by {}, {} on {}, view {}", assumption.title, cell.variant,
                                                  cell.backend, cell.view),
                                      url, std::to_string(cell.width), std::to_string(cell.height)),
                          escaped_html(difference));
    const ErrorFigures& error = assumption.error;
    const Table table = {
        .columns = {words_column(""), number_column("")},
        .rows = {row_of({"RMSE, linear", fmt::format("{:.3g}", error.rmse_linear)}),
                 row_of({"PSNR dB", words_for_psnr(error.psnr_db)}), row_of({"SSIM", fmt::format("{:.4f}", error.ssim)}),
                 row_of({"FLIP", fmt::format("{:.4f}", error.flip)})},
        .html_class = "figures"};
    html += html_table(table) + "</article>\n";
  }
  return html + "</div>\n";
}

}  // namespace

std::string html_assumptions(const Record& record, const PictureUrl& url) {
  std::vector<const CellRow*> cells;
  for (const CellRow& cell : record.cells)
    if (!cell.assumptions.empty()) cells.push_back(&cell);
  if (cells.empty()) return "";
  // The baseline of a view leads, its variants follow; views in order of appearance.
  const auto place = [&](const CellRow* cell) {
    return std::ranges::find_if(cells, [&](const CellRow* other) { return shot_key(*other) == shot_key(*cell); }) -
           cells.begin();
  };
  std::vector<std::pair<std::pair<std::ptrdiff_t, bool>, const CellRow*>> ordered;
  for (const CellRow* cell : cells) ordered.push_back({{place(cell), !cell->baseline}, cell});
  std::ranges::stable_sort(ordered, [](const auto& a, const auto& b) { return a.first < b.first; });

  std::string html =
      "<h2>Which assumption costs you</h2>\n<p class=\"note\">Each picture shows the difference that one assumption alone "
      "makes, in display values; black is no difference. The "
      "figures are over the pixels that the effect covers.</p>\n";
  const std::string difference = difference_words(record);
  const CellRow* before = nullptr;
  for (const auto& [unused, cell] : ordered) {
    const std::string variant = escaped_html(cell->variant);
    if (!before || shot_key(*before) != shot_key(*cell))
      html += fmt::format("<h3>{}, {}, view {}</h3>\n", escaped_html(cell->effect), escaped_html(cell->backend),
                          escaped_html(cell->view));
    if (cell->baseline)
      html += fmt::format("<section><h4>{} <small>baseline</small></h4>\n{}</section>\n", variant,
                          assumption_cards(*cell, difference, url));
    else
      html += fmt::format("<details><summary>{}</summary>\n{}</details>\n", variant, assumption_cards(*cell, difference, url));
    before = cell;
  }
  return html;
}

}  // namespace lamina
