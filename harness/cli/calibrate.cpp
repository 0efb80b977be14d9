// SPDX-License-Identifier: Apache-2.0
// lamina gate --calibrate: the gate's own error rates on this machine. Many gates over equal trees, each of which should find
// nothing, and over trees in which one pass is slower by a known share.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <thread>

#include "harness/cli/gate.h"
#include "harness/cli/run_line.h"
#include "harness/core/text.h"
#include "harness/gate/slowdown.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::array<double, 5> slow_downs = {0.01, 0.02, 0.03, 0.05, 0.10};
constexpr uint32_t first_taps = 8, most_taps = 1024;
constexpr double full_dose_wanted = 0.25;  // extra taps in every block make the pass slower by at least this

struct Trial {
  TimeReport report;
  GateOutcome outcome;
  double seconds = 0;
};

// One gate on times alone.
Trial run_gate_on(const Scene& scene, const fs::path& before, const fs::path& after, GateOptions options, uint64_t seed) {
  const Clock::time_point start = Clock::now();
  const auto elapsed_s = [start] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  options.compare.seed = seed;
  options.against = before;
  TreePair trees = pair_trees(scene, load_library(before), load_library(after), options);
  const GateMeasurements measured = measure_trees(trees, options, {}, elapsed_s);
  if (!measured.failures.empty()) throw Error(ErrorKind::failed, "gate", "calibration", measured.failures.front().sentence);
  Trial trial{judge_pairs(measured.pairs, {}, options.family_error), {}, 0};
  trial.outcome = outcome_of(trial.report.rows);
  trial.seconds = elapsed_s();
  return trial;
}

const VariantManifest& baseline_of(const Library& library, const Scene& scene) {
  const Plan plan = make_plan(library, scene);
  for (const EffectPlan& entry : plan.effects)
    if (entry.called_for && entry.effect->variants.size() > 1) return library.effect(entry.effect->name).baseline();
  throw Error(ErrorKind::bad_input, "gate", scene.source,
              "calls for no effect with several variants; calibrate on another scene");
}

// The ratios of a pass over all backends of one trial.
std::vector<double> ratios_in(const Trial& trial, const std::string& variant, const std::string& pass) {
  std::vector<double> ratios;
  for (const VerdictRow& row : trial.report.rows)
    if (row.variant == variant && row.pass == pass) ratios.push_back(row.ratio->median);
  return ratios;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? std::nan("") : sum / static_cast<double>(values.size());
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
  size_t gates = 0, failed = 0, ambiguous = 0, passed = 0;
  std::vector<double> ratios, seconds;

  void add(const Trial& trial, const std::string& variant, const std::string& pass) {
    ++gates;
    ++(trial.outcome.status == 1 ? failed : trial.outcome.status == 3 ? ambiguous : passed);
    for (const double ratio : ratios_in(trial, variant, pass)) ratios.push_back(ratio);
    seconds.push_back(trial.seconds);
    faster += trial.outcome.verdict == Verdict::faster;
  }
  size_t faster = 0;
};

std::string table(const std::vector<Tally>& tallies) {
  std::string text =
      "| slow-down of one pass | gates | found slower (95% interval) | ambiguous | the same | ratio measured | seconds a gate "
      "|\n"
      "|---|---:|---:|---:|---:|---:|---:|\n";
  for (const Tally& tally : tallies) {
    if (tally.gates == 0) continue;
    const size_t found = tally.slow_down == 0 ? tally.failed + tally.faster : tally.failed;
    const auto [low, high] = share_interval(found, tally.gates);
    const double gates = static_cast<double>(tally.gates);
    text += fmt::format("| {} | {} | {:.1f}% ({:.1f} to {:.1f}) | {:.1f}% | {:.1f}% | {:.4f} | {:.1f} |\n",
                        tally.slow_down == 0 ? "none: false alarms" : fmt::format("{:.0f}%", tally.slow_down * 100),
                        tally.gates, 100 * static_cast<double>(found) / gates, low * 100, high * 100,
                        100 * static_cast<double>(tally.ambiguous) / gates,
                        100 * static_cast<double>(tally.passed - (tally.slow_down == 0 ? tally.faster : 0)) / gates,
                        mean(tally.ratios), mean(tally.seconds));
  }
  return text;
}

}  // namespace

int run_calibration(const GateOptions& given) {
  GateOptions options = given;
  options.exact = options.certify = false;
  const Scene scene = load_scene_for(options.compare.scene);
  const Library library = load_library(home_folder());
  const VariantManifest& variant = baseline_of(library, scene);
  const std::vector<DeviceInfo> devices = probe_devices(options);
  make_run_folder("gate", options.compare.out);
  const fs::path folder = options.compare.out / "slower-tree";
  const auto report = [&](const std::string& text) { fmt::print("{}", text), std::fflush(stdout); };

  GateOptions equal = options;
  equal.time_unchanged = true;
  const Trial first = run_gate_on(scene, home_folder(), home_folder(), equal, options.compare.seed);
  std::string pass;
  double most_ms = 0;
  for (const VerdictRow& row : first.report.rows)
    if (row.variant == variant.name && *row.before > most_ms && (!row.pass.empty())) most_ms = *row.before, pass = row.pass;
  if (pass.empty())
    throw Error(ErrorKind::failed, "gate", variant.name, "none of its passes takes enough of the frame to be judged");

  ExtraTaps full{first_taps, 1024};
  double dose = 0;
  for (;; full.taps *= 2) {
    write_slower_tree(home_folder(), folder, variant, pass, full);
    dose = mean(ratios_in(run_gate_on(scene, home_folder(), folder, options, options.compare.seed), variant.name, pass)) - 1;
    report(fmt::format("{} extra taps in every pixel make pass {} of {} {:+.1f}% slower\n", full.taps, pass, variant.name,
                       dose * 100));
    if (dose >= full_dose_wanted) break;
    if (full.taps >= most_taps) throw Error(ErrorKind::failed, "gate", pass, "extra taps do not make it slower");
  }

  std::vector<Tally> tallies(1 + slow_downs.size());
  for (size_t i = 0; i < slow_downs.size(); ++i) tallies[i + 1].slow_down = slow_downs[i];
  const size_t rounds = std::max(options.equal_gates, options.slower_gates);
  Progress progress("calibrating");
  for (size_t round = 0; round < rounds; ++round) {
    progress.show(static_cast<double>(round) / static_cast<double>(rounds), "");
    const uint64_t seed = options.compare.seed + 1000003 * (round + 1);
    // Spread evenly, so that a change of the machine's mood meets all kinds alike.
    const auto is_due = [&](size_t gates) { return (round + 1) * gates / rounds > round * gates / rounds; };
    if (is_due(options.equal_gates))
      tallies[0].add(run_gate_on(scene, home_folder(), home_folder(), equal, seed), variant.name, pass);
    for (size_t i = 0; i < slow_downs.size() && is_due(options.slower_gates); ++i) {
      const double share = slow_downs[i] / dose;
      write_slower_tree(home_folder(), folder, variant, pass, {full.taps, static_cast<uint32_t>(std::lround(1024 * share))});
      tallies[i + 1].add(run_gate_on(scene, home_folder(), folder, options, seed), variant.name, pass);
    }
    write_file_atomically(options.compare.out / "calibration.md", table(tallies));
  }
  fs::remove_all(folder);
  std::string where;
  for (const DeviceInfo& device : devices)
    where += fmt::format("{}{}: {}, {}", where.empty() ? "" : "; ", device.backend, device.device, device.driver);
  const std::string text =
      fmt::format("Command: {}\nMachine: {}, {} threads; {}\nMargin {:.1f}%, pass {} of {}, {}x{}\n\n{}",
                  options.compare.command, cpu_model(), std::thread::hardware_concurrency(), where, Limits().max_slowdown * 100,
                  pass, variant.name, options.compare.width_px, options.compare.height_px, table(tallies));
  write_file_atomically(options.compare.out / "calibration.md", text);
  report(text);
  return 0;
}

}  // namespace lamina
