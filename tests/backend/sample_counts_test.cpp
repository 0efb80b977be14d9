// SPDX-License-Identifier: Apache-2.0
// Samples counted exactly: as many as the pixels that a draw covers and that pass its depth test.
#include "tests/backend/rig.h"

namespace lamina {
namespace {

constexpr uint32_t frame_width = 300, frame_height = 200;
// Columns `first` to `first + columns - 1` of 300, at depth z.
constexpr const char* columns_of_300 = R"(
layout(constant_id = 0) const int first = 0;
layout(constant_id = 1) const int columns = 300;
layout(constant_id = 100) const float z = 0.5;
void main() {
  vec2 corner[6] = vec2[](vec2(0, 0), vec2(0, 1), vec2(1, 1), vec2(0, 0), vec2(1, 1), vec2(1, 0));
  vec2 at = corner[LAMINA_VERTEX_INDEX];
  gl_Position = vec4((first + columns * at.x) / 150 - 1, at.y * 2 - 1, z, 1);
})";

class BackendSampleCounts : public BackendTest {
 protected:
  Draw columns(uint32_t first, uint32_t count, float z, Look look, const char* fragment = white) {
    look.constants = {{0, first}, {1, count}, depth_at(z)};
    return triangles(pipeline(columns_of_300, fragment, look), 6);
  }
  static Look tested(DepthTest test = DepthTest::less_equal, Depth depth = Depth::read_write) {
    return {.depth_format = Format::d32_float, .depth = depth, .depth_test = test};
  }
  Pass counted(std::vector<Draw> draws) {
    Pass pass = raster(color_ = color_ ? color_ : target(Format::rgba32_float, frame_width, frame_height), std::move(draws));
    pass.count_samples = true;
    return pass;
  }
  // The same with a depth target that is cleared to 1.
  Pass counted_over_depth(std::vector<Draw> draws) {
    Pass pass = counted(std::move(draws));
    depth_ = depth_ ? depth_ : target(Format::d32_float, frame_width, frame_height);
    pass.depth = Attachment{.texture = depth_, .clear = {1}};
    return pass;
  }
  uint64_t samples_of(const Pass& pass) { return run({pass}).samples.at(0); }

 private:
  TextureId color_, depth_;
};
LAMINA_ON_EVERY_BACKEND(BackendSampleCounts);

TEST_P(BackendSampleCounts, AreThePixelsThatAreCovered) {
  EXPECT_EQ(samples_of(counted({})), 0u);
  EXPECT_EQ(samples_of(counted({columns(0, 300, 0.5f, {})})), 60000u);
  EXPECT_EQ(samples_of(counted({columns(7, 1, 0.5f, {})})), 200u);
  EXPECT_EQ(samples_of(counted({columns(0, 100, 0.5f, {}), columns(50, 100, 0.5f, {})})), 40000u) << "each draw counts";
  Pass part = counted({columns(0, 300, 0.5f, {})});
  part.area = Area{5, 6, 70, 80};
  EXPECT_EQ(samples_of(part), 5600u) << "within the area, and its clear is no draw";
  part.draws = {columns(70, 300, 0.5f, {})};
  EXPECT_EQ(samples_of(part), 5u * 80);
}

TEST_P(BackendSampleCounts, AreThoseThatPassTheDepthTest) {
  const Draw wall = columns(0, 120, 0.25f, tested());
  EXPECT_EQ(samples_of(counted_over_depth({wall})), 120u * 200);
  EXPECT_EQ(samples_of(counted_over_depth({wall, columns(100, 50, 0.5f, tested())})), (120u + 30) * 200);
  EXPECT_EQ(samples_of(counted_over_depth({wall, columns(100, 50, 0.125f, tested())})), (120u + 50) * 200);
  EXPECT_EQ(samples_of(counted_over_depth({wall, columns(0, 300, 0.25f, tested(DepthTest::equal, Depth::read))})),
            (120u + 120) * 200);
  EXPECT_EQ(samples_of(counted_over_depth({wall, columns(0, 300, 0.5f, tested(DepthTest::greater))})), (120u + 120) * 200);
  Look untested = tested();
  untested.depth = Depth::none;
  EXPECT_EQ(samples_of(counted_over_depth({wall, columns(0, 300, 0.5f, untested)})), (120u + 300) * 200);
  Pass hidden = counted_over_depth({columns(0, 300, 0.5f, tested())});
  hidden.depth->clear = {0.25f};
  EXPECT_EQ(samples_of(hidden), 0u);
}

TEST_P(BackendSampleCounts, LeaveOutWhatTheShaderDiscards) {
  constexpr const char* odd_rows = R"(
layout(location = 0) out vec4 c;
void main() { if (int(gl_FragCoord.y) % 2 == 0) discard; c = vec4(1); })";
  EXPECT_EQ(samples_of(counted({columns(10, 30, 0.5f, {}, odd_rows)})), 30u * 100);
  EXPECT_EQ(samples_of(counted_over_depth({columns(10, 30, 0.5f, tested(), odd_rows)})), 30u * 100);
}

TEST_P(BackendSampleCounts, NeedNoColourTarget) {
  Look alone = tested();
  alone.colors = {};
  Pass pass =
      counted_over_depth({columns(3, 40, 0.5f, alone, "void main() {}"), columns(0, 20, 0.75f, alone, "void main() {}")});
  pass.colors = {};
  EXPECT_EQ(samples_of(pass), (40u + 3) * 200);
}

TEST_P(BackendSampleCounts, StandBesideThePassesThatAsk) {
  const Draw all = columns(0, 300, 0.5f, {}), some = columns(0, 3, 0.5f, {});
  Pass silent = counted({all});
  silent.count_samples = false;
  for (const Timing timing : {Timing::off, Timing::bracketed}) {
    EXPECT_TRUE(run({silent, silent}, timing).samples.empty());
    const RunTimes times = run({silent, counted({some}), silent, counted({all})}, timing);
    EXPECT_EQ(times.samples, (std::vector<uint64_t>{0, 600, 0, 60000}));
    EXPECT_EQ(times.pass_ms.size(), timing == Timing::off ? 0u : 4u);
    EXPECT_EQ(run({counted({all})}, timing).samples, std::vector<uint64_t>{60000}) << "a shorter frame after a longer one";
  }
  EXPECT_TRUE(run({}).samples.empty());
}

// Devices run shaders for whole blocks of fragments, at least of two by two where a shader may take derivatives.
TEST_P(BackendSampleCounts, OfIssuedFragmentsAreWholeBlocks) {
  const auto issued = [&](std::vector<Draw> draws) {
    Pass pass = counted(std::move(draws));
    pass.count_issued_fragments = true;
    const RunTimes times = run({pass});
    return times.issued_fragments.empty() ? 0 : times.issued_fragments.at(0);
  };
  if (!backend().info().issued_fragment_counts) {
    EXPECT_EQ(issued({columns(0, 300, 0.5f, {})}), 0u) << "a device that does not tell says nothing";
    GTEST_SKIP() << "the device does not tell";
  }
  EXPECT_EQ(issued({}), 0u);
  EXPECT_EQ(issued({columns(0, 300, 0.5f, {})}) / 60000, 1u) << "few lie outside of what covers all";
  EXPECT_GE(issued({columns(7, 1, 0.5f, {})}), 200u);
  EXPECT_EQ(issued({columns(0, 100, 0.5f, {}), columns(0, 100, 0.5f, {})}), 2 * issued({columns(0, 100, 0.5f, {})}));
  Pass silent = counted({columns(0, 300, 0.5f, {})});
  EXPECT_TRUE(run({silent}).issued_fragments.empty());
}

// More than 16 bits hold, and more than one thread of a rasterizer draws.
TEST_P(BackendSampleCounts, AreExactWhereTheyAreLarge) {
  Pass pass = raster(target(Format::r8_unorm, 2048, 1024), {});
  const Draw over = triangles(
      pipeline(full_screen, "layout(location = 0) out float c; void main() { c = 1; }", {.colors = {Format::r8_unorm}}));
  pass.draws.assign(5, over);
  pass.count_samples = true;
  EXPECT_EQ(samples_of(pass), 5u * 2048 * 1024);
}

}  // namespace
}  // namespace lamina
