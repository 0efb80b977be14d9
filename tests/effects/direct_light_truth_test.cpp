// SPDX-License-Identifier: Apache-2.0
// The truth of aperture lighting through the interface that all truths have.
#include "harness/effects/aperture_lighting/direct_light_truth.h"

#include <gtest/gtest.h>

#include "harness/core/error.h"
#include "harness/effects/aperture_lighting/direct_light.h"
#include "tests/effects/made_scenes.h"

namespace lamina {
namespace {

Image two_pixels(glm::vec4 left, glm::vec4 right) {
  return {2, 1, {left.x, left.y, left.z, left.w, right.x, right.y, right.z, right.w}};
}

// The right one of two pixels shows the origin, which faces up and is grey, through an aperture of this radius.
std::map<std::string, Image> told_targets(float radius, float seen = 1) {
  return {{"seen_point", two_pixels({9, 9, 9, 0}, {0, 0, 0, seen})},
          {"seen_normal", two_pixels({0, 0, 0, 0}, {0, 1, 0, 0})},
          {"seen_albedo", two_pixels({0, 0, 0, 0}, {0.5f, 0.5f, 0.5f, 1})},
          {"seen_aperture_0", two_pixels({0, 0, 0, 0}, {0, 1, 0, radius})}};
}

class DirectLightTruth : public testing::Test {
 protected:
  DirectLightTruth() {
    Light sun;
    sun.direction = -glm::vec3(std::sin(0.5f), std::cos(0.5f), 0);
    sun.angular_radius = 0.2f;
    scene_.lights = {sun};
  }
  TruthAnswer answer(const std::map<std::string, Image>& targets) {
    return truth_->answer({targets, view_, {}}, [&](double) { ++traced_; });
  }

  Scene scene_ = scene_of({ring("lid", 1, 1, 50, 1)});
  Occluders occluders_{scene_};
  DiskCache cache_{""};
  View view_;
  std::unique_ptr<Truth> truth_ = effect_code().truths.at("direct_light")({scene_, occluders_, cache_, 512});
  int traced_ = 0;  // how often rays were cast, in steps of progress
};

TEST_F(DirectLightTruth, StepsDropOneAssumptionAfterAnother) {
  const TruthAnswer answered = answer(told_targets(0.6f));
  EXPECT_EQ(answered.pixels, (std::vector<size_t>{1}));
  ASSERT_EQ(answered.steps.size(), 3u);
  ShadingPoints points{2, 1, {{1, {0, 0, 0}, {0, 1, 0}, glm::vec3(0.5f)}}, {}, {{0, 1, 0, 0.6f}}};
  const LightModel models[] = {LightModel::exact_intersection, LightModel::integrated_cosine, LightModel::traced};
  const char* names[] = {"intersection", "cosine", "aperture"};
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(answered.steps[i].name, names[i]);
    EXPECT_FALSE(answered.steps[i].title.empty());
    const DirectLightOptions options = {512, 512, 1, occluders_.default_bias_m()};
    EXPECT_EQ(answered.steps[i].light, direct_light(points, scene_, occluders_, models[i], options, [](double) {}));
    EXPECT_GT(answered.steps[i].light.at(0).g, 0.1f);
  }
}

TEST_F(DirectLightTruth, TracedLightIsSharedUntilItIsForgotten) {
  const std::vector<glm::vec3> first = answer(told_targets(0.6f)).steps.at(2).light;
  const int once = traced_;
  EXPECT_GT(once, 0);
  EXPECT_EQ(answer(told_targets(pi_f / 2)).steps.at(2).light, first) << "rays do not ask for apertures";
  EXPECT_EQ(traced_, once);
  truth_->scene_changed();
  EXPECT_EQ(answer(told_targets(0.6f)).steps.at(2).light, first);
  EXPECT_EQ(traced_, 2 * once);
  scene_.lights[0].radiance *= 2.0f;
  EXPECT_NE(answer(told_targets(0.6f)).steps.at(2).light, first) << "another light is another truth, even unforgotten";
}

TEST_F(DirectLightTruth, SaysNothingOfAViewWithoutTheEffect) {
  EXPECT_TRUE(answer(told_targets(0.6f, 0)).pixels.empty());
  EXPECT_TRUE(answer(told_targets(0.6f, 0)).steps.empty());
}

TEST_F(DirectLightTruth, NamesTheTargetThatItIsNotTold) {
  for (const std::string name : {"seen_point", "seen_normal", "seen_albedo", "seen_aperture_0"}) {
    std::map<std::string, Image> targets = told_targets(0.6f);
    targets.erase(name);
    try {
      answer(targets);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("'" + name + "'"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace lamina
