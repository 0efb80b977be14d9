// SPDX-License-Identifier: Apache-2.0
// The page's last part: what was run, by what, and what was not.
#include <fmt/format.h>

#include <map>
#include <set>

#include "reports/gate/reading.h"
#include "reports/html/html.h"

namespace lamina {
namespace {

std::string failures_section(const Record& record) {
  Table table = {.caption = "Cells that failed; the others are not touched by it.",
                 .columns = {words_column("cell"), words_column("reason", "wrap")},
                 .label = "Failures"};
  for (const auto& [cell, reason] : failures(record)) table.rows.push_back(row_of({cell, reason}));
  return table.rows.empty() ? "" : "<h3>Failures</h3>\n" + html_table(table) + "\n";
}

std::string timer_section(const Record& record) {
  std::string html;
  for (const Certificate& certificate : certificates(record))
    html += fmt::format("<li{}>{}</li>\n", certificate.ok ? "" : " class=\"bad\"", escaped_html(certificate.words));
  for (const std::string& line : phase_lines(record)) html += fmt::format("<li>{}</li>\n", escaped_html(line));
  for (const SameArmRow& aa : record.aas) html += fmt::format("<li>{}</li>\n", escaped_html(words_for_aa(aa)));
  if (html.empty()) return "";
  html = "<h3>Timer</h3>\n<ul>\n" + html + "</ul>\n";
  if (!record.aas.empty()) html += fmt::format("<p class=\"note\">{}</p>\n", aa_note);
  return html;
}

std::string hashes_section(const Record& record) {
  const std::vector<std::string> hashes = hash_lines(record);
  if (hashes.empty()) return "";
  return fmt::format("<details><summary>Hashes of shaders and pictures</summary>\n{}</details>\n", html_list(hashes));
}

}  // namespace

std::string html_run(const Record& record) {
  std::string html = "<h2>What was run, and what was not</h2>\n<dl class=\"facts\">\n";
  for (const auto& [label, value] : run_facts(record))
    if (label != "Command") html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped_html(label), escaped_html(value));
  html += "</dl>\n";
  if (const std::string command = text_at(record.run, "/command"); !command.empty())
    html += fmt::format("<p>To make it again: <code>{}</code></p>\n", escaped_html(command));
  html += failures_section(record);
  if (const auto plan = plan_lines(record); !plan.empty()) html += "<h3>What the scene calls for</h3>\n" + html_list(plan);
  html += html_frame_graph(record);
  if (const auto memory = memory_lines(record); !memory.empty()) html += "<h3>What targets take</h3>\n" + html_list(memory);
  if (const auto baked = bake_lines(record); !baked.empty()) html += "<h3>What is done once</h3>\n" + html_list(baked);
  return html + timer_section(record) + hashes_section(record);
}

}  // namespace lamina
