// SPDX-License-Identifier: Apache-2.0
// Passes that draw depth and no colour, as shadow maps need: any size, cleared to any value, sampled by a later pass.
#include "tests/backend/rig.h"

namespace lamina {
namespace {

class BackendDepthAlone : public BackendTest {
 protected:
  static constexpr Look look(DepthTest test = DepthTest::less_equal) {
    return {.colors = {}, .depth_format = Format::d32_float, .depth = Depth::read_write, .depth_test = test};
  }
  static Pass depth_alone(TextureId depth, float clear, std::vector<Draw> draws) {
    Pass pass{.name = "depth alone", .draws = std::move(draws)};
    pass.depth = Attachment{.texture = depth, .clear = {clear}};
    return pass;
  }
  // Depth runs from 0 at the left edge of the target to 1 at the right one.
  static constexpr const char* ramp = R"(
void main() {
  vec2 corner = vec2(LAMINA_VERTEX_INDEX == 1 ? 3 : -1, LAMINA_VERTEX_INDEX == 2 ? 3 : -1);
  gl_Position = vec4(corner, corner.x / 2 + 0.5, 1);
})";
  // `expression` of a sampler2D `t` over the texture, at every pixel of a picture of this size.
  Floats sampled(TextureId id, Filter filter, uint32_t width, uint32_t height, const std::string& expression) {
    Draw draw;
    draw.textures = {{.binding = 0, .texture = id, .sampler = {.filter = filter}}};
    return draw_over(width, height,
                     "layout(binding = 0) uniform sampler2D t;\n"
                     "layout(location = 0) out vec4 c; void main() { c = vec4(" +
                         expression + "); }",
                     draw);
  }
};
LAMINA_ON_EVERY_BACKEND(BackendDepthAlone);

TEST_P(BackendDepthAlone, AnySizeIsDrawnAndReadTexelByTexel) {
  const PipelineId draws = pipeline(ramp, "void main() {}", look());
  for (const auto& [width, height] : {std::pair{1u, 1u}, {37u, 19u}, {3u, 200u}, {1024u, 512u}}) {
    SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
    const TextureId id = target(Format::d32_float, width, height);
    run({depth_alone(id, 1, {triangles(draws)})});
    const std::vector<float> depths = read<float>(id);
    const Floats seen = sampled(id, Filter::nearest, width, height, "texelFetch(t, ivec2(gl_FragCoord.xy), 0).r");
    ASSERT_EQ(depths.size(), size_t{width} * height);
    for (uint32_t y = 0; y < height; y += 1 + height / 16)
      for (uint32_t x = 0; x < width; x += 1 + width / 64) {
        const float depth = depths[size_t{y} * width + x];
        ASSERT_NEAR(depth, (static_cast<float>(x) + 0.5f) / static_cast<float>(width), 2e-6) << x << "," << y;
        ASSERT_EQ(seen.at(x, y), depth) << x << "," << y;
      }
    backend().destroy(id);
  }
}

// Vulkan leaves the linear filter of depths to the device (lavapipe 22.3 has none); a device without it says so.
TEST_P(BackendDepthAlone, FiltersAreNearestAndWhereTheDeviceHasItLinear) {
  const std::vector<std::vector<std::byte>> texels = {bytes_of<float>({0.125f, 0.25f, 0.5f, 1, 0.125f, 0.75f, 0, 0.5f})};
  const TextureId id = backend().create_texture(
      {.name = "depths", .width = 4, .height = 2, .format = Format::d32_float, .target = true}, texels);
  const std::string at = "texture(t, gl_FragCoord.xy / vec2(8, 2)).r";  // a quarter of a texel left and right of each centre
  const Floats nearest = sampled(id, Filter::nearest, 8, 2, at);
  for (uint32_t x = 0; x < 8; ++x) EXPECT_EQ(nearest.at(x, 0), (std::array{0.125f, 0.25f, 0.5f, 1.0f})[x / 2]) << x;
  for (uint32_t x = 0; x < 8; ++x) EXPECT_EQ(nearest.at(x, 1), (std::array{0.125f, 0.75f, 0.0f, 0.5f})[x / 2]) << x;
  try {
    const Floats linear = sampled(id, Filter::linear, 8, 2, at);
    EXPECT_EQ(linear.at(0, 0), 0.125f) << "the edge is held";
    EXPECT_NEAR(linear.at(1, 0), 0.125f + 0.125f / 4, 1.0 / 256);
    EXPECT_NEAR(linear.at(5, 0), 0.5f + 0.5f / 4, 1.0 / 256);
    EXPECT_NEAR(linear.at(4, 1), 0.75f / 4, 1.0 / 256);
    EXPECT_NEAR(sampled(id, Filter::linear, 1, 1, "texture(t, vec2(0.5)).r").at(0, 0), 1.5 / 4, 1.0 / 256);
  } catch (const Error& error) {
    EXPECT_EQ(backend().info().api, Api::vulkan);
    EXPECT_EQ(error.kind(), ErrorKind::failed);
    EXPECT_NE(error.message().find("nearest"), std::string::npos) << error.what();
  }
}

// A shadow map of another size than the picture, looked up with a comparison in the shader.
TEST_P(BackendDepthAlone, PictureOfAnotherSizeComparesWithIt) {
  const TextureId map = target(Format::d32_float, 50, 20);
  run({depth_alone(map, 1, {triangles(pipeline(ramp, "void main() {}", look()))})});
  const Floats lit = sampled(map, Filter::nearest, 10, 3, "texture(t, gl_FragCoord.xy / vec2(10, 3)).r > 0.5 ? 1 : 0");
  for (uint32_t x = 0; x < 10; ++x) EXPECT_EQ(lit.at(x, 1), x < 5 ? 0 : 1) << x;
}

TEST_P(BackendDepthAlone, IsClearedToAnyValueAndKeptWhereNothingPasses) {
  const PipelineId farther = pipeline(ramp, "void main() {}", look(DepthTest::greater));
  const PipelineId nearer = pipeline(ramp, "void main() {}", look());
  const TextureId id = target(Format::d32_float, 8, 2);
  for (const float clear : {0.0f, 0.3f, 1.0f}) {
    run({depth_alone(id, clear, {})});
    EXPECT_EQ(read<float>(id), std::vector<float>(16, clear));
    run({depth_alone(id, clear, {triangles(farther)})});
    const std::vector<float> far = read<float>(id);
    run({depth_alone(id, clear, {triangles(nearer)})});
    const std::vector<float> near = read<float>(id);
    for (size_t x = 0; x < 8; ++x) {
      const float drawn = (static_cast<float>(x) + 0.5f) / 8;
      EXPECT_NEAR(far[x], std::max(clear, drawn), 1e-6) << x;
      EXPECT_NEAR(near[x], std::min(clear, drawn), 1e-6) << x;
    }
  }
  Pass part = depth_alone(id, 0.25f, {});
  part.area = Area{2, 0, 3, 1};
  run({depth_alone(id, 0.75f, {}), part});
  std::vector<float> expected(16, 0.75f);
  std::fill_n(expected.begin() + 2, 3, 0.25f);
  EXPECT_EQ(read<float>(id), expected);
}

// The fragment shader still runs: what it discards leaves no depth, and what it writes to a buffer arrives.
TEST_P(BackendDepthAlone, FragmentShaderRuns) {
  const TextureId id = target(Format::d32_float, 6, 4);
  const BufferId count = buffer<uint32_t>(BufferUse::storage, {0});
  Draw draw = triangles(pipeline(full_screen, R"(
layout(std430, binding = 0) buffer Count { uint n; } count;
void main() {
  if (gl_FragCoord.x < 2) discard;
  atomicAdd(count.n, 1u);
})",
                                 look()));
  draw.buffers = {{.binding = 0, .buffer = count, .kind = BindingKind::storage_buffer}};
  run({depth_alone(id, 1, {draw})});
  std::vector<float> expected;
  for (int i = 0; i < 24; ++i) expected.push_back(i % 6 < 2 ? 1 : 0.5f);
  EXPECT_EQ(read<float>(id), expected);
  EXPECT_EQ(read<uint32_t>(count), std::vector<uint32_t>{16});
}

}  // namespace
}  // namespace lamina
