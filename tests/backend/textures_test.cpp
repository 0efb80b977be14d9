// SPDX-License-Identifier: Apache-2.0
// Texels in and out: every format, every level, clears, and mip levels.
#include <random>

#include "harness/core/srgb.h"
#include "tests/backend/rig.h"

namespace lamina {
namespace {

using BackendTextures = BackendTest;
LAMINA_ON_EVERY_BACKEND(BackendTextures);

constexpr std::array<Format, 12> all_formats = {
    Format::r8_unorm,     Format::rg8_unorm, Format::rgba8_unorm, Format::rgba8_srgb,   Format::r16_float, Format::rg16_float,
    Format::rgba16_float, Format::r32_float, Format::rg32_float,  Format::rgba32_float, Format::r32_uint,  Format::d32_float};

// Values from 0 to 1 in every channel, different in every texel (any bits for integers).
std::vector<std::byte> texels_of(Format format, size_t count, std::mt19937& random) {
  std::uniform_real_distribution<float> value(0, 1);
  std::vector<std::byte> bytes;
  const auto append = [&](const auto& word) {
    const auto* begin = reinterpret_cast<const std::byte*>(&word);
    bytes.insert(bytes.end(), begin, begin + sizeof(word));
  };
  const uint32_t channel_bytes = bytes_per_texel(format) / channels_of(format);
  for (size_t i = 0; i < count * channels_of(format); ++i) {
    if (channel_bytes == 1) append(static_cast<uint8_t>(random()));
    if (channel_bytes == 2) append(glm::packHalf1x16(value(random)));
    if (channel_bytes == 4 && format == Format::r32_uint) append(static_cast<uint32_t>(random()));
    if (channel_bytes == 4 && format != Format::r32_uint) append(value(random));
  }
  return bytes;
}

// Odd sizes, so that rows of narrow texels end off any alignment.
TEST_P(BackendTextures, EveryLevelOfEveryFormatComesBackAsItWent) {
  std::mt19937 random(1);
  for (const Format format : all_formats) {
    for (const bool is_target : {false, true}) {
      SCOPED_TRACE(std::string(name_of(format)) + (is_target ? " target" : ""));
      const TextureDesc desc{.name = "odd", .width = 13, .height = 7, .levels = 4, .format = format, .target = is_target};
      const std::vector<std::vector<std::byte>> levels = {texels_of(format, 13 * 7, random), texels_of(format, 6 * 3, random),
                                                          texels_of(format, 3 * 1, random), texels_of(format, 1, random)};
      const TextureId id = backend().create_texture(desc, levels);
      for (uint32_t level = 0; level < 4; ++level) EXPECT_EQ(backend().read_texture(id, level), levels[level]) << level;
      EXPECT_THROW(backend().read_texture(id, 4), Error);
      backend().destroy(id);
    }
  }
}

TEST_P(BackendTextures, ClearReachesEveryTexelInTheTargetsOwnFormat) {
  const auto cleared = [&](Format format, std::array<float, 4> value) {
    const TextureId id = target(format, 5, 3);
    Pass pass{.name = "clear"};
    if (format == Format::d32_float)
      pass.depth = Attachment{.texture = id, .clear = value};
    else
      pass.colors = {{.texture = id, .clear = value}};
    run({pass});
    return backend().read_texture(id);
  };
  const auto times_15 = [](auto texel) {
    std::vector<typename decltype(texel)::value_type> all;
    for (int i = 0; i < 15; ++i) all.insert(all.end(), texel.begin(), texel.end());
    return bytes_of(all);
  };
  const float fifth = 51 / 255.0f, two_fifths = 102 / 255.0f, three_fifths = 153 / 255.0f;
  EXPECT_EQ(cleared(Format::r8_unorm, {fifth, 9, 9, 9}), times_15(std::array<uint8_t, 1>{51}));
  EXPECT_EQ(cleared(Format::rg8_unorm, {fifth, two_fifths, 9, 9}), times_15(std::array<uint8_t, 2>{51, 102}));
  EXPECT_EQ(cleared(Format::rgba8_unorm, {fifth, two_fifths, three_fifths, 2}),
            times_15(std::array<uint8_t, 4>{51, 102, 153, 255}));
  // Linear values in, encoded texels out; alpha stays as it is.
  const auto linear = [](int byte) { return static_cast<float>(srgb_decoded(byte / 255.0)); };
  EXPECT_EQ(cleared(Format::rgba8_srgb, {linear(5), linear(100), linear(200), three_fifths}),
            times_15(std::array<uint8_t, 4>{5, 100, 200, 153}));
  const auto half = [](float value) { return glm::packHalf1x16(value); };
  EXPECT_EQ(cleared(Format::r16_float, {-2.5f, 9, 9, 9}), times_15(std::array<uint16_t, 1>{half(-2.5f)}));
  EXPECT_EQ(cleared(Format::rg16_float, {-2.5f, 3, 9, 9}), times_15(std::array<uint16_t, 2>{half(-2.5f), half(3)}));
  EXPECT_EQ(cleared(Format::rgba16_float, {-2.5f, 3, 1024, 0.125f}),
            times_15(std::array<uint16_t, 4>{half(-2.5f), half(3), half(1024), half(0.125f)}));
  EXPECT_EQ(cleared(Format::r32_float, {-0.3f, 9, 9, 9}), times_15(std::array<float, 1>{-0.3f}));
  EXPECT_EQ(cleared(Format::rg32_float, {-0.3f, 1e9f, 9, 9}), times_15(std::array<float, 2>{-0.3f, 1e9f}));
  EXPECT_EQ(cleared(Format::rgba32_float, {-0.3f, 1e9f, 0.1f, 7}), times_15(std::array<float, 4>{-0.3f, 1e9f, 0.1f, 7}));
  EXPECT_EQ(cleared(Format::r32_uint, {70000, 0, 0, 0}), times_15(std::array<uint32_t, 1>{70000}));
  EXPECT_EQ(cleared(Format::d32_float, {0.3f, 0, 0, 0}), times_15(std::array<float, 1>{0.3f}));
}

TEST_P(BackendTextures, DrawnValuesAreStoredInTheTargetsOwnFormat) {
  constexpr const char* fragment = R"(
layout(location = 0) out vec4 c;
void main() { c = vec4(0.2, 0.4, -0.6, 0.75); })";
  const auto drawn = [&](Format format) {
    const TextureId id = target(format, 1, 1);
    run({raster(id, {triangles(pipeline(full_screen, fragment, {.colors = {format}}))})});
    return backend().read_texture(id);
  };
  const auto half = [](float value) { return glm::packHalf1x16(value); };
  const auto encoded = [](double l) { return static_cast<int>(std::lround(srgb_encoded(l) * 255)); };
  EXPECT_EQ(drawn(Format::rgba8_unorm), bytes_of<uint8_t>({51, 102, 0, 191}));
  EXPECT_EQ(drawn(Format::rgba32_float), bytes_of<float>({0.2f, 0.4f, -0.6f, 0.75f}));
  EXPECT_EQ(drawn(Format::rg32_float), bytes_of<float>({0.2f, 0.4f}));
  const auto halves = values_of<uint16_t>(drawn(Format::rgba16_float));
  const std::array<float, 4> written = {0.2f, 0.4f, -0.6f, 0.75f};
  for (size_t i = 0; i < 4; ++i)
    EXPECT_LE(std::abs(halves[i] - half(written[i])), 1) << i;  // either way of rounding is allowed
  const auto srgb = values_of<uint8_t>(drawn(Format::rgba8_srgb));
  EXPECT_NEAR(srgb[0], encoded(0.2), 1);
  EXPECT_NEAR(srgb[1], encoded(0.4), 1);
  EXPECT_EQ(srgb[2], 0);
  EXPECT_EQ(srgb[3], 191) << "alpha is linear";
}

TEST_P(BackendTextures, UnsignedTargetTakesIntegers) {
  const TextureId id = target(Format::r32_uint, 2, 2);
  run({raster(id, {triangles(pipeline(full_screen, R"(
layout(location = 0) out uint c;
void main() { c = 4000000000u + uint(gl_FragCoord.x) + 2u * uint(gl_FragCoord.y); })",
                                      {.colors = {Format::r32_uint}}))})});
  EXPECT_EQ(read<uint32_t>(id), (std::vector<uint32_t>{4000000000u, 4000000001u, 4000000002u, 4000000003u}));
}

TEST_P(BackendTextures, TargetsOfDifferentFormatsAreWrittenTogether) {
  const std::vector<Format> formats = {Format::rgba8_unorm, Format::r32_float, Format::rg16_float};
  Pass pass{.name = "three targets"};
  for (const Format format : formats) pass.colors.push_back({.texture = target(format, 2, 1)});
  pass.draws = {triangles(pipeline(full_screen, R"(
layout(location = 0) out vec4 a;
layout(location = 1) out float b;
layout(location = 2) out vec2 c;
void main() { a = vec4(1, 0, gl_FragCoord.x < 1 ? 0 : 1, 1); b = -gl_FragCoord.x; c = vec2(8, gl_FragCoord.x); })",
                                   {.colors = formats}))};
  run({pass});
  EXPECT_EQ(read<uint8_t>(pass.colors[0].texture), (std::vector<uint8_t>{255, 0, 0, 255, 255, 0, 255, 255}));
  EXPECT_EQ(read<float>(pass.colors[1].texture), (std::vector<float>{-0.5f, -1.5f}));
  std::vector<float> halves;
  for (const uint16_t half : read<uint16_t>(pass.colors[2].texture)) halves.push_back(glm::unpackHalf1x16(half));
  EXPECT_EQ(halves, (std::vector<float>{8, 0.5f, 8, 1.5f}));
}

TEST_P(BackendTextures, KeepLeavesWhatIsNotDrawnAndClearDoesNot) {
  const TextureId id = target(Format::r32_float, 4, 1);
  const auto left_half = [&](float value) {
    return triangles(pipeline(R"(
void main() {  // two triangles over the left half
  vec2 corner[6] = vec2[](vec2(-1, -1), vec2(-1, 1), vec2(0, 1), vec2(-1, -1), vec2(0, 1), vec2(0, -1));
  gl_Position = vec4(corner[LAMINA_VERTEX_INDEX], 0, 1);
})",
                              "layout(constant_id = 0) const float value = 0;\n"
                              "layout(location = 0) out float c; void main() { c = value; }",
                              {.colors = {Format::r32_float}, .constants = {{0, std::bit_cast<uint32_t>(value)}}}),
                     6);
  };
  Pass clear = raster(id, {left_half(5)});
  clear.colors[0].clear = {9, 0, 0, 0};
  run({clear});
  EXPECT_EQ(read<float>(id), (std::vector<float>{5, 5, 9, 9}));
  run({raster(id, {left_half(6)}, Load::keep)});
  EXPECT_EQ(read<float>(id), (std::vector<float>{6, 6, 9, 9}));
  run({raster(id, {left_half(7)}, Load::clear)});
  EXPECT_EQ(read<float>(id), (std::vector<float>{7, 7, 0, 0}));
  Pass discard = raster(id, {left_half(8)}, Load::discard);
  run({discard});
  EXPECT_EQ(read<float>(id)[1], 8);
}

}  // namespace
}  // namespace lamina
