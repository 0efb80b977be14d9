// SPDX-License-Identifier: Apache-2.0
// Contiguous regions of visibility: directions that touch and are both seen belong together (disjoint sets). Then
// each point's regions are put in the order of a neighbour's, walking over the surface.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <queue>
#include <tuple>

#include "harness/effects/aperture_lighting/apertures.h"

namespace lamina {
namespace {

// A region of fewer rays than this share is noise of a boundary.
constexpr double min_share = 0.004;

struct Region {
  size_t rays = 0;
  glm::dvec3 sum{0};  // of the directions, tangent space
};

// At most `count` regions, the largest first; the rest is added to the nearest of them.
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
  const auto is_noise = [&](const Region& region) { return static_cast<double>(region.rays) < min_share * rays; };
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

using Order = std::array<size_t, max_apertures>;
struct Match {
  Order order{};      // which of the apertures goes to each place
  double margin = 0;  // how much better than the next best order
};

// The order in which `apertures` lie nearest to `beside`. One that is hidden there (radius 0) is known by where it last was,
// which counts for less.
Match match(std::span<const Aperture> apertures, std::span<const Aperture> beside) {
  Order order{};
  std::iota(order.begin(), order.begin() + apertures.size(), size_t{0});
  Match best;
  double most = -1, next = -1;
  do {
    double score = 0;
    for (size_t i = 0; i < apertures.size(); ++i) {
      const Aperture &a = apertures[order[i]], &b = beside[i];
      const double weight = b.w > 0 ? std::min(a.w, b.w) : 0.5f * a.w;
      score += weight * (1 + glm::dot(glm::vec3(a), glm::vec3(b)));
    }
    if (score > most)
      next = most, most = score, best.order = order;
    else
      next = std::max(next, score);
  } while (std::next_permutation(order.begin(), order.begin() + apertures.size()));
  best.margin = most - next;
  return best;
}

void reorder(std::span<Aperture> apertures, const Order& order, std::span<const Aperture> beside) {
  const std::vector<Aperture> old(apertures.begin(), apertures.end());
  for (size_t i = 0; i < apertures.size(); ++i)
    apertures[i] = old[order[i]].w > 0 ? old[order[i]] : Aperture(glm::vec3(beside[i]), 0);
}

// Walks over the surface, always along the step whose match is the clearest (Prim, "Shortest Connection Networks and Some
// Generalizations", 1957, for the greatest tree), so that doubtful places divide nobody but themselves.
void match_neighbours(std::vector<Aperture>& apertures, const SurfacePoints& surface, size_t count) {
  struct Step {
    double margin;
    uint32_t from, to;
    bool operator<(const Step& other) const { return std::tie(margin, other.to) < std::tie(other.margin, to); }
  };
  const auto of = [&](uint32_t point) { return std::span<Aperture>(&apertures[point * count], count); };
  std::vector<bool> reached(surface.points.size(), false);
  std::priority_queue<Step> steps;
  const auto reach = [&](uint32_t point) {
    reached[point] = true;
    for (const uint32_t other : surface.neighbours[point])
      if (!reached[other]) steps.push({match(of(other), of(point)).margin, point, other});
  };
  for (uint32_t start = 0; start < surface.points.size(); ++start) {
    if (reached[start]) continue;
    reach(start);
    while (!steps.empty()) {
      const Step step = steps.top();
      steps.pop();
      if (reached[step.to]) continue;
      reorder(of(step.to), match(of(step.to), of(step.from)).order, of(step.from));
      reach(step.to);
    }
  }
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
