// SPDX-License-Identifier: Apache-2.0
// The gallery: for each backend, view and point the figures of the baseline and the variants in a table, and their pictures. It
// reads without a script, and the page's viewer takes its pictures from here.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "reports/html/html.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

constexpr size_t most_groups_open = 1;  // groups that stand open; the others unfold

std::vector<std::vector<const Json*>> group_shots(const Record& record) {
  std::map<std::string, size_t> places;
  std::vector<std::vector<const Json*>> groups;
  for (const Json& cell : record.cells) {
    const auto [known, added] = places.try_emplace(shot_key(cell), groups.size());
    if (added) groups.emplace_back();
    groups[known->second].push_back(&cell);
  }
  for (auto& group : groups)
    std::ranges::stable_sort(group, [](const Json* a, const Json* b) { return a->at("baseline") > b->at("baseline"); });
  return groups;
}

std::string text_of(const Json& cell, const char* field) { return cell.at(field).get<std::string>(); }

std::string picture(const Json& cell, const std::string& path, const std::string& alt, const std::string& caption,
                    const PictureUrl& url) {
  if (path.empty()) return "";
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n",
                     picture_tag(path, alt, url, cell.at("width").dump(), cell.at("height").dump()), escaped_html(caption));
}

// The truth is shared by the cells of a view.
std::string truth_picture(const std::vector<const Json*>& cells, const PictureUrl& url) {
  for (const Json* cell : cells)
    if (cell->contains("truth_image"))
      return picture(*cell, cell->at("truth_image"), "the truth, view " + text_of(*cell, "view"),
                     "truth, which no frame budget allows", url);
  return "";
}

std::string pictures(const std::vector<const Json*>& cells, const std::string& difference, const PictureUrl& url) {
  std::string html = truth_picture(cells, url);
  for (const Json* cell : cells) {
    const std::string variant = text_of(*cell, "variant"), view = text_of(*cell, "view");
    if (cell->contains("before_image"))
      html += picture(*cell, text_of(*cell, "before_image"), fmt::format("{} before the change, view {}", variant, view),
                      variant + ", before the change", url);
    html += picture(*cell, text_of(*cell, "image"), fmt::format("{} on {}, view {}", variant, text_of(*cell, "backend"), view),
                    cell->at("baseline").get<bool>() ? variant + ", the baseline" : variant, url);
    html +=
        picture(*cell, text_of(*cell, "difference"), fmt::format("difference of {} from the baseline, view {}", variant, view),
                fmt::format("{}: {}", variant, difference), url);
    html +=
        picture(*cell, text_of(*cell, "flip"), fmt::format("FLIP map of {}, view {}", variant, view), variant + ": FLIP", url);
  }
  return html.empty() ? "" : "<div class=\"shots\">\n" + html + "</div>\n";
}

constexpr std::array<const char*, 14> gallery_columns = {"variant",
                                                         "frame ms [95%]",
                                                         "ratio [95%]",
                                                         "done once, ms",
                                                         "fetches/px",
                                                         "PSNR dB",
                                                         "SSIM",
                                                         "FLIP",
                                                         "RMSE, linear",
                                                         "max, linear",
                                                         "covered px",
                                                         "non-finite px",
                                                         "worst tile: FLIP at x, y",
                                                         "to truth: PSNR dB, SSIM, FLIP"};

// The last column is left out where no cell has a truth.
std::string cell_row(const Record& record, const Json& cell, bool with_truth) {
  if (cell.at("status") == "failed")
    return fmt::format("<tr><th scope=\"row\">{}</th><td class=\"bad wrap\" colspan=\"{}\">Failed: {}</td></tr>\n",
                       escaped_html(text_of(cell, "variant")), gallery_columns.size() - (with_truth ? 1 : 2),
                       escaped_html(text_of(cell, "reason")));
  const std::vector<double> samples_ms = shown_samples_ms(record, cell);
  const bool shown = times_shown(record, text_of(cell, "backend"));
  const auto error = figures_of(cell.at("error").at("baseline")), truth = figures_of(cell.at("error").at("truth"));
  const auto ratio = interval_of(cell.at("ratio_to_baseline"));
  const Json &once_ms = cell.at("once_ms"), &fetches = cell.at("fetches_per_pixel");
  std::vector<std::string> cells = {samples_ms.empty() ? "not timed" : words_for_ms(interval_or_range(samples_ms)),
                                    cell.at("baseline").get<bool>() ? "baseline"
                                    : ratio && shown                ? words_for_ratio(*ratio)
                                                                    : "-",
                                    once_ms.is_null() || !shown ? "-" : words_for_ms(once_ms.get<double>()),
                                    fetches.is_null() ? "-" : fmt::format("{:.1f}", fetches.get<double>())};
  if (error)
    cells.insert(cells.end(),
                 {words_for_psnr(error->psnr_db), fmt::format("{:.4f}", error->ssim), fmt::format("{:.4f}", error->flip),
                  fmt::format("{:.3g}", error->rmse_linear), fmt::format("{:.3g}", error->max_linear)});
  else
    cells.insert(cells.end(), 5, "");
  for (const char* count : {"covered_pixels", "nonfinite_pixels"})
    cells.push_back(cell.at(count).is_null() ? "-" : cell.at(count).dump());
  const auto tile = cell.find("worst_tile");
  cells.push_back(tile == cell.end() ? ""
                                     : fmt::format("{:.3f} at {}, {}", tile->at("flip").get<double>(), tile->at("x").dump(),
                                                   tile->at("y").dump()));
  if (with_truth)
    cells.push_back(truth ? fmt::format("{}, {:.4f}, {:.4f}", words_for_psnr(truth->psnr_db), truth->ssim, truth->flip) : "");
  std::string html = fmt::format("<tr><th scope=\"row\">{}</th>", escaped_html(text_of(cell, "variant")));
  for (const std::string& one : cells) html += fmt::format("<td>{}</td>", escaped_html(one));
  return html + "</tr>\n";
}

}  // namespace

std::string difference_words(const Record& record) {
  const std::string gain = text_at(record.run, "/settings/difference_gain");
  return gain.empty() ? "difference, scaled" : "difference, times " + gain;
}

bool same_shot(const Json& a, const Json& b) {
  return std::ranges::all_of(std::array{"effect", "backend", "scene", "width", "height", "params", "view"},
                             [&](const char* field) { return a.at(field) == b.at(field); });
}

std::string shot_key(const Json& cell) {
  std::string key;
  for (const char* field : {"effect", "backend", "scene", "width", "height", "params", "view"})
    key += cell.at(field).dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
  return key;
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
  const bool with_truth =
      std::ranges::any_of(record.cells, [](const Json& cell) { return !cell.at("error").at("truth").is_null(); });
  const auto head =
      header_row(std::span(gallery_columns).first(gallery_columns.size() - (with_truth ? 0 : 1)), gallery_columns.size());
  size_t place = 0;
  for (const auto& cells : group_shots(record)) {
    const Json& sample = *cells.front();
    const std::string what =
        fmt::format("{} on {}, view {}", text_of(sample, "effect"), text_of(sample, "backend"), text_of(sample, "view"));
    html += fmt::format(
        "<details class=\"group\"{}><summary>{} <small>{}</small></summary>\n<div class=\"scroll\" tabindex=\"0\" "
        "role=\"region\" aria-label=\"{}\"><table class=\"wide cells\">{}<tbody>\n",
        place++ < most_groups_open ? " open" : "", escaped_html(what), escaped_html(entries_of(sample.at("params"))),
        escaped_html(what + ", " + entries_of(sample.at("params"))), head);
    for (const Json* cell : cells) html += cell_row(record, *cell, with_truth);
    html += "</tbody></table></div>\n" + html_samples(record, cells) + pictures(cells, difference, url) + "</details>\n";
  }
  return html;
}

}  // namespace lamina
