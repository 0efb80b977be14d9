// SPDX-License-Identifier: Apache-2.0
// Whole frames: passes in order, the same bits every time and on every backend, times, and nothing left behind.
#include <fstream>

#include "tests/backend/rig.h"

namespace lamina {
namespace {

class BackendFrames : public BackendTest {
 protected:
  // Something of everything, alike in no direction: a textured, blended, depth-tested mesh over a pattern, then a second pass
  // that turns the picture into another. Returns the last target's bytes.
  std::vector<std::byte> asymmetric_picture() {
    constexpr uint32_t width = 37, height = 23;
    std::vector<uint8_t> texels;
    for (int i = 0; i < 16 * 8 * 4; ++i) texels.push_back(static_cast<uint8_t>(i * i * 7 + i));
    const TextureId pattern = texture(Format::rgba8_srgb, 16, 8, texels);
    const TextureId first = target(Format::rgba16_float, width, height), last = target(Format::rgba8_unorm, width, height);
    const TextureId depth = target(Format::d32_float, width, height);
    const Look solid{.colors = {Format::rgba16_float}, .depth_format = Format::d32_float, .depth = Depth::read_write};
    Look glass = solid;
    glass.blend = {Blend::alpha};
    glass.cull = Cull::back;

    Draw ground = triangles(pipeline(full_screen, R"(
layout(location = 0) out vec4 c;
void main() { c = vec4(gl_FragCoord.x / 37, gl_FragCoord.y * gl_FragCoord.y / 600, fract(gl_FragCoord.x * 0.31), 1); })",
                                     solid));
    Draw over = triangles(pipeline(R"(
layout(location = 0) out vec2 uv;
void main() {  // two overlapping triangles, one of them facing away, both cutting through the ground's depth
  vec3 corner[6] = vec3[](vec3(-0.9, -0.7, 0.1), vec3(-0.4, 0.8, 0.4), vec3(0.7, 0.3, 0.9),
                          vec3(-0.2, -0.9, 0.2), vec3(0.9, -0.6, 0.2), vec3(0.1, 0.9, 0.2));
  gl_Position = vec4(corner[LAMINA_VERTEX_INDEX], 1);
  uv = corner[LAMINA_VERTEX_INDEX].xy * 1.7;
})",
                                   R"(
layout(binding = 0) uniform sampler2D pattern;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 c;
void main() { c = vec4(texture(pattern, uv).rgb, 0.6); })",
                                   glass),
                          6);
    over.textures = {{.binding = 0, .texture = pattern, .sampler = {.filter = Filter::linear, .wrap = Wrap::repeat}}};
    Pass scene = raster(first, {ground, over});
    scene.depth = Attachment{.texture = depth, .clear = {1}};
    Draw turn = triangles(pipeline(full_screen, R"(
layout(binding = 0) uniform sampler2D picture;
layout(location = 0) out vec4 c;
void main() {
  vec4 here = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
  vec4 left = texelFetch(picture, ivec2(max(gl_FragCoord.x - 1, 0), gl_FragCoord.y), 0);
  c = vec4(sqrt(abs(here.rgb - 0.5 * left.bgr)), here.a);
})",
                                   {.colors = {Format::rgba8_unorm}}));
    turn.textures = {{.binding = 0, .texture = first, .sampler = {.filter = Filter::nearest}}};
    frame_ = {scene, raster(last, {turn})};
    run(frame_);
    return backend().read_texture(last);
  }
  // The passes of asymmetric_picture(), to run again.
  const std::vector<Pass>& frame() const { return frame_; }
  TextureId last_target() const { return frame_.back().colors[0].texture; }

  // A pass that writes `from` plus 1 into `into`.
  Pass add_one(PipelineId plus_one, TextureId from, TextureId into) {
    Draw draw = triangles(plus_one);
    draw.textures = {{.binding = 0, .texture = from, .sampler = {.filter = Filter::nearest}}};
    return raster(into, {draw});
  }
  static constexpr const char* add_one_source = R"(
layout(binding = 0) uniform sampler2D from;
layout(location = 0) out vec4 c;
void main() { c = texelFetch(from, ivec2(gl_FragCoord.xy), 0) + 1; })";

 private:
  std::vector<Pass> frame_;
};
LAMINA_ON_EVERY_BACKEND(BackendFrames);

TEST_P(BackendFrames, EveryPassSeesWhatThePassesBeforeItWrote) {
  const TextureId a = target(Format::rgba32_float, 64, 64), b = target(Format::rgba32_float, 64, 64);
  const PipelineId add = pipeline(full_screen, add_one_source);
  std::vector<Pass> passes = {raster(a, {})};
  for (int i = 0; i < 20; ++i) passes.push_back(i % 2 == 0 ? add_one(add, a, b) : add_one(add, b, a));
  for (const Timing timing : {Timing::off, Timing::bracketed}) {
    run(passes, timing);
    EXPECT_EQ(read<float>(a), std::vector<float>(64 * 64 * 4, 20));
    EXPECT_EQ(read<float>(b), std::vector<float>(64 * 64 * 4, 19));
  }
}

TEST_P(BackendFrames, StagesHandOnToEachOtherInOneFrame) {
  const TextureId drawn = target(Format::rgba32_float, 4, 4), shown = target(Format::rgba32_float, 4, 4);
  const TextureId image =
      backend().create_texture({.name = "image", .width = 4, .height = 4, .format = Format::rgba32_float, .storage = true});
  const BufferId sum = buffer<uint32_t>(BufferUse::storage, {0});
  Draw stretch{.pipeline = compute(R"(
layout(local_size_x = 4, local_size_y = 4) in;
layout(binding = 0) uniform sampler2D from;
layout(rgba32f, binding = 1) uniform writeonly image2D to;
layout(std430, binding = 2) buffer Sum { uint sum; };
void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  vec4 texel = texelFetch(from, p, 0);
  imageStore(to, p, texel * 3);
  atomicAdd(sum, uint(texel.x));
})")};
  stretch.textures = {{.binding = 0, .texture = drawn, .sampler = {.filter = Filter::nearest}}};
  stretch.images = {{.binding = 1, .texture = image}};
  stretch.buffers = {{.binding = 2, .buffer = sum, .kind = BindingKind::storage_buffer}};
  Draw show = triangles(pipeline(full_screen, R"(
layout(binding = 0) uniform sampler2D from;
layout(std430, binding = 1) readonly buffer Sum { uint sum; };
layout(location = 0) out vec4 c;
void main() { c = texelFetch(from, ivec2(gl_FragCoord.xy), 0) + float(sum); })"));
  show.textures = {{.binding = 0, .texture = image, .sampler = {.filter = Filter::nearest}}};
  show.buffers = {{.binding = 1, .buffer = sum, .kind = BindingKind::storage_buffer}};
  Pass two = raster(drawn, {});
  two.colors[0].clear = {2, 2, 2, 2};
  run({two, {.name = "stretch", .kind = PassKind::compute, .draws = {stretch}}, raster(shown, {show})});
  EXPECT_EQ(read<float>(shown), std::vector<float>(4 * 4 * 4, 2 * 3 + 16 * 2));
}

TEST_P(BackendFrames, SameFrameGivesTheSameBitsSixtyTimes) {
  const std::vector<std::byte> once = asymmetric_picture();
  for (int i = 1; i < 60; ++i) {
    run(frame(), i % 2 == 0 ? Timing::off : Timing::bracketed);
    ASSERT_EQ(backend().read_texture(last_target()), once) << "run " << i;
  }
}

TEST_P(BackendFrames, PictureIsAlikeInNoDirection) {
  const auto pixels = values_of<uint32_t>(asymmetric_picture());
  constexpr size_t width = 37, height = 23;
  size_t mirrored = 0, flipped = 0;
  for (size_t y = 0; y < height; ++y)
    for (size_t x = 0; x < width; ++x) {
      mirrored += pixels[y * width + x] == pixels[y * width + width - 1 - x];
      flipped += pixels[y * width + x] == pixels[(height - 1 - y) * width + x];
    }
  EXPECT_LT(mirrored, pixels.size() / 10);
  EXPECT_LT(flipped, pixels.size() / 10);
}

// Software rasterizers of one library share their arithmetic; this is the bound that the comparisons rest on.
TEST_P(BackendFrames, PictureHasTheSameBitsOnEveryBackend) {
  if (!backend().info().software) GTEST_SKIP() << "other devices than software rasterizers may round otherwise";
  const std::vector<std::byte> mine = asymmetric_picture();
  const std::string me = backend().info().driver;
  close();
  size_t compared = 0;
  for (const std::string_view name : backend_names()) {
    if (name == GetParam() || survey_devices(name).usable.empty()) continue;
    open(name);
    if (!backend().info().software) continue;
    const std::vector<std::byte> theirs = asymmetric_picture();
    ASSERT_EQ(theirs.size(), mine.size());
    size_t different = 0;
    for (size_t i = 0; i < mine.size(); ++i) different += mine[i] != theirs[i];
    EXPECT_EQ(different, 0u) << "bytes of " << mine.size() << " differ between " << me << " and " << name;
    ++compared;
    close();
  }
  if (compared == 0) GTEST_SKIP() << "no second backend opens here";
}

TEST_P(BackendFrames, BracketedTimingGivesEveryPassAPositiveTime) {
  const TextureId a = target(Format::rgba32_float, 256, 256), b = target(Format::rgba32_float, 256, 256);
  const PipelineId add = pipeline(full_screen, add_one_source);
  const std::vector<Pass> passes = {raster(a, {}), add_one(add, a, b), add_one(add, b, a)};
  for (int i = 0; i < 5; ++i) {
    const RunTimes times = run(passes, Timing::bracketed);
    ASSERT_EQ(times.pass_ms.size(), passes.size());
    for (const double pass_ms : times.pass_ms) EXPECT_GT(pass_ms, 0);
  }
  const RunTimes untimed = run(passes);
  EXPECT_TRUE(untimed.pass_ms.empty());
  EXPECT_GT(untimed.wall_ms, 0);
}

TEST_P(BackendFrames, NoPassesIsAFrameToo) {
  EXPECT_TRUE(run({}).pass_ms.empty());
  EXPECT_TRUE(run({}, Timing::bracketed).pass_ms.empty());
}

size_t resident_bytes() {
  size_t total_pages = 0, resident_pages = 0;
  std::ifstream("/proc/self/statm") >> total_pages >> resident_pages;
  return resident_pages * 4096;
}

// The first 150 rounds fill what a driver keeps for itself and the sanitizer's hoard of freed memory, at most 256 MB. 300
// more rounds of 2 MB would add 600 MB if what was destroyed stayed.
TEST_P(BackendFrames, DestroyedResourcesLeaveNothingBehind) {
  if (resident_bytes() == 0) GTEST_SKIP() << "/proc/self/statm cannot be read, so memory cannot be measured";
  const std::vector<std::vector<std::byte>> megabyte = {std::vector<std::byte>(1 << 20, std::byte{1})};
  const auto rounds = [&](int count) {
    for (int i = 0; i < count; ++i) {
      const TextureId color = backend().create_texture({.name = "brief", .width = 512, .height = 512, .target = true}, megabyte);
      const BufferId storage = backend().create_buffer("brief", BufferUse::storage, 1 << 20, megabyte[0]);
      if (i % 50 == 0) {
        const PipelineId draws = pipeline(full_screen, "layout(location = 0) out vec4 c; void main() { c = vec4(1); }",
                                          {.colors = {Format::rgba8_unorm}});
        run({raster(color, {triangles(draws)})});
        EXPECT_EQ(read<uint8_t>(color)[5], 255);
        backend().destroy(draws);
      }
      backend().destroy(color);
      backend().destroy(storage);
    }
  };
  rounds(150);
  const size_t before = resident_bytes();
  rounds(300);
  const size_t after = resident_bytes();
  EXPECT_LT(after - std::min(before, after), size_t{200} << 20) << "bytes more than " << before;
}

}  // namespace
}  // namespace lamina
