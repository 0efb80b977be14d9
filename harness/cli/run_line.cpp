// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/run_line.h"

#include <fmt/chrono.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

#include "commit.h"
#include "harness/cli/cell.h"
#include "harness/cli/common.h"
#include "harness/graph/graph.h"
#include "harness/record/record.h"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

const std::time_t started = std::time(nullptr);  // about when the program did: before main()

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

Json passes_of(const std::vector<GraphPass>& passes, const Scene& scene, bool runs) {
  Json rows = Json::array();
  for (const GraphPass& pass : passes) {
    Json objects = Json::array(), textures = Json::array();
    std::set<std::string> names;
    for (const GraphDraw& draw : pass.draws) {
      if (draw.object) objects.push_back(scene.objects[*draw.object].name);
      for (const ResolvedRead& read : draw.reads) names.insert(read.source.name);
    }
    for (const std::string& name : names) textures.push_back(name);
    rows.push_back({{"pass", pass.pass->name},
                    {"effect", pass.variant->effect},
                    {"runs", runs},
                    {"once", pass.once},
                    {"reason", pass.reason},
                    {"objects", objects},
                    {"reads", textures},
                    {"writes", pass.pass->written()}});
  }
  return rows;
}

}  // namespace

Json to_json(const DeviceInfo& device) {
  return {{"backend", device.backend},         {"device", device.device},     {"driver", device.driver},
          {"api_version", device.api_version}, {"software", device.software}, {"max_texture_size", device.max_texture_size}};
}

// Quoting by POSIX.1-2017, volume Shell & Utilities, section 2.2.2: inside single quotes nothing but their end is special.
std::string command_line(std::span<const char* const> arguments) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";  // never special, wherever they stand
  std::string line = "lamina";
  for (const std::string_view argument : arguments) {
    line += ' ';
    if (!argument.empty() && argument.find_first_not_of(plain) == std::string_view::npos) {
      line += argument;
      continue;
    }
    line += '\'';
    for (const char c : argument) c == '\'' ? line.append("'\\''") : line.append(1, c);
    line += '\'';
  }
  return line;
}

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

Json run_line(const std::string& command, const std::vector<DeviceInfo>& devices) {
  Json rows = Json::array();
  for (const DeviceInfo& device : devices) rows.push_back(to_json(device));
  return {{"kind", "run"},
          {"schema", record_schema},
          {"lamina", LAMINA_VERSION},
          {"commit", LAMINA_COMMIT},
          {"commit_date", *LAMINA_COMMIT_DATE ? Json(LAMINA_COMMIT_DATE) : Json(nullptr)},
          {"date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(started))},
          {"build", LAMINA_BUILD_NAME},
          {"command", command},
          {"machine",
           {{"cpu", cpu_model()},
            {"threads", std::thread::hardware_concurrency()},
            {"lp_num_threads", environment("LP_NUM_THREADS")}}},
          {"devices", rows}};
}

Json run_line(const CellOptions& options, const RoundOptions& rounds, bool quick, const Scene& scene,
              const std::vector<DeviceInfo>& devices) {
  Json line = run_line(options.command, devices);
  line["settings"] = {
      {"width", options.width_px},        {"height", options.height_px},        {"quick", quick},
      {"budget_s", rounds.budget_s},      {"precision", rounds.precision},      {"seed", rounds.seed},
      {"truth_rays", options.truth_rays}, {"difference_gain", difference_gain}, {"validation", options.validation}};
  line["scene"] = scene.name;
  line["source"] = scene.source;
  line["time_s"] = scene.time_s;
  line["warnings"] = scene.warnings;
  return line;
}

Json plan_line(const Plan& plan, const Scene& scene, ShaderCache& shaders) {
  Json effects = Json::array();
  for (const EffectPlan& entry : plan.effects) {
    Json features = Json::array(), variants = Json::array();
    for (const FeaturePlan& feature : entry.features)
      features.push_back({{"feature", feature.define}, {"on", feature.on}, {"reason", feature.reason}});
    for (const VariantManifest& variant : entry.effect->variants) {
      if (!entry.called_for) break;
      try {
        const Graph graph = make_graph(plan, {&variant}, scene, shaders);
        Json passes = passes_of(graph.passes, scene, true);
        for (const Json& dropped : passes_of(graph.dropped, scene, false)) passes.push_back(dropped);
        variants.push_back({{"variant", variant.name}, {"baseline", variant.baseline}, {"passes", passes}});
      } catch (const Error& error) {
        if (error.kind() == ErrorKind::bad_input && error.stage() == "variants") throw;  // a mistake of a manifest
        variants.push_back({{"variant", variant.name}, {"baseline", variant.baseline}, {"error", error.what()}});
      }
    }
    effects.push_back({{"effect", entry.effect->name},
                       {"called_for", entry.called_for},
                       {"reason", entry.reason},
                       {"objects", entry.objects.size()},
                       {"features", features},
                       {"variants", variants}});
  }
  return {{"kind", "plan"}, {"effects", effects}};
}

}  // namespace lamina
