// SPDX-License-Identifier: Apache-2.0
// The measuring of a gate over two trees, in a process of its own: counts and errors of both, then paired rounds.
#include <algorithm>
#include <set>

#include "harness/cli/effect_run.h"
#include "harness/cli/gate_process.h"
#include "harness/gate/pictures_before.h"

namespace lamina {
namespace {

// What the tree before has made of a variant, where it drew all of it: one that executes the same is not run again.
std::optional<EffectRun::Known> known_from(const std::vector<CellRow>& rows, const PicturesBefore& drawn,
                                           const std::string& variant) {
  EffectRun::Known known;
  for (const CellRow& row : rows) {
    if (row.variant != variant) continue;
    const PicturesBefore::Drawn* was = drawn.of(variant, known.rows.size());
    if (row.failed || !was) return std::nullopt;
    known.rows.push_back(row);
    known.drawn.push_back({was->picture, was->covered});
  }
  if (known.rows.empty()) return std::nullopt;
  return known;
}

// Every variant of one effect that is to be drawn; its baselines always are.
void compare_exactly(GateProcess& process, TreePair& trees, const std::string& effect, const LimitsFile& limits,
                     Progress& progress, const EmitLine& emit) {
  CellOptions only = process.options.compare;
  only.variants.clear();
  for (const VariantPair& pair : trees.variants)
    if (pair.after && pair.after->effect == effect && is_drawn(pair, limits.of(effect, pair.after->name, process.task.backend)))
      only.variants.push_back(pair.after->name);
  if (only.variants.empty()) return;
  const auto run_tree = [&](Tree& tree, const char* side, const EffectRun::Scoring& scoring, const auto& take_known) {
    const std::string images = fmt::format("images/{}", side);
    std::filesystem::create_directories(only.out / images);
    EffectRun run(*process.backend, tree.library.effect(effect), tree.shaders.at(process.backend->info().api), only, images,
                  progress.tell_or_stop());
    const Stopwatch preparing;
    run.start(process.scene_of(tree), {.judged = false});
    take_known(run);
    run.prepare();
    process.ready_s += preparing.elapsed_s();
    run.count(), run.score(scoring);
    std::vector<CellRow> rows = run.rows();
    for (const CellRow& row : rows) emit({{"cell", to_json(row)}, {"side", side}});
    return rows;
  };
  PicturesBefore drawn;
  const bool alpha = only.alpha || reads_frame_after(trees.after.plan, trees.after.library.effect(effect));
  const auto keep = [&](const EffectRun::Scored& scored) -> const CellRow* {
    drawn.add(scored.variant.name, scored.view, scored.picture, scored.covered);
    return nullptr;
  };
  const std::vector<CellRow> rows_before = run_tree(trees.before, "before", {.known = keep}, [](EffectRun&) {});
  const auto compare = [&](const EffectRun::Scored& scored) -> const CellRow* {
    const std::string &variant = scored.variant.name, &view = trees.after.scene->views[scored.view].name;
    if (const PicturesBefore::Drawn* was = drawn.of(variant, scored.view))
      emit({{"change",
             {{"effect", effect},
              {"variant", variant},
              {"view", view},
              {"most", max_change(scored.picture, was->picture, alpha)}}}});
    if (!drawn.same_errors(variant, scored.variant.baseline, scored.view, scored.picture, scored.covered)) return nullptr;
    const auto row = std::ranges::find_if(
        rows_before, [&](const CellRow& each) { return each.variant == variant && each.view == view && !each.failed; });
    return row == rows_before.end() ? nullptr : &*row;
  };
  run_tree(trees.after, "after", {.known = compare}, [&](EffectRun& run) {
    if (trees.before.scene != trees.after.scene) return;
    for (const VariantPair& pair : trees.variants)
      if (pair.same_code && pair.after->effect == effect)
        if (auto known = known_from(rows_before, drawn, pair.after->name)) run.take(pair.after->name, std::move(*known));
  });
}

void time_pairs(GateProcess& process, TreePair& trees, const LimitsFile& limits, const EmitLine& emit) {
  ProcessFrames frames(process);
  std::vector<TimedFrames> all;
  bool changes = false;
  const Stopwatch preparing;
  for (const VariantPair& pair : trees.variants) {
    if (!pair.before || (!pair.after && !pair.before->baseline)) continue;
    const bool changed = pair.after && pair.failure.empty() && !pair.same_code;
    if (!changed && !pair.before->baseline) continue;
    if (!process.task.times(pair.before->effect, pair.before->name)) continue;
    std::vector<ProcessFrames::Wanted> wanted{{frame_before, &trees.before, pair.before}};
    if (changed) wanted.push_back({frame_after, &trees.after, pair.after, 0, pair.same_passes});
    if (pair.before->baseline) wanted.push_back({frame_again, &trees.before, pair.before, 1});
    const double allowed = limits.of(pair.before->effect, pair.before->name, process.task.backend).max_picture_change;
    const bool same_pictures = std::ranges::none_of(process.task.changes, [&](const auto& change) {
      const auto& [backend, effect, variant, view] = change.first;
      return backend == process.task.backend && effect == pair.before->effect && variant == pair.before->name &&
             !(change.second <= allowed);
    });
    all.push_back(frames.timed(wanted, same_pictures));
    changes = changes || changed;
  }
  process.ready_s += preparing.elapsed_s();
  if (all.empty()) return;
  time_rounds(process, all, [&](const TimedFrames& timed, double further_s) {
    return !changes || process.watch.elapsed_s() + further_s > process.task.until_s || precise_enough(timed, process, limits);
  });
  for (const PairsRow& row : rows_of(all, process)) emit({{"pairs", to_json(row)}});
}

}  // namespace

void measure_pairs_of_trees(TreePair& trees, const GateTask& task, const GateOptions& options, const LimitsFile& limits,
                            const EmitLine& emit) {
  GateProcess process(task, trees.after.library.shaders, options);
  process.ready_s = process.watch.elapsed_s();
  if (task.exact) {
    std::set<std::string> effects;
    for (const VariantPair& pair : trees.variants)
      if (pair.after) effects.insert(pair.after->effect);
    Progress progress(task.backend + ", counts and pictures");
    try {
      for (const std::string& effect : effects) compare_exactly(process, trees, effect, limits, progress, emit);
    } catch (const StopRequested&) {  // the effects before it are handed over
    }
  } else if (process.may_time()) {
    time_pairs(process, trees, limits, emit);
  }
  process.end(emit);
}

}  // namespace lamina
