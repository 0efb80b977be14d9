// SPDX-License-Identifier: Apache-2.0
#include "harness/record/plan_dot.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "harness/core/byte_words.h"

namespace lamina {
namespace {

constexpr size_t label_width = 44;  // characters; longer lines are broken at spaces

// Lines centred one below the other, in quotes. A backslash would begin an escape and other control characters mean nothing.
std::string label(const std::vector<std::string>& lines) {
  std::string text = "\"";
  const auto add = [&](char c) {
    if (c == '"' || c == '\\') text += '\\';
    text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  };
  for (size_t i = 0; i < lines.size(); ++i) {
    if (i > 0) text += "\\n";
    size_t column = 0;
    for (const char c : lines[i]) {
      if (c == ' ' && column >= label_width) {
        text += "\\n";
        column = 0;
      } else {
        add(c);
        ++column;
      }
    }
  }
  return text + "\"";
}

std::string target_words(const PlanRow::Target& target) {
  std::string words = byte_words(target.bytes);
  if (target.copies > 1) words = fmt::format("{} of them, {}", target.copies, words);
  return target.shared ? "shared, " + words : words;
}

// What the pass reads that is no target of the frame: textures of objects and of the scene, what is baked, tables.
std::vector<std::string> of_the_scene(const PlanRow::Frame& frame, size_t place) {
  std::set<std::string> targets;
  for (const PlanRow::Target& target : frame.targets)
    if (std::ranges::find(target.readers, place) != target.readers.end()) targets.insert(target.target);
  std::vector<std::string> others;
  for (const std::string& read : frame.passes[place].reads)
    if (!targets.contains(read)) others.push_back(read);
  return others;
}

std::string passes_and_targets(const PlanRow::Frame& frame) {
  std::string dot;
  for (size_t i = 0; i < frame.passes.size(); ++i) {
    const PlanRow::Pass& pass = frame.passes[i];
    std::vector<std::string> lines = {fmt::format("{}. {}", i + 1, pass.pass), fmt::format("{}: {}", pass.effect, pass.variant),
                                      pass.reason};
    if (const auto read = of_the_scene(frame, i); !read.empty()) lines.push_back(fmt::format("from {}", fmt::join(read, ", ")));
    dot += fmt::format("  pass_{} [label={}{}];\n", i, label(lines), pass.once ? ", style=\"rounded\"" : "");
    if (i > 0) dot += fmt::format("  pass_{} -> pass_{} [style=invis];\n", i - 1, i);
  }
  for (size_t i = 0; i < frame.targets.size(); ++i) {
    const PlanRow::Target& target = frame.targets[i];
    if (target.writers.empty() && target.readers.empty()) continue;
    dot += fmt::format("  target_{} [shape=ellipse{}, label={}];\n", i, target.shared ? ", penwidth=2" : "",
                       label({target.target, target_words(target)}));
    for (const uint64_t writer : target.writers) dot += fmt::format("  pass_{} -> target_{};\n", writer, i);
    for (const uint64_t reader : target.readers) dot += fmt::format("  target_{} -> pass_{};\n", i, reader);
  }
  return dot;
}

}  // namespace

std::string plan_dot(const PlanRow& plan, const std::string& scene) {
  std::string dot = fmt::format(
      "digraph {} {{\n  rankdir=TB;\n  node [shape=box, fontname=\"Helvetica\", fontsize=10];\n  edge [arrowsize=0.6];\n",
      label({scene}));
  if (plan.frame) dot += passes_and_targets(*plan.frame);
  constexpr const char* grey = "style=dashed, color=\"grey50\", fontcolor=\"grey40\"";
  size_t count = 0;
  const auto left_out = [&](const std::vector<std::string>& lines) {
    dot += fmt::format("  left_out_{} [{}, label={}];\n", count, grey, label(lines));
    // In columns of a few below each other, beside the frame.
    constexpr size_t below = 4;
    if (count % below > 0) dot += fmt::format("  left_out_{} -> left_out_{} [style=invis];\n", count - 1, count);
    ++count;
  };
  if (!plan.frame) left_out({"the frame", "cannot run: " + plan.frame_error});
  for (const PlanRow::Effect& effect : plan.effects)
    if (!effect.called_for) left_out({effect.effect, "not called for: " + effect.reason});
  if (plan.frame)
    for (const PlanRow::Pass& pass : plan.frame->left_out)
      left_out({pass.pass, fmt::format("{}: {}", pass.effect, pass.variant), pass.reason});
  return dot + "}\n";
}

}  // namespace lamina
