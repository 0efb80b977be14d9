// SPDX-License-Identifier: Apache-2.0
// lamina list: effects, variants and their parameters, built-in scenes, backends and devices.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "harness/backend/backend.h"
#include "harness/cli/commands.h"
#include "harness/cli/common.h"
#include "harness/sweep/parameters.h"

namespace lamina {
namespace {

int run_list(const SceneOptions& options) {
  const Library library = load_library_for(options);
  for (const EffectManifest& effect : library.effects) {
    fmt::print("effect {}: {}\n", effect.name, effect.title);
    for (const VariantManifest& variant : effect.variants) {
      fmt::print("  variant {:<18} {}{}\n", variant.name, variant.baseline ? "baseline: " : "", variant.title);
      for (const ParameterManifest& parameter : variant.parameters)
        fmt::print("    parameter {:<14} {} [{} to {}] {} {}\n", parameter.name, parameter.value, parameter.min, parameter.max,
                   parameter.unit, parameter.title);
    }
  }
  for (const std::string& scene : builtin_scenes()) fmt::print("scene {}\n", scene);
  for (const std::string_view backend : backend_names()) {
    const std::vector<DeviceInfo> devices = list_devices(backend);
    if (devices.empty()) fmt::print("backend {}: no device\n", backend);
    for (size_t i = 0; i < devices.size(); ++i)
      fmt::print("backend {} device {}: {} ({}, {})\n", backend, i, devices[i].device, devices[i].driver,
                 devices[i].api_version);
  }
  return 0;
}

int run_list_parameters(const SceneOptions& options) {
  const Library library = load_library_for(options);
  for (const Parameter& parameter : parameters_of(load_scene_for(options, library), library))
    fmt::print("{:<40} {:>10} [{:g} to {:g}] {}{}{}\n", parameter.path,
               parameter.value ? fmt::format("{:.6g}", *parameter.value) : "-", parameter.min, parameter.max, parameter.unit,
               parameter.unit.empty() || parameter.title.empty() ? "" : ", ", parameter.title);
  return 0;
}

}  // namespace

Command add_list(CLI::App& program) {
  auto options = std::make_shared<SceneOptions>();
  auto parameters = std::make_shared<bool>(false);
  CLI::App& command = *program.add_subcommand("list", "Effects, variants, parameters, scenes, backends, devices");
  add_scene_name(command, *options, "Scene whose parameters are listed");
  command.add_flag("--parameters", *parameters, "Every parameter that 'lamina sweep' can set, and nothing else");
  add_variants_dir(command, *options, "Folder with variants of your own (may be given again)");
  return {&command, [=](const std::string&) { return *parameters ? run_list_parameters(*options) : run_list(*options); }};
}

}  // namespace lamina
