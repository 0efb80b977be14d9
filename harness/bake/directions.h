// SPDX-License-Identifier: Apache-2.0
// Directions spread evenly over parts of the sphere, a set for all points, turned about each point's axis so that neighbours do
// not share a pattern.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace lamina {

// Unit vectors around +z.
struct DirectionSet {
  std::vector<float> x, y, z;
  size_t size() const { return x.size(); }
  glm::vec3 operator[](size_t i) const { return {x[i], y[i], z[i]}; }
};

// `count` directions uniform over the cap around +z whose lowest direction has this cosine (0: the hemisphere), each standing
// for the same solid angle: a spiral of golden angles (Swinbank and Purser, "Fibonacci Grids", 2006), in an order that keeps
// neighbours together.
DirectionSet uniform_cap(size_t count, double lowest_cosine);
// The same over the hemisphere, each standing for the same share of the integral of the cosine to +z.
DirectionSet cosine_hemisphere(size_t count);

// World from tangent space: columns x, y, z, where z is the unit `axis`, turned about it by an angle that follows from the seed
// and the index of the point.
glm::mat3 turned_frame(glm::vec3 axis, uint64_t seed, uint64_t index);

// For each direction its nearest others, at most `most`, by index: which directions touch.
std::vector<std::vector<uint32_t>> touching_directions(const DirectionSet& set, size_t most = 6);

}  // namespace lamina
