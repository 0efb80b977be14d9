// SPDX-License-Identifier: Apache-2.0
#include "harness/plan/seen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace lamina {
namespace {

// A box from -1 to 1 whose middle is at `place`.
Object box_at(glm::vec3 place, float half = 1) {
  Object object;
  for (const float x : {-half, half})
    for (const float y : {-half, half})
      for (const float z : {-half, half}) object.mesh.vertices.push_back({{x, y, z}, {}, {}, {}});
  object.world_from_object = glm::translate(glm::mat4(1), place);
  return object;
}

// From the origin along -z, 90 degrees high: |y| = -z is the upper and lower edge, |x| = -aspect z the sides.
View ahead() { return {"ahead", {0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 90, 1, 10}; }

// Just inside and just outside each of the six planes.
TEST(Seen, ABoxIsOutWhereItIsWhollyBeyondAPlane) {
  for (const float sign : {-1.0f, 1.0f}) {
    EXPECT_TRUE(may_be_seen(box_at({sign * 6.9f, 0, -5}), ahead(), 1));  // its far corners, at z = -6
    EXPECT_FALSE(may_be_seen(box_at({sign * 7.1f, 0, -5}), ahead(), 1));
    EXPECT_TRUE(may_be_seen(box_at({sign * 7.1f, 0, -5}), ahead(), 2)) << "a wider frame sees more";
    EXPECT_FALSE(may_be_seen(box_at({sign * 13.1f, 0, -5}), ahead(), 2));
    EXPECT_TRUE(may_be_seen(box_at({0, sign * 6.9f, -5}), ahead(), 2));
    EXPECT_FALSE(may_be_seen(box_at({0, sign * 7.1f, -5}), ahead(), 2));
  }
  EXPECT_TRUE(may_be_seen(box_at({0, 0, -10.9f}), ahead(), 1));
  EXPECT_FALSE(may_be_seen(box_at({0, 0, -11.1f}), ahead(), 1));
  EXPECT_TRUE(may_be_seen(box_at({0, 0, -0.1f}), ahead(), 1)) << "cut by the near plane";
  EXPECT_FALSE(may_be_seen(box_at({0, 0, 0.1f}), ahead(), 1)) << "between eye and near plane";
  EXPECT_FALSE(may_be_seen(box_at({0, 0, 5}), ahead(), 1)) << "behind";
}

TEST(Seen, ABoxAroundTheEyeOrTheWholeViewIsSeen) {
  EXPECT_TRUE(may_be_seen(box_at({0, 0, 0}, 3), ahead(), 1));
  EXPECT_TRUE(may_be_seen(box_at({0, 0, 0}, 300), ahead(), 1)) << "no corner is in the view";
  EXPECT_FALSE(may_be_seen(Object{}, ahead(), 1)) << "without a mesh there is nothing to see";
}

TEST(Seen, ObjectsAndViewsMayBeTurned) {
  View view{"turned", {100, 50, -30}, {100, 50, -20}, {1, 0, 0}, 60, 0.5f, 40};  // along +z, x is up
  const float edge = 20 * std::tan(glm::radians(30.0f));
  Object object = box_at({100 + edge, 50, -10}, 1);
  EXPECT_TRUE(may_be_seen(object, view, 1));
  object.world_from_object = glm::translate(glm::mat4(1), glm::vec3(100 + edge + 1.7f, 50, -10));
  EXPECT_FALSE(may_be_seen(object, view, 1));
  object.world_from_object = glm::scale(object.world_from_object, glm::vec3(3, 1, 1));
  EXPECT_TRUE(may_be_seen(object, view, 1)) << "its transform makes it longer";
}

}  // namespace
}  // namespace lamina
