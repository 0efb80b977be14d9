// SPDX-License-Identifier: Apache-2.0
// The frame as a picture: a row for each pass in order, a column for each target, and in the column a line from the first pass
// that writes it to the last one that reads it. What is left out stands below, grey, with its reason.
#include <fmt/format.h>

#include <algorithm>

#include "harness/core/byte_words.h"
#include "reports/html/html.h"

namespace lamina {
namespace {

bool is_in(const std::vector<uint64_t>& places, uint64_t place) { return std::ranges::find(places, place) != places.end(); }

// Targets that some pass touches, as it first comes to them.
std::vector<const PlanRow::Target*> used_targets(const PlanRow::Frame& frame) {
  std::vector<const PlanRow::Target*> used;
  for (const PlanRow::Target& target : frame.targets)
    if (!target.writers.empty() || !target.readers.empty()) used.push_back(&target);
  const auto first = [](const PlanRow::Target* target) {
    return std::min(target->writers.empty() ? UINT64_MAX : target->writers.front(),
                    target->readers.empty() ? UINT64_MAX : target->readers.front());
  };
  std::ranges::stable_sort(used, {}, first);
  return used;
}

std::string frame_head(const std::vector<const PlanRow::Target*>& targets) {
  std::string html = "<thead><tr><th>pass</th>";
  for (const PlanRow::Target* target : targets) {
    std::string words = byte_words(target->bytes);
    if (target->shared) words = "shared, " + words;
    if (target->copies > 1) words = fmt::format("{} of them, {}", target->copies, words);
    html += fmt::format("<th class=\"target\"><span>{} <small>{}</small></span></th>", escaped_html(target->target),
                        escaped_html(words));
  }
  return html + "<th>why</th></tr></thead>\n";
}

std::string frame_cell(const PlanRow::Target& target, uint64_t place) {
  const bool writes = is_in(target.writers, place), reads = is_in(target.readers, place);
  if (writes || reads)
    return fmt::format("<td class=\"touch{}\"><span>{}</span></td>", writes ? " writes" : "",
                       writes && reads ? "reads, writes"
                       : writes        ? "writes"
                                       : "reads");
  const auto before = [&](uint64_t other) { return other < place; };
  const auto after = [&](uint64_t other) { return other > place; };
  const bool alive = (std::ranges::any_of(target.writers, before) || std::ranges::any_of(target.readers, before)) &&
                     (std::ranges::any_of(target.writers, after) || std::ranges::any_of(target.readers, after));
  return alive ? "<td class=\"alive\"></td>" : "<td></td>";
}

std::string left_out_row(const std::string& what, const std::string& reason, size_t targets) {
  return fmt::format("<tr class=\"left-out\"><th>{}</th><td colspan=\"{}\"></td><td>{}</td></tr>\n", escaped_html(what),
                     targets, escaped_html(reason));
}

}  // namespace

std::string html_frame_graph(const Record& record) {
  if (record.plans.empty() || !record.plans.front().frame || record.plans.front().frame->passes.empty()) return "";
  const PlanRow& plan = record.plans.front();
  const PlanRow::Frame& frame = *plan.frame;
  const std::vector<const PlanRow::Target*> targets = used_targets(frame);
  std::string html = fmt::format(
      "<h3>The frame and its targets</h3>\n<p class=\"note\">Every effect at the variant it stands at while another is "
      "compared, "
      "at {}x{}. A line runs from the first pass that touches a target to the last.</p>\n"
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"The frame and its targets\">"
      "<table class=\"frame\">\n",
      frame.width, frame.height);
  html += frame_head(targets) + "<tbody>\n";
  for (size_t i = 0; i < frame.passes.size(); ++i) {
    const PlanRow::Pass& pass = frame.passes[i];
    html += fmt::format("<tr><th>{}. {}: {}</th>", i + 1, escaped_html(pass.effect), escaped_html(pass.pass));
    for (const PlanRow::Target* target : targets) html += frame_cell(*target, i);
    html += fmt::format("<td>{}</td></tr>\n", escaped_html(pass.reason));
  }
  for (const PlanRow::Pass& pass : frame.left_out)
    html += left_out_row(fmt::format("{}: {}", pass.effect, pass.pass), pass.reason, targets.size());
  for (const PlanRow::Effect& effect : plan.effects)
    if (!effect.called_for) html += left_out_row(effect.effect, "not called for: " + effect.reason, targets.size());
  return html + "</tbody></table></div>\n";
}

}  // namespace lamina
