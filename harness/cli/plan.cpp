// SPDX-License-Identifier: Apache-2.0
// lamina plan: what a scene calls for and why, and the passes of every variant, those left out too. Needs no device.
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "harness/cli/commands.h"
#include "harness/cli/common.h"
#include "harness/cli/run_line.h"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

void print_variant(const Json& variant) {
  fmt::print("  {}{}\n", variant["variant"].get<std::string>(), variant["baseline"].get<bool>() ? " (baseline)" : "");
  if (variant.contains("error")) {
    fmt::print("    cannot run: {}\n", variant["error"].get<std::string>());
    return;
  }
  for (const Json& pass : variant["passes"]) {
    fmt::print("    {} {:<16} {}\n", pass["runs"].get<bool>() ? "+" : "-", pass["pass"].get<std::string>(),
               pass["reason"].get<std::string>());
    if (!pass["runs"].get<bool>()) continue;
    const auto reads = pass["reads"].get<std::vector<std::string>>(), writes = pass["writes"].get<std::vector<std::string>>();
    fmt::print("      {:<16} {} -> {}\n", "", reads.empty() ? "nothing" : fmt::format("{}", fmt::join(reads, ", ")),
               fmt::join(writes, ", "));
  }
}

int run_plan(const SceneOptions& options) {
  const Library library = load_library_for(options);
  const Scene scene = load_scene_for(options, library);
  const Plan plan = make_plan(library, scene);
  ShaderCache shaders(Api::vulkan, library.shaders);
  const Json line = plan_line(plan, scene, shaders);
  fmt::print("scene {}: {} object{}, {} light{}, {} view{}; meshes {}, lights {}\n", scene.name, scene.objects.size(),
             scene.objects.size() == 1 ? "" : "s", scene.lights.size(), scene.lights.size() == 1 ? "" : "s", scene.views.size(),
             scene.views.size() == 1 ? "" : "s", scene.mesh_moves ? "move" : "are still",
             scene.lights_move ? "move" : "are still");
  for (const std::string& warning : scene.warnings) fmt::print("note: {}\n", warning);
  for (const Json& effect : line["effects"]) {
    fmt::print("\n{}: {}: {}\n", effect["effect"].get<std::string>(),
               effect["called_for"].get<bool>() ? "called for" : "not called for", effect["reason"].get<std::string>());
    for (const Json& feature : effect["features"])
      fmt::print("  {} {}: {}\n", feature["on"].get<bool>() ? "with" : "without", feature["feature"].get<std::string>(),
                 feature["reason"].get<std::string>());
    for (const Json& variant : effect["variants"]) print_variant(variant);
  }
  return 0;
}

}  // namespace

Command add_plan(CLI::App& program) {
  auto options = std::make_shared<SceneOptions>();
  CLI::App& command = *program.add_subcommand("plan", "What the scene calls for and why, and the passes");
  add_scene(command, *options);
  return {&command, [=](const std::string&) { return run_plan(*options); }};
}

}  // namespace lamina
