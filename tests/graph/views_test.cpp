// SPDX-License-Identifier: Apache-2.0
// The matrices of views against what they promise, point by point.
#include "harness/graph/views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <random>

namespace lamina {
namespace {

View looking_at(glm::vec3 eye, glm::vec3 target) {
  View view;
  view.eye = eye, view.target = target;
  return view;
}
glm::vec4 clip(const ViewMatrices& matrices, glm::vec3 world) { return matrices.clip_from_world() * glm::vec4(world, 1); }
glm::vec3 place(const ViewMatrices& matrices, glm::vec3 world) {
  const glm::vec4 c = clip(matrices, world);
  return glm::vec3(c) / c.w;
}
bool in_picture(glm::vec4 c) { return c.w > 0 && std::abs(c.x) <= c.w && std::abs(c.y) <= c.w; }

std::vector<glm::vec3> random_points(size_t count, float low, float high) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> number(low, high);
  std::vector<glm::vec3> points(count);
  for (glm::vec3& p : points) p = {number(random), number(random), number(random)};
  return points;
}

// Every triangle is counter-clockwise in the picture (y down) exactly where its front faces the place it is seen from. Those
// seen edge on, where rounding decides, are left out.
void expect_winding_kept(const ViewMatrices& matrices, std::optional<glm::vec3> parallel = std::nullopt) {
  size_t seen = 0;
  const std::vector<glm::vec3> points = random_points(3000, -1, 1);
  for (size_t i = 0; i < points.size(); i += 3) {
    const glm::vec3 a = points[i], b = points[i + 1], c = points[i + 2];
    if (std::min({clip(matrices, a).w, clip(matrices, b).w, clip(matrices, c).w}) < 0.1f) continue;
    const float towards = glm::dot(glm::cross(b - a, c - a), parallel ? -*parallel : matrices.eye - a);
    if (std::abs(towards) < 0.01f) continue;
    const glm::vec3 p = place(matrices, a), q = place(matrices, b), r = place(matrices, c);
    const float area_y_down = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    EXPECT_EQ(area_y_down<0, towards> 0) << i;
    ++seen;
  }
  EXPECT_GT(seen, 500u);
}

TEST(EyeView, IsTheCamerasArithmeticToTheBit) {
  const std::vector<glm::vec3> points = random_points(20, -3, 3);
  for (size_t i = 0; i + 1 < points.size(); i += 2) {
    View view = looking_at(points[i], points[i + 1]);
    view.fov_y_degrees = 20 + 5 * float(i), view.near_m = 0.03f, view.far_m = 70 + float(i);
    glm::mat4 clip_from_view =
        glm::perspectiveRH_ZO(glm::radians(view.fov_y_degrees), 640.0f / 359.0f, view.near_m, view.far_m);
    clip_from_view[1] *= -1.0f;
    const ViewMatrices matrices = eye_view(view, 640, 359);
    EXPECT_EQ(matrices.clip_from_view, clip_from_view);
    EXPECT_EQ(matrices.view_from_world, glm::lookAtRH(view.eye, view.target, view.up));
    EXPECT_EQ(matrices.clip_from_world(), clip_from_view * glm::lookAtRH(view.eye, view.target, view.up));
    EXPECT_EQ(matrices.eye, view.eye);
  }
}

TEST(EyeView, SeesFrontsCounterClockwise) { expect_winding_kept(eye_view(looking_at({1, 2, 5}, {0, 0, 0}), 200, 100)); }

const BoundingSphere ball{{2, -1, 3}, 1.5f};
const glm::vec3 directions[] = {{0, -1, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}, {-0.5f, -0.7f, -0.6f}, {0.1f, -0.995f, 0.02f}};

Light sun(glm::vec3 direction) {
  Light light;
  light.direction = glm::normalize(direction);
  return light;
}
Light lamp(glm::vec3 position) {
  Light light;
  light.kind = Light::Kind::point;
  light.position = position;
  return light;
}
// Points of three great circles, in the planes of the view's axes, a twentieth of a degree apart.
std::vector<glm::vec3> on_sphere(const BoundingSphere& sphere, const ViewMatrices& matrices) {
  std::vector<glm::vec3> points;
  const glm::mat3 world_from_view = glm::transpose(glm::mat3(matrices.view_from_world));
  for (int plane = 0; plane < 3; ++plane)
    for (int i = 0; i < 7200; ++i) {
      const float angle = 2 * std::numbers::pi_v<float> * float(i) / 7200;
      glm::vec3 p(0);
      p[plane] = std::cos(angle), p[(plane + 1) % 3] = std::sin(angle);
      points.push_back(sphere.centre + sphere.radius * (world_from_view * p));
    }
  return points;
}
// The sphere fills the box of clip space: no point of it is outside, and it touches every side.
void expect_box_fits(const ViewMatrices& matrices, const BoundingSphere& sphere) {
  glm::vec3 low(INFINITY), high(-INFINITY);
  for (const glm::vec3 p : on_sphere(sphere, matrices)) {
    ASSERT_GT(clip(matrices, p).w, 0);
    low = glm::min(low, place(matrices, p)), high = glm::max(high, place(matrices, p));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const float least = axis == 2 ? 0 : -1;
    EXPECT_GE(low[axis], least);
    EXPECT_LE(high[axis], 1);
    EXPECT_NEAR(low[axis], least, 1e-4);
    EXPECT_NEAR(high[axis], 1, 1e-4);
  }
}

TEST(LightView, ADirectionalLightsBoxFitsTheSphere) {
  for (const glm::vec3 direction : directions) expect_box_fits(*light_view(sun(direction), ball), ball);
  const BoundingSphere small{{0.1f, 0, 0}, 0.003f}, large{{-50, 20, 0}, 900};
  expect_box_fits(*light_view(sun(directions[4]), small), small);
  expect_box_fits(*light_view(sun(directions[4]), large), large);
}

TEST(LightView, ADirectionalLightSeesAlongItsRays) {
  for (const glm::vec3 direction : directions) {
    const Light light = sun(direction);
    const ViewMatrices matrices = *light_view(light, ball);
    for (const glm::vec3 p : random_points(50, -2, 2)) {
      const glm::vec3 before = place(matrices, p), behind = place(matrices, p + 0.5f * light.direction);
      EXPECT_NEAR(before.x, behind.x, 1e-5);
      EXPECT_NEAR(before.y, behind.y, 1e-5);
      EXPECT_NEAR(behind.z - before.z, 0.5f / (2 * ball.radius), 1e-4) << "depth is even, and grows away from the light";
    }
    EXPECT_LT(glm::distance(matrices.eye, ball.centre - ball.radius * light.direction), 1e-5);
    expect_winding_kept(matrices, light.direction);
  }
}

TEST(LightView, AMapDoesNotTurnWithTheLight) {
  const glm::mat4 before = light_view(sun({0.3f, -0.8f, 0.1f}), ball)->clip_from_world();
  const glm::mat4 after = light_view(sun({0.3001f, -0.8f, 0.1f}), ball)->clip_from_world();
  for (int column = 0; column < 4; ++column) EXPECT_LT(glm::distance(before[column], after[column]), 1e-2);
}

const glm::vec3 lamps[] = {{2, 4, 3}, {2, -9, 3}, {5, 5, 5}, {3.6f, -1, 3}, {-400, 100, 20}};

// The cone's tangent circle touches the four sides; the sphere's nearest and furthest points are at depth 0 and 1.
TEST(LightView, APointLightsConeHoldsTheSphere) {
  for (const glm::vec3 position : lamps) {
    const ViewMatrices matrices = *light_view(lamp(position), ball);
    EXPECT_EQ(matrices.eye, position);
    const float distance = glm::distance(position, ball.centre);
    const float half_angle = std::asin(ball.radius / distance);
    const glm::mat3 world_from_view = glm::transpose(glm::mat3(matrices.view_from_world));
    for (const glm::vec2 side : {glm::vec2(1, 0), glm::vec2(-1, 0), glm::vec2(0, 1), glm::vec2(0, -1)}) {
      // From the light along the cone, as far as it touches.
      const float along = distance * std::cos(half_angle);
      const glm::vec3 ray(std::sin(half_angle) * side, -std::cos(half_angle));
      const glm::vec3 touched = position + along * (world_from_view * ray);
      EXPECT_NEAR(glm::distance(touched, ball.centre), ball.radius, 1e-3 * ball.radius);
      const glm::vec3 p = place(matrices, touched);
      EXPECT_NEAR(p.x, side.x, 2e-4);
      EXPECT_NEAR(p.y, -side.y, 2e-4);
    }
    const glm::vec3 away = (ball.centre - position) / distance;
    EXPECT_NEAR(place(matrices, ball.centre - ball.radius * away).z, 0, 1e-4 * distance);
    EXPECT_NEAR(place(matrices, ball.centre + ball.radius * away).z, 1, 1e-4);
    EXPECT_GT(place(matrices, ball.centre - ball.radius * away).z, -1e-5 * distance);
    expect_winding_kept(matrices);
  }
  expect_box_fits(*light_view(lamp({2, 4, 3}), ball), ball);
  expect_box_fits(*light_view(lamp({5, 5, 5}), ball), ball);
}

TEST(LightView, APointLightKeepsOrderOfDepth) {
  for (const glm::vec3 position : lamps) {
    const ViewMatrices matrices = *light_view(lamp(position), ball);
    for (const glm::vec3 p : random_points(100, -0.8f, 0.8f)) {
      const glm::vec3 inside = ball.centre + ball.radius * p / std::max(1.0f, 1.01f * glm::length(p));
      const glm::vec3 behind = inside + 0.05f * glm::normalize(inside - position);
      EXPECT_LT(place(matrices, inside).z, place(matrices, behind).z);
      EXPECT_NEAR(place(matrices, inside).x, place(matrices, behind).x, 2e-4);
    }
  }
}

TEST(LightView, NoneOfAPointLightInTheSphere) {
  EXPECT_FALSE(light_view(lamp(ball.centre), ball));
  EXPECT_FALSE(light_view(lamp({2, -1, 4.4f}), ball));
  EXPECT_FALSE(light_view(lamp({2, -1, 4.5f}), ball)) << "on it";
  EXPECT_TRUE(light_view(lamp({2, -1, 4.6f}), ball));
}

struct MirrorCase {
  View view;
  MirrorPlane mirror;
};
glm::vec3 unit(glm::vec3 v) { return glm::normalize(v); }
std::vector<MirrorCase> mirror_cases() {
  return {{looking_at({0, 2, 5}, {0, 0, 0}), {{0, 1, 0}, 0}},
          {looking_at({1, 3, 4}, {0, 0, 0}), {{0, 1, 0}, 0.25f}},
          {looking_at({1, 3, 4}, {0, 0, 0}), {unit({0.3f, 1, 0.2f}), -0.5f}},
          {looking_at({1, 0.4f, 4}, {0, 0, -1}), {unit({0, 1, 0.05f}), 0.1f}},
          {looking_at({0, -2, 5}, {0, 0, 0}), {{0, 1, 0}, 0}},  // from beneath
          {looking_at({4, 0.5f, 1}, {0, 0, 0}), {unit({-1, 0, 0.1f}), 0.2f}},
          {looking_at({-1, 1, 5}, {0, 0, 0}), {unit({1, 0, 0.1f}), -2}},
          {looking_at({1, 1, 5}, {0, 0, 0}), {unit({-1, 0, 0.1f}), -2}}};
}
float height_above(const MirrorPlane& mirror, glm::vec3 p) { return glm::dot(mirror.normal, p) - mirror.height; }
glm::vec3 image(const MirrorPlane& mirror, glm::vec3 p) { return p - 2 * height_above(mirror, p) * mirror.normal; }
// Above the face that the eye sees.
float height_before(const MirrorCase& c, glm::vec3 p) {
  return height_above(c.mirror, p) * (height_above(c.mirror, c.view.eye) < 0 ? -1.0f : 1.0f);
}

TEST(MirrorView, APointOfTheMirrorStandsWhereTheEyeSeesItTurnedLeftToRight) {
  for (const MirrorCase& c : mirror_cases()) {
    const ViewMatrices eye = eye_view(c.view, 200, 100), mirrored = mirror_view(c.view, 200, 100, c.mirror);
    for (const glm::vec3 p : random_points(100, -2, 2)) {
      const glm::vec3 on = p - height_above(c.mirror, p) * c.mirror.normal;
      const glm::vec4 e = clip(eye, on), m = clip(mirrored, on);
      EXPECT_NEAR(m.x, -e.x, 2e-5);
      EXPECT_NEAR(m.y, e.y, 2e-5);
      EXPECT_NEAR(m.w, e.w, 2e-5);
      EXPECT_NEAR(m.z, 0, 2e-5);
    }
  }
}

TEST(MirrorView, APointStandsWhereTheEyeSeesItsImage) {
  for (const MirrorCase& c : mirror_cases()) {
    const ViewMatrices eye = eye_view(c.view, 200, 100), mirrored = mirror_view(c.view, 200, 100, c.mirror);
    EXPECT_LT(glm::distance(mirrored.eye, image(c.mirror, c.view.eye)), 1e-5);
    for (const glm::vec3 p : random_points(100, -2, 2)) {
      const glm::vec4 e = clip(eye, image(c.mirror, p)), m = clip(mirrored, p);
      EXPECT_NEAR(m.x, -e.x, 2e-5);
      EXPECT_NEAR(m.y, e.y, 2e-5);
      EXPECT_NEAR(m.w, e.w, 2e-5);
    }
  }
}

TEST(MirrorView, NothingBehindTheMirrorIsDrawnAndAllBeforeItIs) {
  for (const MirrorCase& c : mirror_cases()) {
    const ViewMatrices mirrored = mirror_view(c.view, 200, 100, c.mirror);
    size_t drawn = 0;
    for (const glm::vec3 p : random_points(2000, -5, 5)) {
      const float height = height_before(c, p);
      const glm::vec4 m = clip(mirrored, p);
      if (height < -1e-4f) {
        EXPECT_LT(m.z, 0);
      }
      if (height < 1e-4f || !in_picture(m)) continue;
      EXPECT_GT(m.z, 0);
      EXPECT_LT(m.z, m.w) << "nothing is lost at the far plane";
      ++drawn;
    }
    EXPECT_GT(drawn, 20u);
  }
}

TEST(MirrorView, KeepsTheOrderOfDepth) {
  for (const MirrorCase& c : mirror_cases()) {
    const ViewMatrices mirrored = mirror_view(c.view, 200, 100, c.mirror);
    for (const glm::vec3 p : random_points(500, -2, 2)) {
      const glm::vec3 further = p + 0.3f * glm::normalize(p - mirrored.eye);
      if (clip(mirrored, p).w < 0.01f || clip(mirrored, further).w < 0.01f) continue;
      EXPECT_LT(place(mirrored, p).z, place(mirrored, further).z);
    }
  }
}

TEST(MirrorView, KeepsTheWindingOfTriangles) {
  for (const MirrorCase& c : mirror_cases()) expect_winding_kept(mirror_view(c.view, 200, 100, c.mirror));
}

// Depth reaches 1 at one corner of the far plane and passes it at none, so that none of its range is wasted.
TEST(MirrorView, UsesTheRangeOfDepth) {
  for (const MirrorCase& c : mirror_cases()) {
    const ViewMatrices mirrored = mirror_view(c.view, 200, 100, c.mirror);
    const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4(eye_view(c.view, 200, 100).clip_from_world()));
    float furthest = 0;
    for (const float x : {-1.0f, 1.0f})
      for (const float y : {-1.0f, 1.0f}) {
        const glm::dvec4 corner = world_from_clip * glm::dvec4(x, y, 1, 1);
        furthest = std::max(furthest, place(mirrored, image(c.mirror, glm::vec3(corner / corner.w))).z);
      }
    EXPECT_NEAR(furthest, 1, 1e-3);
  }
}

TEST(MirrorView, BothFacesReflect) {
  const View view = looking_at({1, 3, 4}, {0, 0, 0});
  const glm::vec3 normal = unit({0.3f, 1, 0.2f});
  const glm::mat4 one = mirror_view(view, 200, 100, {normal, 0.5f}).clip_from_world();
  const glm::mat4 other = mirror_view(view, 200, 100, {-normal, -0.5f}).clip_from_world();
  for (int column = 0; column < 4; ++column) EXPECT_LT(glm::distance(one[column], other[column]), 1e-5);
}

// Every ray from the eye leaves the mirror behind: the picture is empty.
TEST(MirrorView, AMirrorBehindTheEyeShowsNothing) {
  MirrorCase c{looking_at({0, 2, 0}, {0, 20, -1}), {{0, 1, 0}, 0}};
  c.view.far_m = 20;
  const ViewMatrices mirrored = mirror_view(c.view, 200, 100, c.mirror);
  for (const glm::vec3 p : random_points(2000, -90, 90)) {
    const glm::vec4 m = clip(mirrored, p);
    EXPECT_FALSE(in_picture(m) && m.z >= 0 && m.z <= m.w);
  }
}

TEST(MirrorView, AnEyeInTheMirrorSeesItsNormalsSide) {
  const MirrorCase c{looking_at({0, 0, 5}, {0, 0, 0}), {{0, 1, 0}, 0}};
  const ViewMatrices mirrored = mirror_view(c.view, 200, 100, c.mirror);
  const glm::vec3 above{0.1f, 0.5f, 0}, further{0.102f, 0.51f, -0.1f};
  EXPECT_GT(clip(mirrored, above).z, 0);
  EXPECT_LT(clip(mirrored, -above).z, 0);
  EXPECT_LT(place(mirrored, above).z, place(mirrored, further).z);
}

}  // namespace
}  // namespace lamina
