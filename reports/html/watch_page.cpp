// SPDX-License-Identifier: Apache-2.0
#include "reports/html/watch_page.h"

#include <fmt/format.h>

#include "reports/html/html.h"

namespace lamina {
namespace {

// Loads watch.js every half second; what is scrolled stays where it was.
constexpr const char* reload_script = R"(
let asked = 0;
function lamina_watch(now) { if (now !== shown) location.reload(); }
setInterval(() => {
  const script = document.createElement('script');
  script.src = 'watch.js?' + ++asked;
  script.onload = script.onerror = () => script.remove();
  document.head.append(script);
}, 500);
)";

constexpr const char* watch_style = R"(
pre.failure { border-left: .3rem solid var(--bad); color: var(--bad); background: var(--card); padding: .6rem .9rem; white-space: pre-wrap; }
.watched { border: 1px solid var(--line); border-radius: .5rem; background: var(--card); padding: .9rem; margin: 1rem 0; }
.watched.stale .views { opacity: .55; }
.watched h2 { border-top: 0; margin: 0 0 .6rem; padding: 0; }
.views { display: grid; gap: 1rem; grid-template-columns: repeat(3, minmax(0, 32rem)); }
.views figure { margin: 0; } .views img { display: block; width: 100%; height: auto; background: #0c0d0e; border-radius: .25rem; }
.views figcaption { color: var(--soft); font-size: .85rem; }
.fresh { color: var(--accent); font-weight: 600; }
)";

// Pictures of this generation, whatever the browser has kept of the last.
std::string picture(const std::string& path, const std::string& caption, size_t generation) {
  if (path.empty()) return "";
  return fmt::format("<figure><img src=\"{}?{}\" alt=\"{}\"><figcaption>{}</figcaption></figure>\n", picture_url(path),
                     generation, escaped_html(caption), escaped_html(caption));
}

std::string count_words(const std::optional<uint64_t>& count) { return count ? fmt::format("{}", *count) : "-"; }

std::string operations_of(const CellRow& cell) {
  std::map<std::string, uint64_t> sum;
  for (const PassRow& pass : cell.passes)
    for (const auto& [kind, count] : pass.operations) sum[kind] += count;
  std::string words;
  for (const auto& [kind, count] : sum) words += fmt::format("{}{} {}", words.empty() ? "" : ", ", kind, count);
  return words.empty() ? "-" : words;
}

std::string figures(const CellRow& cell) {
  Table table = {
      .columns = {words_column("view"), figures_column("frame ms"), figures_column("to baseline"), number_column("fetches"),
                  number_column("fetches/px"), number_column("PSNR dB"), number_column("SSIM"), number_column("FLIP"),
                  number_column("to the truth: PSNR, SSIM"), number_column("not finite"), words_column("operations", "wrap")},
      .label = cell.variant + ", view " + cell.view,
      .html_class = "wide"};
  const std::optional<ErrorFigures>&error = cell.error_covered, &truth = cell.error_truth;
  table.rows.push_back(
      row_of({cell.view, cell.median_ms ? words_for_ms(*cell.median_ms) : "not timed",
              cell.ratio_to_baseline ? words_for_ratio(*cell.ratio_to_baseline) : "-", count_words(cell.fetches),
              cell.fetches_per_pixel ? fmt::format("{:.1f}", *cell.fetches_per_pixel) : "-",
              error ? words_for_psnr(error->psnr_db) : "-", error ? fmt::format("{:.4f}", error->ssim) : "-",
              error ? fmt::format("{:.4f}", error->flip) : "-",
              truth ? fmt::format("{}, {:.4f}", words_for_psnr(truth->psnr_db), truth->ssim) : "-",
              count_words(cell.nonfinite_pixels), operations_of(cell)}));
  return html_table(table);
}

std::string section_of(const WatchedVariant& variant, size_t generation) {
  std::string html =
      fmt::format("<section class=\"watched{}\"><h2>{} <small>{}</small>{}</h2>\n", variant.failure.empty() ? "" : " stale",
                  escaped_html(variant.name), escaped_html(variant.title),
                  variant.is_new && variant.failure.empty() ? " <span class=\"fresh\">new</span>" : "");
  if (!variant.failure.empty()) {
    html += fmt::format("<pre class=\"failure\">{}</pre>\n", escaped_html(variant.failure));
    html += variant.cells.empty() ? "<p class=\"note\">There is no good picture yet.</p>\n"
                                  : "<p class=\"note\">Below is the last good one.</p>\n";
  }
  for (const CellRow& cell : variant.cells)
    html += "<div class=\"views\">\n" + picture(cell.image, "picture, view " + cell.view, generation) +
            picture(cell.difference, "difference to the baseline", generation) + picture(cell.flip, "FLIP", generation) +
            "</div>\n" + figures(cell);
  return html + "</section>\n";
}

}  // namespace

std::string watch_page(const WatchState& state) {
  bool failed = !state.failure.empty();
  for (const WatchedVariant& variant : state.variants) failed = failed || !variant.failure.empty();
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\">\n"
      "<title>{}{}</title>\n<style>{}{}</style></head><body>\n<h1>{}</h1>\n<p class=\"note\">{}{:.2f} s. This page loads "
      "itself again "
      "when a shader, a manifest or the scene changes. Ctrl-C in the terminal ends it and leaves <a href=\"index.html\">the "
      "report</a>.</p>\n",
      failed ? "(!) " : "", escaped_html(state.what), page_style, watch_style, escaped_html(state.what),
      state.changed.empty() ? "Drawn in " : escaped_html(state.changed + " changed; drawn in "), state.took_s);
  if (!state.failure.empty())
    html += fmt::format("<pre class=\"failure\">{}</pre>\n<p class=\"note\">Below is what was drawn before.</p>\n",
                        escaped_html(state.failure));
  // What failed stands first: whoever writes a shader looks for it.
  for (const bool failures : {true, false})
    for (const WatchedVariant& variant : state.variants)
      if (variant.failure.empty() != failures) html += section_of(variant, state.generation);
  return html + fmt::format("<script>const shown = {};{}</script>\n</body></html>\n", state.generation, reload_script);
}

std::string watch_script(const WatchState& state) { return fmt::format("lamina_watch({});\n", state.generation); }

}  // namespace lamina
