// SPDX-License-Identifier: Apache-2.0
// A scene that calls for one effect of all costs what it costs in a program that has this effect alone: as many pipelines of as
// many words, textures, targets and buffers, passes and draws, fetches and operations, and the same picture.
#include <algorithm>

#include "tests/graph/each_backend.h"
#include "tests/graph/library_of.h"
#include "tests/graph/small_parameters.h"
#include "tests/graph/tally_backend.h"

namespace lamina {
namespace {

class OneEffect : public EachBackend {
 protected:
  static constexpr uint32_t size_px = 32;

  struct Cost {
    std::vector<std::string> once, frame;  // passes
    std::set<std::string> shaders;
    BackendTally timed, counting;
    std::vector<PassCounts> once_counts, frame_counts;
    uint64_t target_bytes = 0, memory_bytes = 0;
    Image picture;
  };
  Cost cost_of(const std::string& name, const Library& library) {
    const Scene scene = load_scene(name, library);
    const Plan plan = make_plan(library, scene, 1);
    ShaderCache shaders(backend_->info().api, library.shaders);
    const Graph graph = make_graph(plan, configuration_of(plan, {}), scene, shaders, nullptr, small_parameters(library));
    Cost cost;
    cost.shaders = graph.shader_hashes();
    for (const Build build : {Build::timed, Build::counting}) {
      TallyBackend backend(*backend_);
      Bakes bakes(scene, *library.code, DiskCache(""));
      SceneResources resources(backend, scene, library, size_px, size_px, &bakes);
      Frame frame(resources, graph, build);
      frame.run_once(Timing::off);
      frame.run(0, Timing::off);
      (build == Build::timed ? cost.timed : cost.counting) = backend.tally;
      cost.once = frame.once_names(), cost.frame = frame.frame_names();
      cost.target_bytes = frame.target_bytes(), cost.memory_bytes = frame.memory_bytes();
      if (build == Build::timed)
        cost.picture = frame.picture();
      else
        cost.once_counts = frame.once_counts(), cost.frame_counts = frame.frame_counts();
    }
    return cost;
  }

  static void expect_same_counts(const std::vector<PassCounts>& a, const std::vector<PassCounts>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].operations, b[i].operations) << i;
      EXPECT_EQ(a[i].issued, b[i].issued) << i;
      EXPECT_EQ(a[i].fragments, b[i].fragments) << i;
      EXPECT_EQ(a[i].vertices, b[i].vertices) << i;
      EXPECT_EQ(a[i].fetches(), b[i].fetches()) << i;
      EXPECT_EQ(a[i].by_texture.size(), b[i].by_texture.size()) << i;
    }
  }
};
INSTANTIATE_TEST_SUITE_P(Backends, OneEffect, backend_parameters, backend_test_name);

TEST_P(OneEffect, CostsWhatItCostsAlone) {
  for (const std::string name : {"leaf_pair", "open_plane"}) {
    SCOPED_TRACE(name);
    const Plan plan = make_plan(library(), load_scene(name, library()), 1);
    const Library alone = library_called_for(library(), plan);
    EXPECT_LE(alone.effects.size(), 3u);
    EXPECT_GE(library().effects.size(), 8u);
    const Cost of_all = cost_of(name, library()), of_one = cost_of(name, alone);
    EXPECT_EQ(of_all.once, of_one.once);
    EXPECT_EQ(of_all.frame, of_one.frame);
    EXPECT_EQ(of_all.shaders, of_one.shaders);
    EXPECT_TRUE(of_all.timed == of_one.timed)
        << of_all.timed.pipelines << " pipelines and " << of_one.timed.pipelines << ", " << of_all.timed.texture_bytes
        << " bytes of textures and " << of_one.timed.texture_bytes;
    EXPECT_TRUE(of_all.counting == of_one.counting);
    EXPECT_GT(of_all.timed.pipelines, 0u);
    EXPECT_GT(of_all.timed.texture_bytes, 0u);
    EXPECT_EQ(of_all.target_bytes, of_one.target_bytes);
    EXPECT_EQ(of_all.memory_bytes, of_one.memory_bytes);
    expect_same_counts(of_all.once_counts, of_one.once_counts);
    expect_same_counts(of_all.frame_counts, of_one.frame_counts);
    EXPECT_EQ(of_all.picture.rgba, of_one.picture.rgba);
    uint64_t operations = 0;
    for (const PassCounts& counts : of_all.frame_counts)
      for (const auto& [what, times] : counts.operations) operations += times;
    EXPECT_GT(operations, 0u);
  }
}

}  // namespace
}  // namespace lamina
