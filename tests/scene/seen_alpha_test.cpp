// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/mesh/seen_alpha.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "harness/scene/textures.h"

namespace lamina {
namespace {

// Opaque white but for one texel.
std::shared_ptr<const TextureImage> one_texel(uint32_t size, uint32_t x, uint32_t y, float alpha = 1) {
  Texels texels{size, size, std::vector<glm::vec4>(size_t{size} * size, glm::vec4(1, 1, 1, 0))};
  texels.rgba[size_t{y} * size + x].a = alpha;
  return make_texture("one", texels, TexelMeaning::colour);
}

Mesh triangle(glm::vec2 a, glm::vec2 b, glm::vec2 c) {
  Mesh mesh;
  for (const glm::vec2 uv : {a, b, c}) mesh.vertices.push_back({{uv, 0}, {0, 0, 1}, {1, 0, 0, 1}, uv});
  mesh.indices = {0, 1, 2};
  return mesh;
}

// Bilinear filtering at (x, y) reads the texels whose centres lie within one texel. A speck of a triangle around the middle of
// texel (8, 8) may read its eight neighbours and no texel further away.
TEST(SeenAlpha, ReachesOneTexelAroundAPoint) {
  const glm::vec2 at(8.5f / 16, 8.5f / 16);
  const Mesh speck = triangle(at, at + glm::vec2(1e-4f, 0), at + glm::vec2(0, 1e-4f));
  for (uint32_t y = 0; y < 16; ++y)
    for (uint32_t x = 0; x < 16; ++x) {
      const bool near = x >= 8 && x <= 9 && y >= 8 && y <= 9;  // the speck leans right and down from the centre
      EXPECT_EQ(seen_alpha(speck, *one_texel(16, x, y)), near ? 1.0f : 0.0f) << x << ", " << y;
    }
}

// Against the definition, point by point: wherever a sampled point of the triangle reads a texel, it must be found (never too
// low); and a texel further than 1.1 from all sampled points must not.
TEST(SeenAlpha, MatchesBilinearFootprintsOfRandomTriangles) {
  std::mt19937 random(5);
  const auto number = [&] { return float(random() % 4096) / 4096; };
  constexpr uint32_t size = 16;
  for (int round = 0; round < 30; ++round) {
    const glm::vec2 a(number(), number()), b(number(), number()), c(number(), number());
    const Mesh mesh = triangle(a, b, c);
    std::vector<float> nearest(size * size,
                               1e9f);  // greatest of the two axes' distances from a texel's centre, over the samples
    constexpr int steps = 160;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const glm::vec2 p = (a + (b - a) * (float(i) / steps) + (c - a) * (float(j) / steps)) * float(size);
        for (uint32_t t = 0; t < size * size; ++t) {
          const glm::vec2 away = glm::abs(p - glm::vec2(float(t % size) + 0.5f, float(t / size) + 0.5f));
          nearest[t] = std::min(nearest[t], std::max(away.x, away.y));
        }
      }
    for (uint32_t t = 0; t < size * size; ++t) {
      // Texels of the border stand in for those beyond it, which is tested on its own.
      const bool border = t % size == 0 || t % size == size - 1 || t / size == 0 || t / size == size - 1;
      const float seen = seen_alpha(mesh, *one_texel(size, t % size, t / size));
      if (nearest[t] < 1) {
        EXPECT_EQ(seen, 1.0f) << "round " << round << ", texel " << t;
      } else if (nearest[t] > 1.15f && !border) {
        EXPECT_EQ(seen, 0.0f) << "round " << round << ", texel " << t;
      }
    }
  }
}

TEST(SeenAlpha, BordersCountForBothWrapModes) {
  const Mesh corner = triangle({0, 0}, {0.01f, 0}, {0, 0.01f});
  EXPECT_EQ(seen_alpha(corner, *one_texel(16, 0, 0)), 1.0f) << "clamp";
  EXPECT_EQ(seen_alpha(corner, *one_texel(16, 15, 15)), 1.0f) << "repeat";
  EXPECT_EQ(seen_alpha(corner, *one_texel(16, 15, 0)), 1.0f) << "repeat along u";
  EXPECT_EQ(seen_alpha(corner, *one_texel(16, 14, 0)), 0.0f);
  const Mesh next_tile = triangle({1.5f, 0.5f}, {1.51f, 0.5f}, {1.5f, 0.51f});
  EXPECT_EQ(seen_alpha(next_tile, *one_texel(16, 8, 8)), 1.0f);
  const Mesh wide = triangle({-5, 0}, {5, 0}, {0, 1e-6f});
  EXPECT_EQ(seen_alpha(wide, *one_texel(16, 8, 8)), 1.0f) << "many tiles: taken to see everything";
  const Mesh endless = triangle({-1e30f, 0}, {1e30f, 0}, {0, 1});
  EXPECT_EQ(seen_alpha(endless, *one_texel(16, 8, 8)), 1.0f);
}

TEST(SeenAlpha, BordersCountAsTheTextureWraps) {
  const auto seen = [](Wrap u, Wrap v, uint32_t x, uint32_t y, glm::vec2 at) {
    TextureImage texture = *one_texel(16, x, y);
    texture.wraps = {u, v};
    return seen_alpha(triangle(at, at + glm::vec2(1e-4f, 0), at + glm::vec2(0, 1e-4f)), texture) > 0;
  };
  const glm::vec2 corner(0.001f, 0.001f), beyond(1 + 3.5f / 16, 0.5f);  // texel 19 of 16
  EXPECT_TRUE(seen(Wrap::repeat, Wrap::clamp, 15, 0, corner));
  EXPECT_FALSE(seen(Wrap::repeat, Wrap::clamp, 15, 15, corner));
  EXPECT_FALSE(seen(Wrap::mirror, Wrap::clamp, 15, 0, corner));
  EXPECT_TRUE(seen(Wrap::repeat, Wrap::repeat, 3, 8, beyond));
  EXPECT_TRUE(seen(Wrap::mirror, Wrap::repeat, 12, 8, beyond));
  EXPECT_FALSE(seen(Wrap::mirror, Wrap::repeat, 3, 8, beyond));
  EXPECT_TRUE(seen(Wrap::clamp, Wrap::repeat, 15, 8, beyond));
  EXPECT_FALSE(seen(Wrap::clamp, Wrap::repeat, 3, 8, beyond));
}

TEST(SeenAlpha, IsTheGreatestAlphaSeen) {
  Texels texels{4, 1, {{1, 1, 1, 0.2f}, {1, 1, 1, 0.4f}, {1, 1, 1, 0.6f}, {1, 1, 1, 0.8f}}};
  const auto texture = make_texture("steps", texels, TexelMeaning::colour);
  const Mesh left = triangle({0.30f, 0.2f}, {0.33f, 0.2f}, {0.30f, 0.8f});  // between the centres of texels 0 and 1
  EXPECT_FLOAT_EQ(seen_alpha(left, *texture), 0.4f);
}

// An atlas whose right half is transparent but whose mesh uses only the left: nothing is called for, and the mip chain, which
// would blend both halves, must not show any of it.
TEST(SettleSeenAlpha, UnseenTransparentTexelsOfAnAtlasAreCleared) {
  Texels atlas{64, 64, std::vector<glm::vec4>(64 * 64)};
  for (size_t i = 0; i < atlas.rgba.size(); ++i) atlas.rgba[i] = glm::vec4(0.5f, 0.25f, 0.75f, i % 64 < 32 ? 0.0f : 1.0f);
  Texture texture = make_texture("atlas", atlas, TexelMeaning::colour);
  const Texture before = texture;
  EXPECT_EQ(settle_seen_alpha(triangle({0, 0}, {30.4f / 64, 0}, {0, 1}), texture), 1.0f)
      << "column 63 is column -1 where textures repeat";
  EXPECT_EQ(settle_seen_alpha(triangle({1.6f / 64, 0.1f}, {30.4f / 64, 0.1f}, {0.1f, 1}), texture), 0.0f);
  ASSERT_EQ(texture->levels.size(), before->levels.size());
  for (size_t level = 0; level < before->levels.size(); ++level)
    for (size_t i = 0; i < before->levels[level].size(); ++i)
      EXPECT_EQ(texture->levels[level][i], i % 4 == 3 ? std::byte{0} : before->levels[level][i]);
  EXPECT_NE(before->levels.back()[3], std::byte{0}) << "the shared texture stays as it was";
}

TEST(SettleSeenAlpha, SeenTransparentTexelsStay) {
  Texture texture = one_texel(16, 8, 8, 0.6f);
  const Texture before = texture;
  EXPECT_FLOAT_EQ(settle_seen_alpha(triangle({0, 0}, {1, 0}, {1, 1}), texture), 0.6f);
  EXPECT_EQ(texture, before);
}

}  // namespace
}  // namespace lamina
