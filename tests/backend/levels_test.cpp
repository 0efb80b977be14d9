// SPDX-License-Identifier: Apache-2.0
// One level of a texture as a texture of its own, read while another level of the same texture is drawn or stored.
#include "tests/backend/rig.h"

namespace lamina {
namespace {

// 16x8 texels in four levels, each texel of a level the largest of the four above it.
struct Pyramid {
  static constexpr uint32_t width = 16, height = 8, levels = 4;
  std::vector<std::vector<float>> expected;
  Pyramid() {
    std::vector<float> base;
    for (uint32_t i = 0; i < width * height; ++i) base.push_back(static_cast<float>(i * 37 % 128) / 128);
    expected.push_back(base);
    for (uint32_t level = 1; level < levels; ++level) {
      const std::vector<float>& above = expected.back();
      const uint32_t w = width >> level, h = height >> level;
      std::vector<float> next;
      for (uint32_t y = 0; y < h; ++y)
        for (uint32_t x = 0; x < w; ++x) {
          const float* corner = &above[(2 * y * w + x) * 2];
          next.push_back(std::max({corner[0], corner[1], corner[2 * w], corner[2 * w + 1]}));
        }
      expected.push_back(next);
    }
  }
  std::vector<std::vector<std::byte>> texels() const { return {bytes_of(expected[0])}; }
};

class BackendLevels : public BackendTest {
 protected:
  TextureId pyramid_base(Format format, bool storage = false) {
    return backend().create_texture({.name = "pyramid",
                                     .width = Pyramid::width,
                                     .height = Pyramid::height,
                                     .levels = Pyramid::levels,
                                     .format = format,
                                     .target = !storage,
                                     .storage = storage},
                                    pyramid_.texels());
  }
  void expect_pyramid(TextureId id) {
    for (uint32_t level = 0; level < Pyramid::levels; ++level) EXPECT_EQ(read<float>(id, level), pyramid_.expected[level]);
  }
  static TextureBinding level_of(TextureId id, uint32_t level, Filter filter = Filter::nearest, uint32_t binding = 0) {
    return {.binding = binding, .texture = id, .sampler = {.filter = filter}, .level = level};
  }
  // Largest of four texels of what the shader takes for level 0.
  static constexpr const char* largest = R"(
layout(binding = 0) uniform sampler2D above;
float largest(ivec2 at) {
  float most = texelFetch(above, 2 * at, 0).r;
  for (int i = 1; i < 4; ++i) most = max(most, texelFetch(above, 2 * at + ivec2(i & 1, i >> 1), 0).r);
  return most;
}
)";

  Pyramid pyramid_;
};
LAMINA_ON_EVERY_BACKEND(BackendLevels);

TEST_P(BackendLevels, OneLevelIsATextureOfItsOwn) {
  std::vector<std::vector<std::byte>> texels;
  for (const uint32_t size : {32, 8, 2}) {
    std::vector<float> level;
    for (uint32_t i = 0; i < size; ++i) level.push_back(static_cast<float>(size * 100 + i));
    texels.push_back(bytes_of(level));
  }
  const TextureId id =
      backend().create_texture({.name = "levels", .width = 8, .height = 4, .levels = 3, .format = Format::r32_float}, texels);
  const auto seen = [&](uint32_t level, Filter filter) {
    Draw draw;
    draw.textures = {level_of(id, level, filter)};
    return draw_over(2, 1, R"(
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 c;
void main() {
  if (gl_FragCoord.x < 1) c = vec4(textureSize(t, 0), textureQueryLevels(t), texelFetch(t, ivec2(1, 0), 0).r);
  else c = vec4(textureLod(t, vec2(0), 0).r, textureLod(t, vec2(0), 5).r, textureLod(t, vec2(1), 1).r, texture(t, vec2(0)).r);
})",
                     draw)
        .values;
  };
  for (const Filter filter : {Filter::nearest, Filter::linear, Filter::trilinear}) {
    SCOPED_TRACE(name_of(filter));
    EXPECT_EQ(seen(0, filter), (std::vector<float>{8, 4, 1, 3201, 3200, 3200, 3231, 3200}));
    EXPECT_EQ(seen(1, filter), (std::vector<float>{4, 2, 1, 801, 800, 800, 807, 800}));
    EXPECT_EQ(seen(2, filter), (std::vector<float>{2, 1, 1, 201, 200, 200, 201, 200}));
  }
}

TEST_P(BackendLevels, LinearMixesWithinTheLevel) {
  const std::vector<std::vector<std::byte>> texels = {bytes_of<float>({9, 9, 9, 9}), bytes_of<float>({1, 3})};
  const TextureId id =
      backend().create_texture({.name = "two", .width = 4, .height = 1, .levels = 2, .format = Format::r32_float}, texels);
  Draw draw;
  draw.textures = {level_of(id, 1, Filter::linear)};
  const Floats seen = draw_over(1, 1, R"(
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 c;
void main() { c = vec4(texture(t, vec2(0.5)).r, texture(t, vec2(0.375, 0.5)).r, texture(t, vec2(0)).r, texture(t, vec2(1)).r); })",
                                draw);
  EXPECT_NEAR(seen.at(0, 0, 0), 2, 2.0 / 256);
  EXPECT_NEAR(seen.at(0, 0, 1), 1.5, 2.0 / 256);
  EXPECT_EQ(seen.at(0, 0, 2), 1);
  EXPECT_EQ(seen.at(0, 0, 3), 3);
}

TEST_P(BackendLevels, OneDrawReadsTwoLevelsAndTheWholeOfOneTexture) {
  const TextureId id = pyramid_base(Format::r32_float);
  std::vector<Pass> passes;
  for (uint32_t level = 1; level < 4; ++level) {
    passes.push_back(raster(id, {}));
    passes.back().colors[0].level = level;
    passes.back().colors[0].clear = {static_cast<float>(level) * 10, 0, 0, 0};
  }
  run(passes);
  Draw draw;
  draw.textures = {level_of(id, 1),
                   level_of(id, 3, Filter::linear, 1),
                   {.binding = 2, .texture = id, .sampler = {.filter = Filter::trilinear}}};
  EXPECT_EQ(draw_over(1, 1, R"(
layout(binding = 0) uniform sampler2D first;
layout(binding = 1) uniform sampler2D third;
layout(binding = 2) uniform sampler2D whole;
layout(location = 0) out vec4 c;
void main() {
  c = vec4(texture(first, vec2(0.5)).r, texture(third, vec2(0.5)).r, textureLod(whole, vec2(0.5), 2).r,
           textureSize(first, 0).x * 100 + textureSize(third, 0).x * 10 + textureQueryLevels(whole));
})",
                      draw)
                .values,
            (std::vector<float>{10, 30, 20, 824}));
}

TEST_P(BackendLevels, PyramidIsDrawnLevelFromLevel) {
  const PipelineId reduce =
      pipeline(full_screen,
               std::string(largest) + "layout(location = 0) out float c; void main() { c = largest(ivec2(gl_FragCoord.xy)); }",
               {.colors = {Format::r32_float}});
  const TextureId id = pyramid_base(Format::r32_float);
  std::vector<Pass> passes;
  for (uint32_t level = 1; level < Pyramid::levels; ++level) {
    Draw draw = triangles(reduce);
    draw.textures = {level_of(id, level - 1)};
    passes.push_back(raster(id, {draw}, Load::discard));
    passes.back().colors[0].level = level;
  }
  for (const Timing timing : {Timing::off, Timing::bracketed, Timing::off}) {
    run(passes, timing);
    expect_pyramid(id);
  }
}

TEST_P(BackendLevels, PyramidOfDepthsIsDrawnLevelFromLevel) {
  const PipelineId reduce =
      pipeline(full_screen, std::string(largest) + "void main() { gl_FragDepth = largest(ivec2(gl_FragCoord.xy)); }",
               {.colors = {}, .depth_format = Format::d32_float, .depth = Depth::read_write});
  const TextureId id = pyramid_base(Format::d32_float);
  std::vector<Pass> passes;
  for (uint32_t level = 1; level < Pyramid::levels; ++level) {
    Draw draw = triangles(reduce);
    draw.textures = {level_of(id, level - 1)};
    passes.push_back({.name = "reduce", .draws = {draw}});
    passes.back().depth = Attachment{.texture = id, .level = level, .clear = {1}};
  }
  run(passes);
  expect_pyramid(id);
}

TEST_P(BackendLevels, PyramidIsComputedLevelFromLevel) {
  const PipelineId reduce = compute("layout(local_size_x = 1) in;\n" + std::string(largest) + R"(
layout(r32f, binding = 1) uniform writeonly image2D below;
void main() { imageStore(below, ivec2(gl_GlobalInvocationID.xy), vec4(largest(ivec2(gl_GlobalInvocationID.xy)))); })");
  const TextureId id = pyramid_base(Format::r32_float, /*storage=*/true);
  Pass all{.name = "reduce", .kind = PassKind::compute};  // dispatches of one pass see what the ones before them wrote
  for (uint32_t level = 1; level < Pyramid::levels; ++level) {
    Draw draw{.pipeline = reduce, .groups = {Pyramid::width >> level, Pyramid::height >> level, 1}};
    draw.textures = {level_of(id, level - 1)};
    draw.images = {{.binding = 1, .texture = id, .level = level}};
    all.draws.push_back(draw);
  }
  run({all});
  expect_pyramid(id);
}

// Up again: a level is drawn from the one below it and its own earlier content, blended.
TEST_P(BackendLevels, LevelsAreAddedUpFromTheSmallest) {
  const TextureId id = target(Format::r32_float, 4, 4, 3);
  const PipelineId add = pipeline(full_screen, R"(
layout(binding = 0) uniform sampler2D below;
layout(location = 0) out float c;
void main() { c = texelFetch(below, ivec2(gl_FragCoord.xy) / 2, 0).r; })",
                                  {.colors = {Format::r32_float}, .blend = {Blend::additive}});
  std::vector<Pass> passes;
  for (uint32_t level = 0; level < 3; ++level) {
    passes.push_back(raster(id, {}));
    passes.back().colors[0].level = level;
    passes.back().colors[0].clear = {std::array{1.0f, 10.0f, 100.0f}[level], 0, 0, 0};
  }
  for (const uint32_t level : {1u, 0u}) {
    Draw draw = triangles(add);
    draw.textures = {level_of(id, level + 1)};
    passes.push_back(raster(id, {draw}, Load::keep));
    passes.back().colors[0].level = level;
  }
  run(passes);
  EXPECT_EQ(read<float>(id, 2), std::vector<float>(1, 100));
  EXPECT_EQ(read<float>(id, 1), std::vector<float>(4, 110));
  EXPECT_EQ(read<float>(id, 0), std::vector<float>(16, 111));
}

TEST_P(BackendLevels, LevelThatIsNotThereOrIsDrawnIntoIsRefused) {
  const TextureId id = target(Format::rgba32_float, 4, 4, 2), other = target(Format::rgba32_float, 4, 4);
  const PipelineId reads = pipeline(full_screen, R"(
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 c;
void main() { c = texelFetch(t, ivec2(0), 0); })");
  const auto reading = [&](TextureId into, uint32_t level) {
    Draw draw = triangles(reads);
    draw.textures = {level_of(id, level)};
    return raster(into, {draw});
  };
  EXPECT_EQ(error_of([&] { run({reading(other, 2)}); }).kind(), ErrorKind::bad_input);
  const Error error = error_of([&] { run({reading(id, 0)}); });
  EXPECT_EQ(error.kind(), ErrorKind::bad_input);
  EXPECT_EQ(error.subject(), "test pass");
  EXPECT_NO_THROW(run({reading(id, 1)}));
  EXPECT_NO_THROW(run({reading(other, 0)}));
}

}  // namespace
}  // namespace lamina
