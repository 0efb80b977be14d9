// SPDX-License-Identifier: Apache-2.0
// lamina list: effects, variants and their parameters, built-in scenes, backends and devices.
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "harness/backend/backend.h"
#include "harness/cli/commands.h"
#include "harness/cli/common.h"
#include "harness/record/run_row.h"
#include "harness/stress/family.h"
#include "harness/sweep/parameters.h"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

void print_device(const DeviceInfo& device, size_t place) {
  fmt::print("backend {} device {}: {} ({}, {})\n", device.backend, place, device.device, device.driver, device.api_version);
  std::vector<std::string> can, cannot;
  const auto tell = [&](bool able, const char* what) { (able ? can : cannot).emplace_back(what); };
  tell(device.vertex_storage, "storage in vertex shaders");
  tell(device.fragment_storage, "storage in fragment shaders");
  tell(device.half_floats, "fp16 in shaders");
  tell(device.doubles, "fp64 in shaders");
  tell(device.exact_sample_counts, "exact counts of samples");
  tell(device.issued_fragment_counts, "counts of issued fragments");
  if (device.timestamp_bits > 0)
    can.push_back(fmt::format("timestamps of {} bits", device.timestamp_bits));
  else
    cannot.push_back("timestamps: nothing can be timed");
  can.push_back(fmt::format("pictures up to {} pixels a side", device.max_texture_size));
  fmt::print("  can: {}\n", fmt::join(can, "; "));
  if (!cannot.empty()) fmt::print("  cannot: {}\n", fmt::join(cannot, "; "));
}

void print_backends() {
  for (const std::string_view backend : backend_names()) {
    const auto [devices, all_refused] = survey_devices(backend);
    if (devices.empty()) fmt::print("backend {}: no device\n", backend);
    for (size_t i = 0; i < devices.size(); ++i) print_device(devices[i], i);
    for (const RefusedDevice& refused : all_refused)
      fmt::print("backend {} cannot use {}: {}\n", backend, refused.device, refused.reason);
  }
}

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
  print_backends();
  return 0;
}

Json json_of(const Parameter& parameter) {
  Json row = {{"path", parameter.path}, {"min", parameter.min},     {"max", parameter.max},
              {"unit", parameter.unit}, {"title", parameter.title}, {"whole", parameter.whole}};
  if (parameter.or_zero) row["or_zero"] = true;
  if (!parameter.words.empty()) row["words"] = parameter.words;
  row["value"] = parameter.value ? Json(*parameter.value) : Json(nullptr);
  return row;
}

Json json_of(const VariantManifest& variant) {
  Json row = {
      {"name", variant.name}, {"title", variant.title}, {"baseline", variant.baseline}, {"file", variant.file.string()}};
  row["parameters"] = Json::array();
  for (const ParameterManifest& parameter : variant.parameters)
    row["parameters"].push_back({{"path", variant.name + "." + parameter.name},
                                 {"value", parameter.value},
                                 {"min", parameter.min},
                                 {"max", parameter.max},
                                 {"unit", parameter.unit},
                                 {"title", parameter.title},
                                 {"whole", parameter.whole},
                                 {"words", parameter.words}});
  return row;
}

// All that 'lamina list' prints, and the parameters of the scene.
int run_list_json(const SceneOptions& options, bool parameters_alone) {
  const Library library = load_library_for(options);
  Json all = {{"lamina", LAMINA_VERSION}, {"home", home_folder().string()}};
  for (const EffectManifest& effect : library.effects) {
    Json variants = Json::array();
    for (const VariantManifest& variant : effect.variants) variants.push_back(json_of(variant));
    all["effects"].push_back({{"name", effect.name}, {"title", effect.title}, {"key", effect.key}, {"variants", variants}});
  }
  for (const Family& family : load_families(home_folder() / "shaders", effect_code()))
    all["families"].push_back({{"name", family.name}, {"title", family.title}, {"functions", family.function_names()}});
  all["scenes"] = builtin_scenes();
  all["scene"] = options.scene;
  all["parameters"] = Json::array();
  for (const Parameter& parameter : parameters_of(load_scene_for(options, library), library))
    all["parameters"].push_back(json_of(parameter));
  if (parameters_alone) {
    fmt::print("{}\n", all["parameters"].dump(1));
    return 0;
  }
  for (const std::string_view backend : backend_names()) {
    Json devices = Json::array(), refused = Json::array();
    const DeviceSurvey found = survey_devices(backend);
    for (const DeviceInfo& device : found.usable) devices.push_back(to_json(device));
    for (const RefusedDevice& device : found.refused) refused.push_back({{"device", device.device}, {"reason", device.reason}});
    all["backends"].push_back({{"name", backend}, {"devices", devices}, {"refused", refused}});
  }
  fmt::print("{}\n", all.dump(1));
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
  auto json = std::make_shared<bool>(false);
  CLI::App& command =
      *program.add_subcommand("list", "Effects, variants, parameters, scenes, backends, and what devices can do");
  add_scene_name(command, *options, "Scene whose parameters are listed");
  command.add_flag("--parameters", *parameters, "Every parameter that 'lamina sweep' can set, and nothing else");
  command.add_flag("--json", *json, "One JSON object of all that, with the scene's parameters; for scripts");
  add_variants_dir(command, *options, "Folder with variants of your own (may be given again)");
  return {&command, [=](const std::string&) {
            if (*json) return run_list_json(*options, *parameters);
            return *parameters ? run_list_parameters(*options) : run_list(*options);
          }};
}

}  // namespace lamina
