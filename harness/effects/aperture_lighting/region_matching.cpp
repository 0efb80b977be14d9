// SPDX-License-Identifier: Apache-2.0
// First a walk over the surface, always along the step whose match is the clearest (Prim, "Shortest Connection Networks and
// Some Generalizations", 1957, for the greatest tree). A walk knows a region that is hidden only by where it was seen last, on
// the way that it came; where the region is seen again from another side, that may be far off. So then each region's directions
// are spread over the points that do not see it, from all sides, and points are put in order anew, until none changes.
#include "harness/effects/aperture_lighting/region_matching.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <queue>
#include <tuple>

namespace lamina {
namespace {

constexpr int max_rounds = 50;          // of putting in order anew
constexpr int smoothing_sweeps = 8;     // of hidden regions' directions
constexpr float hidden_weight = 0.25f;  // of a neighbour that does not see a region

using Order = std::array<size_t, max_apertures>;

// Calls visit(order) for each order of `count` places.
template <class Visit>
void each_order(size_t count, const Visit& visit) {
  Order order{};
  std::iota(order.begin(), order.begin() + ptrdiff_t(count), size_t{0});
  do visit(order);
  while (std::next_permutation(order.begin(), order.begin() + ptrdiff_t(count)));
}

struct Match {
  Order order{};      // which of the apertures goes to each place
  double margin = 0;  // how much better than the next best order
};

// The order in which apertures lie nearest to directions, of any length, by place.
Match match(std::span<const Aperture> apertures, std::span<const glm::vec3> beside) {
  Match best;
  double most = -1e30, next = -1e30;
  each_order(apertures.size(), [&](const Order& order) {
    double score = 0;
    for (size_t i = 0; i < apertures.size(); ++i)
      score += double(apertures[order[i]].w * glm::dot(glm::vec3(apertures[order[i]]), beside[i]));
    if (score > most)
      next = most, most = score, best.order = order;
    else
      next = std::max(next, score);
  });
  best.margin = most - next;
  return best;
}

class Matching {
 public:
  Matching(std::vector<Aperture>& apertures, const SurfacePoints& surface, size_t count)
      : apertures_(apertures), surface_(surface), count_(count), known_(apertures.size()) {}

  void walk() {
    struct Step {
      double margin;
      uint32_t from, to;
      bool operator<(const Step& other) const { return std::tie(margin, other.to) < std::tie(other.margin, to); }
    };
    std::vector<bool> reached(points(), false);
    std::priority_queue<Step> steps;
    const auto reach = [&](uint32_t point) {
      reached[point] = true;
      for (const uint32_t other : surface_.neighbours[point])
        if (!reached[other]) steps.push({match(of(other), known(point)).margin, point, other});
    };
    for (uint32_t start = 0; start < points(); ++start) {
      if (reached[start]) continue;
      reorder(start, match(of(start), known(start)).order);
      // What was never seen lies nowhere: any direction would draw regions to it.
      for (size_t i = 0; i < count_; ++i) known(start)[i] = of(start)[i].w > 0 ? glm::vec3(of(start)[i]) : glm::vec3(0);
      reach(start);
      while (!steps.empty()) {
        const Step step = steps.top();
        steps.pop();
        if (reached[step.to]) continue;
        reorder(step.to, match(of(step.to), known(step.from)).order);
        for (size_t i = 0; i < count_; ++i)
          known(step.to)[i] = of(step.to)[i].w > 0 ? glm::vec3(of(step.to)[i]) : known(step.from)[i];
        reach(step.to);
      }
    }
  }

  // Whether any point changed.
  bool order_anew() {
    spread();
    bool changed = false;
    for (uint32_t point = 0; point < points(); ++point) {
      std::array<glm::vec3, max_apertures> beside{};
      for (const uint32_t other : surface_.neighbours[point])
        for (size_t i = 0; i < count_; ++i) beside[i] += known(other)[i] * (of(other)[i].w > 0 ? 1 : hidden_weight);
      const Match found = match(of(point), std::span(beside).first(count_));
      if (found.margin <= 1e-6 || std::is_sorted(found.order.begin(), found.order.begin() + ptrdiff_t(count_))) continue;
      reorder(point, found.order);
      for (size_t i = 0; i < count_; ++i)
        if (of(point)[i].w > 0) known(point)[i] = glm::vec3(of(point)[i]);
      changed = true;
    }
    return changed;
  }

  void turn_hidden() {
    spread();
    for (size_t i = 0; i < apertures_.size(); ++i)
      if (apertures_[i].w <= 0 && known_[i] != glm::vec3(0)) apertures_[i] = Aperture(known_[i], 0);
  }

 private:
  uint32_t points() const { return static_cast<uint32_t>(surface_.points.size()); }
  std::span<Aperture> of(uint32_t point) { return std::span(apertures_).subspan(point * count_, count_); }
  std::span<glm::vec3> known(uint32_t point) { return std::span(known_).subspan(point * count_, count_); }

  void reorder(uint32_t point, const Order& order) {
    const std::vector<Aperture> old(of(point).begin(), of(point).end());
    for (size_t i = 0; i < count_; ++i) of(point)[i] = old[order[i]];
  }

  // A region's directions over points that do not see it: from the nearest outwards the mean of those beside that are known,
  // then smoothed. A region that no point of a connected part sees keeps what the walk left.
  void spread() {
    for (size_t i = 0; i < count_; ++i) {
      std::vector<uint32_t> hidden;
      std::vector<bool> reached(points(), false);
      std::queue<uint32_t> front;
      for (uint32_t point = 0; point < points(); ++point)
        if (of(point)[i].w > 0) known(point)[i] = glm::vec3(of(point)[i]), reached[point] = true, front.push(point);
      while (!front.empty()) {
        const uint32_t point = front.front();
        front.pop();
        for (const uint32_t other : surface_.neighbours[point]) {
          if (reached[other]) continue;
          known(other)[i] = known(point)[i];
          reached[other] = true;
          hidden.push_back(other);
          front.push(other);
        }
      }
      for (int sweep = 0; sweep < smoothing_sweeps; ++sweep)
        for (const uint32_t point : hidden) {
          glm::vec3 sum(0);
          for (const uint32_t other : surface_.neighbours[point]) sum += known(other)[i];
          if (glm::dot(sum, sum) > 1e-6f) known(point)[i] = glm::normalize(sum);
        }
    }
  }

  std::vector<Aperture>& apertures_;
  const SurfacePoints& surface_;
  size_t count_;
  std::vector<glm::vec3> known_;  // [point * count + i]: where a point's regions lie, seen or not
};

// Whether another order brings the regions that either sees nearer to where the other one has them, seen or hidden.
bool mismatched(std::span<const Aperture> a, std::span<const Aperture> b) {
  double as_it_is = 0, best = -1e30;
  each_order(a.size(), [&](const Order& order) {
    double score = 0;
    for (size_t i = 0; i < a.size(); ++i)
      score += double(a[i].w + b[order[i]].w) * double(glm::dot(glm::vec3(a[i]), glm::vec3(b[order[i]])));
    if (std::is_sorted(order.begin(), order.begin() + ptrdiff_t(a.size()))) as_it_is = score;
    best = std::max(best, score);
  });
  return best > as_it_is + 1e-4;
}

}  // namespace

void match_neighbours(std::vector<Aperture>& apertures, const SurfacePoints& surface, size_t count) {
  Matching matching(apertures, surface, count);
  matching.walk();
  for (int round = 0; round < max_rounds && matching.order_anew(); ++round) {
  }
  matching.turn_hidden();
}

std::vector<uint32_t> mismatched_triangles(const std::vector<Aperture>& apertures, std::span<const uint32_t> indices,
                                           size_t count) {
  std::vector<uint32_t> found;
  const auto of = [&](uint32_t point) { return std::span(apertures).subspan(point * count, count); };
  for (size_t t = 0; t + 2 < indices.size(); t += 3)
    for (size_t side = 0; side < 3; ++side)
      if (mismatched(of(indices[t + side]), of(indices[t + (side + 1) % 3]))) {
        found.push_back(static_cast<uint32_t>(t / 3));
        break;
      }
  return found;
}

}  // namespace lamina
