// SPDX-License-Identifier: Apache-2.0
// lamina gate --calibrate: the gate's own error rates on this machine. It runs many gates over equal trees, each of which
// should find nothing, and over trees in which one pass is slower by a known share. Each gate has its own rounds in several
// processes on every backend, for as long as a gate within the budget has, and is judged as a gate is; while it is ambiguous,
// further processes run within that time. Gates of one kind share no process, since a process's layout of code and memory moves
// all of its ratios; gates of different kinds do, and each counts the opening of the process as its own. Counts and pictures
// are left out. calibration.jsonl holds every gate, and the same command resumes after the last. alarms.jsonl holds the rounds
// of each false alarm, for whoever asks what raised it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <thread>

#include "harness/cli/gate_process.h"
#include "harness/cli/run_line.h"
#include "harness/core/text.h"
#include "harness/gate/calibration.h"
#include "harness/gate/slowdown.h"
#include "harness/record/record.h"
#include "reports/gate/sentences.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;

constexpr std::array<double, 5> slow_downs = {0.01, 0.02, 0.03, 0.05, 0.10};
constexpr std::array<uint32_t, 6> tried_taps = {4, 8, 16, 32, 64, 128};
constexpr size_t whole_rounds = 24;    // to measure what taps cost
constexpr double max_tap_cost = 0.01;  // a tap must cost less of the pass than this, or the smallest slow-down cannot be made

const EffectManifest& effect_with_variants(const Plan& plan, const Scene& scene) {
  for (const EffectPlan& entry : plan.effects)
    if (entry.called_for && entry.effect->variants.size() > 1) return *entry.effect;
  throw Error(ErrorKind::bad_input, "gate", scene.source,
              "calls for no effect with several variants; calibrate on another scene");
}

// What all gates share: the tree as it is, and the same with extra taps in a pass of the effect's baseline.
struct Bench {
  explicit Bench(const GateOptions& given)
      : options(given),
        tree(load_tree(load_library(home_folder(), effect_code()), given.compare)),
        effect(effect_with_variants(tree.plan, *tree.scene)) {
    check_variant_names("gate", options.compare.variants, variant_names({&effect}));
    for (const VariantManifest& variant : effect.variants)
      if (is_compared(variant, options.compare)) variants.push_back(&variant);
  }

  const VariantManifest& baseline_of(const Tree& of) const { return of.library.effect(effect.name).baseline(); }
  // Puts a tree for each number of extra taps into `slower`.
  void make_slower(const std::string& pass, const std::vector<uint32_t>& taps) {
    slower.clear();
    for (const uint32_t count : taps)
      slower.push_back(std::make_unique<Tree>(
          load_tree(with_extra_fetches(tree.library, effect.baseline(), pass, count), options.compare, &tree)));
  }

  const GateOptions& options;
  Tree tree;
  const EffectManifest& effect;
  std::vector<const VariantManifest*> variants;  // of the effect, that are compared
  std::vector<std::unique_ptr<Tree>> slower;
};

// What is timed against what in one process.
class BenchFrames {
 public:
  BenchFrames(GateProcess& process, Bench& bench) : frames_(process), bench_(bench) {}

  // The baseline against itself made slower.
  TimedFrames pair(size_t dose) { return frames_.timed({baseline(frame_before), slowed(dose)}); }
  // And against itself, as a gate does.
  TimedFrames slower(size_t dose) { return frames_.timed({baseline(frame_before), slowed(dose), baseline(frame_again, 2)}); }
  // A variant against itself, as a gate does where its code is not known to be the same.
  TimedFrames equal(const VariantManifest& variant) {
    std::vector<ProcessFrames::Wanted> wanted{{frame_before, &bench_.tree, &variant}, {frame_after, &bench_.tree, &variant, 1}};
    if (variant.baseline) wanted.push_back(baseline(frame_again, 2));
    return frames_.timed(wanted);
  }

 private:
  ProcessFrames::Wanted baseline(std::string_view name, size_t copy = 0) {
    return {name, &bench_.tree, &bench_.effect.baseline(), copy};
  }
  ProcessFrames::Wanted slowed(size_t dose) {
    Tree& tree = *bench_.slower[dose];
    return {frame_after, &tree, &bench_.baseline_of(tree)};
  }

  ProcessFrames frames_;
  Bench& bench_;
};

using Work = std::function<void(GateProcess&, BenchFrames&, const EmitLine&)>;
// Runs `work` in a process on each of these backends and returns the lines of all.
std::vector<nlohmann::json> run_processes(Bench& bench, const std::vector<std::string>& backends, size_t process,
                                          const Work& work) {
  std::vector<std::function<void(const EmitLine&)>> works;
  for (const std::string& backend : backends)
    works.push_back([&, backend](const EmitLine& emit) {
      const GateTask task{.backend = backend, .process = process};
      GateProcess opened(task, bench.tree.library.shaders, bench.options);
      BenchFrames frames(opened, bench);
      work(opened, frames, emit);
    });
  std::vector<ChildResult> children;
  if (bench.options.side_by_side)
    children = run_in_children(works);
  else
    for (const auto& each : works) children.push_back(run_in_child(each));
  std::vector<nlohmann::json> lines;
  for (size_t i = 0; i < children.size(); ++i) {
    if (!children[i].failure.empty()) throw Error(ErrorKind::failed, "gate", backends[i], children[i].failure);
    for (nlohmann::json& line : children[i].lines) lines.push_back(std::move(line));
  }
  return lines;
}

// The passes of the baseline with fragment shaders, the longest on the first backend first.
std::vector<std::string> passes_by_length(Bench& bench) {
  const auto lines = run_processes(bench, {bench.options.compare.backends.front()}, 0,
                                   [&](GateProcess& process, BenchFrames& frames, const EmitLine& emit) {
                                     std::vector<TimedFrames> all;
                                     all.push_back(frames.equal(bench.effect.baseline()));
                                     time_rounds(process, all, [](const TimedFrames&, double) { return true; });
                                     emit(to_json(all.front().row(process)));
                                   });
  std::vector<std::pair<double, std::string>> passes;
  for (const PairedPass& pass : row_of<PairsRow>(lines.front(), "calibration").passes)
    for (const PassManifest& manifest : bench.effect.baseline().passes)
      if (manifest.name == pass.name && !manifest.fragment.empty())
        passes.emplace_back(-whole_ms(pass, 0).value_or(0), pass.name);
  std::sort(passes.begin(), passes.end());
  std::vector<std::string> names;
  for (const auto& [length, name] : passes) names.push_back(name);
  return names;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? std::nan("") : sum / static_cast<double>(values.size());
}

// How much slower the whole pass is in each of the slower trees, over all backends: 0.25 is 25%. Not cut into strips, which
// would make it look smaller than it is.
std::vector<double> costs_of_slower(Bench& bench, const std::string& pass) {
  const PieceOptions whole{.piece_ms = 1e9, .max_repeats = 1};
  const auto lines = run_processes(
      bench, bench.options.compare.backends, 0, [&](GateProcess& process, BenchFrames& frames, const EmitLine& emit) {
        std::vector<TimedFrames> all;
        for (size_t dose = 0; dose < bench.slower.size(); ++dose) all.push_back(frames.pair(dose));
        time_rounds(
            process, all, [](const TimedFrames& timed, double) { return timed.paired->rounds() >= whole_rounds; }, whole);
        for (const PairsRow& row : rows_of(all, process)) emit(to_json(row));
      });
  std::vector<std::vector<double>> ratios(bench.slower.size());
  for (size_t i = 0; i < lines.size(); ++i) {
    const PairsRow row = row_of<PairsRow>(lines[i], "calibration");
    for (size_t k = 0; k < row.passes.size(); ++k)
      if (row.passes[k].name == pass)
        ratios[i % bench.slower.size()].push_back(std::exp(estimate_of(row, frame_after, k).log_ratio));
  }
  std::vector<double> costs;
  for (const std::vector<double>& of_dose : ratios) costs.push_back(mean(of_dose) - 1);
  return costs;
}

// The extra taps for each of slow_downs, by interpolation between those that are tried. None where a pass is much slower for
// the first few, or not slow enough with the most.
std::vector<uint32_t> find_taps(Bench& bench, const std::string& pass) {
  bench.make_slower(pass, {tried_taps.begin(), tried_taps.end()});
  const std::vector<double> costs = costs_of_slower(bench, pass);
  fmt::print("pass {} of {}: extra taps in each pixel", pass, bench.effect.baseline().name);
  for (size_t i = 0; i < tried_taps.size(); ++i) fmt::print(", {} cost {:+.1f}%", tried_taps[i], costs[i] * 100);
  fmt::print("\n");
  if (costs[0] / tried_taps[0] > max_tap_cost) return {};
  std::vector<uint32_t> taps;
  for (const double wanted : slow_downs) {
    size_t above = 0;
    while (above < costs.size() && costs[above] < wanted) ++above;
    if (above == costs.size()) return {};
    const double low_taps = above == 0 ? 0 : tried_taps[above - 1], low = above == 0 ? 0 : costs[above - 1];
    const double part = (wanted - low) / (costs[above] - low);
    taps.push_back(std::max(1u, static_cast<uint32_t>(std::lround(low_taps + part * (tried_taps[above] - low_taps)))));
  }
  return taps;
}

// The seconds that a gate within the budget has for the processes that time, by one real gate in which every variant with this
// pass has changed.
double timing_seconds(Bench& bench, const std::string& pass) {
  Library changed = bench.tree.library;
  for (const VariantManifest* variant : bench.variants) changed = with_extra_fetches(std::move(changed), *variant, pass, 0);
  const Stopwatch watch;
  TreePair trees = pair_trees(bench.tree.library, std::move(changed), bench.options);
  const GateMeasurements measured = measure_trees(trees, bench.options, {}, watch);
  if (!measured.failures.empty()) throw Error(ErrorKind::failed, "gate", "calibration", sentence_of(measured.failures.front()));
  const double seconds = std::max(0.0, bench.options.budget_s - (watch.elapsed_s() - measured.spent.timing));
  fmt::print("a gate on these variants has {:.1f} of its {:g} s for times\n", seconds, bench.options.budget_s);
  std::fflush(stdout);
  return seconds;
}

// What is calibrated, where, and what was found before the first gate; the first line of the calibration's file.
struct Setup {
  nlohmann::ordered_json asked;  // what must be the same for gates to be counted together
  std::string pass;
  std::vector<uint32_t> taps;
  double timing_s = 0;

  nlohmann::ordered_json line() const {
    nlohmann::ordered_json line = asked;
    line["pass"] = pass, line["taps"] = taps, line["timing_s"] = timing_s;
    return line;
  }
};

Setup ask(const GateOptions& options, const Scene& scene, const std::vector<DeviceInfo>& devices) {
  nlohmann::ordered_json on = nlohmann::ordered_json::array();
  for (const DeviceInfo& device : devices)
    on.push_back(fmt::format("{}: {}, {}", device.backend, device.device, device.driver));
  return {{{"kind", "calibration"},
           {"scene", scene.name},
           {"variants", options.compare.variants},
           {"size", fmt::format("{}x{}", options.compare.width_px, options.compare.height_px)},
           {"machine", fmt::format("{}, {} threads", cpu_model(), std::thread::hardware_concurrency())},
           {"devices", on},
           {"margin", Limits().max_slowdown},
           {"processes", options.processes},
           {"budget_s", options.budget_s}},
          "",
          {},
          0};
}

void find(Setup& setup, Bench& bench) {
  for (const std::string& candidate : passes_by_length(bench))
    if (setup.taps.empty()) setup.pass = candidate, setup.taps = find_taps(bench, candidate);
  if (setup.taps.empty())
    throw Error(ErrorKind::failed, "gate", bench.effect.baseline().name,
                "extra taps make none of its passes slower by a known share; calibrate at a larger --size");
  bench.make_slower(setup.pass, setup.taps);
  setup.timing_s = timing_seconds(bench, setup.pass);
}

// Takes what an earlier call found. Throws where that was another calibration.
void go_on(Setup& setup, const nlohmann::json& line, Bench& bench, const fs::path& file) {
  for (const auto& [key, value] : setup.asked.items())
    if (!line.contains(key) || line.at(key) != nlohmann::json(value))
      throw Error(
          ErrorKind::bad_input, "gate", file.string(),
          fmt::format("holds a calibration with another {} ({}, now {}); remove it, or choose another folder with --out", key,
                      line.value(key, nlohmann::json()).dump(), value.dump()));
  try {
    setup.pass = line.at("pass"), setup.timing_s = line.at("timing_s");
    setup.taps = line.at("taps").get<std::vector<uint32_t>>();
  } catch (const nlohmann::json::exception&) {
    setup.taps.clear();
  }
  if (setup.taps.size() != slow_downs.size())
    throw Error(ErrorKind::bad_input, "gate", file.string() + ":1",
                fmt::format("needs 'pass', 'timing_s' and {} numbers in 'taps'; remove the file, or choose another folder with "
                            "--out",
                            slow_downs.size()));
  bench.make_slower(setup.pass, setup.taps);
}

// A gate while its processes run.
struct TimedGate {
  size_t kind = 0;  // 0: equal trees, then slow_downs
  CalibratedGate ended;
  std::vector<PairsRow> pairs;
  std::set<TimedCell> undecided;
  double spent_s = 0, process_s = 0;  // of the gate's time for processes; what the shortest of them took

  double slow_down() const { return kind == 0 ? 0 : slow_downs[kind - 1]; }
  bool false_alarm() const { return kind == 0 && ended.verdict != Verdict::same && ended.verdict != Verdict::ambiguous; }
};

// In the child: the rounds of these gates, one after the other. Emits {"kind":..,"pairs":..} and {"kind":..,"took_s":..} lines.
void time_gates(GateProcess& process, BenchFrames& frames, Bench& bench, const Setup& setup,
                const std::vector<TimedGate*>& gates, size_t processes_left, const EmitLine& emit) {
  process.scene_of(bench.tree);
  const double opening_s = process.watch.elapsed_s();
  for (const TimedGate* each : gates) {
    const Stopwatch watch;
    std::vector<TimedFrames> gate;
    if (each->kind > 0)
      gate.push_back(frames.slower(each->kind - 1));
    else
      for (const VariantManifest* variant : bench.variants)
        if (each->pairs.empty() || each->undecided.contains({process.task.backend, bench.effect.name, variant->name}))
          gate.push_back(frames.equal(*variant));
    const double until_s = (setup.timing_s - each->spent_s) / static_cast<double>(processes_left) - opening_s;
    time_rounds(process, gate, [&](const TimedFrames& timed, double further_s) {
      return watch.elapsed_s() + further_s > until_s || precise_enough(timed, process, {});
    });
    for (const PairsRow& row : rows_of(gate, process)) emit({{"kind", each->kind}, {"pairs", to_json(row)}});
    emit({{"kind", each->kind}, {"took_s", opening_s + watch.elapsed_s()}});
  }
}

// Takes what processes on all backends have handed over.
void take(TimedGate& gate, const std::vector<nlohmann::json>& lines, const Bench& bench, const Setup& setup) {
  double took_s = 0;
  for (const nlohmann::json& line : lines) {
    if (line.at("kind") != gate.kind) continue;
    if (line.contains("pairs")) gate.pairs.push_back(row_of<PairsRow>(line.at("pairs"), "calibration"));
    if (line.contains("took_s"))
      took_s =
          bench.options.side_by_side ? std::max<double>(took_s, line.at("took_s")) : took_s + line.at("took_s").get<double>();
  }
  gate.process_s = gate.spent_s == 0 ? took_s : std::min(gate.process_s, took_s);
  gate.spent_s += took_s;
  gate.ended = judge_calibrated(gate.slow_down(), gate.pairs, bench.options.family_error, setup.pass);
  gate.undecided = judge_pairs(gate.pairs, {}, bench.options.family_error).undecided;
}

// Times a gate of each of these kinds, in processes of one set.
std::vector<TimedGate> run_set(Bench& bench, const Setup& setup, size_t set, const std::vector<size_t>& kinds) {
  std::vector<TimedGate> gates(kinds.size());
  for (size_t i = 0; i < kinds.size(); ++i) gates[i].kind = kinds[i];
  constexpr size_t max_processes = 1000;  // of a gate: each of a set has another seed
  for (size_t process = 0; process < max_processes; ++process) {
    std::vector<TimedGate*> running;
    for (TimedGate& gate : gates)
      if (process < bench.options.processes ||
          (gate.ended.verdict == Verdict::ambiguous && gate.spent_s + gate.process_s < setup.timing_s))
        running.push_back(&gate);
    if (running.empty()) break;
    const size_t left = process < bench.options.processes ? bench.options.processes - process : 1;
    const auto lines = run_processes(bench, bench.options.compare.backends, set * max_processes + process,
                                     [&](GateProcess& opened, BenchFrames& frames, const EmitLine& emit) {
                                       time_gates(opened, frames, bench, setup, running, left, emit);
                                     });
    for (TimedGate* gate : running) take(*gate, lines, bench, setup);
  }
  return gates;
}

// How many gates of a kind are asked for.
size_t asked_of(size_t kind, const GateOptions& options) {
  if (kind == 0) return options.equal_gates;
  const auto percent = static_cast<uint32_t>(std::lround(100 * slow_downs[kind - 1]));
  return options.slow_downs.empty() || std::ranges::count(options.slow_downs, percent) > 0 ? options.slower_gates : 0;
}

// The kinds of gates of which more are wanted.
std::vector<size_t> unfinished(const std::vector<CalibratedGate>& done, const GateOptions& options) {
  std::vector<size_t> kinds;
  for (size_t kind = 0; kind <= slow_downs.size(); ++kind) {
    const double slow_down = kind == 0 ? 0 : slow_downs[kind - 1];
    const auto have = static_cast<size_t>(
        std::ranges::count_if(done, [&](const CalibratedGate& gate) { return gate.slow_down == slow_down; }));
    if (have < asked_of(kind, options)) kinds.push_back(kind);
  }
  return kinds;
}

}  // namespace

int run_calibration(GateOptions options) {
  const std::vector<DeviceInfo> devices = probe_devices(options);
  options.side_by_side = can_run_side_by_side(devices);
  make_run_folder("gate", options.compare.out);
  const fs::path file = options.compare.out / "calibration.jsonl";
  Bench bench(options);
  const Scene& scene = *bench.tree.scene;
  Setup setup = ask(options, scene, devices);
  std::vector<CalibratedGate> gates;
  if (const std::vector<nlohmann::json> lines = read_calibration(file); lines.empty()) {
    find(setup, bench);
  } else {
    go_on(setup, lines.front(), bench, file);
    for (size_t i = 1; i < lines.size(); ++i) gates.push_back(calibrated_from_json(lines[i]));
    fmt::print("resuming after the {} gates in {}\n", gates.size(), file.string());
  }
  std::string whole = setup.line().dump() + "\n";  // without a line that was cut short
  for (const CalibratedGate& gate : gates) whole += to_json(gate).dump() + "\n";
  write_file_atomically(file, whole);
  RecordWriter log(file, true), alarms(options.compare.out / "alarms.jsonl", true);

  const std::string head = fmt::format(
      "Command: {}\nMachine: {}; {}\nMargin {:.1f}%, pass {} of {}, {}, at least {} processes on each backend, {:.1f} s for "
      "all of them\n\n",
      options.compare.command, setup.asked["machine"].get<std::string>(),
      fmt::join(setup.asked["devices"].get<std::vector<std::string>>(), "; "), Limits().max_slowdown * 100, setup.pass,
      bench.effect.baseline().name, setup.asked["size"].get<std::string>(), options.processes, setup.timing_s);
  size_t all = 0;
  for (size_t kind = 0; kind <= slow_downs.size(); ++kind) all += asked_of(kind, options);
  Progress progress("calibrating");
  for (std::vector<size_t> kinds = unfinished(gates, options); !kinds.empty(); kinds = unfinished(gates, options)) {
    progress.show(static_cast<double>(gates.size()) / static_cast<double>(all), "");
    for (const TimedGate& gate : run_set(bench, setup, gates.size(), kinds)) {
      log.append(to_json(gate.ended));
      if (gate.false_alarm())
        for (const PairsRow& row : gate.pairs) alarms.append(to_json(row));
      gates.push_back(gate.ended);
    }
    write_file_atomically(options.compare.out / "calibration.md", head + calibration_table(gates));
  }
  fmt::print("{}{}", head, calibration_table(gates));
  return 0;
}

}  // namespace lamina
