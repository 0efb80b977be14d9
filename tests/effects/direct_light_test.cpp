// SPDX-License-Identifier: Apache-2.0
// Direct light on points whose irradiance is known in closed form.
#include "harness/effects/aperture_lighting/direct_light.h"

#include <gtest/gtest.h>

#include "tests/effects/made_scenes.h"

namespace lamina {
namespace {

// One white point at the origin that faces up, with one open aperture unless another is given.
ShadingPoints point(Aperture aperture = {0, 1, 0, pi_f / 2}) {
  ShadingPoints points{1, 1, {}, {}, {aperture}};
  points.points.push_back({0, {0, 0, 0}, {0, 1, 0}, {1, 1, 1}});
  return points;
}

Scene open_scene() { return scene_of({}); }

// From the zenith angle, in the x-y plane.
Light sun(float zenith, float radius, glm::vec3 irradiance = glm::vec3(1)) {
  Light light;
  light.direction = -glm::vec3(std::sin(zenith), std::cos(zenith), 0);
  light.angular_radius = radius;
  light.radiance = irradiance;
  return light;
}

float lit(const Scene& scene, LightModel model, const ShadingPoints& points = point(), size_t rays = 4096) {
  const Occluders occluders(scene);
  return direct_light(points, scene, occluders, model, {rays, rays, 1, 1e-4f}, [](double) {}).at(0).g;
}

// A cap that is all above the horizon gives its irradiance times the cosine to its centre, whatever its size.
TEST(DirectLight, WholeCapGivesItsCosine) {
  for (const float radius : {0.0f, 1e-3f, 0.1f, 0.5f})
    for (const float zenith : {0.0f, 0.4f, 1.0f}) {
      Scene scene = open_scene();
      scene.lights = {sun(zenith, radius, {3, 2, 1})};
      EXPECT_NEAR(lit(scene, LightModel::traced), 2 * std::cos(zenith), 2e-3f) << radius << " " << zenith;
      EXPECT_NEAR(lit(scene, LightModel::integrated_cosine), 2 * std::cos(zenith), 2e-3f);
      // The slide's cosine is taken at the middle between aperture and light.
      EXPECT_NEAR(lit(scene, LightModel::exact_intersection), 2 * std::cos(zenith / 2), 1e-5f);
    }
}

// A hemisphere of light on the horizon: half of it is above, and that half gives half of what the whole would overhead.
TEST(DirectLight, HemisphereOnTheHorizon) {
  Scene scene = open_scene();
  scene.lights = {sun(pi_f / 2, pi_f / 2)};
  EXPECT_NEAR(lit(scene, LightModel::traced), 0.5f, 2e-3f);
  EXPECT_NEAR(lit(scene, LightModel::exact_intersection), 0.5f * std::sqrt(0.5f),
              1e-4f);  // half the area, cosine of 45 degrees
}

TEST(DirectLight, BelowTheHorizonIsDark) {
  Scene scene = open_scene();
  scene.lights = {sun(pi_f, 0.2f), sun(2.0f, 0.1f)};
  for (const LightModel model :
       {LightModel::traced, LightModel::integrated_cosine, LightModel::exact_intersection, LightModel::traced_share})
    EXPECT_EQ(lit(scene, model), 0);
}

// The sky through a hole of angular radius r: sin^2 r with the cosine, 1 - cos r as a share of the hemisphere.
TEST(DirectLight, SkyThroughAHole) {
  for (const float radius : {0.4f, 1.0f}) {
    Scene scene = scene_of({ring("lid", std::tan(radius), 1, 500, 1)});
    scene.ambient = glm::vec3(1);
    const ShadingPoints points = point({0, 1, 0, radius});
    EXPECT_NEAR(lit(scene, LightModel::traced, points), std::sin(radius) * std::sin(radius), 0.01f);
    EXPECT_NEAR(lit(scene, LightModel::integrated_cosine, points), std::sin(radius) * std::sin(radius), 0.01f);
    EXPECT_NEAR(lit(scene, LightModel::traced_share, points), 1 - std::cos(radius), 0.01f);
    EXPECT_NEAR(lit(scene, LightModel::exact_intersection, points), 1 - std::cos(radius), 1e-5f);
  }
}

// The sky does not shine through a light, and the light hides it by its own share.
TEST(DirectLight, LightsStandInFrontOfTheSky) {
  Scene scene = open_scene();
  scene.ambient = glm::vec3(1);
  scene.lights = {sun(0, pi_f / 3, glm::vec3(0))};
  EXPECT_NEAR(lit(scene, LightModel::traced), 1 - 0.75f, 0.01f);             // sin^2 60 degrees
  EXPECT_NEAR(lit(scene, LightModel::exact_intersection), 1 - 0.5f, 1e-5f);  // cos 60 degrees
}

TEST(DirectLight, EdgeOfAnOccluderCutsTheLightInHalf) {
  Scene scene = scene_of({quad("roof", {0, 1, -50}, {50, 1, -50}, {50, 1, 50}, {0, 1, 50})});
  scene.lights = {sun(0, 0.2f)};
  EXPECT_NEAR(lit(scene, LightModel::traced), 0.5f, 0.01f);
  EXPECT_NEAR(lit(scene, LightModel::traced_share), 0.5f, 0.01f);
}

TEST(DirectLight, PointLightFallsOffAndStopsRaysAtItself) {
  Light lamp;
  lamp.kind = Light::Kind::point;
  lamp.position = {0, 2, 0};
  lamp.radius_m = 0.5f;
  lamp.radiance = glm::vec3(8);
  Scene behind = scene_of({ring("lid", 0, 3, 5, 3)}), between = scene_of({ring("lid", 0, 1, 5, 1)});
  behind.lights = between.lights = {lamp};
  EXPECT_NEAR(lit(behind, LightModel::traced), 2, 0.01f);
  EXPECT_EQ(lit(between, LightModel::traced), 0);
}

TEST(DirectLight, ApertureModelsFollowTheAperture) {
  Scene scene = open_scene();
  scene.lights = {sun(0.5f, 0.2f)};
  EXPECT_NEAR(lit(scene, LightModel::integrated_cosine, point({std::sin(0.5f), std::cos(0.5f), 0, 0.4f})), std::cos(0.5f),
              2e-3f);
  EXPECT_EQ(lit(scene, LightModel::integrated_cosine, point({0, 1, 0, 0.2f})), 0);
  EXPECT_EQ(lit(scene, LightModel::exact_intersection, point({0, 1, 0, 0.2f})), 0);
  EXPECT_EQ(lit(scene, LightModel::exact_intersection, point({0, 1, 0, 0})), 0);
  // An anti-aperture that covers the light, and one beside it.
  ShadingPoints blocked = point({std::sin(0.5f), std::cos(0.5f), 0, 0.3f}), beside = point({0, 1, 0, 0.2f});
  blocked.kind = beside.kind = {1, true};
  for (const LightModel model : {LightModel::integrated_cosine, LightModel::exact_intersection}) {
    EXPECT_NEAR(lit(scene, model, blocked), 0, 1e-5f);
    EXPECT_GT(lit(scene, model, beside), 0.8f);
  }
}

TEST(DirectLight, DegenerateInputsAreFinite) {
  Scene scene = open_scene();
  Light inside;
  inside.kind = Light::Kind::point;
  inside.radius_m = 1;
  scene.lights = {inside, sun(pi_f / 2, 0), sun(pi_f, pi_f / 2)};
  scene.ambient = glm::vec3(0.5f);
  for (const LightModel model :
       {LightModel::traced, LightModel::integrated_cosine, LightModel::exact_intersection, LightModel::traced_share})
    for (const Aperture aperture : {Aperture(0, 1, 0, 0), Aperture(0, -1, 0, pi_f / 2)}) {
      const float value = lit(scene, model, point(aperture), 64);
      EXPECT_TRUE(std::isfinite(value) && value >= 0) << static_cast<int>(model) << ": " << value;
    }
}

}  // namespace
}  // namespace lamina
