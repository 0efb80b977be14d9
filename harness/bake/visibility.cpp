// SPDX-License-Identifier: Apache-2.0
#include "harness/bake/visibility.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace lamina {
namespace {

constexpr size_t points_between_progress = 2048;

}  // namespace

Visibility::Visibility(std::span<const SurfacePoint> points, size_t rays, uint64_t seed)
    : points_(points.begin(), points.end()),
      directions_(uniform_cap(rays, 0)),
      seed_(seed),
      words_((rays + 63) / 64),
      bits_(points.size() * words_) {}

void Visibility::cast(const Occluders& occluders, float bias_m, const ProgressFunction& progress) {
  std::fill(bits_.begin(), bits_.end(), 0);
  const auto cast_point = [&](size_t p) {
    const SurfacePoint& point = points_[p];
    if (point.normal == glm::vec3(0)) return;
    const glm::mat3 world = frame(p);
    const glm::vec3 origin = point.position + point.normal * bias_m;
    uint64_t* bits = &bits_[p * words_];
    Occluders::Packet packet;
    packet.distance_m.fill(std::numeric_limits<float>::infinity());
    for (size_t first = 0; first < rays(); first += Occluders::packet) {
      const size_t count = std::min(Occluders::packet, rays() - first);
      for (int axis = 0; axis < 3; ++axis) {
        const float x = world[0][axis], y = world[1][axis], z = world[2][axis];
        for (size_t i = 0; i < count; ++i)
          packet.direction[axis][i] =
              x * directions_.x[first + i] + y * directions_.y[first + i] + z * directions_.z[first + i];
      }
      bits[first / 64] |= uint64_t{occluders.free_rays(origin, packet, count)} << (first % 64);
    }
  };
  for (size_t done = 0; done < points(); done += points_between_progress) {
    progress(static_cast<double>(done) / static_cast<double>(points()));
    const size_t end = std::min(points(), done + points_between_progress);
    tbb::parallel_for(tbb::blocked_range<size_t>(done, end, 16), [&](const tbb::blocked_range<size_t>& range) {
      for (size_t p = range.begin(); p < range.end(); ++p) cast_point(p);
    });
  }
}

}  // namespace lamina
