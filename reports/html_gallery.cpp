// SPDX-License-Identifier: Apache-2.0
// The gallery: for each backend and view the baseline and each variant beside it, with difference, FLIP map and figures.
#include <fmt/format.h>

#include <algorithm>

#include "reports/html.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

// Cells that show the same thing: one effect, backend, size, parameters and view. The baseline comes first.
struct Shots {
  const Json* sample = nullptr;
  std::vector<const Json*> cells;
};

std::vector<Shots> group_shots(const Record& record) {
  std::vector<Shots> groups;
  for (const Json& cell : record.cells) {
    auto group = std::ranges::find_if(groups, [&](const Shots& known) { return same_shot(*known.sample, cell); });
    if (group == groups.end()) {
      groups.push_back({.sample = &cell, .cells = {}});
      group = groups.end() - 1;
    }
    group->cells.push_back(&cell);
  }
  for (Shots& group : groups)
    std::ranges::stable_sort(group.cells, [](const Json* a, const Json* b) { return a->at("baseline") > b->at("baseline"); });
  return groups;
}

std::string image_tag(const Json& cell, const std::string& path, const std::string& alt) {
  return fmt::format(R"(<img loading="lazy" src="{}" width="{}" height="{}" alt="{}">)", picture_url(path),
                     cell.at("width").dump(), cell.at("height").dump(), escaped_html(alt));
}

std::string figure(const Json& cell, const char* field, const std::string& alt, const std::string& caption,
                   const std::string& legend = "") {
  const std::string path = cell.at(field);
  if (path.empty()) return "";
  return fmt::format("<figure>{}<figcaption>{}{}</figcaption></figure>\n", image_tag(cell, path, alt), escaped_html(caption),
                     legend);
}

// A variant's own picture is a button that swaps the baseline's into its place.
std::string own_picture(const Json& cell, const Json* baseline) {
  const std::string path = cell.at("image"), variant = cell.at("variant"), view = cell.at("view");
  if (path.empty()) return "<figure><div class=\"missing\">no picture</div></figure>\n";
  const std::string alt = fmt::format("{} on {}, view {}", variant, cell.at("backend").get<std::string>(), view);
  const std::string baseline_path = baseline ? baseline->at("image").get<std::string>() : std::string();
  if (baseline == &cell || baseline_path.empty()) return figure(cell, "image", alt, "rendered");
  return fmt::format(
      "<figure><button class=\"flip\" type=\"button\" disabled aria-pressed=\"false\" aria-label=\"Compare {} with {}, view "
      "{}\" "
      "data-own=\"{}\" data-baseline=\"{}\" data-baseline-words=\"the baseline, {}\">{}</button>"
      "<figcaption>rendered</figcaption></figure>\n",
      escaped_html(variant), escaped_html(baseline->at("variant").get<std::string>()), escaped_html(view), picture_url(path),
      picture_url(baseline_path), escaped_html(baseline->at("variant").get<std::string>()), image_tag(cell, path, alt));
}

std::string figures_row(const char* name, const std::string& covered, const std::string& frame) {
  return fmt::format("<tr><th scope=\"row\">{}</th><td class=\"num\">{}</td><td class=\"num\">{}</td></tr>\n", name,
                     escaped_html(covered), escaped_html(frame));
}

// Figures against one reference, over the covered pixels and, where there are any, over the frame.
std::string error_rows(const char* title, const std::optional<ErrorFigures>& covered,
                       const std::optional<ErrorFigures>& frame) {
  if (!covered && !frame) return "";
  const auto row = [&](const char* name, auto words) {
    return figures_row(name, covered ? words(*covered) : "-", frame ? words(*frame) : "");
  };
  return fmt::format(
             "<tbody><tr><th scope=\"col\">{}</th><th scope=\"col\" class=\"num\">covered</th>"
             "<th scope=\"col\" class=\"num\">{}</th></tr>\n",
             title, frame ? "frame" : "") +
         row("PSNR, dB", [](const ErrorFigures& e) { return words_for_psnr(e.psnr_db); }) +
         row("SSIM", [](const ErrorFigures& e) { return fmt::format("{:.4f}", e.ssim); }) +
         row("FLIP", [](const ErrorFigures& e) { return fmt::format("{:.4f}", e.flip); }) +
         row("RMSE, linear", [](const ErrorFigures& e) { return fmt::format("{:.3g}", e.rmse_linear); }) +
         row("max, linear", [](const ErrorFigures& e) { return fmt::format("{:.3g}", e.max_linear); }) + "</tbody>\n";
}

std::string error_figures(const Json& cell) {
  const Json& error = cell.at("error");
  return error_rows("against the baseline", figures_of(error.at("baseline")), figures_of(error.at("frame"))) +
         error_rows("against the truth", figures_of(error.at("truth")), std::nullopt);
}

std::string cost_figures(const Record& record, const Json& cell, const std::vector<double>& samples_ms) {
  const auto row = [](const char* name, const std::string& value) {
    return fmt::format("<tr><th scope=\"row\">{}</th><td class=\"num\" colspan=\"2\">{}</td></tr>\n", name,
                       escaped_html(value));
  };
  const bool shown = times_shown(record, cell.at("backend").get<std::string>());
  std::string rows;
  rows += row("frame", samples_ms.empty() ? "not timed" : words_for_ms(median(samples_ms)) + " ms");
  if (const auto ratio = interval_of(cell.at("ratio_to_baseline")); ratio && shown)
    rows += row("ratio", words_for_ratio(*ratio));
  if (const Json& once_ms = cell.at("once_ms"); shown && !once_ms.is_null() && once_ms != 0)
    rows += row("done once", words_for_ms(once_ms.get<double>()) + " ms");
  if (const Json& fetches = cell.at("fetches_per_pixel"); !fetches.is_null())
    rows += row("fetches a pixel", fmt::format("{:.1f}", fetches.get<double>()));
  if (const Json& covered = cell.at("covered_pixels"); !covered.is_null()) rows += row("covered pixels", covered.dump());
  if (const Json& bad = cell.at("nonfinite_pixels"); !bad.is_null() && bad != 0) rows += row("non-finite pixels", bad.dump());
  return "<tbody>" + rows + "</tbody>\n";
}

std::string shot(const Record& record, const Json& cell, const Json* baseline, double axis_ms, const std::string& gain) {
  const std::string variant = cell.at("variant");
  std::string html = fmt::format("<article class=\"shot\"><h4>{}{}</h4>\n", escaped_html(variant),
                                 cell.at("baseline").get<bool>() ? " <small>baseline</small>" : "");
  if (cell.at("status") == "failed")
    return html +
           fmt::format("<p class=\"bad\">Failed: {}</p></article>\n", escaped_html(cell.at("reason").get<std::string>()));
  html += own_picture(cell, baseline);
  const std::string view = cell.at("view");
  const std::string difference =
      figure(cell, "difference", fmt::format("difference of {} from the baseline, view {}", variant, view),
             "difference" + (gain.empty() ? std::string(", scaled") : fmt::format(", times {}", gain)));
  const std::string flip_map =
      figure(cell, "flip", fmt::format("FLIP map of {}, view {}", variant, view), "FLIP",
             "<div class=\"legend\" role=\"img\" aria-label=\"FLIP's scale: black is 0, pale yellow is 1\">0"
             "<span class=\"magma\"></span>1</div>");
  if (!difference.empty() || !flip_map.empty()) html += fmt::format("<div class=\"maps\">{}{}</div>\n", difference, flip_map);
  const std::vector<double> samples_ms = shown_samples_ms(record, cell);
  html += fmt::format("<table class=\"figures\">{}{}</table>\n", cost_figures(record, cell, samples_ms), error_figures(cell));
  if (!samples_ms.empty()) html += html_strip_plot(samples_ms, axis_ms);
  return html + "</article>\n";
}

// The truth of a view, before the pictures that are held to it; the cells of a view share it.
std::string truth_shot(const std::vector<const Json*>& cells) {
  const auto with = std::ranges::find_if(cells, [](const Json* cell) { return cell->contains("truth_image"); });
  if (with == cells.end()) return "";
  const Json& cell = **with;
  return fmt::format(
      "<article class=\"shot\"><h4>truth <small>no frame budget allows it</small></h4>\n<figure>{}<figcaption>what the others "
      "are "
      "held to</figcaption></figure>\n</article>\n",
      image_tag(cell, cell.at("truth_image"), fmt::format("the truth, view {}", cell.at("view").get<std::string>())));
}

}  // namespace

bool same_shot(const Json& a, const Json& b) {
  return std::ranges::all_of(std::array{"effect", "backend", "scene", "width", "height", "params", "view"},
                             [&](const char* field) { return a.at(field) == b.at(field); });
}

std::string html_strip_plot(const std::vector<double>& samples_ms, double axis_ms) {
  // The axis runs over 300 of 320 units; rounds climb so that equal times stay apart and drift over a run shows as a slant.
  constexpr double left = 10, length = 300, top = 4, rise = 22;
  const auto x_of = [&](double ms) { return left + (axis_ms > 0 ? length * ms / axis_ms : 0); };
  std::string dots;
  for (size_t round = 0; round < samples_ms.size(); ++round) {
    const double y = top + rise * (1 - (static_cast<double>(round) + 0.5) / static_cast<double>(samples_ms.size()));
    dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"1.8\"/>", x_of(samples_ms[round]), y);
  }
  return fmt::format(
      "<svg class=\"strip\" viewBox=\"0 0 320 41\" role=\"img\" aria-label=\"frame time of each of {} rounds, first round at "
      "the bottom\">"
      "<line x1=\"{}\" y1=\"29\" x2=\"{}\" y2=\"29\" stroke=\"currentColor\" stroke-opacity=\".45\"/>"
      "<g fill=\"currentColor\" fill-opacity=\".7\">{}</g>"
      "<text x=\"{}\" y=\"39\">0</text><text x=\"{}\" y=\"39\" text-anchor=\"end\">{} ms</text></svg>\n",
      samples_ms.size(), left, left + length, dots, left, left + length, words_for_ms(axis_ms));
}

std::string html_gallery(const Record& record) {
  const std::string gain = text_at(record.run, "/settings/difference_gain");
  std::string html;
  for (const Shots& shots : group_shots(record)) {
    const Json* baseline = shots.cells.front()->at("baseline").get<bool>() ? shots.cells.front() : nullptr;
    double axis_ms = 0;
    for (const Json* cell : shots.cells)
      for (const double sample_ms : shown_samples_ms(record, *cell)) axis_ms = std::max(axis_ms, sample_ms);
    const Json& sample = *shots.sample;
    html +=
        fmt::format("<section>\n<h3>{}, {}, view {}</h3>\n<p class=\"note\">{}</p>\n<div class=\"shots\">\n",
                    escaped_html(sample.at("effect").get<std::string>()), escaped_html(sample.at("backend").get<std::string>()),
                    escaped_html(sample.at("view").get<std::string>()), escaped_html(entries_of(sample.at("params"))));
    html += truth_shot(shots.cells);
    for (const Json* cell : shots.cells) html += shot(record, *cell, baseline, axis_ms, gain);
    html += "</div>\n</section>\n";
  }
  return html;
}

}  // namespace lamina
