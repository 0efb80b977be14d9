// SPDX-License-Identifier: Apache-2.0
// lamina plan: what a scene calls for and why, the passes of every variant, those left out too, and the frame's targets. Needs
// no device.
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "harness/cli/commands.h"
#include "harness/cli/common.h"
#include "harness/cli/planned.h"
#include "harness/core/byte_words.h"
#include "harness/record/plan_dot.h"

namespace lamina {
namespace {

void print_variant(const PlanRow::Variant& variant) {
  fmt::print("  {}{}\n", variant.variant, variant.baseline ? " (baseline)" : "");
  if (!variant.error.empty()) fmt::print("    cannot run: {}\n", variant.error);
  for (const PlanRow::Pass& pass : variant.passes) {
    fmt::print("    {} {:<16} {}\n", pass.runs ? "+" : "-", pass.pass, pass.reason);
    if (pass.runs)
      fmt::print("      {:<16} {} -> {}\n", "", pass.reads.empty() ? "nothing" : fmt::format("{}", fmt::join(pass.reads, ", ")),
                 fmt::join(pass.writes, ", "));
  }
}

// "hulls (3)": the passes at these places.
std::string passes_at(const PlanRow::Frame& frame, const std::vector<uint64_t>& places) {
  std::vector<std::string> names;
  for (const uint64_t place : places) names.push_back(fmt::format("{} ({})", frame.passes[place].pass, place + 1));
  return names.empty() ? "nobody" : fmt::format("{}", fmt::join(names, ", "));
}

void print_target(const PlanRow::Frame& frame, const PlanRow::Target& target) {
  if (target.writers.empty() && target.readers.empty()) return;
  const std::string whose = target.shared ? "shared" : target.effect.empty() ? "the frame's" : target.effect;
  std::vector<uint64_t> all = target.writers;
  all.insert(all.end(), target.readers.begin(), target.readers.end());
  const auto [first, last] = std::ranges::minmax(all);
  fmt::print("  {:<20} {:<18} {:>9}  passes {} to {}\n", target.target, whose, byte_words(target.bytes), first + 1, last + 1);
  if (target.copies > 1) fmt::print("    {} of them, one for each object or light that has one\n", target.copies);
  fmt::print("    written by {}; read by {}\n", passes_at(frame, target.writers), passes_at(frame, target.readers));
}

// The frame in which every effect stands as it is chosen, else at its baseline.
void print_frame(const PlanRow& row) {
  if (!row.frame) {
    fmt::print("\nthe frame of all effects cannot run: {}\n", row.frame_error);
    return;
  }
  const PlanRow::Frame& frame = *row.frame;
  fmt::print("\nthe frame, {}x{}:\n", frame.width, frame.height);
  for (size_t i = 0; i < frame.passes.size(); ++i)
    fmt::print("  {:>2}. {}: {} ({})\n", i + 1, frame.passes[i].effect, frame.passes[i].pass, frame.passes[i].reason);
  uint64_t bytes = 0, shared = 0;
  for (const PlanRow::Target& target : frame.targets) bytes += target.bytes, shared += target.shared ? 1 : 0;
  fmt::print("\nits targets, {}{}:\n", byte_words(bytes),
             shared > 0 ? fmt::format("; {} of them shared, drawn once for all effects that read them", shared) : "");
  if (frame.aliased_bytes && frame.reused_bytes)
    fmt::print("  where those needed at different times share memory: {} on Vulkan, {} on OpenGL\n",
               byte_words(*frame.aliased_bytes), byte_words(*frame.reused_bytes));
  for (const PlanRow::Target& target : frame.targets) print_target(frame, target);
}

struct PlanOptions : SceneOptions, FrameSize {
  bool dot = false;
};

int run_plan(const PlanOptions& options) {
  const Library library = load_library_for(options);
  const Scene scene = load_scene_for(options, library);
  const Plan plan = plan_for(options, library, scene, options.aspect());
  ShaderCache shaders(Api::vulkan, library.shaders);
  const PlanRow row = plan_row(plan, scene, shaders, options);
  if (options.dot) {
    fmt::print("{}", plan_dot(row, scene.name));
    return 0;
  }
  fmt::print("scene {}: {} object{}, {} light{}, {} view{}; meshes {}, lights {}\n", scene.name, scene.objects.size(),
             scene.objects.size() == 1 ? "" : "s", scene.lights.size(), scene.lights.size() == 1 ? "" : "s", scene.views.size(),
             scene.views.size() == 1 ? "" : "s", scene.mesh_moves || scene.objects_move ? "move" : "are still",
             scene.lights_move ? "move" : "are still");
  for (const std::string& warning : scene.warnings) fmt::print("note: {}\n", warning);
  for (const PlanRow::Effect& effect : row.effects) {
    fmt::print("\n{}: {}: {}\n", effect.effect, effect.called_for ? "called for" : "not called for", effect.reason);
    for (const PlanRow::Feature& feature : effect.features)
      fmt::print("  {} {}: {}\n", feature.on ? "with" : "without", feature.feature, feature.reason);
    for (const PlanRow::Variant& variant : effect.variants) print_variant(variant);
  }
  print_frame(row);
  return 0;
}

}  // namespace

Command add_plan(CLI::App& program) {
  auto options = std::make_shared<PlanOptions>();
  CLI::App& command = *program.add_subcommand("plan", "What the scene calls for and why, the passes, and the frame's targets");
  add_scene(command, *options);
  add_configuration(command, *options);
  add_size(command, *options);
  command.add_flag("--dot", options->dot,
                   "The frame as a graph for Graphviz: lamina plan SCENE --dot | dot -Tsvg -o frame.svg");
  return {&command, [=](const std::string&) { return run_plan(*options); }};
}

}  // namespace lamina
