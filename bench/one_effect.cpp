// SPDX-License-Identifier: Apache-2.0
// A scene that calls for one effect of all, against a program that has this effect alone: frames of both in interleaved rounds
// within one run, beside a second frame of the latter, whose ratio to the first shows what the machine tells apart.
//
//   bench_one_effect [BACKEND] [SCENE...]        vulkan; heart, leaf_pair, glass_stack and rough_glass at 256x256
#include <fmt/format.h>

#include <memory>

#include "harness/core/steady_heap.h"
#include "harness/graph/frame.h"
#include "harness/measure/rounds.h"
#include "tests/graph/library_of.h"

namespace {

using namespace lamina;

constexpr uint32_t size_px = 256;

// A frame with all that it needs, drawn once; in the targets of another one where they have the same, so that their place in
// memory makes no difference.
struct Side {
  Side(Backend& backend, const std::string& name, Library of, const Side* like = nullptr)
      : library(std::move(of)),
        scene(load_scene(name, library)),
        plan(make_plan(library, scene, 1)),
        shaders(backend.info().api, library.shaders),
        bakes(scene, *library.code, DiskCache("")),
        resources(backend, scene, library, size_px, size_px, &bakes),
        graph(make_graph(plan, configuration_of(plan, {}), scene, shaders)),
        frame(resources, graph, Build::timed, TargetSharing::on, like ? &like->frame : nullptr) {
    frame.run_once(Timing::off);
    frame.run(0, Timing::off);
  }
  const Library library;
  const Scene scene;
  const Plan plan;
  ShaderCache shaders;
  Bakes bakes;
  SceneResources resources;
  const Graph graph;
  Frame frame;
};

void print_ratio(const char* what, const std::vector<double>& samples, const std::vector<double>& baseline) {
  const Interval ratio = ratio_interval(samples, baseline);
  fmt::print("  {}: {:.4f} (95% interval {:.4f} to {:.4f}, {} rounds)\n", what, ratio.median, ratio.low, ratio.high,
             ratio.rounds);
}

}  // namespace

int main(int count, char** words) {
  use_steady_heap();
  const std::string backend_name = count > 1 ? words[1] : "vulkan";
  std::vector<std::string> scenes(words + std::min(count, 2), words + count);
  if (scenes.empty()) scenes = {"heart", "leaf_pair", "glass_stack", "rough_glass"};
  try {
    const Library library = load_library(LAMINA_SOURCE_DIR, effect_code());
    const auto backend = open_backend(backend_name);
    for (const std::string& name : scenes) {
      const Scene scene = load_scene(name, library);
      const Library alone = library_called_for(library, make_plan(library, scene, 1));
      Side all(*backend, name, library), one(*backend, name, alone, &all), again(*backend, name, alone, &all);
      std::vector<Arm> arms;
      for (Side* side : {&one, &all, &again})
        arms.push_back(
            {[side] { return side->frame.run(0, Timing::bracketed); }, arms.empty() ? std::nullopt : std::optional<size_t>(0)});
      const RoundsResult result = run_rounds(arms, {.min_rounds = 40, .max_rounds = 400, .precision = 0.005});
      fmt::print("{} on {}, {} effects against {}:\n", name, backend_name, library.effects.size(), alone.effects.size());
      print_ratio("of all effects, over the effect alone", result.arms[1].frame_ms, result.arms[0].frame_ms);
      print_ratio("the effect alone once more, over itself", result.arms[2].frame_ms, result.arms[0].frame_ms);
    }
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
