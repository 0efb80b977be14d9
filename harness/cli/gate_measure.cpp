// SPDX-License-Identifier: Apache-2.0
// The measuring of a gate, in a process of its own: certificate, counts and errors of both trees, then paired rounds.
#include <algorithm>
#include <chrono>
#include <set>

#include "harness/cli/backend_run.h"
#include "harness/cli/gate.h"
#include "harness/measure/timer_certificate.h"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t least_rounds = 2 * rounds_a_frame;
// A process stops when its own interval of every ratio is this share of the margin: pooled over processes, and at the higher
// confidence of many comparisons, it then is about half of it.
constexpr double enough_of_margin = 0.6;

class Stopwatch {
 public:
  double elapsed_s() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Every pair of one effect whose code changed; its baselines are always compared.
void compare_exactly(Backend& backend, TreePair& trees, SceneResources& resources, Bakes& bakes, const GateTask& task,
                     const GateOptions& options, const EmitLine& emit) {
  std::set<std::string> effects;
  for (const VariantPair& pair : trees.variants)
    if (pair.before && pair.after && !pair.same_code) effects.insert(pair.after->effect);
  Progress progress(task.backend + ", counts and pictures");
  for (const std::string& effect : effects) {
    CompareOptions only = options.compare;
    only.variants.clear();
    for (const VariantPair& pair : trees.variants)
      if (pair.after && pair.after->effect == effect && (!pair.same_code || !pair.before) && pair.failure.empty())
        only.variants.push_back(pair.after->name);
    if (only.variants.empty()) continue;
    const auto run_tree = [&](Tree& tree, const char* side) {
      const std::filesystem::path images = options.compare.out / "images" / side;
      std::filesystem::create_directories(images);
      auto run =
          std::make_unique<BackendRun>(backend, resources, tree.plan, tree.library.effect(effect),
                                       const_cast<ShaderCache&>(tree.shaders.at(backend.info().api)), bakes, only, images);
      run->prepare(progress), run->count(progress), run->score(progress);
      for (const CellRow& row : run->rows()) emit({{"cell", to_json(row)}, {"side", side}});
      return run;
    };
    const auto before = run_tree(trees.before, "before");
    const auto after = run_tree(trees.after, "after");
    for (const VariantPair& pair : trees.variants) {
      if (!pair.after || pair.after->effect != effect) continue;
      for (size_t view = 0; view < trees.scene.views.size(); ++view) {
        const std::optional<Image> now = after->picture(pair.after->name, view);
        const std::optional<Image> was = before->picture(pair.after->name, view);
        if (!now) continue;
        const PictureFacts facts = picture_facts(*now, was ? &*was : nullptr);
        emit({{"facts",
               {{"variant", pair.after->name},
                {"view", trees.scene.views[view].name},
                {"range", facts.range},
                {"most_change", facts.most_change ? Json(*facts.most_change) : Json(nullptr)}}}});
      }
    }
  }
}

// A variant's frames, and the passes that pair them.
struct Timed {
  const VariantPair* pair = nullptr;
  std::vector<std::string> names;
  std::vector<std::unique_ptr<Graph>> graphs;
  std::vector<std::unique_ptr<Frame>> frames;
  std::unique_ptr<PairedFrames> paired;
};

Timed prepare(Backend& backend, TreePair& trees, SceneResources& resources, const VariantPair& pair, bool changed) {
  Timed timed;
  timed.pair = &pair;
  const auto add = [&](Tree& tree, const VariantManifest& variant, std::string_view name) {
    const Plan& plan = tree.plan;
    timed.graphs.push_back(std::make_unique<Graph>(make_graph(plan, configuration_with(plan, variant), trees.scene,
                                                              const_cast<ShaderCache&>(tree.shaders.at(backend.info().api)))));
    timed.frames.push_back(std::make_unique<Frame>(resources, *timed.graphs.back(), Build::timed));
    timed.frames.back()->run_once(Timing::off);
    timed.frames.back()->run(0, Timing::off);
    timed.names.emplace_back(name);
  };
  add(trees.before, *pair.before, frame_before);
  if (changed) add(trees.after, *pair.after, frame_after);
  if (pair.before->baseline) add(trees.before, *pair.before, frame_again);
  std::vector<Frame*> frames;
  for (const auto& frame : timed.frames) frames.push_back(frame.get());
  timed.paired = std::make_unique<PairedFrames>(backend, frames, 0);
  return timed;
}

PairsRow row_of(const Timed& timed, const GateTask& task, const Scene& scene) {
  return {task.process, task.backend,          timed.pair->before->effect, timed.pair->before->name, scene.views.front().name,
          timed.names,  timed.paired->passes()};
}

bool precise_enough(const std::vector<Timed>& all, const GateTask& task, const Scene& scene, const LimitsFile& limits) {
  std::vector<PairsRow> rows;
  for (const Timed& timed : all) rows.push_back(row_of(timed, task, scene));
  for (const PairsRow& row : rows) {
    const double margin = limits.of(row.effect, row.variant, row.backend).max_slowdown;
    for (const std::string& frame : row.frames) {
      if (frame == frame_before) continue;
      const std::vector<double> ratios = ratios_of(row, frame, -1);
      const Interval interval = median_interval(ratios);
      if ((interval.high - interval.low) / 2 > enough_of_margin * margin) return false;
    }
  }
  return true;
}

void time_pairs(Backend& backend, TreePair& trees, SceneResources& resources, const GateTask& task, const GateOptions& options,
                const LimitsFile& limits, const Stopwatch& watch, const EmitLine& emit) {
  std::vector<Timed> all;
  for (const VariantPair& pair : trees.variants) {
    if (!pair.before || (!pair.after && !pair.before->baseline)) continue;
    const bool changed = pair.after && pair.failure.empty() && (!pair.same_code || options.time_unchanged);
    if (changed || pair.before->baseline) all.push_back(prepare(backend, trees, resources, pair, changed));
  }
  if (all.empty()) return;
  std::mt19937_64 random(options.compare.seed + 7919 * task.process);  // another order in every process
  const bool changes = std::any_of(all.begin(), all.end(), [](const Timed& timed) { return timed.names[1] == frame_after; });
  size_t rounds = 0;
  while (rounds < least_rounds ||
         (changes && watch.elapsed_s() < task.until_s && !precise_enough(all, task, trees.scene, limits))) {
    std::shuffle(all.begin(), all.end(), random);
    for (const Timed& timed : all) timed.paired->run_round(random);
    ++rounds;
  }
  for (const Timed& timed : all) emit({{"pairs", to_json(row_of(timed, task, trees.scene))}});
}

}  // namespace

void measure_pairs_of_trees(TreePair& trees, const GateTask& task, const GateOptions& options, const LimitsFile& limits,
                            const EmitLine& emit) {
  const Stopwatch watch;
  const std::unique_ptr<Backend> backend = open_backend(task.backend, {options.compare.device, options.compare.validation});
  bool certified = true;
  if (task.certify) {
    const TimerRow timer = certify_timer(*backend, trees.after.library.shaders);
    emit({{"timer", to_json(timer)}});
    certified = timer.ok;
  }
  Bakes bakes(trees.scene, DiskCache(options.compare.cache));
  SceneResources resources(*backend, trees.scene, options.compare.width_px, options.compare.height_px, &bakes);
  if (task.exact) compare_exactly(*backend, trees, resources, bakes, task, options, emit);
  if (options.times && certified) time_pairs(*backend, trees, resources, task, options, limits, watch, emit);
  Json messages = Json::array();
  for (const std::string& message : backend->take_messages()) messages.push_back(message);
  emit({{"messages", messages}, {"elapsed_s", watch.elapsed_s()}});
}

}  // namespace lamina
