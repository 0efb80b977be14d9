// SPDX-License-Identifier: Apache-2.0
// The gallery: for each backend, view and point the figures of the baseline and the variants in a table, and their pictures. It
// reads without a script, and the page's viewer takes its pictures from here.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "reports/html/html.h"

namespace lamina {
namespace {

constexpr size_t max_open_groups = 1;  // groups that stand open; the others unfold

std::vector<std::vector<const CellRow*>> group_shots(const Record& record) {
  std::map<ShotKey, size_t> places;
  std::vector<std::vector<const CellRow*>> groups;
  for (const CellRow& cell : record.cells) {
    const auto [known, added] = places.try_emplace(shot_key(cell), groups.size());
    if (added) groups.emplace_back();
    groups[known->second].push_back(&cell);
  }
  for (auto& group : groups) std::ranges::stable_sort(group, std::greater(), &CellRow::baseline);
  return groups;
}

std::string picture(const CellRow& cell, const std::string& path, const std::string& alt, const std::string& caption,
                    const PictureUrl& url) {
  if (path.empty()) return "";
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n",
                     picture_tag(path, alt, url, std::to_string(cell.width), std::to_string(cell.height)),
                     escaped_html(caption));
}

// The truth is shared by the cells of a view.
std::string truth_picture(const std::vector<const CellRow*>& cells, const PictureUrl& url) {
  for (const CellRow* cell : cells)
    if (!cell->truth_image.empty())
      return picture(*cell, cell->truth_image, "the truth, view " + cell->view, "truth, which no frame budget allows", url);
  return "";
}

std::string pictures(const std::vector<const CellRow*>& cells, const std::string& difference, const PictureUrl& url) {
  std::string html = truth_picture(cells, url);
  for (const CellRow* cell : cells) {
    const std::string &variant = cell->variant, &view = cell->view;
    html += picture(*cell, cell->before_image, fmt::format("{} before the change, view {}", variant, view),
                    variant + ", before the change", url);
    html += picture(*cell, cell->image, fmt::format("{} on {}, view {}", variant, cell->backend, view),
                    cell->baseline ? variant + ", the baseline" : variant, url);
    html += picture(*cell, cell->difference, fmt::format("difference of {} from the baseline, view {}", variant, view),
                    fmt::format("{}: {}", variant, difference), url);
    html += picture(*cell, cell->flip, fmt::format("FLIP map of {}, view {}", variant, view), variant + ": FLIP", url);
  }
  return html.empty() ? "" : "<div class=\"shots\">\n" + html + "</div>\n";
}

std::vector<Column> figures_columns(bool with_truth) {
  std::vector<Column> columns;
  for (const char* heading : {"variant", "frame ms [95%]", "ratio [95%]", "done once, ms", "fetches/px", "PSNR dB", "SSIM",
                              "FLIP", "RMSE, linear", "max, linear", "covered px", "non-finite px", "worst tile: FLIP at x, y"})
    columns.push_back(words_column(heading));
  if (with_truth) columns.push_back(words_column("to truth: PSNR dB, SSIM, FLIP"));
  return columns;
}

Row figures_row(const Record& record, const CellRow& cell, bool with_truth) {
  if (cell.failed) {
    Row row = row_of({cell.variant});
    row.cells.emplace_back("Failed: " + cell.reason, "bad wrap");
    return row;
  }
  const std::vector<double> samples_ms = shown_samples_ms(record, cell);
  const bool shown = times_shown(record, cell.backend);
  const std::optional<ErrorFigures>&error = cell.error_covered, &truth = cell.error_truth;
  const std::optional<Interval>& ratio = cell.ratio_to_baseline;
  const auto count = [](const std::optional<uint64_t>& value) { return value ? std::to_string(*value) : "-"; };
  std::vector<std::string> cells = {cell.variant,
                                    samples_ms.empty() ? "not timed" : words_for_ms(interval_or_range(samples_ms)),
                                    cell.baseline    ? "baseline"
                                    : ratio && shown ? words_for_ratio(*ratio)
                                                     : "-",
                                    cell.once_ms && shown ? words_for_ms(*cell.once_ms) : "-",
                                    cell.fetches_per_pixel ? fmt::format("{:.1f}", *cell.fetches_per_pixel) : "-"};
  if (error)
    cells.insert(cells.end(),
                 {words_for_psnr(error->psnr_db), fmt::format("{:.4f}", error->ssim), fmt::format("{:.4f}", error->flip),
                  fmt::format("{:.3g}", error->rmse_linear), fmt::format("{:.3g}", error->max_linear)});
  else
    cells.insert(cells.end(), 5, "");
  cells.insert(cells.end(), {count(cell.covered_pixels), count(cell.nonfinite_pixels)});
  const std::optional<WorstTile>& tile = cell.worst_tile;
  cells.push_back(tile ? fmt::format("{:.3f} at {}, {}", tile->flip, tile->x, tile->y) : "");
  if (with_truth)
    cells.push_back(truth ? fmt::format("{}, {:.4f}, {:.4f}", words_for_psnr(truth->psnr_db), truth->ssim, truth->flip) : "");
  return row_of(cells);
}

}  // namespace

std::string difference_words(const Record& record) {
  const std::string gain = text_at(record.run, "/settings/difference_gain");
  return gain.empty() ? "difference, scaled" : "difference, times " + gain;
}

std::string html_gallery(const Record& record, const PictureUrl& url) {
  if (record.cells.empty()) return "";
  const std::string difference = difference_words(record);
  std::string html =
      "<h2>All figures and pictures</h2>\n<p class=\"note\">Errors are against the baseline, over the pixels that the effect "
      "covers. Differences are of display values; black is no difference"
      ". Under each table is every round's frame time, the first round at the bottom of its strip, with the median and its "
      "interval. FLIP's map: <span class=\"legend\" role=\"img\" aria-label=\"black is 0, pale yellow is 1\">0<span "
      "class=\"magma\">"
      "</span>1</span></p>\n";
  const bool with_truth = std::ranges::any_of(record.cells, [](const CellRow& cell) { return cell.error_truth.has_value(); });
  size_t place = 0;
  for (const auto& cells : group_shots(record)) {
    const CellRow& sample = *cells.front();
    const std::string what = fmt::format("{} on {}, view {}", sample.effect, sample.backend, sample.view);
    const std::string params = entries_of(sample.params);
    Table table = {.columns = figures_columns(with_truth), .label = what + ", " + params, .html_class = "wide cells"};
    for (const CellRow* cell : cells) table.rows.push_back(figures_row(record, *cell, with_truth));
    html += fmt::format("<details class=\"group\"{}><summary>{} <small>{}</small></summary>\n{}\n{}{}</details>\n",
                        place++ < max_open_groups ? " open" : "", escaped_html(what), escaped_html(params), html_table(table),
                        html_samples(record, cells), pictures(cells, difference, url));
  }
  return html;
}

}  // namespace lamina
