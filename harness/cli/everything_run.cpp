// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/everything_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/graph/everything_graph.h"
#include "harness/graph/target_uses.h"
#include "harness/quality/same_bits.h"

namespace lamina {
namespace {

// A frame with all that it needs, ready to run.
struct Side {
  Side(Backend& backend, const Scene& scene, const Plan& of_plan, Graph of_graph, const CellOptions& options)
      : bakes(scene, *of_plan.library->code, DiskCache(options.cache)),
        resources(backend, scene, *of_plan.library, options.width_px, options.height_px, &bakes),
        graph(std::move(of_graph)),
        frame(resources, graph, Build::timed) {
    frame.run_once(Timing::off);
    for (size_t view = 0; view < scene.views.size(); ++view) {
      frame.run(view, Timing::off);
      pictures.push_back(frame.picture());
    }
  }

  Bakes bakes;
  SceneResources resources;
  Graph graph;
  Frame frame;
  std::vector<Image> pictures;  // by view
};

using CostOf = SavingRow::Cost SavingRow::Effect::*;

SavingRow::Cost& cost_in(SavingRow& row, std::string_view effect, CostOf side) {
  return *std::ranges::find(row.effects, effect, &SavingRow::Effect::effect).*side;
}

// Of the passes that are done once, or those of each frame.
std::vector<const GraphPass*> passes_of(const Graph& graph, bool once) {
  std::vector<const GraphPass*> passes;
  for (const GraphPass& pass : graph.passes)
    if (pass.once == once) passes.push_back(&pass);
  return passes;
}

uint64_t operations_of(const PassCounts& counts) {
  uint64_t sum = 0;
  for (const auto& [name, times] : counts.operations) sum += times;
  return sum;
}

void add_side_counts(std::vector<SavingRow>& rows, Side& side, CostOf cost) {
  Frame counting(side.resources, side.graph, Build::counting);
  counting.run_once(Timing::off);
  const std::vector<PassCounts> once = counting.once_counts();
  const std::vector<const GraphPass*> once_passes = passes_of(side.graph, true), frame_passes = passes_of(side.graph, false);
  for (size_t view = 0; view < rows.size(); ++view) {
    for (size_t i = 0; i < once.size(); ++i)
      cost_in(rows[view], once_passes[i]->effect->name, cost).once_operations += operations_of(once[i]);
    counting.run(view, Timing::off);
    const std::vector<PassCounts> counts = counting.frame_counts();
    for (size_t i = 0; i < counts.size(); ++i) {
      SavingRow::Cost& of = cost_in(rows[view], frame_passes[i]->effect->name, cost);
      of.fetches += counts[i].fetches();
      of.operations += operations_of(counts[i]);
    }
  }
}

// A target counts with the effect whose pass first writes it; what no pass writes was not made.
void add_side_bytes(std::vector<SavingRow>& rows, const Side& side, const Scene& scene, CostOf cost, const CellOptions& options,
                    uint64_t SavingRow::*textures, uint64_t SavingRow::*of_frame, std::optional<uint64_t> SavingRow::*memory) {
  for (const TargetUse& use : target_uses(side.graph, scene, options.width_px, options.height_px)) {
    const bool of_frame_itself = !use.variant && !use.shared;
    if (!of_frame_itself && use.writers.empty() && use.readers.empty()) continue;
    for (SavingRow& row : rows) {
      if (of_frame_itself)
        row.*of_frame += use.bytes;
      else
        cost_in(row, side.graph.passes[use.writers.empty() ? use.readers.front() : use.writers.front()].effect->name, cost)
            .target_bytes += use.bytes;
    }
  }
  for (SavingRow& row : rows) row.*textures = side.resources.texture_bytes(), row.*memory = side.frame.memory_bytes();
}

void add_side_times(std::vector<SavingRow>& rows, Side& culled, Side& all, const RoundOptions& options, const Tell& tell) {
  std::vector<Arm> arms;
  for (size_t view = 0; view < rows.size(); ++view) {
    arms.push_back({[&culled, view] { return culled.frame.run(view, Timing::bracketed); }, 2 * view + 1});
    arms.push_back({[&all, view] { return all.frame.run(view, Timing::bracketed); }, std::nullopt});
  }
  const RoundsResult result = run_rounds(arms, options, [&](double fraction) { tell(fraction, "timing"); });
  for (size_t arm = 0; arm < arms.size(); ++arm) {
    SavingRow& row = rows[arm / 2];
    if (!result.arms[arm].failure.empty())
      throw Error(ErrorKind::failed, "compare", "view " + row.view, result.arms[arm].failure);
    const CostOf side = arm % 2 == 0 ? &SavingRow::Effect::culled : &SavingRow::Effect::all;
    const std::vector<const GraphPass*> passes = passes_of(arm % 2 == 0 ? culled.graph : all.graph, false);
    for (size_t i = 0; i < passes.size(); ++i) {
      std::vector<double>& sums = cost_in(row, passes[i]->effect->name, side).ms;
      const std::vector<double>& samples = result.arms[arm].pass_ms[i];
      sums.resize(samples.size(), 0);
      for (size_t round = 0; round < samples.size(); ++round) sums[round] += samples[round];
    }
  }
  for (size_t view = 0; view < rows.size() && result.rounds >= min_rounds_for_95; ++view)
    rows[view].ratio = ratio_interval(result.arms[2 * view].frame_ms, result.arms[2 * view + 1].frame_ms);
}

// Without which of the effects that the scene does not call for the picture would be the same; "" where no single one is.
std::string culprit(Backend& backend, const Scene& everything, const EverythingPlan& all, const Plan& plan, const Side& culled,
                    size_t view, ShaderCache& shaders, const CellOptions& options) {
  for (const EffectPlan& entry : all.plan.effects) {
    const EffectPlan& own = *plan.of(entry.effect->name);
    if (!entry.called_for || own.called_for) continue;
    EverythingPlan without = all;
    std::ranges::find(without.plan.effects, entry.effect, &EffectPlan::effect)->called_for = false;
    const Graph graph = make_graph(without.plan, configuration_of(without.plan, {}), everything, shaders);
    const Side other(backend, everything, without.plan, graph, options);
    if (bit_difference(culled.pictures[view], other.pictures[view]).pixels == 0) return entry.effect->name;
  }
  return "";
}

void compare_pictures(std::vector<SavingRow>& rows, const Side& culled, const Side& all, const auto& who) {
  for (size_t view = 0; view < rows.size(); ++view) {
    const BitDifference difference = bit_difference(culled.pictures[view], all.pictures[view]);
    if (difference.pixels == 0) continue;
    SavingRow& row = rows[view];
    row.different_pixels = difference.pixels;
    row.largest_difference = difference.largest;
    row.where = fmt::format("pixel {}, {} of {}x{}", difference.x, difference.y, row.width, row.height);
    if (const std::string name = who(view); !name.empty()) row.where += ", by " + name;
  }
}

std::vector<SavingRow> blank_saving_rows(const Backend& backend, const Scene& scene, const Plan& plan,
                                         const EverythingPlan& all, const CellOptions& options) {
  std::vector<SavingRow> rows;
  for (const View& view : scene.views) {
    SavingRow& row = rows.emplace_back();
    row.scene = scene.name, row.backend = backend.info().backend, row.device = backend.info().device, row.view = view.name;
    row.width = static_cast<int>(options.width_px), row.height = static_cast<int>(options.height_px);
    for (const EffectPlan& entry : plan.effects) {
      const auto cannot = all.cannot.find(entry.effect->name);
      row.effects.push_back({.effect = entry.effect->name,
                             .called_for = entry.called_for,
                             .reason = entry.reason,
                             .cannot = cannot == all.cannot.end() ? "" : cannot->second});
    }
  }
  return rows;
}

}  // namespace

std::vector<SavingRow> saving_rows(Backend& backend, const Library& library, const Scene& scene, const Plan& plan,
                                   ShaderCache& shaders, const CellOptions& options, const std::optional<RoundOptions>& rounds,
                                   const Tell& tell) {
  const Scene everything = scene_of_everything(scene, library);
  EverythingPlan all = plan_of_everything(plan, everything);
  std::vector<SavingRow> rows;
  try {
    tell(0, "making both frames");
    Graph graph = make_graph_of_everything(all, plan, everything, shaders);
    rows = blank_saving_rows(backend, scene, plan, all, options);
    Side culled(backend, scene, plan, make_graph(plan, configuration_of(plan, {}), scene, shaders), options);
    Side whole(backend, everything, all.plan, std::move(graph), options);
    compare_pictures(rows, culled, whole,
                     [&](size_t view) { return culprit(backend, everything, all, plan, culled, view, shaders, options); });
    tell(0.3, "counting");
    add_side_counts(rows, culled, &SavingRow::Effect::culled);
    add_side_counts(rows, whole, &SavingRow::Effect::all);
    add_side_bytes(rows, culled, scene, &SavingRow::Effect::culled, options, &SavingRow::culled_texture_bytes,
                   &SavingRow::culled_frame_bytes, &SavingRow::culled_memory_bytes);
    add_side_bytes(rows, whole, everything, &SavingRow::Effect::all, options, &SavingRow::all_texture_bytes,
                   &SavingRow::all_frame_bytes, &SavingRow::all_memory_bytes);
    if (rounds) add_side_times(rows, culled, whole, *rounds, tell);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::bad_input) throw;
    rows = blank_saving_rows(backend, scene, plan, all, options);
    for (SavingRow& row : rows) row.failure = error.what();
  }
  return rows;
}

}  // namespace lamina
