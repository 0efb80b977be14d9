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
#include "harness/record/run_row.h"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

static_assert(LAMINA_VERSION_MAJOR == record_schema, "the version's first number is the record's schema: see CHANGELOG.md");

const std::time_t started = std::time(nullptr);  // about when the program did: before main()

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

std::vector<PlanRow::Pass> planned(const std::vector<GraphPass>& passes, const Scene& scene, bool runs) {
  std::vector<PlanRow::Pass> rows;
  for (const GraphPass& pass : passes) {
    PlanRow::Pass& row = rows.emplace_back();
    row.pass = pass.pass->name, row.effect = pass.variant->effect;
    row.runs = runs, row.once = pass.once, row.reason = pass.reason;
    std::set<std::string> names;
    for (const GraphDraw& draw : pass.draws) {
      if (draw.object) row.objects.push_back(scene.objects[*draw.object].name);
      for (const ResolvedRead& read : draw.reads) names.insert(read.source.name);
    }
    row.reads.assign(names.begin(), names.end());
    row.writes = pass.pass->written();
  }
  return rows;
}

}  // namespace

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

Json run_line(const std::string& command, const std::vector<ProbedBackend>& backends) {
  RunRow row{.lamina = LAMINA_VERSION, .commit = LAMINA_COMMIT};
  if (*LAMINA_COMMIT_DATE) row.commit_date = LAMINA_COMMIT_DATE;
  row.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(started));
  row.build = LAMINA_BUILD_NAME, row.command = command;
  row.machine = {cpu_model(), std::thread::hardware_concurrency(), environment("LP_NUM_THREADS")};
  for (const ProbedBackend& backend : backends)
    row.backends.push_back(
        {backend.name, backend.device.has_value(), backend.device ? backend.device->device : "", backend.failure});
  row.devices = devices_of(backends);
  return to_json(row);
}

Json run_line(const CellOptions& options, const RoundOptions& rounds, bool quick, const Scene& scene,
              const std::vector<ProbedBackend>& backends) {
  Json line = run_line(options.command, backends);
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

PlanRow plan_row(const Plan& plan, const Scene& scene, ShaderCache& shaders) {
  PlanRow row;
  for (const EffectPlan& entry : plan.effects) {
    PlanRow::Effect& effect = row.effects.emplace_back();
    effect.effect = entry.effect->name, effect.called_for = entry.called_for, effect.reason = entry.reason;
    effect.objects = entry.objects.size();
    for (const FeaturePlan& feature : entry.features) effect.features.push_back({feature.define, feature.on, feature.reason});
    for (const VariantManifest& manifest : entry.effect->variants) {
      if (!entry.called_for) break;
      PlanRow::Variant& variant = effect.variants.emplace_back();
      variant.variant = manifest.name, variant.baseline = manifest.baseline;
      try {
        const Graph graph = make_graph(plan, {&manifest}, scene, shaders);
        variant.passes = planned(graph.passes, scene, true);
        for (PlanRow::Pass& dropped : planned(graph.dropped, scene, false)) variant.passes.push_back(std::move(dropped));
      } catch (const Error& error) {
        if (error.kind() == ErrorKind::bad_input && error.stage() == "variants") throw;  // a mistake of a manifest
        variant.error = error.what();
      }
    }
  }
  return row;
}

}  // namespace lamina
