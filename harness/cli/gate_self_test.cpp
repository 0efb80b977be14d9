// SPDX-License-Identifier: Apache-2.0
// lamina gate SCENE --self-test: each fault that the gate claims to catch is put into the baseline of an effect of the user's
// own scene, in memory, and a gate runs over the tree with and without it. Counts and pictures decide; faults of the timer go
// to its certificate.
#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "harness/cli/gate.h"
#include "harness/gate/faults.h"
#include "harness/gate/verdict.h"
#include "harness/measure/timer_certificate.h"
#include "reports/gate/sentences.h"

namespace lamina {
namespace {

struct Caught {
  std::string fault, title, result, reason;
};

// The last pass of the effect's baseline that draws into the frame.
PassManifest* drawing_pass(VariantManifest& variant) {
  const auto found = std::find_if(variant.passes.rbegin(), variant.passes.rend(), [](const PassManifest& pass) {
    return !pass.fragment.empty() && pass.when == Frequency::frame && std::ranges::count(pass.writes, "frame") > 0;
  });
  return found == variant.passes.rend() ? nullptr : &*found;
}

VariantManifest& baseline_in(Library& library, const std::string& effect) {
  const auto found = std::ranges::find(library.effects, effect, &EffectManifest::name);
  return found->variants.front();
}

// The fragment shader of the effect's pass, as the scene compiles it.
std::shared_ptr<const CompiledShader> compiled_in(Tree& tree, const VariantManifest& variant, const std::string& pass) {
  const Graph graph = make_graph(tree.plan, configuration_with(tree.plan, variant), *tree.scene, tree.shaders.begin()->second);
  for (const GraphPass& each : graph.passes)
    if (each.variant->name == variant.name && each.variant->effect == variant.effect && each.pass->name == pass)
      for (const GraphDraw& draw : each.draws)
        for (const auto& stage : draw.stages)
          if (stage->stage == Stage::fragment) return stage;
  return nullptr;
}

// The gate's answer to `library` with the change, against the library as it is.
struct Answer {
  std::vector<VerdictRow> rows;
  bool same_code = false, same_pictures = false;
};
Answer answer_to(const GateOptions& options, Library library, const ShaderCache::Change& change) {
  TreePair trees = pair_trees(load_library_for(options.compare.scene), std::move(library), options, change);
  const GateMeasurements measured = measure_trees(trees, options, {}, Stopwatch());
  const auto hash = [](const CellRow& cell) { return std::tie(cell.backend, cell.view, cell.image_hash); };
  return {judge_trees(trees, measured, options, {}).rows, std::ranges::all_of(trees.variants, &VariantPair::same_code),
          std::ranges::equal(measured.cells_before, measured.cells_after, {}, hash, hash)};
}

Caught try_fault(const GateOptions& options, const std::string& effect, const Fault& fault, bool compares_alpha) {
  Caught caught{fault.name, fault.title, "", ""};
  Library library = load_library_for(options.compare.scene);
  Tree tree = load_tree(library, options.compare);
  VariantManifest& variant = baseline_in(library, effect);
  PassManifest* pass = drawing_pass(variant);
  const auto compiled = pass ? compiled_in(tree, tree.library.effect(effect).baseline(), pass->name) : nullptr;
  ShaderCache::Change change;
  caught.reason = compiled ? fault.put({variant, *pass, *compiled, options.compare.out / "faults", change})
                           : "its baseline has no pass that draws into the frame in this scene";
  if (caught.reason.empty() && fault.of == Fault::Of::alpha && !compares_alpha)
    caught.reason = "no later pass reads the frame's alpha, and --alpha was not given: it is the same picture";
  Answer answer;
  if (caught.reason.empty()) {
    answer = answer_to(options, std::move(library), change);
    if (answer.same_code)
      caught.reason = "it executes the same here";
    else if (fault.of == Fault::Of::picture && answer.same_pictures)
      caught.reason = "it changes no bit of a picture here";
  }
  if (!caught.reason.empty()) {
    caught.result = "not there";
    return caught;
  }
  const bool failed = outcome_of(answer.rows).verdict == Verdict::failed;
  caught.result = failed ? "caught" : "MISSED";
  for (const VerdictRow& row : answer.rows)
    if (failed && caught.reason.empty() && (row.verdict == Verdict::failed || row.verdict == Verdict::worse))
      caught.reason = sentence_of(row);
  return caught;
}

// A timer that gives 0 for every pass, and one that gives every pass the same time.
std::vector<Caught> try_timers() {
  std::vector<Caught> all;
  const auto lies = [&](const char* name, const char* title, double ms) {
    std::vector<double> round;
    for (const int passes : timer_passes) round.push_back(ms * passes);
    const TimerRow row = judge_timer(std::vector(9, round), std::vector<double>(9, 100.0));
    all.push_back({name, title, row.ok ? "MISSED" : "caught", row.reason});
  };
  lies("times_zero", "the timer says 0 ms of every pass", 0);
  lies("times_equal", "the timer says the same of every pass", 100.0 / 9);
  return all;
}

void print(const std::vector<Caught>& all) {
  for (const Caught& each : all)
    fmt::print("{:<10} {:<16} {}{}{}\n", each.result, each.fault, each.title, each.reason.empty() ? "" : ": ", each.reason);
  std::fflush(stdout);
}

}  // namespace

int run_self_test(GateOptions options) {
  const std::vector<DeviceInfo> devices = probe_devices(options);
  options.side_by_side = can_run_side_by_side(devices);
  options.times = false;
  make_folder("gate", options.compare.out / "faults");  // the shaders that are written can be read there
  const Library library = load_library_for(options.compare.scene);
  const Scene scene = load_scene_for(options.compare.scene, library);
  const Plan plan = plan_for(options.compare.scene, library, scene, options.compare.aspect());
  const StopSignals signals("\nlamina: stopping\n");
  size_t missed = 0;
  for (const EffectManifest* effect : compared_effects(plan)) {
    options.compare.variants = {effect->baseline().name};
    fmt::print("{}, {} of {}:\n", scene.name, effect->baseline().name, effect->name);
    const bool passes = outcome_of(answer_to(options, library, {}).rows).verdict == Verdict::same;
    print({{"nothing", "the same tree", passes ? "passes" : "MISSED", passes ? "" : "an equal tree fails the gate"}});
    missed += passes ? 0 : 1;
    for (const Fault& fault : gate_faults()) {
      if (StopSignals::stopped_by() != 0) return 128 + StopSignals::stopped_by();
      const Caught caught = try_fault(options, effect->name, fault, options.compare.alpha || reads_frame_after(plan, *effect));
      print({caught});
      missed += caught.result == "MISSED" ? 1 : 0;
    }
  }
  const std::vector<Caught> timers = try_timers();
  fmt::print("the timer's certificate:\n");
  print(timers);
  missed += static_cast<size_t>(std::ranges::count(timers, "MISSED", &Caught::result));
  fmt::print("\n{}\n", missed == 0 ? "every fault that is there was caught"
                                   : fmt::format("{} MISSED: the gate does not see everything that it claims to", missed));
  return missed == 0 ? 0 : 1;
}

}  // namespace lamina
