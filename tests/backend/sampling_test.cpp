// SPDX-License-Identifier: Apache-2.0
// What textures give back: filters, wraps, levels, sRGB, and mip levels made by a pass.
#include "harness/core/srgb.h"
#include "tests/backend/rig.h"

namespace lamina {
namespace {

class BackendSampling : public BackendTest {
 protected:
  // `expression` of one sample, as a shader sees it, of a texture `t`.
  float sample(TextureId id, Sampler sampler, const std::string& expression) {
    Draw draw;
    draw.textures = {{.binding = 2, .texture = id, .sampler = sampler}};
    return draw_over(1, 1,
                     "layout(binding = 2) uniform sampler2D t;\n"
                     "layout(location = 0) out vec4 c; void main() { c = vec4(" +
                         expression + "); }",
                     draw)
        .at(0, 0);
  }
};
LAMINA_ON_EVERY_BACKEND(BackendSampling);

TEST_P(BackendSampling, RowZeroIsAtVZero) {
  const TextureId id = texture<float>(Format::r32_float, 2, 2, {1, 2, 3, 4});
  const Sampler nearest{.filter = Filter::nearest};
  EXPECT_EQ(sample(id, nearest, "texture(t, vec2(0.25, 0.25)).r"), 1);
  EXPECT_EQ(sample(id, nearest, "texture(t, vec2(0.75, 0.25)).r"), 2);
  EXPECT_EQ(sample(id, nearest, "texture(t, vec2(0.25, 0.75)).r"), 3);
  EXPECT_EQ(sample(id, nearest, "texelFetch(t, ivec2(1, 1), 0).r"), 4);
}

TEST_P(BackendSampling, LinearIsBilinear) {
  const TextureId id = texture<float>(Format::r32_float, 2, 2, {0, 1, 2, 5});
  const Sampler linear{.filter = Filter::linear};
  EXPECT_EQ(sample(id, linear, "texture(t, vec2(0.25, 0.25)).r"), 0);
  EXPECT_NEAR(sample(id, linear, "texture(t, vec2(0.5, 0.25)).r"), 0.5, weight_step);
  EXPECT_NEAR(sample(id, linear, "texture(t, vec2(0.25, 0.5)).r"), 1.0, 2 * weight_step);
  EXPECT_NEAR(sample(id, linear, "texture(t, vec2(0.5, 0.5)).r"), 2.0, 5 * weight_step);
  EXPECT_NEAR(sample(id, {.filter = Filter::trilinear}, "texture(t, vec2(0.5, 0.5)).r"), 2.0, 5 * weight_step);
  // Three quarters of the way right, a quarter down: (1 - a)(1 - b) 0 + a (1 - b) 1 + (1 - a) b 2 + a b 5.
  EXPECT_NEAR(sample(id, linear, "texture(t, vec2(0.625, 0.375)).r"), 0.5625 + 0.125 + 0.9375, 5 * weight_step);
}

TEST_P(BackendSampling, ClampHoldsTheEdgeAndRepeatComesRound) {
  const TextureId id = texture<float>(Format::r32_float, 4, 1, {1, 2, 3, 4});
  const Sampler clamp{.filter = Filter::nearest, .wrap = Wrap::clamp}, repeat{.filter = Filter::nearest, .wrap = Wrap::repeat};
  EXPECT_EQ(sample(id, clamp, "texture(t, vec2(1.375, 0.5)).r"), 4);
  EXPECT_EQ(sample(id, clamp, "texture(t, vec2(-0.375, 0.5)).r"), 1);
  EXPECT_EQ(sample(id, repeat, "texture(t, vec2(1.375, 0.5)).r"), 2);
  EXPECT_EQ(sample(id, repeat, "texture(t, vec2(-0.375, 0.5)).r"), 3);
  // At the border, linear mixes the edge with itself or with the other side.
  EXPECT_NEAR(sample(id, {.filter = Filter::linear, .wrap = Wrap::clamp}, "texture(t, vec2(0.0, 0.5)).r"), 1, weight_step);
  EXPECT_NEAR(sample(id, {.filter = Filter::linear, .wrap = Wrap::repeat}, "texture(t, vec2(0.0, 0.5)).r"), 2.5,
              3 * weight_step);
}

TEST_P(BackendSampling, MirrorTurnsEveryOtherRepetitionAndTheAxesAreApart) {
  const TextureId row = texture<float>(Format::r32_float, 4, 1, {1, 2, 3, 4});
  const Sampler mirror{.filter = Filter::nearest, .wrap = Wrap::mirror};
  EXPECT_EQ(sample(row, mirror, "texture(t, vec2(1.125, 0.5)).r"), 4) << "turned";
  EXPECT_EQ(sample(row, mirror, "texture(t, vec2(1.875, 0.5)).r"), 1) << "turned";
  EXPECT_EQ(sample(row, mirror, "texture(t, vec2(2.125, 0.5)).r"), 1) << "as it is again";
  EXPECT_EQ(sample(row, mirror, "texture(t, vec2(-0.375, 0.5)).r"), 2) << "turned";
  EXPECT_NEAR(sample(row, {.filter = Filter::linear, .wrap = Wrap::mirror}, "texture(t, vec2(1.0, 0.5)).r"), 4, weight_step);
  const TextureId square = texture<float>(Format::r32_float, 2, 2, {1, 2, 3, 4});
  const auto at = [&](Wrap u, Wrap v) {
    return sample(square, {.filter = Filter::nearest, .wrap = u, .wrap_v = v}, "texture(t, vec2(1.25, 1.25)).r");
  };
  EXPECT_EQ(at(Wrap::repeat, Wrap::repeat), 1);
  EXPECT_EQ(at(Wrap::clamp, Wrap::repeat), 2);
  EXPECT_EQ(at(Wrap::repeat, Wrap::mirror), 3);
  EXPECT_EQ(at(Wrap::mirror, Wrap::clamp), 4);
}

TEST_P(BackendSampling, OnlyTrilinearReadsOtherLevels) {
  const std::vector<std::vector<std::byte>> levels = {bytes_of(std::vector<float>(16, 1)), bytes_of(std::vector<float>(4, 3)),
                                                      bytes_of(std::vector<float>(1, 7))};
  const TextureId id =
      backend().create_texture({.name = "levels", .width = 4, .height = 4, .levels = 3, .format = Format::r32_float}, levels);
  const auto at_lod = [&](Filter filter, const char* lod) {
    return sample(id, {.filter = filter}, "textureLod(t, vec2(0.3), " + std::string(lod) + ").r");
  };
  EXPECT_EQ(at_lod(Filter::nearest, "1.0"), 1);
  EXPECT_EQ(at_lod(Filter::linear, "2.0"), 1);
  EXPECT_EQ(at_lod(Filter::trilinear, "-1.0"), 1);
  EXPECT_EQ(at_lod(Filter::trilinear, "0.0"), 1);
  EXPECT_NEAR(at_lod(Filter::trilinear, "0.5"), 2, 2 * weight_step);
  EXPECT_EQ(at_lod(Filter::trilinear, "1.0"), 3);
  EXPECT_NEAR(at_lod(Filter::trilinear, "1.25"), 4, 4 * weight_step);
  EXPECT_EQ(at_lod(Filter::trilinear, "9.0"), 7);
  EXPECT_EQ(sample(id, {.filter = Filter::nearest}, "texelFetch(t, ivec2(1), 1).r"), 3) << "a fetch names its level itself";
  EXPECT_EQ(sample(id, {.filter = Filter::nearest}, "textureQueryLevels(t)"), 3);
}

TEST_P(BackendSampling, SrgbIsDecodedBeforeFilteringAndAlphaIsNot) {
  std::vector<uint8_t> bytes;
  for (int i = 0; i < 256; ++i) bytes.insert(bytes.end(), {uint8_t(i), uint8_t(i), uint8_t(i), uint8_t(i)});
  const TextureId ramp = texture(Format::rgba8_srgb, 256, 1, bytes);
  Draw draw;
  draw.textures = {{.binding = 0, .texture = ramp, .sampler = {.filter = Filter::nearest}}};
  const Floats decoded = draw_over(256, 1, R"(
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 c;
void main() { c = texelFetch(t, ivec2(gl_FragCoord.x, 0), 0); })",
                                   draw);
  for (uint32_t i = 0; i < 256; ++i) {
    // Half a step of the encoded byte.
    const double slack = (srgb_decoded((i + 0.5) / 255) - srgb_decoded((i - 0.5) / 255)) / 2;
    EXPECT_NEAR(decoded.at(i, 0, 0), srgb_decoded(i / 255.0), slack) << i;
    EXPECT_NEAR(decoded.at(i, 0, 3), i / 255.0, 1e-6) << i;
  }
  // Black and white meet at linear 0.5, not at the decoded middle byte (0.214).
  const TextureId edge = texture<uint8_t>(Format::rgba8_srgb, 2, 1, {0, 0, 0, 0, 255, 255, 255, 255});
  EXPECT_NEAR(sample(edge, {.filter = Filter::linear}, "texture(t, vec2(0.5, 0.5)).r"), 0.5, 2 * weight_step);
}

// A pass that fills the levels, against boxes of 2x2 texels averaged here.
TEST_P(BackendSampling, MipsPassIsTheBoxFilterOfTheLevelAbove) {
  constexpr uint32_t width = 8, height = 4;
  const auto value = [](uint32_t x, uint32_t y, uint32_t channel) { return (x * 37 + y * 91 + channel * 53) % 256; };
  for (const Format format : {Format::rgba8_unorm, Format::rgba8_srgb, Format::rgba32_float}) {
    SCOPED_TRACE(name_of(format));
    const bool bytes = format != Format::rgba32_float;
    const bool srgb = format == Format::rgba8_srgb;
    const auto decoded = [&](double byte, size_t i) { return srgb && i % 4 < 3 ? srgb_decoded(byte / 255) : byte / 255; };
    std::vector<double> level;  // linear
    std::vector<uint8_t> base_bytes;
    std::vector<float> base_floats;
    for (uint32_t y = 0; y < height; ++y)
      for (uint32_t x = 0; x < width; ++x)
        for (uint32_t channel = 0; channel < 4; ++channel) {
          base_bytes.push_back(static_cast<uint8_t>(value(x, y, channel)));
          base_floats.push_back(static_cast<float>(value(x, y, channel)) / 255);
          level.push_back(decoded(value(x, y, channel), channel));
        }
    const std::vector<std::vector<std::byte>> base = {bytes ? bytes_of(base_bytes) : bytes_of(base_floats)};
    const TextureId id = backend().create_texture(
        {.name = "mips", .width = width, .height = height, .levels = 4, .format = format, .target = true}, base);
    run({{.name = "fill", .kind = PassKind::mips, .mips_of = id}});
    EXPECT_EQ(backend().read_texture(id), base[0]) << "the base level stays";

    uint32_t w = width, h = height;
    for (uint32_t l = 1; l < 4; ++l) {
      const uint32_t next_w = std::max(1u, w / 2), next_h = std::max(1u, h / 2);
      std::vector<double> next, seen;
      for (uint32_t y = 0; y < next_h; ++y)
        for (uint32_t x = 0; x < next_w; ++x)
          for (uint32_t channel = 0; channel < 4; ++channel) {
            double sum = 0;
            for (const uint32_t sy : {2 * y, std::min(2 * y + 1, h - 1)})
              for (const uint32_t sx : {2 * x, std::min(2 * x + 1, w - 1)}) sum += level[(size_t{sy} * w + sx) * 4 + channel];
            next.push_back(sum / 4);
          }
      if (bytes)
        for (const uint8_t byte : read<uint8_t>(id, l)) seen.push_back(byte);
      else
        for (const float real : read<float>(id, l)) seen.push_back(real);
      ASSERT_EQ(seen.size(), next.size());
      for (size_t i = 0; i < seen.size(); ++i) {
        const double expected = !bytes ? next[i] : srgb && i % 4 < 3 ? srgb_encoded(next[i]) * 255 : next[i] * 255;
        // Bytes are rounded once a level.
        EXPECT_NEAR(seen[i], expected, bytes ? 0.6 + l : 1e-6) << "level " << l << " value " << i;
      }
      level = next, w = next_w, h = next_h;
    }
  }
}

TEST_P(BackendSampling, LevelsAreTargetsOfTheirOwnSize) {
  const TextureId id = target(Format::rgba32_float, 16, 8, 3);
  const PipelineId coordinates = pipeline(full_screen, "layout(location = 0) out vec4 c; void main() { c = gl_FragCoord; }");
  for (const uint32_t level : {0u, 2u}) {
    Pass pass = raster(id, {triangles(coordinates)});
    pass.colors[0].level = level;
    run({pass});
  }
  const Floats base = picture(id, 16), second = picture(id, 4, 4, 2);
  ASSERT_EQ(second.values.size(), 4u * 2 * 4);
  EXPECT_EQ(second.at(3, 1, 0), 3.5f);
  EXPECT_EQ(second.at(3, 1, 1), 1.5f);
  EXPECT_EQ(base.at(15, 7, 0), 15.5f) << "the base level stays";
}

// Each level is drawn from the one above it, in one texture.
TEST_P(BackendSampling, OneLevelMayBeReadWhileAnotherIsDrawn) {
  const TextureId id = target(Format::rgba32_float, 8, 8, 4);
  Pass base = raster(id, {});
  base.colors[0].clear = {1, 0, 0, 0};
  std::vector<Pass> passes = {base};
  for (uint32_t level = 1; level < 4; ++level) {
    Draw draw = triangles(pipeline(full_screen, R"(
layout(binding = 0) uniform sampler2D above;
layout(constant_id = 0) const int level = 0;
layout(location = 0) out vec4 c;
void main() { c = 1 + texelFetch(above, ivec2(gl_FragCoord.xy) * 2, level - 1); })",
                                   {.constants = {{0, level}}}));
    draw.textures = {{.binding = 0, .texture = id, .sampler = {.filter = Filter::trilinear}}};
    passes.push_back(raster(id, {draw}));
    passes.back().colors[0].level = level;
  }
  run(passes);
  EXPECT_EQ(picture(id, 1, 4, 3).at(0, 0), 4);
  EXPECT_EQ(picture(id, 8).at(7, 7), 1);
}

}  // namespace
}  // namespace lamina
