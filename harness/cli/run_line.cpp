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

RecordWriter begin_record(std::string_view stage, const std::filesystem::path& out, const nlohmann::ordered_json& run,
                          const PlanRow& planned) {
  make_new_run_folder(stage, out);
  RecordWriter record(out / "record.jsonl");
  record.append(run);
  record.append(to_json(planned));
  return record;
}

}  // namespace lamina
