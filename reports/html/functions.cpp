// SPDX-License-Identifier: Apache-2.0
// The page's section on functions: which variants are worth having, the chart that shows it, tables and pictures of the error.
#include "reports/functions.h"

#include <fmt/format.h>

#include "reports/html/html.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

// Every round behind the intervals of that table. What differs by decades, as exact and fast do, needs a logarithmic axis.
std::string rounds(const FunctionBackend& backend) {
  std::vector<SampleRow> rows;
  for (const FunctionSummary& row : backend.variants) rows.push_back({row.variant, row.samples});
  return html_rounds(rows, SampleAxis::logarithmic, words_for_ns, "ns a call");
}

// Which cases each variant passes and fails, in words, and the figures of every set.
std::string hard_cases_html(const FunctionBackend& backend) {
  const Table table = function_sets_table(backend);
  if (table.rows.empty()) return "";
  std::string html = fmt::format("<h3>Hard cases on {}</h3>\n<ul class=\"verdicts\">\n", escaped_html(backend.backend));
  for (const Headline& one : hard_case_headlines(backend))
    html += fmt::format("<li><strong>{}</strong> {}</li>\n", escaped_html(one.variant), escaped_html(one.words));
  return html + fmt::format("</ul>\n<details class=\"printed\"><summary>Every function and set on {}</summary>{}</details>\n",
                            escaped_html(backend.backend), html_table(table));
}

std::string slices(const FunctionBackend& backend, bool open, const PictureUrl& url) {
  std::string html, axes, full_error;
  for (const FunctionSummary& variant : backend.variants) {
    if (variant.pictures.empty()) continue;
    html += fmt::format("<div class=\"slices\"><h4>{}</h4>", escaped_html(variant.variant));
    for (const FunctionPictureRow* picture : variant.pictures) {
      axes = picture->axes;
      full_error = fmt::format("{:g}", picture->full_error);
      html +=
          fmt::format("<figure>{}<figcaption>{}</figcaption></figure>",
                      picture_tag(picture->image,
                                  fmt::format("error of {} on {}, {}", variant.variant, backend.backend, picture->slice), url),
                      escaped_html(picture->slice));
    }
    html += "</div>\n";
  }
  if (html.empty()) return "";
  const std::string legend = fmt::format(
      "<p class=\"note\">{}.</p>\n<div class=\"legend\" role=\"img\" aria-label=\"blue is too little, white right, red too "
      "much, "
      "black not finite\">too little, -{} or less<span class=\"diverging\"></span>+{} or more, too much; black: not "
      "finite</div>\n",
      escaped_html(axes), full_error, full_error);
  return fmt::format("<details{}><summary>Where it errs, on {}</summary>\n{}{}</details>\n", open ? " open" : "",
                     escaped_html(backend.backend), legend, html);
}

}  // namespace

std::string html_function_chart(const FunctionReport& report, const std::string& name) {
  Json points = Json::array();
  std::string left_out;
  for (const FunctionBackend& backend : report.backends)
    for (const FunctionSummary& row : backend.variants) {
      if (!row.ns) continue;
      if (!row.error || *row.error <= 0 || row.ns->low <= 0) {
        left_out += fmt::format("{}{} on {}", left_out.empty() ? "" : ", ", row.variant, backend.backend);
        continue;
      }
      points.push_back({{"group", (name.empty() ? "" : name + ", ") + backend.backend},
                        {"name", row.variant},
                        {"x", row.ns->median},
                        {"low", row.ns->low},
                        {"high", row.ns->high},
                        {"y", *row.error},
                        {"frontier", row.frontier()},
                        {"not_told", row.standing == Standing::not_told_apart}});
    }
  if (points.empty()) return "";
  const Json data = {{"x", "time of a call, ns (log scale)"},
                     {"y", fmt::format("greatest error, of {} (log scale)", report.scale)},
                     {"points", points}};
  return fmt::format(
      "<figure class=\"chart\"><div class=\"plots\"></div><noscript><p class=\"note\">Here a chart shows error against time; "
      "it "
      "needs JavaScript. The tables below hold its figures.</p></noscript>"
      "<script type=\"application/json\">{}</script>"
      "<figcaption>Error against time: left is faster, down is closer. The line joins the variants worth "
      "having: nothing closer is as fast, by the ratios of the rounds. Half-filled ones are not told apart from a closer one. "
      "The bars are "
      "95% intervals of the time.{}</figcaption></figure>\n",
      for_script(data),
      left_out.empty() ? ""
                       : escaped_html(fmt::format(" Without a place on these axes (no error, values that are not finite, or a "
                                                  "time that noise hides): {}.",
                                                  left_out)));
}

std::string html_functions(const Record& record, const std::string& name, const PictureUrl& url) {
  std::string html;
  for (const FunctionReport& report : summarize_functions(record)) {
    html += fmt::format("<h2>Functions: {}</h2>\n<ul class=\"headlines\">\n", escaped_html(report.title));
    for (const Headline& headline : function_headlines(report))
      html += fmt::format("<li><strong>{}</strong> {}</li>\n", escaped_html(headline.variant), escaped_html(headline.words));
    html += "</ul>\n" + html_function_chart(report, name);
    for (const FunctionBackend& backend : report.backends)
      html += html_table(function_table(report, backend)) + "\n" + rounds(backend);
    for (const std::string& note : function_notes(report))
      html += fmt::format("<p class=\"note\">{}</p>\n", escaped_html(note));
    for (const FunctionBackend& backend : report.backends) html += hard_cases_html(backend);
    for (const FunctionBackend& backend : report.backends) html += slices(backend, &backend == &report.backends.front(), url);
  }
  return html;
}

}  // namespace lamina
