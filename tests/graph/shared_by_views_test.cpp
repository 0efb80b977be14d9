// SPDX-License-Identifier: Apache-2.0
// What depends on meshes and lights alone is drawn and counted once for all views of a moving scene: a second view after the
// first is what it is by itself, and a scene that has changed is drawn anew.
#include <algorithm>

#include "tests/graph/each_backend.h"
#include "tests/graph/layer_stacks.h"

namespace lamina {
namespace {

class SharedByViews : public EachBackend {
 protected:
  static Scene moving_stack(float light_x) {
    Scene scene = stack_scene({{0.8f, 0.4f}, {0.3f, 1}}, 0);
    scene.ambient = glm::vec3(0);
    scene.lights = {{"low", Light::Kind::directional, glm::normalize(glm::vec3(light_x, 0, -1)), {}, glm::vec3(1)}};
    scene.mesh_moves = true;
    scene.views.push_back(scene.views.front());
    scene.views.back().name = "aside";
    scene.views.back().eye += glm::vec3(0.7f, 0.3f, 0);
    return scene;
  }
};

TEST_P(SharedByViews, TheSecondViewIsWhatItIsAlone) {
  const Scene both = moving_stack(-1);
  Scene second = both;
  second.views.erase(second.views.begin());
  for (const Build build : {Build::timed, Build::counting}) {
    const DrawnFrame::Choice choice{.variant = &variant("light_map"), .build = build, .aspect = 1};
    DrawnFrame after(*backend_, library(), both, choice), alone(*backend_, library(), second, choice);
    ASSERT_GT(after.frame.frame_names().size(), 1u);
    ASSERT_TRUE(std::ranges::any_of(after.graph.passes, [](const GraphPass& pass) {
      return !pass.once && pass.pass->when == Frequency::mesh_or_lights_move;
    })) << "a pass that the views share";
    after.frame.run(1, Timing::off);
    EXPECT_EQ(after.picture().rgba, alone.picture().rgba);
    if (build == Build::timed) continue;
    const std::vector<PassCounts> counts = after.frame.frame_counts(), expected = alone.frame.frame_counts();
    ASSERT_EQ(counts.size(), expected.size());
    EXPECT_GT(counts.front().fragments, 0u) << "of the light map";
    for (size_t i = 0; i < counts.size(); ++i) {
      EXPECT_EQ(counts[i].fragments, expected[i].fragments) << i;
      EXPECT_EQ(counts[i].fetches(), expected[i].fetches()) << i;
      EXPECT_EQ(counts[i].runs, expected[i].runs) << i;
      EXPECT_EQ(counts[i].issued_fragments, expected[i].issued_fragments) << i;
    }
  }
}

TEST_P(SharedByViews, AnotherLightIsDrawnAnew) {
  Scene scene = moving_stack(-1);
  const DrawnFrame::Choice choice{.variant = &variant("light_map"), .aspect = 1};
  DrawnFrame drawn(*backend_, library(), scene, choice);
  const Image before = drawn.picture();
  scene.lights = moving_stack(-4).lights;
  drawn.resources.update(false);
  drawn.frame.run(0, Timing::off);
  EXPECT_NE(drawn.picture().rgba, before.rgba);
  EXPECT_EQ(drawn.picture().rgba, DrawnFrame(*backend_, library(), moving_stack(-4), choice).picture().rgba);
}

INSTANTIATE_TEST_SUITE_P(Backends, SharedByViews, backend_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
