// SPDX-License-Identifier: Apache-2.0
#include "harness/bake/directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lamina {
namespace {

// Over a cap whose lowest cosine is c: mean z = (1 + c) / 2, mean z^2 = (1 + c + c^2) / 3, no mean to the sides.
TEST(Directions, CapIsUniform) {
  for (const double c : {0.0, 0.5, 0.99, -1.0}) {
    const DirectionSet set = uniform_cap(4096, c);
    double z = 0, z2 = 0, x = 0, y = 0;
    for (size_t i = 0; i < set.size(); ++i) {
      EXPECT_NEAR(glm::length(set[i]), 1, 1e-6);
      z += set.z[i], z2 += double(set.z[i]) * set.z[i], x += set.x[i], y += set.y[i];
    }
    EXPECT_NEAR(z / 4096, (1 + c) / 2, 1e-4);
    EXPECT_NEAR(z2 / 4096, (1 + c + c * c) / 3, 1e-4);
    EXPECT_NEAR(x / 4096, 0, 2e-3);
    EXPECT_NEAR(y / 4096, 0, 2e-3);
  }
}

// Weighed by its cosine, a hemisphere has mean cosine 2 / 3.
TEST(Directions, CosineHemisphere) {
  const DirectionSet set = cosine_hemisphere(4096);
  double z = 0, z2 = 0;
  for (size_t i = 0; i < set.size(); ++i) z += set.z[i], z2 += double(set.z[i]) * set.z[i];
  EXPECT_NEAR(z / 4096, 2.0 / 3, 1e-4);
  EXPECT_NEAR(z2 / 4096, 0.5, 1e-4);
}

TEST(Directions, FramesAreRotationsAroundTheAxis) {
  std::set<float> turns;
  for (uint64_t i = 0; i < 200; ++i) {
    const auto a = static_cast<float>(i);
    const glm::vec3 axis = i == 0   ? glm::vec3(0, 0, -1)
                           : i == 1 ? glm::vec3(0, 0, 1)
                                    : glm::normalize(glm::vec3(std::sin(a), std::cos(2 * a), std::sin(3 * a)));
    const glm::mat3 frame = turned_frame(axis, 7, i);
    EXPECT_NEAR(glm::determinant(frame), 1, 1e-5);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(glm::length(frame[k]), 1, 1e-5);
    EXPECT_EQ(frame[2], axis);
    EXPECT_NEAR(glm::dot(frame[0], frame[1]), 0, 1e-5);
    EXPECT_EQ(frame, turned_frame(axis, 7, i)) << "the same every time";
    turns.insert(turned_frame({0, 1, 0}, 7, i)[0].x);
  }
  EXPECT_GT(turns.size(), 195u) << "points are turned differently";
  EXPECT_NE(turned_frame({0, 1, 0}, 7, 1), turned_frame({0, 1, 0}, 8, 1));
}

TEST(Directions, TouchingOnesAreTheNearest) {
  const DirectionSet set = uniform_cap(500, 0);
  const auto touching = touching_directions(set, 6);
  for (uint32_t i = 0; i < set.size(); i += 37) {
    std::vector<std::pair<float, uint32_t>> all;
    for (uint32_t j = 0; j < set.size(); ++j)
      if (j != i) all.emplace_back(glm::length(set[i] - set[j]), j);
    std::sort(all.begin(), all.end());
    ASSERT_GE(touching[i].size(), 3u);
    for (size_t k = 0; k < touching[i].size(); ++k)
      EXPECT_FLOAT_EQ(glm::length(set[i] - set[touching[i][k]]), all[k].first) << i;
  }
}

}  // namespace
}  // namespace lamina
