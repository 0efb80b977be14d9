// SPDX-License-Identifier: Apache-2.0
// The first lines of a record: what was run, on what, and what the scene called for.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "harness/cli/commands.h"
#include "harness/graph/graph.h"
#include "harness/record/plan_row.h"

namespace lamina {

// As run lines hold it.
nlohmann::ordered_json to_json(const DeviceInfo& device);
// "lamina" and the program's arguments, each quoted where a POSIX shell would not take it as it is.
std::string command_line(std::span<const char* const> arguments);
// As /proc/cpuinfo names it.
std::string cpu_model();
nlohmann::ordered_json run_line(const CompareOptions& options, const Scene& scene, const std::vector<DeviceInfo>& devices);
// The same for a sweep; `inputs` is a hash of all that its cells follow from.
nlohmann::ordered_json run_line(const SweepOptions& options, const Scene& scene,
                                const std::vector<const EffectManifest*>& effects, const std::vector<DeviceInfo>& devices,
                                const std::string& inputs);
// The same for a record that holds functions alone.
nlohmann::ordered_json run_line(const StressOptions& options, const std::vector<DeviceInfo>& devices);
PlanRow plan_row(const Plan& plan, const Scene& scene, ShaderCache& shaders);

}  // namespace lamina
