// SPDX-License-Identifier: Apache-2.0
// Where triangles land and which survive: rows, clip space, depth, facing, blending.
#include "tests/backend/rig.h"

namespace lamina {
namespace {

using BackendRaster = BackendTest;
LAMINA_ON_EVERY_BACKEND(BackendRaster);

TEST_P(BackendRaster, FragCoordGrowsRightAndDownFromTheTopLeftPixelsCentre) {
  const Floats drawn = draw_over(7, 5, "layout(location = 0) out vec4 c; void main() { c = gl_FragCoord; }");
  for (uint32_t y = 0; y < 5; ++y)
    for (uint32_t x = 0; x < 7; ++x) {
      EXPECT_EQ(drawn.at(x, y, 0), static_cast<float>(x) + 0.5f);
      EXPECT_EQ(drawn.at(x, y, 1), static_cast<float>(y) + 0.5f);
      EXPECT_EQ(drawn.at(x, y, 2), 0.5f);  // full_screen's depth
      EXPECT_EQ(drawn.at(x, y, 3), 1.0f);
    }
}

TEST_P(BackendRaster, ClipSpaceHasYDown) {
  const TextureId id = target(Format::rgba32_float, 4, 4);
  // Clip x from 0 to 1 and y from -1 to -0.5: the right half of the top row.
  const PipelineId right_top = pipeline(R"(
void main() {
  vec2 corner[6] = vec2[](vec2(0, -1), vec2(0, -0.5), vec2(1, -0.5), vec2(0, -1), vec2(1, -0.5), vec2(1, -1));
  gl_Position = vec4(corner[LAMINA_VERTEX_INDEX], 0, 1);
})",
                                        white);
  run({raster(id, {triangles(right_top, 6)})});
  const Floats drawn = picture(id, 4);
  for (uint32_t y = 0; y < 4; ++y)
    for (uint32_t x = 0; x < 4; ++x) EXPECT_EQ(drawn.at(x, y), y == 0 && x >= 2 ? 1 : 0) << x << "," << y;
}

// Coverage against edge functions at pixel centres. Vertices lie on quarter pixels, so no device moves them, and no centre lies
// on an edge.
TEST_P(BackendRaster, TriangleCoversThePixelsWhoseCentresLieInside) {
  constexpr uint32_t width = 16, height = 12;
  constexpr float corners[3][2] = {{1.25f, 0.75f}, {4.25f, 11.25f}, {14.75f, 3.25f}};
  const TextureId id = target(Format::rgba32_float, width, height);
  const PipelineId drawn = pipeline(R"(
void main() {
  vec2 corner_px[3] = vec2[](vec2(1.25, 0.75), vec2(4.25, 11.25), vec2(14.75, 3.25));
  gl_Position = vec4(corner_px[LAMINA_VERTEX_INDEX] / vec2(16, 12) * 2 - 1, 0, 1);
})",
                                    white);
  run({raster(id, {triangles(drawn)})});
  const Floats seen = picture(id, width);
  int covered = 0;
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) {
      bool inside = true;
      for (int i = 0; i < 3; ++i) {
        const float* a = corners[i];
        const float* b = corners[(i + 1) % 3];
        const float px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
        const float side = (b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0]);
        ASSERT_NE(side, 0) << "a centre on an edge proves nothing";
        inside = inside && side < 0;
      }
      covered += inside;
      EXPECT_EQ(seen.at(x, y), inside ? 1 : 0) << x << "," << y;
    }
  EXPECT_GT(covered, 40);
}

// Depth tests: a target cleared to `before`, one triangle over it at depth `z`.
struct DepthResult {
  float color, depth;
};
class BackendDepth : public BackendTest {
 protected:
  DepthResult draw(float before, float z, Depth mode, DepthTest test = DepthTest::less_equal) {
    const TextureId color = target(Format::rgba32_float, 2, 2), depth = target(Format::d32_float, 2, 2);
    Pass pass = raster(
        color, {triangles(pipeline(
                   full_screen, white,
                   {.depth_format = Format::d32_float, .depth = mode, .depth_test = test, .constants = {depth_at(z)}}))});
    pass.depth = Attachment{.texture = depth, .clear = {before}};
    run({pass});
    return {picture(color, 2).at(1, 1), picture(depth, 2, 1).at(1, 1)};
  }
};
LAMINA_ON_EVERY_BACKEND(BackendDepth);

TEST_P(BackendDepth, IsZeroToOneAndStoredAsGiven) {
  for (const float z : {0.0f, 0.25f, 0.625f, 1.0f}) EXPECT_EQ(draw(1, z, Depth::read_write).depth, z);
}

TEST_P(BackendDepth, OutsideZeroToOneIsClipped) {
  for (const float z : {-0.25f, 1.25f}) EXPECT_EQ(draw(1, z, Depth::none).color, 0) << z;
}

TEST_P(BackendDepth, TestIsLessOrEqual) {
  EXPECT_EQ(draw(0.5f, 0.25f, Depth::read_write).color, 1);
  EXPECT_EQ(draw(0.5f, 0.5f, Depth::read_write).color, 1);
  EXPECT_EQ(draw(0.5f, 0.75f, Depth::read_write).color, 0);
  EXPECT_EQ(draw(0.5f, 0.75f, Depth::read_write).depth, 0.5f);
}

TEST_P(BackendDepth, EqualPassesWhereDepthsAreTheSameAndNowhereElse) {
  const float next = std::nextafter(0.3f, 1.0f), before = std::nextafter(0.3f, 0.0f);
  EXPECT_EQ(draw(0.3f, 0.3f, Depth::read, DepthTest::equal).color, 1);
  EXPECT_EQ(draw(0.3f, next, Depth::read, DepthTest::equal).color, 0);
  EXPECT_EQ(draw(0.3f, before, Depth::read, DepthTest::equal).color, 0);
  EXPECT_EQ(draw(0.5f, 0.25f, Depth::read_write, DepthTest::equal).depth, 0.5f);
}

TEST_P(BackendDepth, GreaterPassesBehindWhatIsThere) {
  EXPECT_EQ(draw(0.5f, 0.25f, Depth::read_write, DepthTest::greater).color, 0);
  EXPECT_EQ(draw(0.5f, 0.25f, Depth::read_write, DepthTest::greater).depth, 0.5f);
  EXPECT_EQ(draw(0.5f, 0.5f, Depth::read_write, DepthTest::greater).color, 0);
  EXPECT_EQ(draw(0.5f, 0.75f, Depth::read_write, DepthTest::greater).color, 1);
  EXPECT_EQ(draw(0.5f, 0.75f, Depth::read_write, DepthTest::greater).depth, 0.75f);
  EXPECT_EQ(draw(0.5f, 0.75f, Depth::read, DepthTest::greater).depth, 0.5f);
  EXPECT_EQ(draw(0, 0.75f, Depth::read_write, DepthTest::greater).depth, 0.75f) << "the farthest of what is drawn";
}

// Each pipeline brings its own test: no draw leaves one behind for the next.
TEST_P(BackendDepth, DrawsOfOnePassTestEachInItsWay) {
  const TextureId color = target(Format::r32_float, 1, 1), depth = target(Format::d32_float, 1, 1);
  const auto add = [&](float amount, float z, DepthTest test) {
    return triangles(pipeline(full_screen,
                              "layout(constant_id = 0) const float amount = 0;\n"
                              "layout(location = 0) out float c; void main() { c = amount; }",
                              {.colors = {Format::r32_float},
                               .depth_format = Format::d32_float,
                               .depth = Depth::read_write,
                               .depth_test = test,
                               .blend = {Blend::additive},
                               .constants = {depth_at(z), {0, std::bit_cast<uint32_t>(amount)}}}));
  };
  Pass pass = raster(
      color, {add(1, 0.75f, DepthTest::greater), add(2, 0.75f, DepthTest::equal), add(4, 0.75f, DepthTest::greater),
              add(8, 0.25f, DepthTest::less_equal), add(16, 0.5f, DepthTest::less_equal), add(32, 0.5f, DepthTest::greater)});
  pass.depth = Attachment{.texture = depth, .clear = {0.5f}};
  run({pass});
  EXPECT_EQ(read<float>(color), std::vector<float>{1 + 2 + 8 + 32});
  EXPECT_EQ(read<float>(depth), std::vector<float>{0.5f});
}

TEST_P(BackendDepth, ReadTestsAndWritesNothing) {
  EXPECT_EQ(draw(0.5f, 0.25f, Depth::read).color, 1);
  EXPECT_EQ(draw(0.5f, 0.25f, Depth::read).depth, 0.5f);
  EXPECT_EQ(draw(0.5f, 0.75f, Depth::read).color, 0);
}

TEST_P(BackendDepth, NoneNeitherTestsNorWrites) {
  EXPECT_EQ(draw(0.5f, 0.75f, Depth::none).color, 1);
  EXPECT_EQ(draw(0.5f, 0.25f, Depth::none).depth, 0.5f);
}

TEST_P(BackendDepth, IsKeptFromPassToPassAndReadAsATexture) {
  const TextureId depth = target(Format::d32_float, 2, 2), color = target(Format::rgba32_float, 2, 2);
  const Look near{.colors = {}, .depth_format = Format::d32_float, .depth = Depth::read_write, .constants = {depth_at(0.25f)}};
  Pass first{.name = "depth alone", .draws = {triangles(pipeline(full_screen, "void main() {}", near))}};
  first.depth = Attachment{.texture = depth, .clear = {1}};
  const Look far{.depth_format = Format::d32_float, .depth = Depth::read, .constants = {depth_at(0.75f)}};
  Pass second = raster(color, {triangles(pipeline(full_screen, white, far))});
  second.depth = Attachment{.texture = depth, .load = Load::keep};
  run({first, second});
  EXPECT_EQ(picture(color, 2).at(0, 0), 0) << "hidden behind what the first pass drew";

  Draw look;
  look.textures = {{.binding = 0, .texture = depth, .sampler = {.filter = Filter::nearest}}};
  EXPECT_EQ(draw_over(2, 2, R"(
layout(binding = 0) uniform sampler2D depth;
layout(location = 0) out vec4 c;
void main() { c = vec4(texture(depth, vec2(0.5)).r); })",
                      look)
                .at(1, 0),
            0.25f);
}

// The left half goes round counter-clockwise as seen (down the left side first), the right half clockwise.
TEST_P(BackendRaster, CounterClockwiseAsSeenIsTheFront) {
  constexpr const char* halves = R"(
void main() {
  vec2 corner[12] = vec2[](vec2(-1, -1), vec2(-1, 1), vec2(0, 1), vec2(-1, -1), vec2(0, 1), vec2(0, -1),
                           vec2(0, -1), vec2(1, 1), vec2(0, 1), vec2(0, -1), vec2(1, -1), vec2(1, 1));
  gl_Position = vec4(corner[LAMINA_VERTEX_INDEX], 0, 1);
})";
  constexpr const char* facing = "layout(location = 0) out vec4 c; void main() { c = vec4(gl_FrontFacing ? 1 : 2); }";
  const auto row = [&](Cull cull) {
    const TextureId id = target(Format::rgba32_float, 4, 3);
    run({raster(id, {triangles(pipeline(halves, facing, {.cull = cull}), 12)})});
    const Floats drawn = picture(id, 4);
    return std::vector<float>{drawn.at(0, 1), drawn.at(1, 1), drawn.at(2, 1), drawn.at(3, 1)};
  };
  EXPECT_EQ(row(Cull::none), (std::vector<float>{1, 1, 2, 2}));
  EXPECT_EQ(row(Cull::back), (std::vector<float>{1, 1, 0, 0}));
  EXPECT_EQ(row(Cull::front), (std::vector<float>{0, 0, 2, 2}));
}

// Every factor is a small power of two, so floats are exact.
TEST_P(BackendRaster, BlendsAreTheirArithmetic) {
  constexpr std::array<float, 4> src = {0.5f, 0.25f, 1, 0.25f}, dst = {0.25f, 0.5f, 0.125f, 0.5f};
  const auto blended = [&](Blend blend, Format format) {
    const TextureId id = target(format, 1, 1);
    Pass pass = raster(
        id, {triangles(pipeline(full_screen, "layout(location = 0) out vec4 c; void main() { c = vec4(0.5, 0.25, 1, 0.25); }",
                                {.colors = {format}, .blend = {blend}}))});
    pass.colors[0].clear = dst;
    run({pass});
    std::vector<float> result;
    if (format == Format::rgba32_float) result = read<float>(id);
    if (format == Format::rgba16_float)
      for (const uint16_t half : read<uint16_t>(id)) result.push_back(glm::unpackHalf1x16(half));
    if (format == Format::rgba8_unorm)
      for (const uint8_t byte : read<uint8_t>(id)) result.push_back(static_cast<float>(byte) / 255);
    return result;
  };
  for (const Format format : {Format::rgba32_float, Format::rgba16_float, Format::rgba8_unorm}) {
    const bool bytes = format == Format::rgba8_unorm;
    const float tolerance = bytes ? 1.01f / 255 : 0;
    const float most = bytes ? 1 : 9;
    for (size_t i = 0; i < 4; ++i) {
      SCOPED_TRACE(std::string(name_of(format)) + " channel " + std::to_string(i));
      const float alpha = (i < 3 ? src[i] * src[3] : src[3]) + dst[i] * (1 - src[3]);
      EXPECT_NEAR(blended(Blend::none, format)[i], src[i], tolerance);
      EXPECT_NEAR(blended(Blend::alpha, format)[i], alpha, tolerance);
      EXPECT_NEAR(blended(Blend::premultiplied, format)[i], std::min(most, src[i] + dst[i] * (1 - src[3])), tolerance);
      EXPECT_NEAR(blended(Blend::additive, format)[i], std::min(most, src[i] + dst[i]), tolerance);
      EXPECT_NEAR(blended(Blend::multiplied, format)[i], src[i] * dst[i], tolerance);
    }
  }
}

// Two targets, two blends, and a draw after it with none: each target has its own arithmetic and no draw leaves it behind.
TEST_P(BackendRaster, EachTargetOfOnePassHasItsOwnBlend) {
  constexpr const char* both = R"(
layout(location = 0) out vec4 a;
layout(location = 1) out float b;
void main() { a = vec4(0.5, 0.25, 2, 0.5); b = 0.5; })";
  const std::vector<Format> formats = {Format::rgba32_float, Format::r32_float};
  const auto drawn = [&](const std::vector<std::vector<Blend>>& blends) {
    Pass pass = raster(target(formats[0], 1, 1), {});
    pass.colors[0].clear = {0.25f, 1, 0.5f, 0.25f};
    pass.colors.push_back({.texture = target(formats[1], 1, 1), .clear = {8, 0, 0, 0}});
    for (const std::vector<Blend>& blend : blends)
      pass.draws.push_back(triangles(pipeline(full_screen, both, {.colors = formats, .blend = blend})));
    run({pass});
    std::vector<float> values = read<float>(pass.colors[0].texture);
    values.push_back(read<float>(pass.colors[1].texture).front());
    return values;
  };
  using enum Blend;
  EXPECT_EQ(drawn({{multiplied, additive}}), (std::vector<float>{0.125f, 0.25f, 1, 0.125f, 8.5f}));
  EXPECT_EQ(drawn({{additive, multiplied}}), (std::vector<float>{0.75f, 1.25f, 2.5f, 0.75f, 4}));
  EXPECT_EQ(drawn({{none, multiplied}}), (std::vector<float>{0.5f, 0.25f, 2, 0.5f, 4}));
  EXPECT_EQ(drawn({{multiplied, none}}), (std::vector<float>{0.125f, 0.25f, 1, 0.125f, 0.5f}));
  EXPECT_EQ(drawn({{alpha, additive}}), (std::vector<float>{0.375f, 0.625f, 1.25f, 0.625f, 8.5f}));
  EXPECT_EQ(drawn({{premultiplied, none}}), (std::vector<float>{0.625f, 0.75f, 2.25f, 0.625f, 0.5f}));
  EXPECT_EQ(drawn({{}}), (std::vector<float>{0.5f, 0.25f, 2, 0.5f, 0.5f})) << "none for all";
  EXPECT_EQ(drawn({{additive, additive}, {multiplied, none}}), (std::vector<float>{0.375f, 0.3125f, 5, 0.375f, 0.5f}));

  const Error error = error_of([&] { drawn({{additive}}); });
  EXPECT_EQ(error.kind(), ErrorKind::bad_input);
  EXPECT_EQ(error.subject(), "test pipeline");
}

TEST_P(BackendRaster, DrawsOfOnePassBlendInOrder) {
  const TextureId id = target(Format::rgba32_float, 1, 1);
  const auto over = [&](const char* color) {
    return triangles(pipeline(full_screen, "layout(location = 0) out vec4 c; void main() { c = " + std::string(color) + "; }",
                              {.blend = {Blend::alpha}}));
  };
  run({raster(id, {over("vec4(1, 0, 0, 0.5)"), over("vec4(0, 1, 0, 0.5)")})});
  EXPECT_EQ(read<float>(id), (std::vector<float>{0.25f, 0.5f, 0, 0.75f}));
}

}  // namespace
}  // namespace lamina
