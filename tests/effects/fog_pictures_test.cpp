// SPDX-License-Identifier: Apache-2.0
// Pictures with fog: backends agree, nothing is NaN, colour follows the formula, and fog that is none costs nothing.
#include <gtest/gtest.h>

#include "harness/effects/volume_fog/fog_color.h"
#include "harness/scene/textures.h"
#include "tests/effects/backends_agree.h"
#include "tests/effects/fog_cases.h"

namespace lamina {
namespace {

// A ball in two hulls and a hole, before a wall.
Scene ball_in_fog(float density) {
  Scene scene;
  scene.name = scene.source = "ball in fog";
  scene.objects.push_back(coloured_object("ball", sphere_mesh(17), {0.5f, 0.4f, 0.3f}, false));
  scene.objects.push_back(wall(-3, 6));
  scene.objects.push_back(fog_ball("outer", {0, 0.3f, 0}, {2.0f, 1.7f, 1.9f}, 0.3f));
  scene.objects.push_back(fog_ball("low", {0.4f, -0.8f, 0}, {2.4f, 0.6f, 0.9f}, 1, 25));
  scene.objects.push_back(fog_box("shaft", {0.5f, -0.5f, -0.2f}, {0.9f, 1, 1}, 0.3f, true));
  scene.ambient = {0.9f, 0.8f, 0.7f};
  scene.views = {{"front", {0.5f, 1.3f, 5.6f}, {0.06f, 0.27f, 0}, {0, 1, 0}, 40, 0.1f, 14}};
  set_fog(scene, density, {0.3f, 0.4f, 0.5f});
  return settled(std::move(scene));
}

class FogPictures : public FogOnEachBackend {};

// A box of fog 2 m deep before a wall: both ways to colour, by hand.
TEST_P(FogPictures, ColourFollowsTheFormula) {
  FogCases cases;
  cases.add("box", {fog_box("box", {-1, -1, -1}, {1, 1, 1}, 0.5f), wall(-2)}, {0, 0, 5}, {0, 0, 0}, 1);
  Scene scene = cases.scene();
  scene.ambient = glm::vec3(0.8f);
  scene.effects.at("volume_fog").numbers["density"] = 0.7;
  const glm::vec3 behind = pixel(picture(settled([&] {
                                           Scene bare = scene;
                                           bare.objects.erase(bare.objects.begin());
                                           return bare;
                                         }()),
                                         "lambert", 33),
                                 16, 16);
  const FogColor exponential(scene);
  const glm::dvec3 seen = pixel(picture(scene, "float_sum", 33), 16, 16), through = exponential.over(behind, 1);
  const double kept = std::exp(-0.7);
  const glm::dvec3 colour(base_texels(*scene.effects.at("volume_fog").textures.at("fog_color")).rgba.at(0));
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(through[c], behind[c] * kept + colour[c] * (1 - kept), 1e-12);
    EXPECT_NEAR(seen[c], through[c], 1e-3) << c;
  }
  // A ramp of three texels, 4 m long: a metre is half way from the first to the second.
  Texels ramp{3, 1, {{1, 0, 0, 0}, {0, 1, 0, 0.5f}, {0, 0, 1, 1}}};
  scene.effects.at("volume_fog").textures["ramp"] = make_texture("ramp", ramp, TexelMeaning::colour);
  scene.effects.at("volume_fog").numbers["ramp_length"] = 4;
  const FogColor ramped(scene);
  const glm::dvec3 with_ramp = pixel(picture(scene, "float_sum", 33), 16, 16), expected = ramped.over(behind, 1);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(with_ramp[c], expected[c], 5e-3) << c;
  EXPECT_NEAR(expected.r, 0.5 * 0.25 + behind.r * 0.75, 2e-3);
}

// Density 0, and hulls of no share: the picture of a scene without them, to the bit.
TEST_P(FogPictures, NoFogCostsNothing) {
  Scene none = ball_in_fog(1);
  none.objects.resize(2);
  const Image bare = picture(none, "lambert");
  const auto same = [&](const Scene& scene) {
    const Image foggy = picture(scene, "lambert");
    return foggy.rgba == bare.rgba;
  };
  const Scene clear = ball_in_fog(0);
  EXPECT_TRUE(same(clear));
  EXPECT_FALSE(make_plan(library(), clear).of("volume_fog")->called_for);
  Scene no_share = ball_in_fog(1);
  for (Object& object : no_share.objects)
    if (const auto fog = object.effects.find("volume_fog"); fog != object.effects.end()) fog->second.numbers["share"] = 0;
  EXPECT_TRUE(same(no_share));
  EXPECT_FALSE(make_plan(library(), no_share).of("volume_fog")->called_for);
  EXPECT_FALSE(same(ball_in_fog(1))) << "where there is fog it is seen";
}

Scene moved(Scene scene, std::string_view name, glm::vec3 by) {
  for (Object& object : scene.objects)
    if (!object.solid && (name.empty() || object.name == name)) object.world_from_object[3] += glm::vec4(by, 0);
  return scene;
}

// Hulls beside, above, behind and far beyond the view: no pass, and to the bit the picture of a scene without them.
TEST_P(FogPictures, FogOutsideEveryViewCostsNothing) {
  const auto passes = [&](const Scene& scene) {
    const Plan plan = make_plan(library(), scene, 1);
    ShaderCache shaders(backend_->info().api, library().shaders);
    const Graph graph = make_graph(plan, configuration_with(plan, variant("lambert")), scene, shaders);
    return graph.passes.size() + graph.dropped.size();
  };
  Scene none = ball_in_fog(1);
  none.objects.resize(2);
  const Image bare = picture(none, "lambert");
  for (const glm::vec3 by : {glm::vec3(0, 0, 40), {14, 0, 0}, {-14, 0, 0}, {0, 14, 0}, {0, -14, 0}, {0, 0, -40}}) {
    SCOPED_TRACE(fmt::format("{} {} {}", by.x, by.y, by.z));
    const Scene outside = moved(ball_in_fog(1), "", by);
    const EffectPlan fog = *make_plan(library(), outside, 1).of("volume_fog");
    EXPECT_FALSE(fog.called_for);
    EXPECT_EQ(fog.reason, "no view sees an object that calls for it");
    EXPECT_EQ(passes(outside), passes(none));
    EXPECT_EQ(picture(outside, "lambert").rgba, bare.rgba);
  }
  EXPECT_GT(passes(ball_in_fog(1)), passes(none));
  Scene two_views = moved(ball_in_fog(1), "", {0, 0, 40});
  two_views.views.push_back(two_views.views[0]);
  two_views.views[1].eye.z += 40, two_views.views[1].target.z += 40;
  EXPECT_TRUE(make_plan(library(), two_views, 1).of("volume_fog")->called_for) << "the second view sees it";
}

// A hull that leaves the view is left out, and comes back with its next plan. A hole takes away from nothing where no fog is.
TEST_P(FogPictures, HullsAreDrawnWhereAViewSeesThem) {
  const Scene scene = moved(ball_in_fog(1), "low", {0, 0, 40});
  const EffectPlan fog = *make_plan(library(), scene, 1).of("volume_fog");
  EXPECT_EQ(fog.objects, (std::vector<size_t>{2, 4}));
  EXPECT_EQ(fog.reason, "an object is a hull of fog (2 of 3 objects; no view sees the others)");
  Scene without = ball_in_fog(1);
  without.objects.erase(without.objects.begin() + 3);
  EXPECT_EQ(picture(scene, "float_sum").rgba, picture(without, "float_sum").rgba);
  EXPECT_EQ(make_plan(library(), moved(scene, "low", {0, 0, -40}), 1).of("volume_fog")->objects.size(), 3u);

  const Scene hole_alone = moved(scene, "outer", {0, 0, 40});
  EXPECT_FALSE(make_plan(library(), hole_alone, 1).of("volume_fog")->called_for);
  without.objects.resize(2);
  EXPECT_EQ(picture(hole_alone, "lambert").rgba, picture(without, "lambert").rgba);
  EXPECT_TRUE(make_plan(library(), moved(hole_alone, "outer", {0.5f, 1, -34.4f}), 1).of("volume_fog")->called_for)
      << "the eye is in the hull";
}

TEST(FogBackends, AgreeAndHaveNoNaN) { expect_backends_agree("volume_fog", {ball_in_fog(0.9f)}); }

INSTANTIATE_TEST_SUITE_P(Backends, FogPictures, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
