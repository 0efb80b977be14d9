// SPDX-License-Identifier: Apache-2.0
// The measuring of a gate over two trees, in a process of its own: counts and errors of both, then paired rounds.
#include <algorithm>
#include <set>

#include "harness/cli/backend_run.h"
#include "harness/cli/gate_process.h"

namespace lamina {
namespace {

// What the tree before has shown, so that a picture that is the same is not scored again.
class Before {
 public:
  void see(const BackendRun::Scored& scored) { seen_[{scored.variant.name, scored.view}] = {scored.picture, scored.covered}; }
  void rows(std::vector<CellRow> rows) { rows_ = std::move(rows); }
  // Null: there was no such picture.
  const Image* picture(const BackendRun::Scored& scored) const {
    const auto was = seen_.find({scored.variant.name, scored.view});
    return was == seen_.end() ? nullptr : &was->second.picture;
  }
  // The row with the errors of this picture of the tree after, if it, the pixels and the baseline are the same to the bit.
  const CellRow* known(const BackendRun::Scored& scored, const std::string& view) {
    const auto was = seen_.find({scored.variant.name, scored.view});
    const bool same =
        was != seen_.end() && was->second.picture.rgba == scored.picture.rgba && was->second.covered.on == scored.covered.on;
    if (scored.variant.baseline) same_baseline_[scored.view] = same;
    if (!same || !same_baseline_[scored.view]) return nullptr;
    const auto row = std::ranges::find_if(
        rows_, [&](const CellRow& each) { return each.variant == scored.variant.name && each.view == view && !each.failed; });
    return row == rows_.end() ? nullptr : &*row;
  }

 private:
  struct Seen {
    Image picture;
    Mask covered;
  };
  std::map<std::pair<std::string, size_t>, Seen> seen_;
  std::map<size_t, bool> same_baseline_;  // by view
  std::vector<CellRow> rows_;
};

// Every variant of one effect that is to be drawn; its baselines always are.
void compare_exactly(GateProcess& process, TreePair& trees, const std::string& effect, const LimitsFile& limits,
                     Progress& progress, const EmitLine& emit) {
  CompareOptions only = process.options.compare;
  only.variants.clear();
  for (const VariantPair& pair : trees.variants)
    if (pair.after && pair.after->effect == effect && is_drawn(pair, limits.of(effect, pair.after->name, process.task.backend)))
      only.variants.push_back(pair.after->name);
  if (only.variants.empty()) return;
  const auto run_tree = [&](Tree& tree, const char* side, const BackendRun::Known& known) {
    const std::string images = fmt::format("images/{}", side);
    std::filesystem::create_directories(only.out / images);
    BackendRun run(*process.backend, process.resources, tree.plan, tree.library.effect(effect),
                   tree.shaders.at(process.backend->info().api), process.bakes, only, images);
    run.prepare(progress), run.count(progress), run.score(progress, known);
    std::vector<CellRow> rows = run.rows();
    for (const CellRow& row : rows) emit({{"cell", to_json(row)}, {"side", side}});
    return rows;
  };
  Before before;
  before.rows(run_tree(trees.before, "before", [&](const BackendRun::Scored& scored) {
    before.see(scored);
    return nullptr;
  }));
  run_tree(trees.after, "after", [&](const BackendRun::Scored& scored) {
    const std::string& view = trees.scene.views[scored.view].name;
    if (const Image* was = before.picture(scored))
      emit({{"change",
             {{"effect", effect},
              {"variant", scored.variant.name},
              {"view", view},
              {"most", most_change(scored.picture, *was)}}}});
    return before.known(scored, view);
  });
}

void time_pairs(GateProcess& process, TreePair& trees, const LimitsFile& limits, const EmitLine& emit) {
  ProcessFrames frames(process);
  std::vector<TimedFrames> all;
  bool changes = false;
  for (const VariantPair& pair : trees.variants) {
    if (!pair.before || (!pair.after && !pair.before->baseline)) continue;
    const bool changed = pair.after && pair.failure.empty() && !pair.same_code;
    if (!changed && !pair.before->baseline) continue;
    TimedFrames& timed = all.emplace_back(TimedFrames{pair.before->effect, pair.before->name, {}, {}, nullptr});
    timed.add(frame_before, frames.get(trees.before, *pair.before));
    if (changed) timed.add(frame_after, frames.get(trees.after, *pair.after), pair.same_passes);
    if (pair.before->baseline) timed.add(frame_again, frames.get(trees.before, *pair.before, 1));
    changes = changes || changed;
  }
  if (all.empty()) return;
  time_rounds(process, all, [&](const TimedFrames& timed, double further_s) {
    return !changes || process.watch.elapsed_s() + further_s > process.task.until_s || precise_enough(timed, process, limits);
  });
  for (const PairsRow& row : rows_of(all, process)) emit({{"pairs", to_json(row)}});
}

}  // namespace

void measure_pairs_of_trees(TreePair& trees, const GateTask& task, const GateOptions& options, const LimitsFile& limits,
                            const EmitLine& emit) {
  GateProcess process(task, trees.scene, trees.after.library.shaders, options, emit);
  if (task.exact) {
    std::set<std::string> effects;
    for (const VariantPair& pair : trees.variants)
      if (pair.after) effects.insert(pair.after->effect);
    Progress progress(task.backend + ", counts and pictures");
    for (const std::string& effect : effects) compare_exactly(process, trees, effect, limits, progress, emit);
  } else if (process.certified) {
    time_pairs(process, trees, limits, emit);
  }
  process.end(emit);
}

}  // namespace lamina
