// SPDX-License-Identifier: Apache-2.0
// See strand_texture.h.
#include "harness/scene/made/strand_texture.h"

#include <algorithm>
#include <cmath>

#include "harness/scene/made/noise.h"

namespace lamina {
namespace {

constexpr uint32_t clump_texels = 64, length_texels = 512, margin_texels = 5, strands_a_clump = 15;

// A strand's course down its clump; x in texels, v from root 0 to tip 1.
struct DrawnStrand {
  float middle, sway, waves, phase, drift, width, start, end, shade;

  float x(float v) const {
    return middle + drift * v * v + sway * v * std::sin(2 * static_cast<float>(M_PI) * (waves * v + phase));
  }
  float slope(float v) const { return (x(v + 0.004f) - x(v - 0.004f)) / 0.008f; }  // texels for the whole length
  float half_width(float v) const {
    if (v < start) return 0;
    const float left = (end - v) / 0.35f;  // tapers over the last third
    return left <= 0 ? 0 : 0.5f * width * std::min(std::sqrt(left), 1.0f);
  }
};

std::vector<DrawnStrand> draw_clump(uint32_t clump) {
  Random random(101 + clump);
  std::vector<DrawnStrand> strands;
  const float room = clump_texels - 2.0f * margin_texels, place = room / strands_a_clump;
  for (uint32_t i = 0; i < strands_a_clump; ++i) {
    DrawnStrand strand{};
    strand.middle = margin_texels + (static_cast<float>(i) + 0.2f + 0.6f * random.next()) * place;
    strand.sway = 0.6f + 1.6f * random.next();
    strand.waves = 0.6f + 0.9f * random.next();
    strand.phase = random.next();
    strand.drift = (static_cast<float>(clump_texels) / 2 - strand.middle) * 0.3f * random.next();  // clumps close towards tips
    strand.width = (clump == 0 ? 4.6f : 2.6f) + 1.8f * random.next();
    strand.start = clump == 0 ? 0 : 0.07f * random.next();  // so that no row of ends shows where a card begins
    strand.end = 0.72f + 0.27f * random.next();
    strand.shade = 0.62f + 0.76f * random.next();
    strands.push_back(strand);
  }
  return strands;
}

}  // namespace

StrandTextures strand_textures(glm::vec3 colour, glm::vec2 card_m) {
  StrandTextures made;
  for (Texels* texels : {&made.albedo, &made.direction})
    *texels = {strand_clumps * clump_texels, length_texels,
               std::vector<glm::vec4>(size_t{strand_clumps} * clump_texels * length_texels)};
  for (uint32_t clump = 0; clump < strand_clumps; ++clump) {
    const std::vector<DrawnStrand> strands = draw_clump(clump);
    for (uint32_t row = 0; row < length_texels; ++row) {
      const float v = (static_cast<float>(row) + 0.5f) / length_texels;
      for (uint32_t column = 0; column < clump_texels; ++column) {
        const float x = static_cast<float>(column) + 0.5f;
        float alpha = 0, nearest = 1e9f;
        const DrawnStrand* shown = nullptr;
        for (const DrawnStrand& strand : strands) {
          const float beside = std::abs(x - strand.x(v)) - strand.half_width(v);
          if (strand.half_width(v) > 0) alpha = std::max(alpha, std::clamp(0.5f - beside, 0.0f, 1.0f));
          if (beside < nearest) nearest = beside, shown = &strand;
        }
        // Roots lie in the shade of what is above them, and so do the dense clump's strands.
        const float light = (0.42f + 0.58f * std::min(v / 0.35f, 1.0f)) * (clump == 0 ? 0.7f : 1.0f);
        const float angle = std::atan2(card_m.y, shown->slope(v) * card_m.x / clump_texels);
        const size_t at = size_t{row} * made.albedo.width + clump * clump_texels + column;
        made.albedo.rgba[at] = glm::vec4(colour * (shown->shade * light), alpha);
        made.direction.rgba[at] = {0.5f + 0.5f * std::cos(2 * angle), 0.5f + 0.5f * std::sin(2 * angle), 0.5f, 1};
      }
    }
  }
  return made;
}

}  // namespace lamina
