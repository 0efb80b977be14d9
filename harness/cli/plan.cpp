// SPDX-License-Identifier: Apache-2.0
// lamina plan: what a scene calls for and why, and the passes of every variant, those left out too. Needs no device.
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "harness/cli/commands.h"
#include "harness/cli/common.h"
#include "harness/cli/run_line.h"

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

struct PlanOptions : SceneOptions, FrameSize {};

int run_plan(const PlanOptions& options) {
  const Library library = load_library_for(options);
  const Scene scene = load_scene_for(options, library);
  const Plan plan = plan_for(options, library, scene, options.aspect());
  ShaderCache shaders(Api::vulkan, library.shaders);
  const PlanRow row = plan_row(plan, scene, shaders);
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
  return 0;
}

}  // namespace

Command add_plan(CLI::App& program) {
  auto options = std::make_shared<PlanOptions>();
  CLI::App& command = *program.add_subcommand("plan", "What the scene calls for and why, and the passes");
  add_scene(command, *options);
  add_configuration(command, *options);
  add_size(command, *options);
  return {&command, [=](const std::string&) { return run_plan(*options); }};
}

}  // namespace lamina
