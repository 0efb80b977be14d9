// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/default_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/scene/made_files.h"

namespace lamina {
namespace {

// A sphere of `radius` around `centre` as an object, the radius as its matrix.
Object ball(glm::vec3 centre, float radius) {
  Object object;
  constexpr int around = 48, up = 24;
  for (int j = 0; j <= up; ++j)
    for (int i = 0; i <= around; ++i) {
      const float latitude = float(M_PI) * (float(j) / up - 0.5f), longitude = 2 * float(M_PI) * float(i) / around;
      const glm::vec3 p(std::cos(latitude) * std::cos(longitude), std::sin(latitude), std::cos(latitude) * std::sin(longitude));
      object.mesh.vertices.push_back({p, p, {1, 0, 0, 1}, {float(i) / around, float(j) / up}});
    }
  object.world_from_object = glm::scale(glm::translate(glm::mat4(1), centre), glm::vec3(radius));
  return object;
}

// Where a ray meets the ball first: the cosine between it and the normal there, or nothing.
std::optional<float> cosine_at_hit(glm::vec3 eye, glm::vec3 direction, glm::vec3 centre, float radius) {
  const float along = glm::dot(centre - eye, direction);
  const float below = radius * radius - glm::dot(eye + along * direction - centre, eye + along * direction - centre);
  if (below < 0 || along < 0) return std::nullopt;
  return std::sqrt(below) / radius;
}

struct Frame {
  glm::vec3 ahead, right, up;
  float half_height;
};
Frame frame_of(const View& view) {
  const glm::vec3 ahead = glm::normalize(view.target - view.eye), right = glm::normalize(glm::cross(ahead, view.up));
  return {ahead, right, glm::cross(right, ahead), std::tan(glm::radians(view.fov_y_degrees) / 2)};
}

class DefaultViews : public testing::TestWithParam<float> {
 protected:
  const glm::vec3 centre{3, -2, 5};
  const float radius = GetParam();
  const std::vector<Object> objects{ball(centre, radius)};
  const BoundingSphere bounds = bounding_sphere(objects);
  const std::vector<View> views = default_views(objects);
};
INSTANTIATE_TEST_SUITE_P(Scale, DefaultViews, testing::Values(0.02f, 1.0f, 300.0f));

TEST_P(DefaultViews, BoundsAreTheBall) {
  EXPECT_LT(glm::distance(bounds.centre, centre), 0.01f * radius);
  EXPECT_NEAR(bounds.radius, radius, 0.01f * radius);
}

// A cone around the view's axis with half the field of view as its angle holds the sphere where sin(fov / 2) * distance >=
// radius; a picture at least as wide as high holds the cone.
TEST_P(DefaultViews, FrontAndThreeQuarterSeeTheWholeSphere) {
  ASSERT_EQ(views.size(), 3u);
  EXPECT_EQ(views[0].name, "front");
  EXPECT_EQ(views[1].name, "three_quarter");
  for (const View& view : {views[0], views[1]}) {
    const float distance = glm::distance(view.eye, bounds.centre);
    EXPECT_GE(distance * std::sin(glm::radians(view.fov_y_degrees) / 2), bounds.radius);
    EXPECT_LT(distance * std::sin(glm::radians(view.fov_y_degrees) / 2), 1.2f * bounds.radius)
        << "and fills the picture with it";
    EXPECT_EQ(view.target, bounds.centre);
  }
}

TEST_P(DefaultViews, GrazingIsOutsideAndSeesMuchEdgeOn) {
  const View& view = views[2];
  EXPECT_EQ(view.name, "grazing");
  EXPECT_GT(glm::distance(view.eye, centre), radius) << "outside";
  EXPECT_LT(glm::distance(view.eye, centre), 1.3f * radius) << "close to the surface";
  const Frame frame = frame_of(view);
  constexpr int size = 64;
  int covered = 0, edge_on = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const glm::vec2 ndc = (glm::vec2(x, y) + 0.5f) * (2.0f / size) - 1.0f;
      const glm::vec3 ray = glm::normalize(frame.ahead + frame.half_height * (ndc.x * frame.right - ndc.y * frame.up));
      const auto cosine = cosine_at_hit(view.eye, ray, centre, radius);
      covered += cosine.has_value();
      edge_on += cosine && *cosine < 0.5f;
    }
  EXPECT_GT(covered, size * size / 4);
  EXPECT_GT(edge_on, covered / 2) << "more than half of what it sees meets the surface at 30 degrees or less";
}

TEST_P(DefaultViews, NothingIsCutOffByNearOrFar) {
  size_t seen = 0;
  for (const View& view : views) {
    const Frame frame = frame_of(view);
    EXPECT_GT(view.near_m, 0.0f);
    EXPECT_LE(view.far_m / view.near_m, 500.0f) << "depth keeps its precision";
    for (const Vertex& vertex : objects[0].mesh.vertices) {
      const glm::vec3 from_eye = centre + radius * vertex.position - view.eye;
      const float depth = glm::dot(from_eye, frame.ahead);
      const float x = std::abs(glm::dot(from_eye, frame.right)), y = std::abs(glm::dot(from_eye, frame.up));
      const bool in_picture = depth > 0 && y <= depth * frame.half_height && x <= 2 * depth * frame.half_height;
      if (in_picture && glm::dot(vertex.position, -from_eye) > 0) {
        ++seen;
        EXPECT_GE(depth, view.near_m) << view.name;
      }
      EXPECT_LE(depth, view.far_m) << view.name;
    }
  }
  EXPECT_GT(seen, 0u) << "vertices before the near plane";
}

// Inverse squares: the rim light's irradiance at the centre is the same at every scale.
TEST_P(DefaultViews, LightsAreAsStrongAtAnyScale) {
  const std::vector<Light> lights = default_lights(bounds);
  ASSERT_EQ(lights.size(), 3u);
  for (const Light& light : lights) {
    if (light.kind == Light::Kind::directional) {
      EXPECT_NEAR(glm::length(light.direction), 1.0f, 1e-5f);
      continue;
    }
    const glm::vec3 offset = light.position - bounds.centre;
    EXPECT_GT(glm::length(offset), bounds.radius) << "outside";
    EXPECT_NEAR(light.radiance.r / glm::dot(offset, offset), 0.9f, 1e-3f);
  }
}

TEST(FitDepth, AnEyeInsideTheSphereKeepsAPositiveNearPlane) {
  View view;
  view.eye = {0.5f, 0, 0};
  fit_depth(view, {{0, 0, 0}, 1});
  EXPECT_FLOAT_EQ(view.near_m, 0.01f);
  EXPECT_GE(view.far_m, 1.5f);
}

TEST(BoundingSphere, RefusesScenesWithoutAFiniteSize) {
  Object object = ball({0, 0, 0}, 1);
  object.mesh.vertices[0].position = glm::vec3(3e38f, -3e38f, 0);
  expect_refused([&] { bounding_sphere({object}); }, {"bounds", "radius"});
  expect_refused([&] { bounding_sphere({}); }, {"bounds", "radius"});
}

}  // namespace
}  // namespace lamina
