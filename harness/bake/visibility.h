// SPDX-License-Identifier: Apache-2.0
// Visibility by casting rays from every point, evenly over the hemisphere around its normal (no cosine). Kept as one bit a ray,
// set where the ray meets nothing, so that everything made of it uses the same rays.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "harness/bake/directions.h"
#include "harness/bake/occluders.h"
#include "harness/bake/surface_points.h"

namespace lamina {

using ProgressFunction = std::function<void(double fraction)>;

class Visibility {
 public:
  // `rays` a point, at least 1; `bias_m`: how far they start above the surface, along the normal. What is made depends on these
  // and the seed alone, not on threads.
  Visibility(std::span<const SurfacePoint> points, size_t rays, uint64_t seed);
  void cast(const Occluders& occluders, float bias_m, const ProgressFunction& progress);

  size_t points() const { return points_.size(); }
  size_t rays() const { return directions_.size(); }
  const DirectionSet& directions() const { return directions_; }  // around +z, shared by all points
  const SurfacePoint& point(size_t i) const { return points_[i]; }
  // World from the space of directions(), for a point that has a normal.
  glm::mat3 frame(size_t point) const { return turned_frame(points_[point].normal, seed_, point); }
  bool sees(size_t point, size_t ray) const { return (bits_[point * words_ + ray / 64] >> (ray % 64)) & 1; }

  // All points' bits, as they are kept on disk: ceil(rays / 64) words a point, unused bits 0.
  std::span<uint64_t> all_bits() { return bits_; }

 private:
  std::vector<SurfacePoint> points_;
  DirectionSet directions_;
  uint64_t seed_;
  size_t words_;
  std::vector<uint64_t> bits_;
};

}  // namespace lamina
