// SPDX-License-Identifier: Apache-2.0
// lamina gate: is a state of the code slower, hungrier or less accurate than the one before? The whole flow, top to bottom.
#include "harness/cli/gate.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <thread>

#include "harness/cli/commands.h"
#include "harness/cli/planned.h"
#include "harness/cli/run_line.h"
#include "harness/core/text.h"
#include "harness/gate/verdict.h"
#include "harness/record/record.h"
#include "reports/gate/gate.h"
#include "reports/gate/sentences.h"
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

  RecordWriter record = begin_record("gate", options.compare.out, gate_run_line(options, scene, devices),
                                     plan_row(trees.after.plan, scene, trees.after.shaders.begin()->second, options.compare));
  const StopSignals signals(report_on_stop);
  const double loading_s = watch.elapsed_s();
  GateMeasurements measured = measure_trees(trees, options, limits, watch);
  measured.spent.loading = loading_s;
  GateResult result;
  if (StopSignals::stopped_by() == 0)
    result = judge_trees(trees, measured, options, limits);
  else
    result.rows.push_back(stopped_row());
  const GateOutcome outcome = outcome_of(result.rows);
  for (const TimerRow& timer : measured.timers) record.append(to_json(timer));
  for (const CellRow& cell : measured.cells_after) record.append(to_json(with_picture_before(cell, measured.cells_before)));
  for (const PairsRow& row : measured.pairs) record.append(to_json(row));
  for (const SameArmRow& row : result.times.same_arms) record.append(to_json(row));
  append_verdicts(record, std::move(result.rows));
  record.append(
      to_json(GateRow{"against", fmt::format("the variants and shaders of {}", options.against.string()), outcome.verdict,
                      outcome.status, measured.processes, result.times.rounds, result.times.comparisons, watch.elapsed_s(),
                      limits.of("", "", "").max_slowdown, 1 - options.family_error}));
  return finish_gate(options, measured.spent, watch);
}

}  // namespace

std::vector<DeviceInfo> probe_devices(const GateOptions& options) {
  const std::vector<ProbedBackend> backends = probe_backends(options.compare);
  std::vector<DeviceInfo> devices = devices_of(backends);
  require_any("gate", backends);
  check_size("gate", options.compare, devices);
  if (devices.size() < backends.size())
    throw Error(
        ErrorKind::no_device, "gate", "--backend",
        "a backend that was asked for does not open here (see above), and a cell that is not run is never a pass; choose "
        "those that do with --backend");
  return devices;
}

nlohmann::ordered_json gate_run_line(const GateOptions& options, const Scene& scene, const std::vector<DeviceInfo>& devices) {
  RoundOptions rounds;
  rounds.seed = options.seed;
  return run_line(options.compare, rounds, false, scene, all_ran(devices));
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

void append_verdicts(RecordWriter& record, std::vector<VerdictRow> rows) {
  for (VerdictRow& row : rows) {
    row.sentence = sentence_of(row);
    record.append(to_json(row));
  }
}

std::string GateSpent::words(double all_s, double budget_s, size_t backends) const {
  const auto each = [&](double of_all) { return of_all / static_cast<double>(backends); };
  const double rest = std::max(0.0, all_s - loading - exact - timing - report);
  return fmt::format(
      "took {:.1f} s of {:.0f}: loading and comparing code {:.1f}; counts, pictures and errors {:.1f}; times {:.1f}, of which "
      "rounds {:.1f} and the timer's certificate {:.1f}; report {:.1f}; rest {:.1f}",
      all_s, budget_s, loading, exact, timing, each(rounds), each(certifying), report, rest);
}

int finish_gate(const GateOptions& options, GateSpent spent, const Stopwatch& watch) {
  const std::filesystem::path& out = options.compare.out;
  const double before_s = watch.elapsed_s();
  const Record written = read_record(out / "record.jsonl");
  write_reports(out);
  spent.report = watch.elapsed_s() - before_s;
  fmt::print("{}\n{}\nreport: {}\n", gate_table(written, ::isatty(STDOUT_FILENO) == 1),
             spent.words(watch.elapsed_s(), options.budget_s, options.side_by_side ? options.compare.backends.size() : 1),
             (out / "index.html").string());
  announce_on_github(written);
  return StopSignals::stopped_by() != 0 ? 128 + StopSignals::stopped_by() : written.gates.front().status;
}

VerdictRow stopped_row() {
  VerdictRow row;
  row.what = "stopped", row.verdict = Verdict::ambiguous, row.cause = Cause::stopped;
  return row;
}

namespace {

int run_gate(const GateOptions& options) {
  const Stopwatch watch;
  pin_rasterizer_threads(0);  // so that backends can run side by side
  if (options.calibrate) return run_calibration(options);
  if (options.self_test) return run_self_test(options);
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

}  // namespace

Command add_gate(CLI::App& program) {
  auto options = std::make_shared<GateOptions>();
  options->compare.truth_rays = 64;
  CLI::App& command = *program.add_subcommand(
      "gate", "Compares two states of the code; fails where the newer one is slower, fetches more or is less accurate");
  add_scene(command, options->compare.scene);
  add_configuration(command, options->compare.scene);
  CLI::Option* against = command
                             .add_option("--against", options->against,
                                         "Tree of variants/ and shaders/ as they were before, measured in the same run")
                             ->type_name(placeholder::directory);
  command.add_option("--baseline", options->baseline, "Record of the state before (record.jsonl or its folder)")
      ->type_name(placeholder::record)
      ->excludes(against);
  command.add_flag("--update", options->update, "Replace the record that --baseline names, and say what changed");
  command.add_option("--limits", options->limits, "Gate file (.toml): what is allowed, by effect, variant and backend")
      ->type_name(placeholder::gate_file);
  add_out(command, options->compare.out);
  add_backends(command, options->compare);
  add_variant(command, options->compare.variants);
  add_size(command, options->compare);
  command.add_option("--budget", options->budget_s, "Seconds of wall time for everything")
      ->capture_default_str()
      ->type_name("SECONDS")
      ->check(CLI::Range(1.0, 86400.0));
  command
      .add_option("--processes", options->processes,
                  "Processes that measure on each backend; fewer, but at least two, where the budget is short")
      ->capture_default_str()
      ->check(CLI::Range(2, 100));
  command
      .add_flag("--self-test", options->self_test,
                "Put each fault that the gate claims to catch into the scene's own baseline, and print which are caught")
      ->excludes(against);
  CLI::Option* calibrate = command.add_flag("--calibrate", options->calibrate,
                                            "Measure the gate's own error rates here: gates over equal trees, and over trees "
                                            "with one slower pass, each within --budget");
  command.add_option("--gates", options->equal_gates, "Gates over equal trees")->capture_default_str()->needs(calibrate);
  command.add_option("--slower-gates", options->slower_gates, "Gates for each slow-down of 1, 2, 3, 5 and 10%")
      ->capture_default_str()
      ->needs(calibrate);
  command.add_option("--slow-down", options->slow_downs, "Only this slow-down (may be given again)")
      ->type_name("PERCENT")
      ->check(CLI::IsMember({1u, 2u, 3u, 5u, 10u}))
      ->needs(calibrate);
  command.add_flag("!--no-time", options->times, "Counts, pictures and errors alone");
  add_truth(command, options->compare);
  add_alpha(command, options->compare);
  add_seed(command, options->seed);
  add_validation(command, options->compare);
  return {&command, [=](const std::string& typed) {
            options->compare.command = typed;
            return run_gate(*options);
          }};
}

}  // namespace lamina
