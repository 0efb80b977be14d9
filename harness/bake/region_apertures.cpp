// SPDX-License-Identifier: Apache-2.0
// Contiguous regions of visibility: directions that touch and are both seen belong together (union-find; Tarjan 1975). Then
// each point's regions are put in the order of a neighbour's, walking over the surface.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "harness/bake/apertures.h"

namespace lamina {
namespace {

// A region of fewer rays than this share is noise of a boundary.
constexpr double least_share = 0.004;

struct Region {
  size_t rays = 0;
  glm::dvec3 sum{0};  // of the directions, tangent space
};

uint32_t root_of(std::vector<uint32_t>& parent, uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

// At most `count` regions, the largest first; the rest is added to the nearest of them.
std::vector<Region> regions_of(const Visibility& visibility, size_t point, size_t count,
                               const std::vector<std::vector<uint32_t>>& touching) {
  const auto rays = static_cast<uint32_t>(visibility.rays());
  std::vector<uint32_t> parent(rays);
  std::iota(parent.begin(), parent.end(), 0u);
  for (uint32_t ray = 0; ray < rays; ++ray) {
    if (!visibility.sees(point, ray)) continue;
    for (const uint32_t other : touching[ray])
      if (visibility.sees(point, other)) parent[root_of(parent, ray)] = root_of(parent, other);
  }
  std::vector<Region> by_root(rays), regions;
  for (uint32_t ray = 0; ray < rays; ++ray) {
    if (!visibility.sees(point, ray)) continue;
    Region& region = by_root[root_of(parent, ray)];
    ++region.rays;
    region.sum += glm::dvec3(visibility.directions()[ray]);
  }
  std::copy_if(by_root.begin(), by_root.end(), std::back_inserter(regions),
               [](const Region& region) { return region.rays > 0; });
  std::stable_sort(regions.begin(), regions.end(), [](const Region& a, const Region& b) { return a.rays > b.rays; });
  const auto is_noise = [&](const Region& region) { return static_cast<double>(region.rays) < least_share * rays; };
  while (regions.size() > 1 && (regions.size() > count || is_noise(regions.back()))) {
    const Region last = regions.back();
    regions.pop_back();
    const auto cosine = [&](const Region& region) {
      return glm::dot(region.sum, last.sum) / std::max(glm::length(region.sum), 1e-12);
    };
    Region& nearest = *std::max_element(regions.begin(), regions.end(),
                                        [&](const Region& a, const Region& b) { return cosine(a) < cosine(b); });
    nearest.rays += last.rays;
    nearest.sum += last.sum;
  }
  return regions;
}

// Puts `apertures` into the order in which they lie nearest to `beside`; those of radius 0 look where their partners do.
void order_like(std::span<Aperture> apertures, std::span<const Aperture> beside) {
  std::array<size_t, most_apertures> order{}, best{};
  std::iota(order.begin(), order.begin() + apertures.size(), size_t{0});
  double most = -1e9;
  do {
    double score = 0;
    for (size_t i = 0; i < apertures.size(); ++i) {
      const Aperture &a = apertures[order[i]], &b = beside[i];
      if (a.w > 0 && b.w > 0) score += std::min(a.w, b.w) * (1 + glm::dot(glm::vec3(a), glm::vec3(b)));
    }
    if (score > most) most = score, best = order;
  } while (std::next_permutation(order.begin(), order.begin() + apertures.size()));
  const std::vector<Aperture> old(apertures.begin(), apertures.end());
  for (size_t i = 0; i < apertures.size(); ++i) {
    apertures[i] = old[best[i]];
    if (apertures[i].w == 0) apertures[i] = Aperture(glm::vec3(beside[i]), 0);
  }
}

}  // namespace

std::vector<Aperture> region_apertures(const Visibility& visibility, const SurfacePoints& surface, size_t count) {
  const std::vector<std::vector<uint32_t>> touching = touching_directions(visibility.directions());
  std::vector<Aperture> apertures(visibility.points() * count);
  tbb::parallel_for(size_t{0}, visibility.points(), [&](size_t point) {
    const SurfacePoint& at = visibility.point(point);
    const glm::vec3 otherwise = at.normal == glm::vec3(0) ? glm::vec3(0, 1, 0) : at.normal;
    for (size_t i = 0; i < count; ++i) apertures[point * count + i] = Aperture(otherwise, 0);
    if (at.normal == glm::vec3(0)) return;
    const std::vector<Region> regions = regions_of(visibility, point, count, touching);
    for (size_t i = 0; i < regions.size(); ++i) {
      const double length = glm::length(regions[i].sum), share = double(regions[i].rays) / double(visibility.rays());
      const glm::vec3 along =
          length > 1e-6 ? glm::normalize(visibility.frame(point) * glm::vec3(regions[i].sum / length)) : at.normal;
      apertures[point * count + i] = Aperture(along, static_cast<float>(cap_radius(2 * std::numbers::pi * share)));
    }
  });
  if (count == 1) return apertures;
  std::vector<bool> reached(visibility.points(), false);
  std::vector<uint32_t> front;
  for (uint32_t start = 0; start < visibility.points(); ++start) {
    if (reached[start]) continue;
    reached[start] = true;
    front = {start};
    for (size_t next = 0; next < front.size(); ++next)
      for (const uint32_t other : surface.neighbours[front[next]]) {
        if (reached[other]) continue;
        reached[other] = true;
        front.push_back(other);
        order_like({&apertures[other * count], count}, {&apertures[front[next] * count], count});
      }
  }
  return apertures;
}

}  // namespace lamina
