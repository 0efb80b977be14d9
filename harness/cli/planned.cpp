// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/planned.h"

#include <algorithm>
#include <functional>

#include "harness/graph/lifetimes.h"
#include "harness/graph/target_uses.h"

namespace lamina {
namespace {

std::vector<PlanRow::Pass> planned_passes(const std::vector<GraphPass>& passes, const Scene& scene, bool runs,
                                          bool with_variants = false) {
  std::vector<PlanRow::Pass> rows;
  for (const GraphPass& pass : passes) {
    PlanRow::Pass& row = rows.emplace_back();
    row.pass = pass.pass->name, row.effect = pass.variant->effect;
    row.runs = runs, row.once = pass.once, row.reason = pass.reason;
    std::set<std::string> names;
    for (const GraphDraw& draw : pass.draws) {
      if (draw.object) row.objects.push_back(scene.objects[*draw.object].name);
      for (const ResolvedRead& read : draw.reads) names.insert(read.source.name);
    }
    row.reads.assign(names.begin(), names.end());
    row.writes = pass.pass->written();
    if (with_variants) row.variant = pass.variant->name;
  }
  return rows;
}

// The frame in which each effect stands as it is chosen, else at its baseline.
PlanRow::Frame planned_frame(const Plan& plan, const Scene& scene, ShaderCache& shaders, const FrameSize& size) {
  Graph graph = make_graph(plan, configuration_of(plan, {}), scene, shaders);
  std::stable_partition(graph.passes.begin(), graph.passes.end(), [](const GraphPass& pass) { return pass.once; });
  PlanRow::Frame frame;
  frame.width = size.width_px, frame.height = size.height_px;
  frame.passes = planned_passes(graph.passes, scene, true, true);
  frame.left_out = planned_passes(graph.dropped, scene, false, true);
  uint64_t bytes = 0;
  for (TargetUse& use : target_uses(graph, scene, size.width_px, size.height_px)) {
    PlanRow::Target& target = frame.targets.emplace_back();
    target.target = use.name;
    if (use.variant) target.effect = use.variant->effect, target.variant = use.variant->name;
    target.shared = use.shared, target.copies = use.copies, target.bytes = use.bytes;
    target.writers.assign(use.writers.begin(), use.writers.end());
    target.readers.assign(use.readers.begin(), use.readers.end());
    bytes += use.bytes;
  }
  const TargetMemory memory = target_memory(make_frame_passes(graph, scene, {size.width_px, size.height_px}));
  const uint64_t buffers = bytes - std::min(bytes, memory.alone);  // storage buffers keep theirs
  frame.aliased_bytes = memory.aliased + buffers, frame.reused_bytes = memory.reused + buffers;
  return frame;
}

// What `work` throws, "" where it does not. A mistake of a manifest is thrown on.
std::string failure_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::bad_input && error.stage() == "variants") throw;
    return error.what();
  }
  return "";
}

}  // namespace

PlanRow plan_row(const Plan& plan, const Scene& scene, ShaderCache& shaders, const FrameSize& size) {
  PlanRow row;
  for (const EffectPlan& entry : plan.effects) {
    PlanRow::Effect& effect = row.effects.emplace_back();
    effect.effect = entry.effect->name, effect.called_for = entry.called_for, effect.reason = entry.reason;
    effect.objects = entry.objects.size();
    for (const FeaturePlan& feature : entry.features) effect.features.push_back({feature.define, feature.on, feature.reason});
    for (const VariantManifest& manifest : entry.effect->variants) {
      if (!entry.called_for) break;
      PlanRow::Variant& variant = effect.variants.emplace_back();
      variant.variant = manifest.name, variant.baseline = manifest.baseline;
      variant.error = failure_of([&] {
        const Graph graph = make_graph(plan, {&manifest}, scene, shaders);
        variant.passes = planned_passes(graph.passes, scene, true);
        for (PlanRow::Pass& dropped : planned_passes(graph.dropped, scene, false)) variant.passes.push_back(std::move(dropped));
      });
    }
  }
  row.frame_error = failure_of([&] { row.frame = planned_frame(plan, scene, shaders, size); });
  return row;
}

}  // namespace lamina
