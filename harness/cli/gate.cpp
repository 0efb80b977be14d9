// SPDX-License-Identifier: Apache-2.0
// lamina gate: is a state of the code slower, hungrier or less accurate than the one before? The whole flow, top to bottom.
#include "harness/cli/gate.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <thread>

#include "harness/cli/run_line.h"
#include "harness/core/text.h"
#include "harness/gate/verdict.h"
#include "harness/record/record.h"
#include "reports/gate/gate.h"
#include "reports/reports.h"
#include "reports/words.h"

namespace lamina {
namespace {

GateNames names_in(const TreePair& trees, const GateOptions& options) {
  GateNames names;
  for (const VariantPair& pair : trees.variants) {
    const VariantManifest& manifest = pair.after ? *pair.after : *pair.before;
    names.effects.push_back(manifest.effect);
    names.variants.push_back(manifest.name);
  }
  names.backends = options.compare.backends;
  return names;
}

// The cell with the picture of the same cell before the change, where there is one.
CellRow with_picture_before(CellRow cell, const std::vector<CellRow>& cells_before) {
  if (const auto before = find_cell(cells_before, cell.backend, cell.effect, cell.variant, cell.view))
    cell.before_image = before->image;
  return cell;
}

int run_against(GateOptions options, const Stopwatch& watch) {
  TreePair trees = pair_trees(load_library(options.against, effect_code()), load_library_for(options.compare.scene), options);
  const Scene& scene = *trees.after.scene;
  const LimitsFile limits = options.limits.empty() ? LimitsFile() : LimitsFile(options.limits, names_in(trees, options));
  const std::vector<DeviceInfo> devices = probe_devices(options);
  options.side_by_side = can_run_side_by_side(devices);

  RecordWriter record = begin_record(options.compare.out, run_line(options.compare, scene, devices), scene, trees.after);
  const GateMeasurements measured = measure_trees(trees, options, limits, watch);
  const GateResult result = judge_trees(trees, measured, options, limits);
  const GateOutcome outcome = outcome_of(result.rows);
  for (const TimerRow& timer : measured.timers) record.append(to_json(timer));
  for (const CellRow& cell : measured.cells_after) record.append(to_json(with_picture_before(cell, measured.cells_before)));
  for (const PairsRow& row : measured.pairs) record.append(to_json(row));
  for (const SameArmRow& row : result.times.same_arms) record.append(to_json(row));
  for (const VerdictRow& row : result.rows) record.append(to_json(row));
  record.append(
      to_json(GateRow{"against", fmt::format("the variants and shaders of {}", options.against.string()), outcome.verdict,
                      outcome.status, measured.processes, result.times.rounds, result.times.comparisons, watch.elapsed_s(),
                      limits.of("", "", "").max_slowdown, 1 - options.family_error}));
  return finish_gate(options.compare.out);
}

}  // namespace

std::vector<DeviceInfo> probe_devices(const GateOptions& options) {
  std::vector<DeviceInfo> devices;
  std::vector<std::string> usable;
  for (const std::string& name : options.compare.backends) {
    const ChildResult child = run_in_child([&](const EmitLine& emit) {
      emit(to_json(open_backend(name, {options.compare.device, options.compare.validation})->info()));
    });
    if (!child.failure.empty() || child.lines.empty()) {
      fmt::print(stderr, "lamina: {}: {}\n", name, child.failure);
      continue;
    }
    const nlohmann::json& line = child.lines.front();
    DeviceInfo info;
    info.backend = line["backend"], info.device = line["device"], info.driver = line["driver"];
    info.api_version = line["api_version"], info.software = line["software"], info.max_texture_size = line["max_texture_size"];
    if (std::max(options.compare.width_px, options.compare.height_px) > info.max_texture_size)
      throw Error(ErrorKind::bad_input, "gate", "--size",
                  fmt::format("{}x{} is larger than {} pixels, the most that {} can draw", options.compare.width_px,
                              options.compare.height_px, info.max_texture_size, name));
    devices.push_back(info);
    usable.push_back(name);
  }
  if (usable.empty()) throw_no_backend("gate");
  if (usable.size() < options.compare.backends.size())
    throw Error(
        ErrorKind::no_device, "gate", "--backend",
        "a backend that was asked for does not open here (see above), and a cell that is not run is never a pass; choose "
        "those that do with --backend");
  return devices;
}

void pin_threads_of(const Record& stored) {
  const auto here = [&](const char* field) { return text_at(stored.run, field); };
  if (here("/machine/cpu") == cpu_model() && here("/machine/threads") == std::to_string(std::thread::hardware_concurrency()))
    ::setenv("LP_NUM_THREADS", here("/machine/lp_num_threads").c_str(), 1);
}

bool can_run_side_by_side(const std::vector<DeviceInfo>& devices) {
  const char* threads = ::getenv("LP_NUM_THREADS");
  return threads && std::string_view(threads) == "0" && std::thread::hardware_concurrency() >= devices.size() &&
         std::ranges::all_of(devices, [](const DeviceInfo& device) { return device.software; });
}

RecordWriter begin_record(const std::filesystem::path& out, const nlohmann::ordered_json& run, const Scene& scene, Tree& tree) {
  std::error_code not_there;
  std::filesystem::remove_all(out / "images", not_there);  // an earlier run's
  make_run_folder("gate", out);
  RecordWriter record(out / "record.jsonl");
  record.append(run);
  record.append(to_json(plan_row(tree.plan, scene, tree.shaders.begin()->second)));
  return record;
}

int finish_gate(const std::filesystem::path& out) {
  const Record written = read_record(out / "record.jsonl");
  write_reports(out);
  fmt::print("{}\nreport: {}\n", gate_table(written, ::isatty(STDOUT_FILENO) == 1), (out / "index.html").string());
  announce_on_github(written);
  return written.gates.front().status;
}

int run_gate(const GateOptions& options) {
  const Stopwatch watch;
  if (options.calibrate) return run_calibration(options);
  if (options.against.empty() == options.baseline.empty())
    throw Error(ErrorKind::bad_input, "gate", "options",
                "say what to compare with: --against DIR, a tree of variants and shaders, or --baseline RECORD; one of them");
  if (options.update && options.baseline.empty())
    throw Error(ErrorKind::bad_input, "gate", "--update", "writes the record that --baseline names; name one");
  for (const char* folder : {"variants", "shaders"})
    if (!options.against.empty() && !std::filesystem::is_directory(options.against / folder))
      throw Error(ErrorKind::bad_input, "gate", options.against.string(),
                  fmt::format("has no folder '{}'; give a tree with variants/ and shaders/, such as a checkout", folder));
  return options.baseline.empty() ? run_against(options, watch) : run_against_record(options, watch);
}

}  // namespace lamina
