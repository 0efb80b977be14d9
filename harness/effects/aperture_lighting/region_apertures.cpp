// SPDX-License-Identifier: Apache-2.0
// Contiguous regions of visibility: directions that touch and are both seen belong together (disjoint sets). Then
// each point's regions are put in the order of its neighbours' (region_matching.h).
#include <tbb/parallel_for.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <iterator>
#include <utility>

#include "harness/effects/aperture_lighting/apertures.h"
#include "harness/effects/aperture_lighting/region_matching.h"

namespace lamina {
namespace {

// A region of fewer rays than this share is noise of a boundary.
constexpr double min_share = 0.004;

struct Region {
  size_t rays = 0;
  glm::dvec3 sum{0};  // of the directions, tangent space
};

// At most `count` regions, the largest first. Where there are more, those that lie nearest together are joined (J. H. Ward,
// "Hierarchical Grouping to Optimize an Objective Function", 1963).
std::vector<Region> regions_of(const Visibility& visibility, size_t point, size_t count,
                               const std::vector<std::vector<uint32_t>>& touching) {
  const auto rays = static_cast<uint32_t>(visibility.rays());
  boost::disjoint_sets_with_storage<> sets(rays);
  for (uint32_t ray = 0; ray < rays; ++ray) {
    if (!visibility.sees(point, ray)) continue;
    for (const uint32_t other : touching[ray])
      if (visibility.sees(point, other)) sets.union_set(ray, other);
  }
  std::vector<Region> by_set(rays), regions;
  for (uint32_t ray = 0; ray < rays; ++ray) {
    if (!visibility.sees(point, ray)) continue;
    Region& region = by_set[sets.find_set(ray)];
    ++region.rays;
    region.sum += glm::dvec3(visibility.directions()[ray]);
  }
  std::copy_if(by_set.begin(), by_set.end(), std::back_inserter(regions), [](const Region& region) { return region.rays > 0; });
  std::stable_sort(regions.begin(), regions.end(), [](const Region& a, const Region& b) { return a.rays > b.rays; });
  const auto cosine = [](const Region& a, const Region& b) {
    return glm::dot(a.sum, b.sum) / std::max(glm::length(a.sum) * glm::length(b.sum), 1e-12);
  };
  const auto join = [&](size_t into, size_t last) {
    regions[into].rays += regions[last].rays, regions[into].sum += regions[last].sum;
    regions.erase(regions.begin() + ptrdiff_t(last));
  };
  while (regions.size() > 1 && static_cast<double>(regions.back().rays) < min_share * rays) {
    size_t nearest = 0;
    for (size_t i = 1; i + 1 < regions.size(); ++i)
      if (cosine(regions[i], regions.back()) > cosine(regions[nearest], regions.back())) nearest = i;
    join(nearest, regions.size() - 1);
  }
  // Ward's choice: the two that lose the least by becoming one. What a bar cuts in two is joined before what lies far apart.
  while (regions.size() > count) {
    std::pair<size_t, size_t> pair;
    double least = 1e30;
    for (size_t i = 0; i < regions.size(); ++i)
      for (size_t j = i + 1; j < regions.size(); ++j) {
        const double a = static_cast<double>(regions[i].rays), b = static_cast<double>(regions[j].rays),
                     cost = a * b / (a + b) * (1 - cosine(regions[i], regions[j]));
        if (cost < least) least = cost, pair = {i, j};
      }
    join(pair.first, pair.second);
  }
  std::stable_sort(regions.begin(), regions.end(), [](const Region& a, const Region& b) { return a.rays > b.rays; });
  return regions;
}

}  // namespace

std::vector<Aperture> region_apertures(const Visibility& visibility, const SurfacePoints& surface, size_t count) {
  const std::vector<std::vector<uint32_t>> touching = touching_directions(visibility.directions());
  std::vector<Aperture> apertures(visibility.points() * count);
  tbb::parallel_for(size_t{0}, visibility.points(), [&](size_t point) {
    for (size_t i = 0; i < count; ++i) apertures[point * count + i] = aperture_of_rays(visibility, point, 0, glm::dvec3(0));
    if (visibility.point(point).normal == glm::vec3(0)) return;
    const std::vector<Region> regions = regions_of(visibility, point, count, touching);
    for (size_t i = 0; i < regions.size(); ++i)
      apertures[point * count + i] = aperture_of_rays(visibility, point, regions[i].rays, regions[i].sum);
  });
  if (count > 1) match_neighbours(apertures, surface, count);
  return apertures;
}

}  // namespace lamina
