// SPDX-License-Identifier: Apache-2.0
// The first line of a record: what was run, and on what.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "harness/cli/devices.h"
#include "harness/cli/options.h"
#include "harness/record/record.h"
#include "harness/scene/scene.h"

namespace lamina {

// "lamina" and the program's arguments, each quoted where a POSIX shell would not take it as it is.
std::string command_line(std::span<const char* const> arguments);
// As /proc/cpuinfo names it.
std::string cpu_model();
// What was run, and on what: each backend that was asked for, and the devices that ran.
nlohmann::ordered_json run_line(const std::string& command, const std::vector<ProbedBackend>& backends);
// The same with the scene and the settings of a command that leaves cells.
nlohmann::ordered_json run_line(const CellOptions& options, const RoundOptions& rounds, bool quick, const Scene& scene,
                                const std::vector<ProbedBackend>& backends);

// The record of a run that begins in `out`, with the lines that say what is run and what is planned.
RecordWriter begin_record(std::string_view stage, const std::filesystem::path& out, const nlohmann::ordered_json& run,
                          const PlanRow& planned);

}  // namespace lamina
