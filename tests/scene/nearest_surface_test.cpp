// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/nearest_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/scene/default_views.h"
#include "tests/builtin_library.h"
#include "tests/scene/made_files.h"

namespace lamina {
namespace {

// A right triangle in the plane y = 0, from the world's middle to 2 m along x and to 2 m along z, moved up by `up_m`.
std::vector<Object> triangle(float up_m = 0) {
  Object object;
  for (const glm::vec3 at : {glm::vec3(0), glm::vec3(2, 0, 0), glm::vec3(0, 0, 2)})
    object.mesh.vertices.push_back({at, {0, 1, 0}, {1, 0, 0, 1}, {0, 0}});
  object.mesh.indices = {0, 2, 1};
  object.world_from_object[3] = glm::vec4(0, up_m, 0, 1);
  return {object};
}

View looking(glm::vec3 eye, glm::vec3 target) {
  View view;
  view.eye = eye, view.target = target;
  return view;
}

TEST(NearestSurface, IsThePlaneAnEdgeOrACorner) {
  const auto metres = [](glm::vec3 eye) { return nearest_surface_m(triangle(), looking(eye, {0.5f, 0, 0.5f})); };
  EXPECT_NEAR(metres({0.5f, 3, 0.5f}), 3, 1e-6) << "over it";
  EXPECT_NEAR(metres({0.5f, -3, 0.5f}), 3, 1e-6) << "under it";
  EXPECT_NEAR(metres({1, 3, -4}), 5, 1e-6) << "beside its edge";
  EXPECT_NEAR(metres({2, 0, 2}), std::sqrt(2), 1e-6) << "beside its longest edge";
  EXPECT_NEAR(metres({-1, 2, -2}), 3, 1e-6) << "beside its corner";
  EXPECT_NEAR(nearest_surface_m(triangle(2), looking({0.5f, 3, 0.5f}, {0, 0, 0})), 1, 1e-6) << "where the object is";
}

TEST(NearestSurface, WhatIsBehindTheEyeIsNotSeen) {
  EXPECT_EQ(nearest_surface_m(triangle(), looking({0.5f, 3, 0.5f}, {0.5f, 9, 0.5f})), INFINITY);
  EXPECT_EQ(nearest_surface_m({}, looking({0.5f, 3, 0.5f}, {0.5f, 9, 0.5f})), INFINITY);
}

// A view of a scene file from a metre over the sand of a bay of some hundred metres: the sand before it is not cut off.
TEST(NearestSurface, IsKeptInAWideScene) {
  const Folder folder;
  const std::string file =
      folder
          .write("bay.toml",
                 "[scene]\nbuiltin = \"beach\"\n[views.shore]\neye = [-1.5, 2.1, 5.5]\ntarget = [0.2, -0.2, -4.5]\n")
          .string();
  const Scene scene = load_scene(file, builtin_library());
  const View& view = scene.views.at(0);
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  ASSERT_GT(0.01f * bounds.radius, 2) << "a hundredth of the radius would cut it";
  EXPECT_LT(double(view.near_m), nearest_surface_m(scene.objects, view));
  EXPECT_GT(view.near_m, 0.2f);
  EXPECT_GT(double(view.near_m), 0.999e-5 * double(view.far_m));
}

// However near the eye is to a wall, depths stay apart.
TEST(NearestSurface, IsBounded) {
  View view = looking({0.5f, 1e-9f, 0.5f}, {0.5f, -1, 0.5f});
  view.near_m = 1, view.far_m = 500;
  keep_what_is_near(view, triangle());
  EXPECT_FLOAT_EQ(view.near_m, 0.005f);
  view = looking({0.5f, 100, 0.5f}, {0.5f, 0, 0.5f});
  view.near_m = 1, view.far_m = 500;
  keep_what_is_near(view, triangle());
  EXPECT_EQ(view.near_m, 1) << "nothing is nearer: it stays";
}

}  // namespace
}  // namespace lamina
