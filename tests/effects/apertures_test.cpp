// SPDX-License-Identifier: Apache-2.0
// Apertures of places whose visible directions are known in closed form.
#include <gtest/gtest.h>

#include "harness/bake/surface_points.h"
#include "harness/core/error.h"
#include "tests/effects/made_scenes.h"

namespace lamina {
namespace {

Aperture aperture(const Scene& scene, ApertureKind kind = {}, size_t point = 0) {
  Bakes bakes(scene, effect_code(), DiskCache(""));
  return vertex_apertures(bakes, 0, kind)[point * kind.count];
}

float angle(glm::vec3 a, glm::vec3 b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

TEST(Apertures, OpenSkyIsTheHemisphereAroundTheNormal) {
  Scene scene = scene_of({receiver()});
  EXPECT_FLOAT_EQ(aperture(scene).w, pi_f / 2);
  EXPECT_LT(angle(aperture(scene), {0, 1, 0}), 2e-3f);
  scene.objects[0].world_from_object =
      glm::mat4(glm::vec4(0, 0, 1, 0), glm::vec4(0, -1, 0, 0), glm::vec4(1, 0, 0, 0), glm::vec4(3, 4, 5, 1));
  EXPECT_LT(angle(aperture(scene), {0, -1, 0}), 2e-3f) << "the normal turns with the object";
}

// A disc of radius r at height h blocks a cap of the angular radius arc tangent of r / h; a hole shows it.
TEST(Apertures, HoleInALidIsItsCap) {
  for (const float radius : {0.3f, 0.6f, 1.0f, 1.4f}) {
    const Scene scene = scene_of({receiver(), ring("lid", std::tan(radius), 1, 500, 1)});
    EXPECT_NEAR(aperture(scene).w, radius, 0.02f) << radius;
    EXPECT_LT(angle(aperture(scene), {0, 1, 0}), 0.02f);
  }
}

TEST(Apertures, WhatBlocksNoLightHidesNothing) {
  Scene scene = scene_of({receiver(), ring("lid", 0, 1, 500, 1)});
  EXPECT_LT(aperture(scene).w, 0.1f) << "nearly all of the sky is hidden";
  scene.objects[1].blocks_light = false;
  EXPECT_FLOAT_EQ(aperture(scene).w, pi_f / 2);
}

TEST(Apertures, AntiApertureIsTheCapOfADisc) {
  for (const float radius : {0.3f, 0.6f, 1.0f}) {
    const Scene scene = scene_of({receiver(), ring("disc", 0, 1, std::tan(radius), 1)});
    EXPECT_NEAR(aperture(scene, {1, true}).w, radius, 0.02f) << radius;
    EXPECT_LT(angle(aperture(scene, {1, true}), {0, 1, 0}), 0.02f);
    // What is left is a band around it, whose area makes the one aperture: 1 - cos r = cos radius.
    EXPECT_NEAR(aperture(scene).w, std::acos(1 - std::cos(radius)), 0.02f);
  }
}

TEST(Apertures, WallLeavesHalfTheHemisphereAndLooksAway) {
  const Scene scene =
      scene_of({receiver(), quad("wall", {-0.01f, -500, -500}, {-0.01f, 500, -500}, {-0.01f, 500, 500}, {-0.01f, -500, 500})});
  const Aperture seen = aperture(scene);
  EXPECT_NEAR(seen.w, pi_f / 3, 0.02f);  // area pi
  EXPECT_LT(angle(seen, glm::normalize(glm::vec3(1, 1, 0))), 0.02f);
}

// Two square windows in a closed box: each is a region of its own, with the solid angle of Oosterom and Strackee's triangles.
TEST(Apertures, TwoWindowsAreTwoRegions) {
  const auto slab = [](std::string name, float x) {  // a wall at x with a window, y 0.4..0.8, z -0.2..0.2
    Object wall = quad(std::move(name), {x, -1, -9}, {x, -1, 9}, {x, 0.4f, 9}, {x, 0.4f, -9});
    for (const Object& part : {quad("", {x, 0.8f, -9}, {x, 0.8f, 9}, {x, 9, 9}, {x, 9, -9}),
                               quad("", {x, 0.4f, -9}, {x, 0.8f, -9}, {x, 0.8f, -0.2f}, {x, 0.4f, -0.2f}),
                               quad("", {x, 0.4f, 0.2f}, {x, 0.8f, 0.2f}, {x, 0.8f, 9}, {x, 0.4f, 9})}) {
      const auto first = static_cast<uint32_t>(wall.mesh.vertices.size());
      wall.mesh.vertices.insert(wall.mesh.vertices.end(), part.mesh.vertices.begin(), part.mesh.vertices.end());
      for (const uint32_t index : part.mesh.indices) wall.mesh.indices.push_back(first + index);
    }
    return wall;
  };
  Scene scene =
      scene_of({receiver(), slab("left", -1), slab("right", 1), quad("lid", {-1, 9, -9}, {1, 9, -9}, {1, 9, 9}, {-1, 9, 9}),
                quad("back", {-1, -1, -9}, {1, -1, -9}, {1, 9, -9}, {-1, 9, -9}),
                quad("front", {-1, -1, 9}, {1, -1, 9}, {1, 9, 9}, {-1, 9, 9})});
  apertures_of(scene.objects[0]).numbers["rays"] = 8192;
  const auto solid_angle = [](glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    return 2 * std::atan2(std::abs(glm::dot(a, glm::cross(b, c))),
                          la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
  };
  const double area =
      solid_angle({1, 0.4, -0.2}, {1, 0.8, -0.2}, {1, 0.8, 0.2}) + solid_angle({1, 0.4, -0.2}, {1, 0.8, 0.2}, {1, 0.4, 0.2});
  Bakes bakes(scene, effect_code(), DiskCache(""));
  const std::vector<Aperture> two = vertex_apertures(bakes, 0, {2, false});
  const float x0 = two[0].x, x1 = two[1].x;
  EXPECT_LT(x0 * x1, 0) << "one to each side";
  for (const Aperture& window : {two[0], two[1]}) {
    EXPECT_NEAR(window.w, cap_radius(area), 0.03 * cap_radius(area));
    EXPECT_LT(angle(window, glm::normalize(glm::vec3(window.x > 0 ? 1 : -1, 0.58f, 0))), 0.03f);
  }
  const std::vector<Aperture> four = vertex_apertures(bakes, 0, {4, false});
  EXPECT_EQ((four[0].w > 0) + (four[1].w > 0) + (four[2].w > 0) + (four[3].w > 0), 2) << "there are no more regions";
  // One aperture has both areas and looks up between them.
  EXPECT_NEAR(vertex_apertures(bakes, 0)[0].w, cap_radius(2 * area), 0.03 * cap_radius(2 * area));
  EXPECT_LT(angle(vertex_apertures(bakes, 0)[0], {0, 1, 0}), 0.05f);
  // The three points of the receiver agree which is which, so that what lies between them may be interpolated.
  for (size_t point = 1; point < 3; ++point) EXPECT_GT(two[point * 2].x * x0, 0) << point;
}

// Spherical harmonics of a cap of radius r along z: c0 = sqrt(pi) (1 - cos r), c2 = sqrt(3 pi) / 2 sin^2 r.
TEST(Apertures, HarmonicsOfACap) {
  const double radius = 0.8;
  const Scene scene = scene_of({receiver(), ring("lid", static_cast<float>(std::tan(radius)), 1, 500, 1)});
  Scene fine = scene;
  apertures_of(fine.objects[0]).numbers["rays"] = 16384;
  Bakes bakes(fine, effect_code(), DiskCache(""));
  Visibility visibility(vertex_points(fine.objects[0]).points, 16384, 1);
  visibility.cast(bakes.occluders(), 1e-4f, [](double) {});
  const Harmonics c = project_visibility(visibility, 0);
  EXPECT_NEAR(c[0], std::sqrt(std::numbers::pi) * (1 - std::cos(radius)), 0.01);
  EXPECT_NEAR(c[1], std::sqrt(3 * std::numbers::pi) / 2 * std::sin(radius) * std::sin(radius), 0.01);  // y is up
  EXPECT_NEAR(c[2], 0, 0.01);
  EXPECT_NEAR(c[3], 0, 0.01);
  EXPECT_NEAR(aperture_of(c, {0, 1, 0}).w, radius, 0.01);
  apertures_of(fine.objects[0]).words["baker"] = "spherical_harmonics";
  EXPECT_NEAR(aperture(fine).w, radius, 0.01);
  EXPECT_LT(angle(aperture(fine), {0, 1, 0}), 0.01f);
}

TEST(Apertures, RadiusOfACapHasItsArea) {
  for (const double radius : {1e-6, 1e-3, 0.5, 1.5, 3.0})
    EXPECT_NEAR(cap_radius(4 * std::numbers::pi * std::pow(std::sin(radius / 2), 2)), radius, 1e-12 * (1 + radius)) << radius;
  EXPECT_EQ(cap_radius(0), 0);
  EXPECT_EQ(cap_radius(-1), 0);
}

TEST(Apertures, ClosedBoxSeesNothing) {
  const Scene scene = scene_of({receiver(), ring("lid", 0, 1, 2, 1), ring("side", 2, 1, 2, -1)});
  EXPECT_EQ(aperture(scene), Aperture(0, 1, 0, 0));
  EXPECT_NEAR(aperture(scene, {1, true}).w, pi_f / 2, 1e-3f);
  EXPECT_EQ(aperture(scene, {2, false}), Aperture(0, 1, 0, 0));
}

// What a mesh may bring: normals without length, triangles without area, vertices that no triangle uses, no triangles at all.
TEST(Apertures, BrokenMeshesHaveDefinedApertures) {
  Object broken = object_of("broken",
                            {vertex_at({0, 0, 0}, {0, 0, 0}), vertex_at({0, 0, 1}, {0, 0, 0}), vertex_at({1, 0, 0}, {0, 0, 0}),
                             vertex_at({5, 5, 5}, {0, 0, 0}), vertex_at({6, 6, 6})},
                            {0, 1, 2, 1, 1, 1});
  apertures_of(broken);
  Object empty = object_of("empty", {}, {});
  apertures_of(empty);
  const Scene scene = scene_of({broken, empty});
  Bakes bakes(scene, effect_code(), DiskCache(""));
  for (const ApertureKind kind : {ApertureKind{1, false}, ApertureKind{3, false}, ApertureKind{1, true}}) {
    const std::vector<Aperture> all = vertex_apertures(bakes, 0, kind);
    ASSERT_EQ(all.size(), 5 * kind.count);
    for (const Aperture& one : all) {
      EXPECT_NEAR(glm::length(glm::vec3(one)), 1, 1e-5f);
      EXPECT_TRUE(one.w >= 0 && one.w <= pi_f / 2 + 1e-4f) << one.w;
    }
    EXPECT_TRUE(vertex_apertures(bakes, 1, kind).empty());
  }
  EXPECT_FLOAT_EQ(vertex_apertures(bakes, 0)[0].w, pi_f / 2) << "the triangle's own normal is up";
  EXPECT_EQ(vertex_apertures(bakes, 0)[3].w, 0) << "no triangle, no normal: sees nothing";
  EXPECT_FLOAT_EQ(vertex_apertures(bakes, 0)[4].w, pi_f / 2) << "has a normal";
}

TEST(Apertures, MapHasATexelsOwnPointOrTheNearest) {
  Object floor = object_of(
      "floor", {vertex_at({-1, 0, -1}), vertex_at({1, 0, -1}), vertex_at({1, 0, 1}), vertex_at({-1, 0, 1})}, {0, 2, 1});
  apertures_of(floor).numbers["map_texels"] = 16;
  apertures_of(floor).numbers["rays"] = 256;
  // A wall to the left of x = 0: the left half of the map is blocked to its left, more so near the wall.
  const Scene scene = scene_of({floor, quad("roof", {-9, 0.5f, -9}, {0, 0.5f, -9}, {0, 0.5f, 9}, {-9, 0.5f, 9})});
  Bakes bakes(scene, effect_code(), DiskCache(""));
  const std::vector<Aperture> map = map_apertures(bakes, 0);
  ASSERT_EQ(map.size(), 256u);
  EXPECT_EQ(bakes.stats().at(0).points, 136u) << "half a square with its diagonal, a left edge";
  EXPECT_LT(map[2 * 16 + 4].w, map[2 * 16 + 13].w) << "under the roof less is seen";
  EXPECT_EQ(map[15 * 16], map[15 * 16 + 0]);
  for (const Aperture& texel : map) EXPECT_GT(texel.w, 0) << "texels without a point have their neighbour's";
  Scene doubled = scene;
  doubled.objects[0].unwrap_problem = "texture coordinates overlap";
  Bakes refused(doubled, effect_code(), DiskCache(""));
  EXPECT_THROW(map_apertures(refused, 0), Error);
}

TEST(Apertures, MapsDoNotSpreadAroundTheirBorders) {
  constexpr uint32_t side = 16;
  const Object right = quad("right half", {0, 0, -1}, {0, 0, 1}, {1, 0, 1}, {1, 0, -1});
  const std::vector<uint32_t> point = map_points(right, side).point_of_texel;
  const Object left = quad("left half", {-1, 0, -1}, {-1, 0, 1}, {0, 0, 1}, {0, 0, -1});
  const std::vector<uint32_t> mirrored = map_points(left, side).point_of_texel;
  for (uint32_t y = 0; y < side; ++y) {
    EXPECT_EQ(point[y * side], point[y * side + side / 2]) << "row " << y << ": the nearest point lies in the row";
    EXPECT_EQ(mirrored[y * side + side - 1], mirrored[y * side + side / 2 - 1]) << "row " << y;
  }
}

}  // namespace
}  // namespace lamina
