// SPDX-License-Identifier: Apache-2.0
// lamina gate --baseline RECORD: the present state against a stored record, or with --update the record afresh.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "harness/cli/backend_run.h"
#include "harness/cli/gate.h"
#include "harness/cli/run_line.h"
#include "harness/core/text.h"
#include "harness/gate/stored.h"
#include "harness/measure/timer_certificate.h"
#include "harness/record/record.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

// Everything one process measures on one backend: in the first one cells with their counts and errors, then the variants of
// each effect paired with each other.
void measure_state(const Scene& scene, Tree& tree, const std::vector<const EffectManifest*>& effects, const GateTask& task,
                   const GateOptions& options, const EmitLine& emit) {
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed_s = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  const std::unique_ptr<Backend> backend = open_backend(task.backend, {options.compare.device, options.compare.validation});
  bool certified = true;
  if (task.certify) {
    const TimerRow timer = certify_timer(*backend, tree.library.shaders);
    emit({{"timer", to_json(timer)}});
    certified = timer.ok;
  }
  Bakes bakes(scene, DiskCache(options.compare.cache));
  SceneResources resources(*backend, scene, options.compare.width_px, options.compare.height_px, &bakes);
  ShaderCache& shaders = tree.shaders.at(backend->info().api);
  Progress progress(task.backend);
  if (task.exact)
    for (const EffectManifest* effect : effects) {
      const std::filesystem::path images = options.compare.out / "images";
      BackendRun run(*backend, resources, tree.plan, *effect, shaders, bakes, options.compare, images);
      run.prepare(progress), run.count(progress), run.score(progress);
      for (const CellRow& row : run.rows()) emit({{"cell", to_json(row)}});
    }
  if (!options.times || !certified) return;

  struct Timed {
    const EffectManifest* effect;
    std::vector<std::string> names;
    std::vector<std::unique_ptr<Graph>> graphs;
    std::vector<std::unique_ptr<Frame>> frames;
    std::unique_ptr<PairedFrames> paired;
  };
  std::vector<Timed> all;
  for (const EffectManifest* effect : effects) {
    Timed timed{effect, {}, {}, {}, nullptr};
    for (const VariantManifest& variant : effect->variants) {
      if (!is_compared(variant, options.compare)) continue;
      try {
        auto graph = std::make_unique<Graph>(make_graph(tree.plan, configuration_with(tree.plan, variant), scene, shaders));
        auto frame = std::make_unique<Frame>(resources, *graph, Build::timed);
        frame->run_once(Timing::off);
        frame->run(0, Timing::off);
        timed.graphs.push_back(std::move(graph)), timed.frames.push_back(std::move(frame)), timed.names.push_back(variant.name);
      } catch (const Error&) {  // its cells have failed and say why
      }
    }
    std::vector<Frame*> frames;
    for (const auto& frame : timed.frames) frames.push_back(frame.get());
    if (frames.empty()) continue;
    timed.paired = std::make_unique<PairedFrames>(*backend, frames, 0);
    all.push_back(std::move(timed));
  }
  std::mt19937_64 random(options.compare.seed + 7919 * task.process);  // another order in every process
  for (size_t round = 0;
       !all.empty() && (round % rounds_a_frame != 0 || round < 2 * rounds_a_frame || elapsed_s() < task.until_s); ++round)
    for (const Timed& timed : all) timed.paired->run_round(random);
  for (const Timed& timed : all)
    emit({{"pairs", to_json(PairsRow{task.process, task.backend, timed.effect->name, "", scene.views.front().name, timed.names,
                                     timed.paired->passes()})}});
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
void add_times(std::vector<Json>& cells, const std::vector<PairsRow>& pairs, bool certified, const std::string& backend) {
  for (Json& cell : cells) {
    if (cell.at("backend") != backend) continue;
    cell["timed"] = certified;
    if (!certified || cell.at("status") == "failed") continue;
    const std::string variant = cell.at("variant");
    std::vector<double> ratios;
    std::map<std::string, size_t> seen;
    for (const PairsRow& row : pairs) {
      const auto at = std::find(row.frames.begin(), row.frames.end(), variant);
      if (row.backend != backend || row.view != cell.at("view") || row.effect != cell.at("effect") || at == row.frames.end())
        continue;
      const auto frame = static_cast<size_t>(at - row.frames.begin());
      seen.clear();
      for (Json& pass : cell["passes"]) {
        if (pass.at("once")) continue;
        const std::string name = pass.at("name");
        size_t occurrence = seen[name]++;
        for (const PairedPass& paired : row.passes)
          if (paired.name == name && occurrence-- == 0)
            for (const double ms : frame_samples(paired, frame)) pass["ms"].push_back(ms);
      }
      if (frame > 0)
        for (const double ratio : ratios_of(row, variant, -1)) ratios.push_back(ratio);
    }
    for (Json& pass : cell["passes"])
      if (!pass.at("ms").empty()) pass["median_ms"] = median(pass.at("ms").get<std::vector<double>>());
    const std::vector<double> whole = frame_samples_ms(passes_of(cell));
    if (!whole.empty()) cell["median_ms"] = median(whole);
    if (ratios.size() < min_rounds_for_95 || cell.at("baseline").get<bool>()) continue;
    const Interval ratio = median_interval(ratios);
    cell["ratio_to_baseline"] = {{"median", ratio.median},
                                 {"low", ratio.low},
                                 {"high", ratio.high},
                                 {"rounds", ratio.rounds},
                                 {"coverage", ratio.coverage}};
  }
}

Record load_baseline(const std::filesystem::path& given) {
  return read_record(std::filesystem::is_directory(given) ? given / "record.jsonl" : given);
}

}  // namespace

int run_against_record(const GateOptions& options, const std::function<double()>& elapsed_s) {
  const bool known = std::filesystem::exists(options.baseline);
  if (!known && !options.update)
    throw Error(ErrorKind::bad_input, "gate", options.baseline.string(), "there is no such record; make one with --update");
  const std::filesystem::path file =
      std::filesystem::is_directory(options.baseline) ? options.baseline / "record.jsonl" : options.baseline;
  std::optional<Record> stored;
  if (!options.update) stored = load_baseline(options.baseline);
  if (options.update && std::filesystem::exists(file)) {
    try {
      stored = load_baseline(options.baseline);
    } catch (const Error& error) {  // what is written afresh need not be readable
      fmt::print(stderr, "lamina: warning: {}; it is written afresh\n", error.what());
    }
  }
  const Scene scene = load_scene_for(options.compare.scene);
  Tree tree = load_tree(load_library_for(options.compare.scene), scene, options.compare.backends);
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
  const std::vector<DeviceInfo> devices = probe_devices(options);
  if (stored && !options.update) {  // before the minute of measuring, not after it
    Record shape;
    shape.run = run_line(options.compare, scene, devices);
    for (const std::string& backend : options.compare.backends)
      for (const EffectManifest* effect : effects)
        for (const VariantManifest& variant : effect->variants)
          if (is_compared(variant, options.compare))
            shape.cells.push_back({{"backend", backend}, {"effect", effect->name}, {"variant", variant.name}});
    check_comparable(*stored, shape, file);
  }

  std::error_code not_there;
  std::filesystem::remove_all(options.compare.out / "images", not_there);  // an earlier run's
  make_run_folder("gate", options.compare.out);
  RecordWriter record(options.compare.out / "record.jsonl");
  Record run;
  run.run = run_line(options.compare, scene, devices);
  record.append(run_line(options.compare, scene, devices));
  record.append(plan_line(tree.plan, scene, tree.shaders.begin()->second));

  GateMeasurements measured;
  std::set<std::string> broken;
  std::map<std::string, bool> certified;
  const size_t planned = options.times ? options.processes : 1;
  for (size_t process = 0; process < planned; ++process)
    for (size_t i = 0; i < options.compare.backends.size(); ++i) {
      const std::string& backend = options.compare.backends[i];
      if (broken.contains(backend)) continue;
      const size_t left = (planned - process) * options.compare.backends.size() - i;
      const GateTask task{backend, process, options.times && !certified[backend], process == 0,
                          (options.budget_s - elapsed_s()) / static_cast<double>(left)};
      const ChildResult child =
          run_in_child([&](const EmitLine& emit) { measure_state(scene, tree, effects, task, options, emit); });
      take_lines(child, task, measured);
      if (!child.failure.empty()) broken.insert(backend);
      for (const Json& timer : measured.timers)
        if (timer.at("backend") == backend) certified[backend] = timer.at("ok");
    }
  for (const std::string& backend : options.compare.backends)
    add_times(measured.cells_after, measured.pairs, certified[backend], backend);
  for (const Json& timer : measured.timers) record.append(nlohmann::ordered_json(timer));
  for (const Json& cell : measured.cells_after) record.append(nlohmann::ordered_json(cell));
  const std::string baseline_lines = read_file(options.compare.out / "record.jsonl", "gate");
  for (const PairsRow& row : measured.pairs) record.append(to_json(row));
  run.cells = measured.cells_after;

  std::vector<VerdictRow> rows = measured.failures;
  size_t comparisons = 0;
  for (const Json& timer : measured.timers)
    if (options.times) rows.push_back(judge_timer(timer));
  if (stored && !run.cells.empty()) {
    const auto judge = [&] {
      check_comparable(*stored, run, file);
      for (VerdictRow& row : judge_stored(*stored, run, limits, options.family_error)) rows.push_back(std::move(row));
    };
    if (options.update) {
      try {
        judge();
      } catch (const Error& error) {
        fmt::print(stderr, "lamina: note: the record before cannot be compared with: {}\n", error.what());
      }
    } else {
      judge();
    }
  }
  for (const VerdictRow& row : rows) comparisons += row.ratio.has_value();
  if (options.update) {
    const bool whole = measured.failures.empty() && std::none_of(run.cells.begin(), run.cells.end(), [](const Json& cell) {
                         return cell.at("status") == "failed";
                       });
    if (!whole || run.cells.empty()) {
      for (const VerdictRow& row : measured.failures) fmt::print(stderr, "lamina: {}\n", row.sentence);
      throw Error(ErrorKind::failed, "gate", file.string(), "not written: a cell failed, and what failed is no baseline");
    }
    if (!file.parent_path().empty()) std::filesystem::create_directories(file.parent_path());
    write_file_atomically(file, baseline_lines);
    size_t changes = 0;
    for (const VerdictRow& row : rows)
      if (row.verdict != Verdict::same && ++changes) fmt::print("changed: {}\n", row.sentence);
    fmt::print("{}: {} cells written{}\n", file.string(), run.cells.size(),
               !stored        ? ", there was no record before"
               : changes == 0 ? ", nothing changed"
                              : "");
    return 0;
  }
  const GateOutcome outcome = outcome_of(rows);
  for (const VerdictRow& row : rows) record.append(to_json(row));
  record.append(to_json(GateRow{"baseline", fmt::format("the record {}", file.string()), outcome.verdict, outcome.status,
                                planned, judge_pairs(measured.pairs, limits, options.family_error).rounds, comparisons,
                                elapsed_s(), limits.of("", "", "").max_drift, 1 - options.family_error}));
  return finish_gate(options.compare.out);
}

}  // namespace lamina
