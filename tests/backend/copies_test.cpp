// SPDX-License-Identifier: Apache-2.0
// Passes that copy a texture to another.
#include "tests/backend/rig.h"

namespace lamina {
namespace {

class BackendCopies : public BackendTest {
 protected:
  static Pass copy(TextureId from, TextureId to) {
    return {.name = "test copy", .kind = PassKind::copy, .copy_from = from, .copy_to = to};
  }
  static Pass clear(TextureId color, float value) {
    Pass pass = raster(color, {});
    pass.colors[0].clear = {value, value, value, value};
    return pass;
  }
  static Pass clear_depth(TextureId depth, float value) {
    Pass pass{.name = "clear depth"};
    pass.depth = Attachment{.texture = depth, .clear = {value}};
    return pass;
  }
};
LAMINA_ON_EVERY_BACKEND(BackendCopies);

// Odd sizes, so that rows of narrow texels end off any alignment. Bytes of depths are of floats from 0 to 1.
TEST_P(BackendCopies, EveryFormatArrivesAsItWas) {
  for (int f = 0; f <= static_cast<int>(Format::d32_float); ++f) {
    const auto format = static_cast<Format>(f);
    SCOPED_TRACE(name_of(format));
    std::vector<std::byte> texels(size_t{13} * 7 * bytes_per_texel(format));
    for (size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::byte>(i % 4 == 3 ? 0x3e : i * 7 % 60);
    const std::vector<std::vector<std::byte>> levels = {texels};
    const TextureId from =
        backend().create_texture({.name = "from", .width = 13, .height = 7, .format = format, .target = true}, levels);
    const TextureId to = target(format, 13, 7);
    run({copy(from, to)});
    EXPECT_EQ(backend().read_texture(to), texels);
    EXPECT_EQ(backend().read_texture(from), texels) << "the source stays";
  }
}

TEST_P(BackendCopies, TakesWhatTheSourceHoldsAtItsPlaceInTheFrame) {
  const TextureId color = target(Format::rgba32_float, 64, 33), first = target(Format::rgba32_float, 64, 33),
                  second = target(Format::rgba32_float, 64, 33);
  const TextureId depth = target(Format::d32_float, 64, 33), kept = target(Format::d32_float, 64, 33);
  for (const Timing timing : {Timing::off, Timing::bracketed}) {
    const std::vector<Pass> passes = {clear(color, 1),         copy(color, first),       clear(color, 2),
                                      copy(color, second),     clear_depth(depth, 0.3f), copy(depth, kept),
                                      clear_depth(depth, 0.8f)};
    const RunTimes times = run(passes, timing);
    EXPECT_EQ(read<float>(first), std::vector<float>(64 * 33 * 4, 1));
    EXPECT_EQ(read<float>(second), std::vector<float>(64 * 33 * 4, 2));
    EXPECT_EQ(read<float>(kept), std::vector<float>(64 * 33, 0.3f));
    EXPECT_EQ(read<float>(depth), std::vector<float>(64 * 33, 0.8f));
    if (timing == Timing::off) continue;
    ASSERT_EQ(times.pass_ms.size(), passes.size());
    for (const double pass_ms : times.pass_ms) EXPECT_GT(pass_ms, 0);
  }
}

// A copied depth is a depth: tested against, and read by a shader.
TEST_P(BackendCopies, CopyOfDepthIsTestedAgainstAndSampled) {
  const TextureId depth = target(Format::d32_float, 2, 2), kept = target(Format::d32_float, 2, 2);
  const TextureId color = target(Format::rgba32_float, 2, 2);
  const Look equal{
      .depth_format = Format::d32_float, .depth = Depth::read, .depth_test = DepthTest::equal, .constants = {depth_at(0.3f)}};
  Pass test =
      raster(color, {triangles(pipeline(full_screen, "layout(location = 0) out vec4 c; void main() { c = vec4(5); }", equal))});
  test.depth = Attachment{.texture = kept, .load = Load::keep};
  run({clear_depth(depth, 0.3f), copy(depth, kept), test});
  EXPECT_EQ(read<float>(color), std::vector<float>(16, 5));
  Draw look;
  look.textures = {{.binding = 0, .texture = kept, .sampler = {.filter = Filter::nearest}}};
  EXPECT_EQ(draw_over(1, 1, R"(
layout(binding = 0) uniform sampler2D depth;
layout(location = 0) out vec4 c;
void main() { c = vec4(texture(depth, vec2(0.5)).r); })",
                      look)
                .at(0, 0),
            0.3f);
}

TEST_P(BackendCopies, OtherLevelsStay) {
  const TextureId from = target(Format::r32_float, 4, 4, 2), to = target(Format::r32_float, 4, 4, 3);
  std::vector<Pass> passes;
  for (const TextureId id : {from, to})
    for (uint32_t level = 0; level < 2; ++level) {
      passes.push_back(clear(id, (id == from ? 1.0f : 10.0f) + static_cast<float>(level)));
      passes.back().colors[0].level = level;
    }
  passes.push_back(copy(from, to));
  run(passes);
  EXPECT_EQ(read<float>(to), std::vector<float>(16, 1));
  EXPECT_EQ(read<float>(to, 1), std::vector<float>(4, 11));
  EXPECT_EQ(read<float>(from, 1), std::vector<float>(4, 2));
}

TEST_P(BackendCopies, TexturesThatAreNotAlikeAreRefused) {
  const TextureId from = target(Format::rgba8_unorm, 4, 4);
  const auto refused = [&](TextureId a, TextureId b) {
    const Error error = error_of([&] { run({copy(a, b)}); });
    EXPECT_EQ(error.subject(), "test copy");
    return error.kind();
  };
  EXPECT_EQ(refused(from, target(Format::rgba8_unorm, 4, 5)), ErrorKind::bad_input);
  EXPECT_EQ(refused(from, target(Format::rgba8_srgb, 4, 4)), ErrorKind::bad_input) << "as many bytes, another meaning";
  EXPECT_EQ(refused(target(Format::d32_float, 4, 4), target(Format::r32_float, 4, 4)), ErrorKind::bad_input);
  EXPECT_EQ(refused(from, from), ErrorKind::bad_input);
  EXPECT_THROW(run({copy(from, {})}), Error);
  EXPECT_NO_THROW(run({clear(from, 0), copy(from, target(Format::rgba8_unorm, 4, 4))}));
}

}  // namespace
}  // namespace lamina
