// SPDX-License-Identifier: Apache-2.0
// lamina gate --calibrate: the gate's own error rates on this machine. Many gates over equal trees, each of which should find
// nothing, and over trees in which one pass is slower by a known share. Each gate has rounds of its own in several processes on
// every backend, for as long as a gate within the budget has, and is judged as a gate is. What is dear is shared: gates come in
// sets whose processes are the same, prepared once. Counts and pictures are left out, and an ambiguous gate gets no further
// processes, though one on its own would.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include "harness/cli/gate_process.h"
#include "harness/cli/run_line.h"
#include "harness/core/text.h"
#include "harness/gate/slowdown.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;

constexpr size_t gates_a_set = 40;  // over equal trees; their share of those with a slower pass goes along
constexpr std::array<double, 5> slow_downs = {0.01, 0.02, 0.03, 0.05, 0.10};
constexpr std::array<uint32_t, 6> tried_taps = {4, 8, 16, 32, 64, 128};
constexpr double most_dear_tap = 0.01;  // a tap costs less of the pass than this, or the least slow-down cannot be made

const EffectManifest& effect_with_variants(const Plan& plan, const Scene& scene) {
  for (const EffectPlan& entry : plan.effects)
    if (entry.called_for && entry.effect->variants.size() > 1) return *entry.effect;
  throw Error(ErrorKind::bad_input, "gate", scene.source,
              "calls for no effect with several variants; calibrate on another scene");
}

// What all gates share: the tree as it is, and the same with extra taps in a pass of the effect's baseline.
class Bench {
 public:
  Bench(const GateOptions& given, const Scene& of_scene)
      : options(given),
        scene(of_scene),
        tree(load_tree(load_library(home_folder()), scene, given.compare.backends)),
        effect(effect_with_variants(tree.plan, scene)),
        folder_(given.compare.out / "slower-trees") {}
  ~Bench() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  const VariantManifest& baseline_of(const Tree& of) const { return of.library.effect(effect.name).baseline(); }
  fs::path slower_home(size_t dose) const { return folder_ / std::to_string(dose); }
  // Puts a tree for each number of extra taps into `slower`.
  void make_slower(const std::string& pass, const std::vector<uint32_t>& taps) {
    slower.clear();
    for (size_t i = 0; i < taps.size(); ++i) {
      write_slower_tree(home_folder(), slower_home(i), effect.baseline(), pass, taps[i]);
      slower.push_back(std::make_unique<Tree>(load_tree(load_library(slower_home(i)), scene, options.compare.backends)));
    }
  }

  const GateOptions& options;
  const Scene& scene;
  Tree tree;
  const EffectManifest& effect;
  std::vector<std::unique_ptr<Tree>> slower;

 private:
  fs::path folder_;
};

// Frames of the bench in one process, each made when it is first asked for.
class BenchFrames {
 public:
  BenchFrames(GateProcess& process, Bench& bench) : process_(process), bench_(bench) {}

  Frame& get(Tree& tree, const VariantManifest& variant, size_t copy = 0) {
    auto& ready = made_[{&variant, copy}];
    if (!ready)
      ready =
          std::make_unique<ReadyFrame>(process_.resources, tree.plan, variant, tree.shaders.at(process_.backend->info().api));
    return ready->frame;
  }
  // The baseline against itself made slower, and against itself.
  TimedFrames slower(size_t dose) {
    TimedFrames timed = of(bench_.effect.baseline());
    timed.add(frame_after, get(*bench_.slower[dose], bench_.baseline_of(*bench_.slower[dose])));
    timed.add(frame_again, get(bench_.tree, bench_.effect.baseline(), 2));
    return timed;
  }
  // A variant against itself, as a gate does where its code is not known to be the same.
  TimedFrames equal(const VariantManifest& variant) {
    TimedFrames timed = of(variant);
    timed.add(frame_after, get(bench_.tree, variant, 1));
    if (variant.baseline) timed.add(frame_again, get(bench_.tree, variant, 2));
    return timed;
  }

 private:
  TimedFrames of(const VariantManifest& variant) {
    TimedFrames timed{bench_.effect.name, variant.name, {}, {}, nullptr};
    timed.add(frame_before, get(bench_.tree, variant));
    return timed;
  }
  GateProcess& process_;
  Bench& bench_;
  std::map<std::pair<const VariantManifest*, size_t>, std::unique_ptr<ReadyFrame>> made_;
};

using Work = std::function<void(GateProcess&, BenchFrames&, const EmitLine&)>;
// Runs `work` in a process on this backend and returns its lines.
std::vector<nlohmann::json> run_process(Bench& bench, const std::string& backend, size_t process, const Work& work) {
  const GateTask task{backend, process, false, false, 0};
  const ChildResult child = run_in_child([&](const EmitLine& emit) {
    GateProcess opened(task, bench.scene, bench.tree.library.shaders, bench.options, emit);
    BenchFrames frames(opened, bench);
    work(opened, frames, emit);
  });
  if (!child.failure.empty()) throw Error(ErrorKind::failed, "gate", backend, child.failure);
  return child.lines;
}

// The passes of the baseline with fragment shaders, the longest on the first backend first.
std::vector<std::string> passes_by_length(Bench& bench) {
  const auto lines = run_process(bench, bench.options.compare.backends.front(), 0,
                                 [&](GateProcess& process, BenchFrames& frames, const EmitLine& emit) {
                                   std::vector<TimedFrames> all;
                                   all.push_back(frames.equal(bench.effect.baseline()));
                                   std::mt19937_64 random = random_of(process);
                                   time_rounds(process, all, random, [] { return true; });
                                   emit(to_json(all.front().row(process)));
                                 });
  std::vector<std::pair<double, std::string>> passes;
  for (const PairedPass& pass : pairs_from_json(lines.front()).passes)
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

// How much slower the pass is in each of the slower trees, over all backends: 0.25 is 25%.
std::vector<double> costs_of_slower(Bench& bench, const std::string& pass) {
  std::vector<std::vector<double>> ratios(bench.slower.size());
  for (const std::string& backend : bench.options.compare.backends) {
    const auto lines = run_process(bench, backend, 0, [&](GateProcess& process, BenchFrames& frames, const EmitLine& emit) {
      std::vector<TimedFrames> all;
      for (size_t dose = 0; dose < bench.slower.size(); ++dose) all.push_back(frames.slower(dose));
      std::mt19937_64 random = random_of(process);
      time_rounds(process, all, random, [] { return true; });
      for (const TimedFrames& timed : all) emit(to_json(timed.row(process)));
    });
    for (size_t dose = 0; dose < bench.slower.size(); ++dose) {
      const PairsRow row = pairs_from_json(lines.at(dose));
      for (size_t i = 0; i < row.passes.size(); ++i)
        if (row.passes[i].name == pass)
          ratios[dose].push_back(median(ratios_of(row, frame_after, static_cast<std::ptrdiff_t>(i))));
    }
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
  if (costs[0] / tried_taps[0] > most_dear_tap) return {};
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

// The seconds that a process has for rounds in a gate within the budget, by one real gate on a variant that changed.
double round_seconds(Bench& bench) {
  const Stopwatch watch;
  TreePair trees = pair_trees(bench.scene, load_library(home_folder()), load_library(bench.slower_home(0)), bench.options);
  const GateMeasurements measured = measure_trees(trees, bench.options, {}, watch);
  if (!measured.failures.empty()) throw Error(ErrorKind::failed, "gate", "calibration", measured.failures.front().sentence);
  const double processes = static_cast<double>(bench.options.processes * bench.options.compare.backends.size());
  const double beside = watch.elapsed_s() - measured.rounds_s;
  const double seconds = std::max(0.0, bench.options.budget_s - beside) / processes;
  fmt::print("a gate on one variant takes {:.1f} s beside its rounds, so each of its {} processes has {:.1f} s for them\n",
             beside, processes, seconds);
  std::fflush(stdout);
  return seconds;
}

// Wilson's interval of a share (E. B. Wilson, "Probable inference, the law of succession, and statistical inference", Journal
// of the American Statistical Association 22, 1927), 95%.
std::pair<double, double> share_interval(size_t hits, size_t of) {
  constexpr double z = 1.959964;
  const double n = static_cast<double>(of), p = static_cast<double>(hits) / n, scale = 1 / (1 + z * z / n);
  const double center = (p + z * z / (2 * n)) * scale;
  const double half = z * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n)) * scale;
  return {std::max(0.0, center - half), std::min(1.0, center + half)};
}

// How gates over one kind of trees ended.
struct Tally {
  double slow_down = 0;  // 0: equal trees
  size_t gates = 0, failed = 0, faster = 0, ambiguous = 0, passed = 0;
  std::vector<double> ratios;

  void add(const std::vector<PairsRow>& pairs, double family_error, const std::string& pass) {
    const TimeReport report = judge_pairs(pairs, {}, family_error);
    const GateOutcome outcome = outcome_of(report.rows);
    ++gates;
    if (outcome.status == 1)
      ++failed;
    else if (outcome.status == 3)
      ++ambiguous;
    else
      ++(outcome.verdict == Verdict::faster ? faster : passed);
    for (const VerdictRow& row : report.rows)
      if (row.pass == pass) ratios.push_back(row.ratio->median);
  }
};

std::string table(const std::vector<Tally>& tallies) {
  std::string text =
      "| slow-down of one pass | gates | found slower (95% interval) | ambiguous | the same | ratio measured |\n"
      "|---|---:|---:|---:|---:|---:|\n";
  for (const Tally& tally : tallies) {
    if (tally.gates == 0) continue;
    const size_t found = tally.slow_down == 0 ? tally.failed + tally.faster : tally.failed;
    const auto [low, high] = share_interval(found, tally.gates);
    const double gates = static_cast<double>(tally.gates);
    text += fmt::format("| {} | {} | {:.1f}% ({:.1f} to {:.1f}) | {:.1f}% | {:.1f}% | {:.4f} |\n",
                        tally.slow_down == 0 ? "none: false alarms" : fmt::format("{:.0f}%", tally.slow_down * 100),
                        tally.gates, 100 * static_cast<double>(found) / gates, low * 100, high * 100,
                        100 * static_cast<double>(tally.ambiguous) / gates, 100 * static_cast<double>(tally.passed) / gates,
                        mean(tally.ratios));
  }
  return text;
}

// Times `gates` gates over equal trees, and their share of those with a slower pass, in processes of one set.
void run_set(Bench& bench, size_t set, size_t gates, size_t slower_gates, double round_s, const std::string& pass,
             std::vector<Tally>& tallies) {
  std::vector<std::vector<std::vector<PairsRow>>> rows(tallies.size());  // [kind][gate]
  rows[0].resize(gates);
  for (size_t kind = 1; kind < tallies.size(); ++kind) rows[kind].resize(slower_gates);
  const auto work = [&](GateProcess& process, BenchFrames& frames, const EmitLine& emit) {
    std::vector<std::vector<TimedFrames>> kinds(tallies.size());
    for (const VariantManifest& variant : bench.effect.variants) kinds[0].push_back(frames.equal(variant));
    for (size_t kind = 1; kind < kinds.size(); ++kind) kinds[kind].push_back(frames.slower(kind - 1));
    std::mt19937_64 random = random_of(process);
    for (size_t gate = 0; gate < std::max(gates, slower_gates); ++gate)
      for (size_t kind = 0; kind < kinds.size(); ++kind) {
        // Spread evenly over the set, so that a change of the machine's mood meets all kinds alike.
        const size_t of_kind = rows[kind].size(), most = std::max(gates, slower_gates);
        if ((gate + 1) * of_kind / most == gate * of_kind / most) continue;
        const Stopwatch watch;
        const auto measured = [&] {
          std::vector<PairsRow> all;
          for (const TimedFrames& timed : kinds[kind]) all.push_back(timed.row(process));
          return all;
        };
        time_rounds(process, kinds[kind], random,
                    [&] { return watch.elapsed_s() >= round_s || precise_enough(measured(), {}); });
        for (const PairsRow& row : measured()) emit({{"kind", kind}, {"gate", gate * of_kind / most}, {"pairs", to_json(row)}});
      }
  };
  for (size_t process = 0; process < bench.options.processes; ++process)
    for (const std::string& backend : bench.options.compare.backends)
      for (const nlohmann::json& line : run_process(bench, backend, set * bench.options.processes + process, work))
        rows[line.at("kind")][line.at("gate")].push_back(pairs_from_json(line.at("pairs")));
  for (size_t kind = 0; kind < rows.size(); ++kind)
    for (const std::vector<PairsRow>& gate : rows[kind]) tallies[kind].add(gate, bench.options.family_error, pass);
}

}  // namespace

int run_calibration(const GateOptions& options) {
  const Scene scene = load_scene_for(options.compare.scene);
  const std::vector<DeviceInfo> devices = probe_devices(options);
  make_run_folder("gate", options.compare.out);
  Bench bench(options, scene);
  std::string pass;
  std::vector<uint32_t> taps;
  for (const std::string& candidate : passes_by_length(bench))
    if (taps.empty()) pass = candidate, taps = find_taps(bench, pass);
  if (taps.empty())
    throw Error(ErrorKind::failed, "gate", bench.effect.baseline().name,
                "extra taps make none of its passes slower by a known share; calibrate at a larger --size");
  bench.make_slower(pass, taps);
  const double round_s = round_seconds(bench);

  std::string where;
  for (const DeviceInfo& device : devices)
    where += fmt::format("{}{}: {}, {}", where.empty() ? "" : "; ", device.backend, device.device, device.driver);
  const std::string head = fmt::format(
      "Command: {}\nMachine: {}, {} threads; {}\nMargin {:.1f}%, pass {} of {}, {}x{}, {} processes on each backend, {:.1f} s "
      "of "
      "rounds in each\n\n",
      options.compare.command, cpu_model(), std::thread::hardware_concurrency(), where, Limits().max_slowdown * 100, pass,
      bench.effect.baseline().name, options.compare.width_px, options.compare.height_px, options.processes, round_s);
  std::vector<Tally> tallies(1 + slow_downs.size());
  for (size_t i = 0; i < slow_downs.size(); ++i) tallies[i + 1].slow_down = slow_downs[i];
  const size_t gates = std::max(options.equal_gates, options.slower_gates), sets = (gates + gates_a_set - 1) / gates_a_set;
  Progress progress("calibrating");
  for (size_t set = 0; set < sets; ++set) {
    progress.show(static_cast<double>(set) / static_cast<double>(sets), "");
    const auto share = [&](size_t all) { return (set + 1) * all / sets - set * all / sets; };
    run_set(bench, set, share(options.equal_gates), share(options.slower_gates), round_s, pass, tallies);
    write_file_atomically(options.compare.out / "calibration.md", head + table(tallies));
  }
  fmt::print("{}{}", head, table(tallies));
  return 0;
}

}  // namespace lamina
