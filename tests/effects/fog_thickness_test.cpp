// SPDX-License-Identifier: Apache-2.0
// Thickness of fog against closed forms, on every backend. Spheres are made of triangles, so theirs lies between two spheres'.
#include <gtest/gtest.h>

#include "harness/effects/volume_fog/fog_lengths.h"
#include "harness/effects/volume_fog/hull_shapes.h"
#include "harness/scene/made/block_mesh.h"
#include "tests/effects/fog_cases.h"

namespace lamina {
namespace {

double chord(double radius, double offset) { return radius > offset ? 2 * std::sqrt(radius * radius - offset * offset) : 0; }

Object cube_of_fog(float low, float high) { return fog_box("cube", glm::vec3(low), glm::vec3(high), 1); }

// From 5 m away, `degrees` off the axis.
void add_off_axis(FogCases& cases, double degrees) {
  const double offset = 5 * std::sin(glm::radians(degrees));
  const glm::vec3 target(5 * std::tan(glm::radians(degrees)), 0, 0);
  cases.add("off axis", {sphere_of_fog(1, {0, 0, 0})}, {0, 0, 5}, target, chord(1 - sphere_sagitta, offset), chord(1, offset));
}

const FogCases& closed_forms() {
  static const FogCases made = [] {
    FogCases cases;
    const auto nested = [] { return std::vector<Object>{sphere_of_fog(2, {0, 0, 0}), sphere_of_fog(1, {0, 0, 0})}; };
    const auto with_wall = [](std::vector<Object> objects, float distance) {
      objects.push_back(wall(5 - distance));
      return objects;
    };
    const double s = sphere_sagitta;
    cases.add("cube along an axis", {cube_of_fog(-0.5f, 0.5f)}, {0, 0, 3}, {0, 0, 0}, 1);
    cases.add("cube through a diagonal", {cube_of_fog(-0.5f, 0.5f)}, {2, 2, 2}, {0, 0, 0}, std::sqrt(3.0));
    cases.add("a cube of 2 in a cube of 4", {cube_of_fog(-1, 1), cube_of_fog(-2, 2)}, {0, 0, 5}, {0, 0, 0}, 6);
    for (const double y : {0.0, 0.5, 0.8, 0.9})
      cases.add("two spheres", {sphere_of_fog(1, {0, 0, -0.5f}), sphere_of_fog(1, {0, 0, 0.5f})}, {0, y, 5}, {0, y, 0},
                2 * chord(1 - s, y), 2 * chord(1, y));
    for (const double degrees : {5.0, 10.0, 11.0, 11.6}) add_off_axis(cases, degrees);
    for (const float distance : {3.0f, 5.0f, 7.0f}) {
      const double inside = std::clamp(distance - 4.0, 0.0, 2.0);
      cases.add("a sphere before a wall", with_wall({sphere_of_fog(1, {0, 0, 0})}, distance), {0, 0, 5}, {0, 0, 0},
                inside - 2 * s, inside);
    }
    const std::pair<float, double> nested_walls[] = {{2, 0}, {3.5f, 0.5}, {4.5f, 2}, {5, 3}, {5.5f, 4}, {6.5f, 5.5}, {8, 6}};
    for (const auto& [distance, metres] : nested_walls)
      cases.add("nested spheres before a wall", with_wall(nested(), distance), {0, 0, 5}, {0, 0, 0}, metres - 6 * s, metres);
    for (const double offset : {0.0, 0.4, 0.79}) {
      const double least = chord(1 - s, offset) - chord(0.8, offset), most = chord(1, offset) - chord(0.8 * (1 - s), offset);
      cases.add("a shell", {sphere_of_fog(1, {0, 0, 0}), sphere_of_fog(0.8f, {0, 0, 0}, 1, true)}, {offset, 0, 5},
                {offset, 0, 0}, least, most);
    }
    cases.add("touching boxes", {fog_box("near", {-1, -1, 0}, {1, 1, 1}, 1), fog_box("far", {-1, -1, -1}, {1, 1, 0}, 1)},
              {0.3f, 0.2f, 3}, {0.3f, 0.2f, 0}, 2);
    return cases;
  }();
  return made;
}

class FogThickness : public FogOnEachBackend {};

// At most 1e-4 of the hull's depth and 5e-6 of the distance.
double allowed(double metres, double distance_m) { return 1e-4 * metres + 5e-6 * distance_m; }

TEST_P(FogThickness, FloatSumAgreesWithClosedForms) {
  const std::vector<Thickness> found = thickness(closed_forms().scene(), "float_sum");
  for (size_t i = 0; i < found.size(); ++i) {
    const FogCase& expected = closed_forms().cases()[i];
    SCOPED_TRACE(fmt::format("{} ({})", expected.name, i));
    EXPECT_GE(found[i].middle_m(), expected.min_m - allowed(expected.max_m, expected.distance_m));
    EXPECT_LE(found[i].middle_m(), expected.max_m + allowed(expected.max_m, expected.distance_m));
  }
}

TEST(FogTracer, RaysAgreeWithClosedForms) {
  const Scene& scene = closed_forms().scene();
  const FogTracer tracer(scene);
  for (size_t i = 0; i < scene.views.size(); ++i) {
    const FogCase& expected = closed_forms().cases()[i];
    SCOPED_TRACE(fmt::format("{} ({})", expected.name, i));
    const double metres = tracer.lengths_m(scene.views[i], 1, 1)[0];
    EXPECT_GE(metres, expected.min_m - 2e-6 * expected.distance_m);
    EXPECT_LE(metres, expected.max_m + 2e-6 * expected.distance_m);
  }
}

// From the middle of a sphere every direction has its radius of fog, and from within a box cut by the near plane no more is
// missing than that plane's distance.
TEST_P(FogThickness, TheEyeInAHull) {
  FogCases cases;
  cases.add("in a sphere", {sphere_of_fog(1, {0, 0, 0})}, {0, 0, 0}, {0.3f, 0.5f, -1}, 1, 1);
  cases.add("a box from 5 cm on", {fog_box("box", {-1, -1, -2}, {1, 1, -0.05f}, 1)}, {0, 0, 0}, {0, 0, -1}, 1.95, 1.95);
  const std::vector<Thickness> found = thickness(cases.scene(), "float_sum");
  for (const double metres : found[0].own_m) {
    ASSERT_LE(metres, 1 + 5e-6);
    ASSERT_GE(metres, 1 - sphere_sagitta - 1e-4);
  }
  EXPECT_GE(found[1].middle_m(), 1.95 - 1e-4) << "the front face is cut away";
  EXPECT_LE(found[1].middle_m(), 1.95 + 0.1);
}

// The same box as fog and as a hole: exactly nothing. A hole of half the share: half. Two that touch: as one, to the last bits.
TEST_P(FogThickness, EqualFacesCancelExactly) {
  FogCases cases;
  const glm::vec3 low(-0.7f, -0.9f, -0.8f), high(0.6f, 0.8f, 0.9f);
  cases.add("nothing", {fog_box("fog", low, high, 1), fog_box("hole", low, high, 1, true)}, {1, 2, 5}, {0, 0, 0}, 0);
  cases.add("half", {fog_box("fog", low, high, 1), fog_box("hole", low, high, 0.5f, true)}, {0, 0, 5}, {0, 0, 0}, 0.85);
  const std::vector<Thickness> found = thickness(cases.scene(), "float_sum");
  for (const double metres : found[0].own_m) ASSERT_EQ(metres, 0);
  EXPECT_NEAR(found[1].middle_m(), 0.85, 1e-4);
}

// Two nested hulls, two that cross, and a hole, around a solid ball.
Scene around_a_ball() {
  Scene scene;
  scene.name = scene.source = "fog around a ball";
  scene.objects.push_back(coloured_object("ball", sphere_mesh(17), {0.5f, 0.4f, 0.3f}, false));
  scene.objects.push_back(fog_ball("outer", {0, 0.35f, 0}, {2.0f, 1.8f, 1.9f}, 0.25f));
  scene.objects.push_back(fog_ball("inner", {-0.1f, 0.1f, 0.1f}, {1.4f, 1.1f, 1.4f}, 0.4f));
  scene.objects.push_back(fog_ball("left", {0, -0.72f, 0}, {2.6f, 0.5f, 0.8f}, 1, 35));
  scene.objects.push_back(fog_ball("right", {0, -0.68f, 0}, {2.6f, 0.5f, 0.8f}, 1, -35));
  scene.objects.push_back(fog_box("shaft", {0.5f, -2, -0.2f}, {0.9f, 3, 3}, 0.25f, true));
  scene.views = {{"front", {0.5f, 1.3f, 5.6f}, {0.06f, 0.27f, 0}, {0, 1, 0}, 40, 0.1f, 12}};
  set_fog(scene, 0.9f, {0.3f, 0.36f, 0.42f});
  return settled(std::move(scene));
}

// Everywhere but at silhouettes.
TEST_P(FogThickness, FloatSumAgreesWithRaysOnAScene) {
  constexpr uint32_t size = 64;
  const Scene scene = around_a_ball();
  const std::vector<double> drawn = thickness(scene, "float_sum", size)[0].own_m;
  const std::vector<double> rays = FogTracer(scene).lengths_m(scene.views[0], size, size);
  size_t with_fog = 0, off = 0;
  for (size_t y = 1; y + 1 < size; ++y)
    for (size_t x = 1; x + 1 < size; ++x) {
      const size_t pixel = y * size + x;
      with_fog += rays[pixel] > 0;
      const double metres = std::max(drawn[pixel], 0.0);  // the hole sticks out
      if (std::abs(metres - rays[pixel]) <= allowed(rays[pixel], 6)) continue;
      ++off;
      double least = rays[pixel], most = least;
      for (const size_t beside : {pixel - size - 1, pixel - size, pixel - size + 1, pixel - 1, pixel + 1, pixel + size - 1,
                                  pixel + size, pixel + size + 1})
        least = std::min(least, rays[beside]), most = std::max(most, rays[beside]);
      EXPECT_GT(most - least, 0.02) << x << " " << y << ": " << metres << " for " << rays[pixel];
    }
  EXPECT_GT(with_fog, size * size / 2);
  EXPECT_LT(off, size * size / 100);
}

// With true spheres in place of polygons the closed forms hold without a tessellation's share; from within too.
TEST_P(FogThickness, AnalyticHullsAgreeWithClosedForms) {
  FogCases cases;
  for (const double offset : {0.0, 0.4, 0.8, 0.95})
    cases.add("a sphere", {sphere_of_fog(1, {0, 0, 0})}, {offset, 0, 5}, {offset, 0, 0}, chord(1, offset));
  cases.add("a sphere before a wall", {sphere_of_fog(1, {0, 0, 0}), wall(0)}, {0, 0, 5}, {0, 0, 0}, 1);
  cases.add("a box, and a hole in it", {fog_box("fog", {-1, -1, -1}, {1, 1, 1}, 1), sphere_of_fog(0.5f, {0, 0, 0}, 0.5f, true)},
            {0, 0, 5}, {0, 0, 0}, 1.5);
  cases.add("in a sphere", {sphere_of_fog(1, {0, 0, 0})}, {0, 0, 0.5f}, {0, 0, -1}, 1.5);
  const std::vector<Thickness> found = thickness(cases.scene(), "analytic");
  ASSERT_EQ(found.size(), cases.cases().size());
  for (size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i].middle_m(), cases.cases()[i].max_m, 3e-5) << cases.cases()[i].name << " " << i;
}

// Both meshes as one; the second turned inside out where it is said.
Mesh joined(Mesh mesh, const Mesh& other, bool inside_out) {
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (size_t i = 0; i < other.indices.size(); i += 3)
    for (const size_t corner : {i, i + (inside_out ? 2 : 1), i + (inside_out ? 1 : 2)})
      mesh.indices.push_back(first + other.indices[corner]);
  return mesh;
}

TEST(HullShapes, AreToldFromOtherMeshes) {
  EXPECT_EQ(hull_shape(sphere_mesh(9)), HullShape::ellipsoid);
  EXPECT_EQ(hull_shape(block_mesh({{{-1, 2, 3}, {4, 5, 6}}}, 0.7f)), HullShape::box);
  EXPECT_EQ(hull_shape(block_mesh({{{0, 0, 0}, {2, 2, 2}}, {{0, 0, 0}, {1, 1, 1}, false}}, 5)), HullShape::any)
      << "a corner out";
  EXPECT_EQ(hull_shape(block_mesh({{{0, 0, 0}, {3, 3, 3}}, {{1, 1, 1}, {2, 2, 2}, false}}, 5)), HullShape::any) << "a shell";
  const Mesh box = block_mesh({{{-1, -1, -1}, {1, 1, 1}}}, 5), inner = block_mesh({{{0, 0, 0}, {0.5f, 0.5f, 0.5f}}}, 5);
  EXPECT_EQ(hull_shape(joined(box, box, false)), HullShape::any) << "twice the same box: fog of twice the density";
  EXPECT_EQ(hull_shape(joined(joined(box, inner, false), inner, true)), HullShape::any) << "more than a box, of its volume";
  Mesh dented = sphere_mesh(9);
  dented.vertices[40].position *= 0.999f;
  EXPECT_EQ(hull_shape(dented), HullShape::any);
  Mesh turned = sphere_mesh(9);
  std::swap(turned.indices[0], turned.indices[1]);
  for (size_t i = 3; i < turned.indices.size(); i += 3) std::swap(turned.indices[i], turned.indices[i + 1]);
  EXPECT_EQ(hull_shape(turned), HullShape::any) << "inside out";
}

INSTANTIATE_TEST_SUITE_P(Backends, FogThickness, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
