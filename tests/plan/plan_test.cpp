// SPDX-License-Identifier: Apache-2.0
#include "harness/plan/plan.h"

#include <gtest/gtest.h>

namespace lamina {
namespace {

Library builtin() { return load_library(LAMINA_SOURCE_DIR, effect_code()); }

Object layered(float thickness, float transparency) {
  Object object;
  object.name = "object";
  object.effects["layered_material"] = {{{"thickness", thickness}}, {}, {}, {{"transparency", transparency}}};
  return object;
}

TEST(Plan, CallsForTheLayeredMaterialWhereAnObjectHasLayers) {
  Scene scene;
  scene.objects = {layered(8, 1)};
  const Library library = builtin();
  const Plan plan = make_plan(library, scene);
  EXPECT_TRUE(plan.of("layered_material")->called_for);
  EXPECT_FALSE(plan.of("surface")->called_for);
  EXPECT_EQ(plan.of("surface")->reason, "every object is drawn by another effect");
}

TEST(Plan, CallsForNothingButTheSurfaceWithoutLayers) {
  Scene scene;
  scene.objects = {Object{}};
  const Library library = builtin();
  const Plan plan = make_plan(library, scene);
  EXPECT_FALSE(plan.of("layered_material")->called_for);
  EXPECT_EQ(plan.of("layered_material")->reason, "no object has layers");
  EXPECT_TRUE(plan.of("surface")->called_for);
}

TEST(Plan, KnowsWhoseFrameALaterEffectReads) {
  Scene scene;
  scene.objects = {layered(8, 1)};
  const Library library = builtin();
  const EffectManifest &layers = library.effect("layered_material"), &glass = library.effect("rough_refraction");
  ASSERT_TRUE(glass.reads_frame);
  EXPECT_FALSE(reads_frame_after(make_plan(library, scene), layers));
  Object pane;
  pane.effects["rough_refraction"];
  for (const NeedManifest& need : glass.needs) pane.effects["rough_refraction"].numbers[need.name] = 1;
  scene.objects.push_back(pane);
  const Plan plan = make_plan(library, scene);
  ASSERT_TRUE(plan.of("rough_refraction")->called_for);
  EXPECT_TRUE(reads_frame_after(plan, layers));
  EXPECT_FALSE(reads_frame_after(plan, glass)) << "nobody comes after it";
}

TEST(Plan, EachObjectGetsTheFeaturesThatItsFactsCallFor) {
  const Library library = builtin();
  const EffectManifest& effect = library.effect("layered_material");
  using Defines = std::map<std::string, std::string>;
  const auto defines = [&](const Object& object) { return feature_defines(effect, Scene{}, &object); };
  EXPECT_EQ(defines(layered(8, 1)), (Defines{{"INNER_LAYER", "1"}, {"LAYER_DEPTH", "1"}}));
  EXPECT_EQ(defines(layered(0, 1)), (Defines{{"INNER_LAYER", "1"}}));
  EXPECT_EQ(defines(layered(8, 0)), Defines{}) << "no depth where no inner layer is seen";
}

TEST(Plan, SaysWhyAFeatureIsOffAndOnHowManyObjectsItIsOn) {
  Scene scene;
  scene.objects = {layered(8, 1), layered(0, 1)};
  const Library library = builtin();
  const EffectPlan effect = *make_plan(library, scene).of("layered_material");
  EXPECT_EQ(effect.features[1].define, "LAYER_DEPTH");
  EXPECT_EQ(effect.features[1].reason, "the layers are apart (on 1 of 2 objects)");
  scene.objects = {layered(8, 1)};
  EXPECT_EQ(make_plan(library, scene).of("layered_material")->features[1].reason, "the layers are apart");
  scene.objects = {layered(0, 1)};
  EXPECT_EQ(make_plan(library, scene).of("layered_material")->features[1].reason,
            "the thickness is 0, or the inner layer is not seen");
}

TEST(Plan, ConfigurationIsBaselinesButForTheVariant) {
  Scene scene;
  scene.objects = {layered(8, 1), Object{}};
  const Library library = builtin();
  const Plan plan = make_plan(library, scene);
  const Configuration configuration = configuration_with(plan, library.effect("layered_material").variants.back());
  ASSERT_EQ(configuration.size(), 2u);
  EXPECT_EQ(configuration[0]->name, "lambert") << "plain surfaces are drawn first";
  EXPECT_EQ(configuration[1]->name, "vertex_normal");
}

}  // namespace
}  // namespace lamina
