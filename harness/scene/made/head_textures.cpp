// SPDX-License-Identifier: Apache-2.0
// See head_textures.h. Colours and amplitudes are an artist's choices, by eye on the finished picture.
#include "harness/scene/made/head_textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "harness/scene/made/kept.h"
#include "harness/scene/made/noise.h"
#include "harness/scene/textures.h"

namespace lamina {
namespace {

// Height of the skin's relief in mm at a place given in mm: pores a millimetre apart, and a net of fine lines.
float relief_mm(glm::vec3 mm, const HeadRegions& r) {
  const CellSample pore = cell_noise(mm / 1.15f, 11), net = cell_noise(mm * glm::vec3(0.8f, 1.15f, 0.8f), 12);
  const float deep =
      0.13f * (1 - r.lips) * (0.45f + 0.75f * std::max({r.nose, r.cheeks, 0.5f * r.forehead})) * (0.4f + pore.shade);
  float height = -deep * std::exp(-pore.nearest * pore.nearest / 0.075f);
  height -= 0.035f * (1 - r.lips) * std::exp(-(net.second - net.nearest) * (net.second - net.nearest) / 0.012f);
  height += 0.10f * fractal_noise(mm / 4.5f, 3, 13);
  height += 0.10f * r.lips * gradient_noise(glm::vec3(mm.x / 0.9f, mm.y / 5, mm.z / 5), 14);
  return height + 0.09f * r.brows * gradient_noise(glm::vec3(mm.x / 1.4f, (mm.y + 0.6f * mm.x) / 0.5f, mm.z), 15);
}

glm::vec3 skin_colour(glm::vec3 tone, glm::vec3 mm, const HeadRegions& r) {
  const float dark = 1 - glm::dot(tone, glm::vec3(0.3f, 0.5f, 0.2f)) / 0.45f;  // of the tone itself
  const float blotch = fractal_noise(mm / 14.0f, 4, 21), speck = cell_noise(mm / 3.2f, 22).nearest;
  glm::vec3 c = tone * (1 + 0.10f * fractal_noise(mm / 5.0f, 4, 23));
  const float blood =
      std::clamp(0.40f * r.cheeks + 0.45f * r.nose + 0.5f * r.ears + 0.30f * blotch + 0.12f * r.lids, 0.0f, 1.0f);
  c = glm::mix(c, c * glm::vec3(1.05f, 0.70f, 0.68f), blood);
  c *= 1 - 0.16f * glm::smoothstep(0.22f, 0.08f, speck) * glm::smoothstep(-0.05f, 0.25f, blotch);
  c = glm::mix(c, tone * glm::vec3(0.90f, 0.46f, 0.47f), 0.62f * r.lips);
  c *= 1 - 0.10f * r.lids;
  const float hairs = 0.62f + 0.38f * gradient_noise(glm::vec3(mm.x / 1.1f, (mm.y + 0.6f * mm.x) / 0.45f, mm.z / 2), 25);
  c = glm::mix(c, tone * glm::vec3(0.16f, 0.13f, 0.11f), std::clamp(r.brows * hairs * 1.15f, 0.0f, 0.92f));
  return glm::clamp(c * (1 - 0.1f * std::max(dark, 0.0f) * r.forehead), 0.0f, 0.95f);
}

// Albedo, normal, specular, translucency.
std::vector<std::shared_ptr<const TextureImage>> make_textures(glm::vec3 tone, uint32_t texels) {
  const Texels blank{texels, texels, std::vector<glm::vec4>(size_t{texels} * texels)};
  Texels albedo = blank, normal = blank, specular = blank, translucency = blank;
  std::vector<HeadPlace> places(size_t{texels} * texels);
  std::vector<float> heights(places.size());
  for (uint32_t y = 0; y < texels; ++y)
    for (uint32_t x = 0; x < texels; ++x) {
      const size_t at = size_t{y} * texels + x;
      const HeadPlace place = head_place((glm::vec2(x, y) + 0.5f) / static_cast<float>(texels));
      const glm::vec3 mm = place.position * 1000.0f;
      const HeadRegions& r = place.regions;
      places[at] = place;
      heights[at] = relief_mm(mm, r);
      albedo.rgba[at] = glm::vec4(skin_colour(tone, mm, r), 1);
      const float shine = std::clamp(0.55f + 0.35f * r.nose + 0.40f * r.lips + 0.25f * r.forehead - 0.15f * r.ears -
                                         0.3f * r.brows + 0.20f * fractal_noise(mm / 1.3f, 2, 31),
                                     0.1f, 1.0f);
      const float rough = std::clamp(0.90f - 0.14f * r.nose - 0.26f * r.lips - 0.08f * r.forehead, 0.1f, 1.0f);
      specular.rgba[at] = {shine, rough, 0, 1};
      translucency.rgba[at] = glm::vec4(std::clamp(0.36f + 0.50f * r.ears + 0.12f * r.nose, 0.0f, 1.0f));
    }
  for (uint32_t y = 0; y < texels; ++y)
    for (uint32_t x = 0; x < texels; ++x) {
      const auto at = [&](uint32_t column, uint32_t row) { return size_t{row} * texels + column; };
      const size_t left = at(x > 0 ? x - 1 : x, y), right = at(std::min(x + 1, texels - 1), y), up = at(x, y > 0 ? y - 1 : y),
                   down = at(x, std::min(y + 1, texels - 1));
      const auto slope = [&](size_t a, size_t b) {
        const float apart = 1000 * glm::distance(places[a].position, places[b].position);
        return apart > 0.02f && apart < 8 ? (heights[b] - heights[a]) / apart : 0.0f;
      };
      const glm::vec3 n = glm::normalize(glm::vec3(-slope(left, right), -slope(up, down), 1));
      normal.rgba[at(x, y)] = glm::vec4(n * 0.5f + 0.5f, 1);
    }
  return {make_texture("skin", albedo, TexelMeaning::colour), make_texture("pores", normal, TexelMeaning::normal),
          make_texture("shine", specular, TexelMeaning::data), make_texture("translucency", translucency, TexelMeaning::data)};
}

}  // namespace

HeadTextures head_textures(glm::vec3 tone, uint32_t texels) {
  const auto made = kept_textures(fmt::format("head_{}_{}_{}_{}", texels, tone.r, tone.g, tone.b),
                                  [&] { return make_textures(tone, texels); });
  return {made[0], made[1], made[2], made[3]};
}

}  // namespace lamina
