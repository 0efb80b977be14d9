// SPDX-License-Identifier: Apache-2.0
// lamina gate --baseline RECORD: the present state against a stored record, or with --update the record afresh.
#include <fmt/format.h>

#include <algorithm>

#include "harness/cli/effect_run.h"
#include "harness/cli/gate_process.h"
#include "harness/cli/planned.h"
#include "harness/cli/run_line.h"
#include "harness/core/text.h"
#include "harness/gate/stored.h"
#include "harness/gate/time_verdicts.h"
#include "harness/gate/verdict.h"
#include "harness/record/record.h"
#include "reports/gate/sentences.h"

namespace lamina {
namespace {

// Everything one process measures on one backend: in the first one cells with their counts and errors, then the variants of
// each effect paired with each other.
void measure_state(Tree& tree, const std::vector<const EffectManifest*>& effects, const GateTask& task,
                   const GateOptions& options, const EmitLine& emit) {
  GateProcess process(task, tree.library.shaders, options);
  ShaderCache& shaders = tree.shaders.at(process.backend->info().api);
  Progress progress(task.backend);
  std::vector<std::unique_ptr<EffectRun>> runs;
  try {
    for (const EffectManifest* effect : effects) {
      runs.push_back(
          std::make_unique<EffectRun>(*process.backend, *effect, shaders, options.compare, "images", progress.tell_or_stop()));
      EffectRun& run = *runs.back();
      const Stopwatch preparing;
      run.start(process.scene_of(tree), {.judged = false});
      run.prepare();
      process.ready_s += preparing.elapsed_s();
      if (!task.exact) continue;
      run.count(), run.score();
      for (const CellRow& row : run.rows()) emit({{"cell", to_json(row)}});
    }
  } catch (const StopRequested&) {  // the effects before it are handed over
    return process.end(emit);
  }
  if (task.exact) return process.end(emit);
  std::vector<TimedFrames> all;
  for (size_t i = 0; i < effects.size() && process.may_time(); ++i) {
    TimedFrames timed{effects[i]->name, "", {}, {}, nullptr};
    for (const VariantManifest& variant : effects[i]->variants)
      if (ReadyFrame* frame = runs[i]->frame(variant.name)) timed.add(variant.name, *frame);
    if (!timed.frames.empty()) all.push_back(std::move(timed));
  }
  // However short the budget, as many whole frames from all processes as give an interval.
  const size_t min_rounds = rounds_a_frame * ((min_rounds_for_95 + task.processes - 1) / task.processes);
  if (!all.empty())
    time_rounds(process, all, [&](const TimedFrames& timed, double further_s) {
      return process.watch.elapsed_s() + further_s > task.until_s && timed.paired->rounds() >= min_rounds;
    });
  for (const PairsRow& row : rows_of(all, process)) emit({{"pairs", to_json(row)}});
  process.end(emit);
}

// One sample a whole frame, from the rounds that make it up.
std::vector<double> frame_samples(const PairedPass& pass, size_t frame) {
  std::vector<double> samples;
  for (size_t round = 0; round + rounds_a_frame <= pass.ms[frame].size(); round += rounds_a_frame) {
    double sum = 0;
    for (size_t kind = 0; kind < rounds_a_frame; ++kind) sum += pass.ms[frame][round + kind];
    samples.push_back(pass.cut ? sum : sum / rounds_a_frame);
  }
  return samples;
}

// Puts the samples of all processes into the cells of the view that was timed.
void add_times(std::vector<CellRow>& cells, const std::vector<PairsRow>& pairs, bool certified, const std::string& backend) {
  for (CellRow& cell : cells) {
    if (cell.backend != backend) continue;
    cell.timed = certified;
    if (!certified || cell.failed) continue;
    std::vector<RatioEstimate> ratios;
    std::map<std::string, size_t> seen;
    for (const PairsRow& row : pairs) {
      const auto at = std::find(row.frames.begin(), row.frames.end(), cell.variant);
      if (row.backend != backend || row.view != cell.view || row.effect != cell.effect || at == row.frames.end()) continue;
      const auto frame = static_cast<size_t>(at - row.frames.begin());
      seen.clear();
      for (PassRow& pass : cell.passes) {
        if (pass.once) continue;
        size_t occurrence = seen[pass.name]++;
        for (const PairedPass& paired : row.passes)
          if (paired.name == pass.name && occurrence-- == 0)
            for (const double ms : frame_samples(paired, frame)) pass.ms.push_back(ms);
      }
      if (frame > 0) ratios.push_back(estimate_of(row, cell.variant));
    }
    if (ratios.empty() || cell.baseline) continue;
    cell.ratio_to_baseline = ratio_interval(settle(pool(ratios)), 0.95);
  }
}

// The stored record; none where there is none and one is to be written.
std::optional<Record> load_baseline(const std::filesystem::path& file, bool update) {
  if (!std::filesystem::exists(file)) {
    if (update) return std::nullopt;
    throw Error(ErrorKind::bad_input, "gate", file.string(), "there is no such record; make one with --update");
  }
  if (!update) return read_record(file);
  try {
    return read_record(file);
  } catch (const Error& error) {  // what is written afresh need not be readable
    fmt::print(stderr, "lamina: warning: {}; it is replaced\n", error.what());
    return std::nullopt;
  }
}

// The present state as it can be known before the minute of measuring.
Record shape_of(const nlohmann::ordered_json& run, const std::vector<const EffectManifest*>& effects,
                const GateOptions& options) {
  Record shape;
  shape.run = run;
  for (const std::string& backend : options.compare.backends)
    for (const EffectManifest* effect : effects)
      for (const VariantManifest& variant : effect->variants)
        if (is_compared(variant, options.compare))
          shape.cells.push_back({.effect = effect->name, .variant = variant.name, .backend = backend});
  return shape;
}

// Writes the record afresh, whole or not at all, and prints what changed. Returns the exit status.
int write_baseline(const std::filesystem::path& file, const std::string& lines, const std::optional<Record>& stored,
                   const Record& present, const GateMeasurements& measured, const GateOptions& options,
                   const LimitsFile& limits) {
  if (present.cells.empty() || !measured.failures.empty() || std::ranges::any_of(present.cells, &CellRow::failed)) {
    for (const VerdictRow& row : measured.failures) fmt::print(stderr, "lamina: {}\n", sentence_of(row));
    throw Error(ErrorKind::failed, "gate", file.string(), "not written: a cell failed, and what failed is no baseline");
  }
  std::vector<VerdictRow> rows;
  if (stored) try {
      check_comparable(*stored, present, file);
      rows = judge_stored(*stored, present, limits, options.family_error);
    } catch (const Error& error) {
      fmt::print(stderr, "lamina: note: the earlier record cannot be compared with this run: {}\n", error.what());
    }
  if (!file.parent_path().empty()) std::filesystem::create_directories(file.parent_path());
  write_file_atomically(file, lines);
  size_t changes = 0;
  for (const VerdictRow& row : rows)
    if (row.verdict != Verdict::same && ++changes) fmt::print("changed: {}\n", sentence_of(row));
  fmt::print("{}: {} cells written{}\n", file.string(), present.cells.size(),
             !stored        ? ", there was no record before"
             : changes == 0 ? ", nothing changed"
                            : "");
  return 0;
}

}  // namespace

int run_against_record(GateOptions options, const Stopwatch& watch) {
  const std::filesystem::path file =
      std::filesystem::is_directory(options.baseline) ? options.baseline / "record.jsonl" : options.baseline;
  const std::optional<Record> stored = load_baseline(file, options.update);
  Tree tree = load_tree(load_library_for(options.compare.scene), options.compare);
  const Scene& scene = *tree.scene;
  std::vector<const EffectManifest*> effects;
  GateNames names{{}, {}, options.compare.backends};
  for (const EffectPlan& entry : tree.plan.effects) {
    if (!entry.called_for) continue;
    effects.push_back(entry.effect);
    names.effects.push_back(entry.effect->name);
    for (const VariantManifest& variant : entry.effect->variants) names.variants.push_back(variant.name);
  }
  check_variant_names("gate", options.compare.variants, names.variants);
  const LimitsFile limits = options.limits.empty() ? LimitsFile() : LimitsFile(options.limits, names);
  if (stored && !options.update) pin_threads_of(*stored);
  const std::vector<DeviceInfo> devices = probe_devices(options);
  options.side_by_side = can_run_side_by_side(devices);
  const nlohmann::ordered_json run = gate_run_line(options, scene, devices);
  if (!options.update) check_comparable(*stored, shape_of(run, effects, options), file);

  RecordWriter record =
      begin_record("gate", options.compare.out, run, plan_row(tree.plan, scene, tree.shaders.begin()->second, options.compare));
  const StopSignals signals(report_on_stop);
  const double loading_s = watch.elapsed_s();
  GateMeasurements measured = measure_in_processes(
      options, watch, [&](const GateTask& task, const EmitLine& emit) { measure_state(tree, effects, task, options, emit); },
      {}, {});
  measured.spent.loading = loading_s;
  for (const std::string& backend : options.compare.backends)
    add_times(measured.cells_after, measured.pairs, measured.certified(backend), backend);
  for (const TimerRow& timer : measured.timers) record.append(to_json(timer));
  for (const CellRow& cell : measured.cells_after) record.append(to_json(cell));
  Record present;
  present.run = run, present.cells = measured.cells_after;
  if (options.update && StopSignals::stopped_by() != 0) {
    fmt::print(stderr, "lamina: gate: {}: not written: stopped before everything was measured\n", file.string());
    return 128 + StopSignals::stopped_by();
  }
  if (options.update)
    return write_baseline(file, read_file(options.compare.out / "record.jsonl", "gate"), stored, present, measured, options,
                          limits);

  for (const PairsRow& row : measured.pairs) record.append(to_json(row));
  std::vector<VerdictRow> rows = measured.failures;
  for (const std::string& backend : options.compare.backends)
    if (const TimerRow* timer = measured.timer(backend)) rows.push_back(judge_timer(*timer));
  if (StopSignals::stopped_by() != 0) {
    rows.push_back(stopped_row());
  } else if (!present.cells.empty()) {
    check_comparable(*stored, present, file);
    for (VerdictRow& row : judge_stored(*stored, present, limits, options.family_error)) rows.push_back(std::move(row));
  }
  let_counts_decide(rows, limits);
  const auto comparisons = std::ranges::count_if(rows, [](const VerdictRow& row) { return row.ratio.has_value(); });
  const GateOutcome outcome = outcome_of(rows);
  append_verdicts(record, std::move(rows));
  record.append(to_json(GateRow{"baseline", fmt::format("the record {}", file.string()), outcome.verdict, outcome.status,
                                measured.processes, rounds_in(measured.pairs), static_cast<size_t>(comparisons),
                                watch.elapsed_s(), limits.of("", "", "").max_drift, 1 - options.family_error}));
  return finish_gate(options, measured.spent, watch);
}

}  // namespace lamina
