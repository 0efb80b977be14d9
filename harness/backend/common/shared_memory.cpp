// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/common/shared_memory.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "harness/backend/common/checks.h"

namespace lamina {
namespace {

struct Stretch {
  uint64_t begin = 0, end = 0;
};

uint64_t aligned_up(uint64_t offset, uint64_t alignment) { return (offset + alignment - 1) / alignment * alignment; }

// The start of the smallest gap between the stretches that takes `bytes`, else the place behind them all. `taken` is in order
// of beginnings.
uint64_t best_gap(std::span<const Stretch> taken, uint64_t bytes, uint64_t alignment) {
  uint64_t end = 0, best = UINT64_MAX, best_bytes = UINT64_MAX;
  for (const Stretch& stretch : taken) {
    const uint64_t begin = aligned_up(end, alignment);
    if (begin + bytes <= stretch.begin && stretch.begin - end < best_bytes) best = begin, best_bytes = stretch.begin - end;
    end = std::max(end, stretch.end);
  }
  return best == UINT64_MAX ? aligned_up(end, alignment) : best;
}

bool is_alike(const TextureDesc& a, const TextureDesc& b) {
  const auto all = [](const TextureDesc& of) {
    return std::tuple(of.width, of.height, of.depth, of.levels, of.format, of.target, of.storage);
  };
  return all(a) == all(b);
}

}  // namespace

MemoryPlaces place_in_memory(std::span<const MemoryNeed> needs) {
  std::vector<size_t> order(needs.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::ranges::stable_sort(order, [&](size_t a, size_t b) { return needs[a].bytes > needs[b].bytes; });
  MemoryPlaces places;
  places.offsets.resize(needs.size());
  std::vector<size_t> placed;  // in order of offsets
  std::vector<Stretch> taken;
  for (const size_t i : order) {
    const MemoryNeed& need = needs[i];
    taken.clear();
    for (const size_t j : placed)
      if (overlap(needs[j].lifetime, need.lifetime)) taken.push_back({places.offsets[j], places.offsets[j] + needs[j].bytes});
    const uint64_t offset = best_gap(taken, need.bytes, need.alignment);
    places.offsets[i] = offset;
    places.bytes = std::max(places.bytes, offset + need.bytes);
    placed.insert(std::ranges::upper_bound(placed, offset, {}, [&](size_t j) { return places.offsets[j]; }), i);
  }
  return places;
}

std::vector<size_t> reused_textures(std::span<const TransientDesc> descs) {
  std::vector<size_t> order(descs.size()), which(descs.size());
  std::iota(which.begin(), which.end(), size_t{0});
  std::iota(order.begin(), order.end(), size_t{0});
  std::erase_if(order, [&](size_t i) { return !descs[i].lifetime; });
  std::ranges::stable_sort(order, {}, [&](size_t i) { return descs[i].lifetime->first; });
  struct Made {
    size_t first_user;
    uint32_t last_use;
  };
  std::vector<Made> made;
  for (const size_t i : order) {
    const auto free = std::ranges::find_if(made, [&](const Made& other) {
      return other.last_use < descs[i].lifetime->first && is_alike(descs[other.first_user].texture, descs[i].texture);
    });
    if (free == made.end()) {
      made.push_back({i, descs[i].lifetime->last});
      continue;
    }
    which[i] = free->first_user;
    free->last_use = descs[i].lifetime->last;
  }
  return which;
}

uint64_t texture_bytes(const TextureDesc& desc) {
  uint64_t bytes = 0;
  for (uint32_t level = 0; level < desc.levels; ++level) bytes += level_bytes(desc, level);
  return bytes;
}

}  // namespace lamina
