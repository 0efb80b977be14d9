// SPDX-License-Identifier: Apache-2.0
// See erosion.h.
#include "harness/scene/made/erosion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/scene/made/kept.h"
#include "harness/scene/made/noise.h"

namespace lamina {
namespace {

constexpr uint32_t coarsest = 65, finest_eroded = 129;
constexpr int coarse_steps = 150, fine_steps = 40, last_steps = 12;  // until the picture hardly changes
constexpr float uplift = 1, erodibility = 1, time_step = 0.08f;  // lengths in units of the extent; the relief is set in the end

// One level of detail, in units of the extent.
class Land {
 public:
  Land(uint32_t side, uint32_t seed)
      : side_(side), spacing_(1 / static_cast<float>(side - 1)), seed_(seed), height_(side * side), lift_(side * side) {
    for (uint32_t i = 0; i < height_.size(); ++i) {
      // Falls towards the outlet, so that hardly any lake must fill first.
      height_[i] = 0.5f * glm::distance(place(i), glm::vec2(0.5f, 1)) +
                   0.1f * fractal_noise(glm::vec3(12.0f * place(i), 0.5f), 4, seed_);
      lift_[i] = lift_at(place(i));
    }
  }

  // The same land on twice as many points. A new point lies between the two old ones across it, the lower pair of a square's,
  // so that valleys stay open; where between is noise, which keeps streams from running straight.
  Land refined() const {
    Land fine(2 * side_ - 1, seed_);
    for (uint32_t i = 0; i < fine.height_.size(); ++i) {
      const uint32_t column = i % fine.side_, row = i / fine.side_;
      const uint32_t a = row / 2 * side_ + column / 2, right = column % 2, down = row % 2 * side_;
      const float falling = height_[a] + height_[a + right + down], rising = height_[a + right] + height_[a + down];
      const float drop = falling < rising ? height_[a] - height_[a + right + down] : height_[a + right] - height_[a + down];
      const float noise = gradient_noise(glm::vec3(0.37f * glm::vec2(column, row), 0.5f), seed_ + 7);
      fine.height_[i] = (std::min(falling, rising) + drop * noise) / 2;
    }
    return fine;
  }

  void erode() {
    drain();
    // From the outlets up, so that each point sees its receiver's new height: the implicit step is stable at any length.
    for (const uint32_t i : order_) {
      const uint32_t to = receiver_[i];
      if (is_outlet(i)) {
        height_[i] = 0;
        continue;
      }
      height_[i] += time_step * uplift * lift_[i];
      if (to == i) continue;
      const float cut = time_step * erodibility * std::sqrt(drained_[i]) / run(i, to);
      height_[i] = std::min(height_[i], (height_[i] + cut * height_[to]) / (1 + cut));
    }
  }

  // Lowers what stands steeper over any point than `steepest`: each height becomes the least of all others' plus the rise that
  // the way there allows. Two sweeps, as for distance maps (Borgefors, "Distance transformations in digital images", 1986).
  void slide(float steepest) {
    drain();
    const auto lower = [&](uint32_t i) {
      for_each_neighbour(i, [&](uint32_t n) { height_[i] = std::min(height_[i], height_[n] + steepest * run(i, n)); });
    };
    for (uint32_t i = 0; i < height_.size(); ++i) lower(i);
    for (uint32_t i = static_cast<uint32_t>(height_.size()); i-- > 0;) lower(i);
  }

  float highest() const { return *std::max_element(height_.begin(), height_.end()); }
  const std::vector<float>& height() const { return height_; }
  const std::vector<float>& drained() const { return drained_; }

 private:
  glm::vec2 place(uint32_t i) const { return spacing_ * glm::vec2(i % side_, i / side_); }

  // Weak along the winding valley, strong in the ranges beside and behind it.
  float lift_at(glm::vec2 p) const {
    const float axis = 0.5f + 0.06f * std::sin(5.5f * p.y + 0.6f) + 0.03f * std::sin(13 * p.y);
    const float beside = std::abs(p.x - axis), behind = 1 - p.y;
    const float ranges = glm::smoothstep(0.0f, 0.20f, beside) * (0.5f + 0.3f * behind);
    const float head = 1.0f * glm::smoothstep(0.34f, 0.0f, glm::distance(p, glm::vec2(0.47f, 0.14f)));
    return (0.06f + ranges + head) * std::max(0.2f, 1 + 1.6f * fractal_noise(glm::vec3(3.5f * p, 0.25f), 2, seed_ + 3));
  }

  bool is_outlet(uint32_t i) const {
    const uint32_t column = i % side_;
    return i / side_ == side_ - 1 && 20 * column > 9 * side_ && 20 * column < 11 * side_;
  }

  // Between neighbours.
  float run(uint32_t a, uint32_t b) const {
    const bool diagonal = a % side_ != b % side_ && a / side_ != b / side_;
    return diagonal ? 1.41421356f * spacing_ : spacing_;
  }

  // Where the water goes, and how much passes.
  void drain() {
    find_receivers();
    order_upstream();
    drained_.assign(height_.size(), spacing_ * spacing_);
    for (size_t i = order_.size(); i-- > 0;)
      if (receiver_[order_[i]] != order_[i]) drained_[receiver_[order_[i]]] += drained_[order_[i]];
  }

  // The eight around a point, as far as they are there.
  template <class Visit>
  void for_each_neighbour(uint32_t i, const Visit& visit) const {
    const int column = static_cast<int>(i % side_), row = static_cast<int>(i / side_), last = static_cast<int>(side_) - 1;
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, last); ++y)
      for (int x = std::max(column - 1, 0); x <= std::min(column + 1, last); ++x)
        if (x != column || y != row) visit(static_cast<uint32_t>(y) * side_ + static_cast<uint32_t>(x));
  }

  // The neighbour down the steepest slope, or nearly so; the point itself in a pit and at the outlet.
  void find_receivers() {
    receiver_.resize(height_.size());
    for (uint32_t i = 0; i < height_.size(); ++i) {
      receiver_[i] = i;
      if (is_outlet(i)) continue;
      float steepest = 0;
      for_each_neighbour(i, [&](uint32_t n) {
        // Uneven rock: without it, streams on an even slope run straight along the grid.
        const float uneven = 0.7f + 0.6f * static_cast<float>(hash_lattice({i, n, 0}, seed_) >> 8) * 0x1p-24f;
        const float slope = uneven * (height_[i] - height_[n]) / run(i, n);
        if (slope > steepest) steepest = slope, receiver_[i] = n;
      });
    }
  }

  // Every point after its receiver: first those that drain nowhere, then, point by point, those that drain into it.
  void order_upstream() {
    const auto count = static_cast<uint32_t>(height_.size());
    std::vector<uint32_t> end(count + 1), donors(count);  // the donors of i end before end[i]
    for (uint32_t i = 0; i < count; ++i)
      if (receiver_[i] != i) ++end[receiver_[i] + 1];
    for (uint32_t i = 0; i < count; ++i) end[i + 1] += end[i];
    for (uint32_t i = 0; i < count; ++i)
      if (receiver_[i] != i) donors[end[receiver_[i]]++] = i;
    order_.clear();
    for (uint32_t i = 0; i < count; ++i)
      if (receiver_[i] == i) order_.push_back(i);
    for (size_t next = 0; next < order_.size(); ++next) {
      const uint32_t i = order_[next];
      order_.insert(order_.end(), donors.begin() + (i > 0 ? end[i - 1] : 0), donors.begin() + end[i]);
    }
  }

  uint32_t side_;
  float spacing_;
  uint32_t seed_;
  std::vector<float> height_, lift_, drained_;
  std::vector<uint32_t> receiver_, order_;
};

Terrain erode(const Erosion& options) {
  Land land(coarsest, options.seed);
  for (int i = 0; i < coarse_steps; ++i) land.erode();
  for (uint32_t side = coarsest; side < options.side; side = 2 * side - 1) {
    land = land.refined();
    for (int i = 0; i < (side < finest_eroded ? fine_steps : last_steps); ++i) land.erode();
  }
  // Heights so far and metres differ by this factor; slopes in the end are metres over metres.
  const float stretch = options.relief_m / land.highest() / options.extent_m;
  land.slide(options.steepest / stretch);
  Terrain terrain{options.side, options.extent_m / static_cast<float>(options.side - 1), land.height(), land.drained()};
  for (float& height : terrain.height_m) height *= stretch * options.extent_m;
  for (float& area : terrain.drained_m2) area *= options.extent_m * options.extent_m;
  return terrain;
}

}  // namespace

Terrain eroded_valley(const Erosion& options) {
  const std::string name =
      fmt::format("valley_{}_{}_{}_{}_{}", options.side, options.extent_m, options.relief_m, options.steepest, options.seed);
  const Parts parts = kept(name, [&] {
    const Terrain terrain = erode(options);
    return Parts{std::string(bytes_of(terrain.spacing_m)), std::string(bytes_of(terrain.height_m)),
                 std::string(bytes_of(terrain.drained_m2))};
  });
  return {options.side, values_in<float>(parts[0]).front(), values_in<float>(parts[1]), values_in<float>(parts[2])};
}

}  // namespace lamina
