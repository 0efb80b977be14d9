// SPDX-License-Identifier: Apache-2.0
// Two trees of variants and shaders: paired, measured by processes, judged.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "harness/cli/common.h"
#include "harness/cli/gate_process.h"
#include "harness/core/text.h"
#include "harness/gate/identity.h"
#include "harness/gate/verdict.h"

namespace lamina {
namespace {

std::map<Api, Identity> identities(Tree& tree, const VariantManifest& variant, CodeHashes& hashes) {
  const Scene& scene = *tree.scene;
  std::map<Api, Identity> all;
  const Configuration configuration = configuration_with(tree.plan, variant);
  for (auto& [api, shaders] : tree.shaders) {
    std::optional<Graph> truth;
    if (has_truth_passes(variant)) truth = make_graph(tree.plan, configuration, scene, shaders, &variant);
    all[api] =
        identity_of(variant, make_graph(tree.plan, configuration, scene, shaders), truth ? &*truth : nullptr, api, hashes);
  }
  return all;
}

// Whether the code is the same; compiles the shaders, so that every process finds them compiled.
void look_at_code(VariantPair& pair, Tree& before, Tree& after, CodeHashes& hashes) {
  std::map<Api, Identity> was, now;
  try {
    if (pair.before) was = identities(before, *pair.before, hashes);
  } catch (const Error&) {  // its cells say so
  }
  try {
    if (pair.after) now = identities(after, *pair.after, hashes);
  } catch (const Error& error) {
    pair.failure = error.what();
  }
  if (was.empty() || now.empty()) return;
  const auto same = [&](auto&& part) {
    return std::ranges::all_of(was, [&](const auto& entry) { return part(entry.second) == part(now.at(entry.first)); });
  };
  pair.same_code = same([](const Identity& identity) { return std::pair(identity.whole, identity.frame_passes); });
  pair.same_errors = pair.same_code && same([](const Identity& identity) { return identity.truth; });
  pair.same_passes = std::numeric_limits<size_t>::max();
  for (const auto& [api, identity] : was) pair.same_passes = std::min(pair.same_passes, same_passes(identity, now.at(api)));
}

}  // namespace

Tree load_tree(Library library, const CellOptions& options, const Tree* known) {
  const auto owner = std::make_shared<const Library>(std::move(library));
  const bool same = known && known->library.declarations() == owner->declarations();
  Tree tree{owner, *owner, same ? known->scene : std::make_shared<const Scene>(load_scene_for(options.scene, *owner)), {}, {}};
  for (const std::string& backend : options.backends) {
    const Api api = backend == "vulkan" ? Api::vulkan : Api::opengl;
    tree.shaders.try_emplace(api, api, tree.library.shaders);
  }
  tree.plan = plan_for(options.scene, tree.library, *tree.scene, options.aspect());
  return tree;
}

bool GateTask::times(const std::string& effect, const std::string& variant) const {
  return only.contains({backend, effect, variant}) ||
         std::ranges::none_of(only, [&](const TimedCell& cell) { return cell[0] == backend; });
}

const TimerRow* GateMeasurements::timer(const std::string& backend) const {
  const auto found = std::ranges::find(timers, backend, &TimerRow::backend);
  return found == timers.end() ? nullptr : &*found;
}

bool GateMeasurements::certified(const std::string& backend) const {
  const TimerRow* of_backend = timer(backend);
  return of_backend && of_backend->ok;
}

void take_lines(const ChildResult& child, const GateTask& task, GateMeasurements& measured) {
  for (const nlohmann::json& line : child.lines) {
    if (line.contains("timer")) {  // it takes the place of an earlier process's, with which it went on
      std::erase_if(measured.timers, [&](const TimerRow& timer) { return timer.backend == task.backend; });
      measured.timers.push_back(row_of<TimerRow>(line["timer"], task.backend));
      measured.certified_so_far.erase(task.backend);
    }
    if (line.contains("certified")) {
      const nlohmann::json& there = line["certified"];
      measured.certified_so_far[task.backend] = {there.at("effort").get<size_t>(),
                                                 there.at("times_ms").get<std::vector<std::vector<double>>>(),
                                                 there.at("wall_ms").get<std::vector<double>>()};
    }
    if (line.contains("cell"))
      (line.value("side", "after") == "before" ? measured.cells_before : measured.cells_after)
          .push_back(row_of<CellRow>(line["cell"], task.backend));
    if (line.contains("pairs")) measured.pairs.push_back(row_of<PairsRow>(line["pairs"], task.backend));
    if (line.contains("change")) {
      const nlohmann::json& of = line["change"];
      measured.changes[{task.backend, of.at("effect"), of.at("variant"), of.at("view")}] = of.at("most");
    }
    if (!line.contains("messages")) continue;
    measured.spent.rounds += line["rounds_s"].get<double>();
    measured.spent.certifying += line["certifying_s"].get<double>();
    measured.ready_s = std::max(measured.ready_s, line["ready_s"].get<double>());
    for (const nlohmann::json& message : line["messages"]) {
      VerdictRow& row = measured.failures.emplace_back();
      row.backend = task.backend, row.what = "api", row.verdict = Verdict::failed;
      row.cause = Cause::api_message, row.details = {message.get<std::string>()};
    }
  }
  if (child.failure.empty()) return;
  VerdictRow& row = measured.failures.emplace_back();
  row.backend = task.backend, row.what = "cell", row.verdict = Verdict::failed;
  row.cause = Cause::process_failed, row.details = {child.failure};
}

VerdictRow judge_timer(const TimerRow& timer) {
  VerdictRow row;
  row.backend = timer.backend, row.what = "timer";
  row.verdict = timer.ok ? Verdict::same : Verdict::ambiguous;
  row.cause = timer.ok ? Cause::certificate_holds : Cause::certificate_failed;
  if (!timer.ok) row.details = {timer.reason};
  return row;
}

TreePair pair_trees(Library library_before, Library library_after, const GateOptions& options,
                    const ShaderCache::Change& change) {
  Tree present = load_tree(std::move(library_after), options.compare);
  for (auto& [api, shaders] : present.shaders) shaders.set_change(change);
  Tree earlier = load_tree(std::move(library_before), options.compare, &present);
  TreePair trees{std::move(earlier), std::move(present), {}};
  CodeHashes hashes;
  std::vector<std::string> effects, all;
  for (const Plan* plan : {&trees.before.plan, &trees.after.plan})
    for (const EffectPlan& entry : plan->effects)
      if (entry.called_for && std::find(effects.begin(), effects.end(), entry.effect->name) == effects.end())
        effects.push_back(entry.effect->name);
  for (const std::string& effect : effects) {
    const auto called_for = [&](const Plan& plan) {
      const EffectPlan* entry = plan.of(effect);
      return entry && entry->called_for ? entry->effect : nullptr;
    };
    const EffectManifest *before = called_for(trees.before.plan), *after = called_for(trees.after.plan);
    std::vector<std::string> names;
    for (const EffectManifest* side : {before, after})
      if (side)
        for (const VariantManifest& variant : side->variants)
          if (std::find(names.begin(), names.end(), variant.name) == names.end()) names.push_back(variant.name);
    all.insert(all.end(), names.begin(), names.end());
    std::vector<VariantPair> pairs;
    for (const std::string& name : names) {
      VariantPair pair{.effect_before = before, .effect_after = after};
      if (before) pair.before = before->variant(name);
      if (after) pair.after = after->variant(name);
      if (!is_compared(pair.before ? *pair.before : *pair.after, options.compare)) continue;
      look_at_code(pair, trees.before, trees.after, hashes);
      pairs.push_back(std::move(pair));
    }
    // Errors are against a baseline, and against a truth, for which some variants draw what the pixels show.
    const auto is_reference = [](const VariantManifest* variant) {
      return variant && (variant->baseline || has_truth_passes(*variant));
    };
    const bool same_references = std::ranges::all_of(pairs, [&](const VariantPair& pair) {
      return pair.same_errors || !(is_reference(pair.before) || is_reference(pair.after));
    });
    for (VariantPair& pair : pairs) {
      pair.same_errors = pair.same_errors && same_references;
      trees.variants.push_back(std::move(pair));
    }
  }
  check_variant_names("gate", options.compare.variants, all);
  if (std::none_of(trees.variants.begin(), trees.variants.end(),
                   [](const VariantPair& pair) { return pair.before && pair.after; }))
    throw Error(ErrorKind::bad_input, "gate", options.against.string(),
                "no variant that the scene calls for is in both trees, so there is nothing to compare");
  return trees;
}

bool is_drawn(const VariantPair& pair, const Limits& limits) {
  const bool bounded = limits.baseline != ErrorLimits{} || limits.truth != ErrorLimits{};
  return pair.after && pair.failure.empty() && (!pair.same_errors || bounded);
}

GateMeasurements measure_trees(TreePair& trees, const GateOptions& options, const LimitsFile& limits, const Stopwatch& watch) {
  const auto is_measured = [&](const VariantPair& pair) {
    return std::ranges::any_of(options.compare.backends, [&](const std::string& backend) {
      const VariantManifest& variant = pair.after ? *pair.after : *pair.before;
      return is_drawn(pair, limits.of(variant.effect, variant.name, backend));
    });
  };
  if (std::ranges::none_of(trees.variants, is_measured)) return {};
  return measure_in_processes(
      options, watch,
      [&](const GateTask& task, const EmitLine& emit) { measure_pairs_of_trees(trees, task, options, limits, emit); },
      [&](const GateMeasurements& measured) {
        GateOptions exact = options;
        exact.times = false;
        return outcome_of(judge_trees(trees, measured, exact, limits).rows).verdict == Verdict::failed;
      },
      [&](const std::vector<PairsRow>& pairs) { return judge_pairs(pairs, limits, options.family_error).undecided; });
}

std::optional<CellRow> find_cell(const std::vector<CellRow>& cells, const std::string& backend, const std::string& effect,
                                 const std::string& variant, const std::string& view) {
  for (const CellRow& cell : cells)
    if (cell.backend == backend && cell.effect == effect && cell.variant == variant && cell.view == view) return cell;
  return std::nullopt;
}

namespace {

CellPair cells_of(const VariantPair& pair, const std::string& backend, const GateMeasurements& measured, const Scene& scene) {
  const VariantManifest& variant = pair.after ? *pair.after : *pair.before;
  CellPair cells;
  for (const View& view : scene.views) {
    cells.before.push_back(find_cell(measured.cells_before, backend, variant.effect, variant.name, view.name));
    cells.after.push_back(find_cell(measured.cells_after, backend, variant.effect, variant.name, view.name));
    const auto change = measured.changes.find({backend, variant.effect, variant.name, view.name});
    cells.changes.push_back(change == measured.changes.end() ? std::nullopt : std::optional(change->second));
  }
  return cells;
}

VerdictRow row_about(const std::string& backend, const VariantPair& pair, std::string what, Verdict verdict, Cause cause,
                     std::vector<std::string> details = {}) {
  const VariantManifest& manifest = pair.after ? *pair.after : *pair.before;
  VerdictRow row;
  row.backend = backend, row.effect = manifest.effect, row.variant = manifest.name;
  row.what = std::move(what), row.verdict = verdict, row.cause = cause, row.details = std::move(details);
  return row;
}

// What is known without any cell.
std::optional<VerdictRow> judge_code(const VariantPair& pair, const std::string& backend) {
  if (!pair.after) return row_about(backend, pair, "cell", Verdict::failed, Cause::gone);
  if (!pair.failure.empty()) return row_about(backend, pair, "cell", Verdict::failed, Cause::cannot_be_run, {pair.failure});
  if (pair.same_code)
    return row_about(backend, pair, "code", Verdict::same, pair.same_errors ? Cause::same_code : Cause::same_code_new_errors);
  return std::nullopt;
}

}  // namespace

GateResult judge_trees(const TreePair& trees, const GateMeasurements& measured, const GateOptions& options,
                       const LimitsFile& limits) {
  GateResult result;
  result.rows = measured.failures;
  for (const std::string& backend : options.compare.backends) {
    if (const TimerRow* timer = measured.timer(backend)) result.rows.push_back(judge_timer(*timer));
    for (const VariantPair& pair : trees.variants) {
      if (auto row = judge_code(pair, backend)) result.rows.push_back(std::move(*row));
      const VariantManifest& variant = pair.after ? *pair.after : *pair.before;
      const Limits allowed = limits.of(variant.effect, variant.name, backend);
      if (!is_drawn(pair, allowed)) continue;
      const CellPair cells = cells_of(pair, backend, measured, *trees.after.scene);
      const auto missing = [](const std::vector<std::optional<CellRow>>& side) {
        return std::ranges::none_of(side, [](const std::optional<CellRow>& cell) { return cell.has_value(); });
      };
      if (missing(cells.after) && missing(cells.before)) {
        result.rows.push_back(row_about(backend, pair, "cell", Verdict::failed, Cause::not_measured));
        continue;
      }
      for (VerdictRow& row : judge_cells(cells, allowed)) result.rows.push_back(std::move(row));
    }
  }
  if (!options.times) return result;
  result.times = judge_pairs(measured.pairs, limits, options.family_error);
  result.rows.insert(result.rows.end(), result.times.rows.begin(), result.times.rows.end());
  for (const std::string& backend : measured.out_of_time)
    for (const VariantPair& pair : trees.variants)
      if (pair.before && pair.after && pair.failure.empty() && !pair.same_code)
        result.rows.push_back(
            row_about(backend, pair, "time", Verdict::ambiguous, Cause::out_of_time,
                      {fmt::format("{:.0f}", options.budget_s), fmt::format("{:.0f}", std::ceil(2 * (measured.ready_s + 1)))}));
  let_counts_decide(result.rows, limits);
  if (measured.processes == 0 && outcome_of(result.rows).verdict == Verdict::failed) {
    VerdictRow& row = result.rows.emplace_back();
    row.what = "time", row.verdict = Verdict::not_compared;
    row.cause = Cause::exact_failed;
  }
  return result;
}

}  // namespace lamina
