// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/counted_texture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace lamina {

std::optional<double> mean_level(const std::vector<uint64_t>& levels) {
  double reads = 0, sum = 0;
  for (size_t level = 0; level < levels.size(); ++level) {
    reads += static_cast<double>(levels[level]);
    sum += static_cast<double>(level) * static_cast<double>(levels[level]);
  }
  return reads > 0 ? std::optional(sum / reads) : std::nullopt;
}

CountedTexture counted_texture(std::string sampler, Filter filter, Format format, std::array<uint32_t, 3> size, uint32_t levels,
                               std::optional<uint32_t> level) {
  CountedTexture texture;
  const bool is_3d = size[2] > 1;
  texture.row.texture = std::move(sampler);
  texture.row.format = name_of(format);
  texture.row.filter = name_of(filter);
  texture.row.dimensions = is_3d ? 3 : 2;
  texture.row.size.assign(size.begin(), size.begin() + (is_3d ? 3 : 2));
  texture.leveled = {.levels = levels, .mipmapped = filter == Filter::trilinear, .size = size};
  if (!level) return texture;
  texture.base_level = *level;
  texture.leveled.levels = 1;
  for (uint32_t& side : texture.leveled.size) side = std::max(side >> *level, 1u);
  return texture;
}

std::string key_of(const CountedTexture& texture) {
  const TextureFetches& row = texture.row;
  return fmt::format("{},{},{},{},{},{}", row.texture, row.format, row.filter, fmt::join(row.size, "x"), texture.leveled.levels,
                     texture.base_level);
}

void FetchesByTexture::add(const CountedTexture& texture, uint32_t binding, const ShaderWork& done, const ShaderWork& issued) {
  const auto same = std::ranges::find_if(rows_, [&](const TextureFetches& row) {
    const TextureFetches& one = texture.row;
    return row.texture == one.texture && row.format == one.format && row.filter == one.filter && row.size == one.size;
  });
  TextureFetches& row = same == rows_.end() ? rows_.emplace_back(texture.row) : *same;
  const auto place = static_cast<size_t>(&row - rows_.data());
  const uint64_t fetches = done.fetches.at(binding);
  row.fetches += fetches;
  row.issued += issued.fetches.at(binding);
  const auto unfiltered = done.unfiltered.find(binding);
  row.unfiltered = row.unfiltered.value_or(0) + (unfiltered == done.unfiltered.end() ? 0 : unfiltered->second);
  const auto levels = done.levels.find(binding);
  if (levels == done.levels.end() && fetches > 0) without_levels_.insert(place);
  if (without_levels_.contains(place)) {
    row.levels.clear();
    return;
  }
  if (levels == done.levels.end()) return;
  const std::vector<uint64_t>& reads = levels->second;
  row.levels.resize(std::max(row.levels.size(), reads.size() + texture.base_level));
  for (size_t level = 0; level < reads.size(); ++level) row.levels[level + texture.base_level] += reads[level];
}

}  // namespace lamina
