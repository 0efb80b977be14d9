// SPDX-License-Identifier: Apache-2.0
// The counting build, run on every backend that opens here, against counts in closed form.
#include "tests/shader/counting_run.h"

namespace lamina {
namespace {

constexpr uint64_t all_pixels = run_width_px * run_height_px;

// The legs of a right triangle in the target's top left corner are 32.5 pixels long, so the pixel in column x and row y is
// covered where (x + 0.5) + (y + 0.5) < 32.5: rows of 32, 31, .. 1 pixels.
constexpr uint64_t corner_pixels = 32 * 33 / 2;
constexpr std::string_view corner = R"(
void main() {
  vec2 px = LAMINA_VERTEX_INDEX == 1 ? vec2(32.5, 0) : LAMINA_VERTEX_INDEX == 2 ? vec2(0, 32.5) : vec2(0);
  gl_Position = vec4(px / vec2(64, 48) * 2.0 - 1.0, 0, 1);
}
)";

TEST_P(CountingRun, FiveTapsOnEveryPixel) {
  const Counts counts = run({.fragment = R"(
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 o;
void main() {
  vec2 uv = gl_FragCoord.xy / 16.0;
  o = texture(t, uv) + texture(t, uv + 0.1) + texture(t, uv + 0.2) + texture(t, uv + 0.3) + texture(t, uv + 0.4);
}
)"});
  EXPECT_EQ(counts.fetches.at(0), all_pixels * 5);
  EXPECT_EQ(counts.invocations, all_pixels);
  EXPECT_EQ(counts.coverage, std::vector<uint32_t>(all_pixels, 1));
  EXPECT_TRUE(counts.early_fragment_tests);
}

// The slanted edge cuts quads, whose outside fragments run as helpers to give texture() its derivatives.
TEST_P(CountingRun, HelperInvocationsDoNotCount) {
  const Counts counts = run({.vertex = corner, .fragment = R"(
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 o;
void main() { o = vec4(texture(t, gl_FragCoord.xy * gl_FragCoord.yx / 64.0).rgb + texture(t, gl_FragCoord.yx / 5.0).rgb, 1); }
)"});
  uint64_t drawn = 0;
  for (size_t i = 0; i < all_pixels; ++i) {
    const bool on = counts.picture[4 * i + 3] == 1.0f;
    drawn += on;
    EXPECT_EQ(counts.coverage[i], on ? 1u : 0u) << "pixel " << i % run_width_px << ", " << i / run_width_px;
  }
  EXPECT_EQ(drawn, corner_pixels);
  EXPECT_EQ(counts.invocations, corner_pixels);
  EXPECT_EQ(counts.fetches.at(0), corner_pixels * 2);
}

TEST_P(CountingRun, LoopsAndBranchesCountWhatTheyExecute) {
  const Counts counts = run({.fragment = R"(
layout(binding = 0) uniform sampler2D t;
layout(binding = 1) uniform sampler2D u;
layout(location = 0) out vec4 o;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  int taps = 1 + (p.x + 3 * p.y) % 7;
  o = vec4(0);
  for (int i = 0; i < taps; ++i) o += textureLod(t, vec2(p) / 16.0 + float(i), 0.0);
  if (p.x % 3 == 0) {
    if (p.y % 2 == 0) o += textureLod(u, vec2(p) / 8.0, 1.0);
  } else {
    o *= 0.5;
  }
  int i = p.y;
  while (true) {
    if (i >= 40) break;
    i += 8;
    if (p.x == 5) continue;
    o += texelFetch(u, ivec2(i) & 15, 0);
  }
}
)"});
  uint64_t of_t = 0, of_u = 0;
  for (uint64_t y = 0; y < run_height_px; ++y)
    for (uint64_t x = 0; x < run_width_px; ++x) {
      of_t += 1 + (x + 3 * y) % 7;
      of_u += x % 3 == 0 && y % 2 == 0;
      if (x != 5 && y < 40) of_u += (40 - y + 7) / 8;
    }
  EXPECT_EQ(counts.fetches.at(0), of_t);
  EXPECT_EQ(counts.fetches.at(1), of_u);
}

TEST_P(CountingRun, FunctionsCountForTheTextureTheyAreGiven) {
  const Counts counts = run({.fragment = R"(
layout(binding = 3) uniform sampler2D a;
layout(binding = 2) uniform sampler2D b;
layout(location = 0) out vec4 o;
vec4 twice(sampler2D s, vec2 uv) { return texture(s, uv) + texture(s, -uv); }
vec4 first_bright(sampler2D s) {
  for (int i = 0; i < 16; ++i)
    if (i == int(gl_FragCoord.x) % 4) return texelFetch(s, ivec2(i), 0);
  return vec4(0);
}
vec4 some(sampler2D s) {
  if (gl_FragCoord.x < 16.0) return vec4(1);
  return texelFetch(s, ivec2(0), 0) + first_bright(s);
}
void main() {
  vec2 uv = gl_FragCoord.xy / 16.0;
  o = twice(a, uv) + twice(b, uv) + twice(a, uv * 2.0) + some(b);
}
)"});
  EXPECT_EQ(counts.fetches.at(3), all_pixels * 4);
  EXPECT_EQ(counts.fetches.at(2), all_pixels * 2 + (run_width_px - 16) * run_height_px * 2);
}

// What discards cannot be inlined into a loop's continuing part: the call stays, and counts all the same.
TEST_P(CountingRun, AFunctionThatCannotBeInlinedCounts) {
  const Counts counts = run({.fragment = R"(
layout(binding = 3) uniform sampler2D t;
layout(location = 0) out vec4 o;
int advance() {
  if (texelFetch(t, ivec2(1), 0).x > 2.0) discard;
  return 1;
}
void main() {
  o = vec4(0);
  for (int i = 0; i < 4; i += advance()) o += vec4(i);
}
)"});
  EXPECT_EQ(counts.invocations, all_pixels);
  EXPECT_EQ(counts.fetches.at(3), all_pixels * 4);
}

TEST_P(CountingRun, EveryKindOfOperationCountsOnce) {
  const Counts counts = run({.fragment = R"(
layout(binding = 0) uniform sampler2D a;
layout(binding = 1) uniform sampler2D b;
layout(binding = 2) uniform sampler2D c;
layout(binding = 3) uniform sampler2D d;
layout(binding = 4) uniform sampler2D e;
layout(binding = 5) uniform sampler2D f;
layout(binding = 6) uniform sampler2D g;
layout(binding = 7) uniform sampler2D only_asked_for_its_size;
layout(location = 0) out vec4 o;
void main() {
  vec2 uv = gl_FragCoord.xy / 16.0;
  o = texelFetch(a, ivec2(gl_FragCoord.xy) & 15, 0);
  o += textureGather(b, uv, 1);
  o += textureLod(c, uv, 2.0);
  o += textureGrad(d, uv, vec2(0.1), vec2(0.2));
  o += textureProj(e, vec3(uv, 2.0));
  o += textureOffset(f, uv, ivec2(1, 2));
  o += texture(g, uv, 1.0);
  o += vec4(textureSize(only_asked_for_its_size, 0), textureQueryLevels(only_asked_for_its_size), 0);
}
)"});
  ASSERT_EQ(counts.fetches.size(), 7u);
  for (uint32_t binding = 0; binding < 7; ++binding) EXPECT_EQ(counts.fetches.at(binding), all_pixels) << "binding " << binding;
}

TEST_P(CountingRun, TexturesOfThreeDimensionsCountAsOthers) {
  const Counts counts = run({.fragment = R"(
layout(binding = 2) uniform sampler3D volume;
layout(binding = 5) uniform sampler2D plane;
layout(location = 0) out vec4 o;
vec4 at(sampler3D s, vec3 where) { return textureLod(s, where, 0.0); }
void main() {
  vec3 where = gl_FragCoord.xyz / 16.0;
  o = texture(volume, where) + at(volume, where.zyx) + texture(plane, where.xy);
  for (int i = 0; i < int(gl_FragCoord.x) % 4; ++i) o += texelFetch(volume, ivec3(gl_FragCoord.y, i, 1) & ivec3(15, 7, 1), 0);
}
)"});
  EXPECT_EQ(counts.fetches.at(2), all_pixels * 2 + all_pixels / 4 * (0 + 1 + 2 + 3));
  EXPECT_EQ(counts.fetches.at(5), all_pixels);
}

TEST_P(CountingRun, AnEarlyReturnCountsWhatCameBefore) {
  const Counts counts = run({.fragment = R"(
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 o;
void main() {
  o = texelFetch(t, ivec2(3), 0);
  if (gl_FragCoord.x < 20.0) return;
  o += texelFetch(t, ivec2(5), 0);
}
)"});
  EXPECT_EQ(counts.fetches.at(0), all_pixels + (run_width_px - 20) * run_height_px);
  EXPECT_EQ(counts.invocations, all_pixels);
}

// A discarding shader counts the fragments that it discards, and what they fetched until then; the coverage map has them too.
TEST_P(CountingRun, DiscardedFragmentsCountUntilTheyAreDiscarded) {
  const Counts counts = run({.fragment = R"(
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 o;
void main() {
  o = vec4(texelFetch(t, ivec2(3), 0).rgb, 1);
  if (int(gl_FragCoord.x) % 4 == 1) discard;
  o += texelFetch(t, ivec2(5), 0);
}
)"});
  EXPECT_FALSE(counts.early_fragment_tests);
  EXPECT_EQ(counts.invocations, all_pixels);
  EXPECT_EQ(counts.fetches.at(0), all_pixels + all_pixels * 3 / 4);
  EXPECT_EQ(counts.covered(), all_pixels);
  EXPECT_EQ(counts.picture[4 * 1 + 3], 0.0f) << "pixel 1 was discarded";
}

constexpr std::string_view near_quad_then_far_quad = R"(
void main() {
  vec2 corner = vec2[](vec2(-1), vec2(1, -1), vec2(-1, 1), vec2(-1, 1), vec2(1, -1), vec2(1))[LAMINA_VERTEX_INDEX % 6];
  gl_Position = vec4(corner, LAMINA_VERTEX_INDEX < 6 ? 0.25 : 0.75, 1);
}
)";

TEST_P(CountingRun, HiddenFragmentsDoNotCountWhereTestsComeFirst) {
  const Counts counts = run({.vertex = near_quad_then_far_quad,
                             .fragment = R"(
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 o;
void main() { o = texelFetch(t, ivec2(gl_FragCoord.xy) & 15, 0) + vec4(gl_FragCoord.z); }
)",
                             .vertices = 12,
                             .depth = true});
  EXPECT_TRUE(counts.early_fragment_tests);
  EXPECT_EQ(counts.invocations, all_pixels);
  EXPECT_EQ(counts.fetches.at(0), all_pixels);
  EXPECT_EQ(counts.coverage, std::vector<uint32_t>(all_pixels, 1));
}

TEST_P(CountingRun, HiddenFragmentsCountWhereTestsComeLast) {
  const Counts counts = run({.vertex = near_quad_then_far_quad,
                             .fragment = R"(
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 o;
void main() {
  if (gl_FragCoord.x < 0.0) discard;
  o = texelFetch(t, ivec2(gl_FragCoord.xy) & 15, 0) + vec4(gl_FragCoord.z);
}
)",
                             .vertices = 12,
                             .depth = true});
  EXPECT_FALSE(counts.early_fragment_tests);
  EXPECT_EQ(counts.invocations, 2 * all_pixels);
  EXPECT_EQ(counts.coverage, std::vector<uint32_t>(all_pixels, 2));
}

TEST_P(CountingRun, AShaderThatWritesMemoryKeepsItsHiddenFragments) {
  const Counts counts = run({.vertex = near_quad_then_far_quad,
                             .fragment = R"(
layout(binding = 3) buffer Tally { uint n; };
layout(location = 0) out vec4 o;
void main() { atomicAdd(n, 1u); o = vec4(gl_FragCoord.z); }
)",
                             .vertices = 12,
                             .depth = true});
  EXPECT_EQ(counts.invocations, 2 * all_pixels);
}

TEST_P(CountingRun, VertexShadersCount) {
  const Counts counts = run({.vertex = R"(
layout(binding = 0) uniform sampler2D t;
void main() {
  vec4 lift = vec4(0);
  for (int i = 0; i <= LAMINA_VERTEX_INDEX; ++i) lift += texelFetch(t, ivec2(i, 0), 0);
  gl_Position = vec4(LAMINA_VERTEX_INDEX == 1 ? 3 : -1, LAMINA_VERTEX_INDEX == 2 ? 3 : -1, lift.x * 0.001, 1);
}
)",
                             .fragment = "layout(location = 0) out vec4 o; void main() { o = gl_FragCoord; }\n",
                             .count_vertex = true});
  EXPECT_EQ(counts.invocations, 3u);
  EXPECT_EQ(counts.fetches.at(0), 1u + 2u + 3u);
  EXPECT_EQ(counts.covered(), 0u) << "the map is the fragment stage's";
}

TEST_P(CountingRun, ComputeShadersCount) {
  const Counts counts = dispatch(R"(
layout(local_size_x = 8, local_size_y = 4) in;
layout(binding = 0) uniform sampler2D t;
layout(binding = 1) buffer Result { vec4 sum[]; };
void main() {
  vec4 s = vec4(0);
  for (uint i = 0u; i < gl_LocalInvocationID.x; ++i) s += textureLod(t, vec2(i) / 8.0, 0.0);
  sum[gl_LocalInvocationIndex] = s;
}
)",
                                 {3, 2, 2});
  EXPECT_EQ(counts.invocations, 8u * 4 * 12);
  EXPECT_EQ(counts.fetches.at(0), (0u + 1 + 2 + 3 + 4 + 5 + 6 + 7) * 4 * 12);
}

TEST_P(CountingRun, SpecializationConstantsSteerWhatIsCounted) {
  const Counts counts = run({.fragment = R"(
layout(constant_id = 7) const int taps = 2;
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 o;
void main() { o = vec4(0); for (int i = 0; i < taps; ++i) o += texelFetch(t, ivec2(i, 1), 0); }
)",
                             .constants = {{7, 6}}});
  EXPECT_EQ(counts.fetches.at(0), all_pixels * 6);
}

TEST_P(CountingRun, CountersCarryIntoTheirHighWord) {
  const Counts counts = run({.fragment = R"(
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 o;
void main() { o = vec4(0); if (gl_FragCoord.x > 0.0) o = texelFetch(t, ivec2(1), 0) + texelFetch(t, ivec2(2), 0); }
)",
                             .preset = {0, 0, 0xfffffff0u, 0, 0xfffffff0u, 6}});
  EXPECT_EQ(counts.invocations, 0xfffffff0ull + all_pixels);
  EXPECT_EQ(counts.fetches.at(0), 2 * ((6ull << 32) + 0xfffffff0ull + all_pixels));
}

// Work belongs to the line that says it, in a function that is called twice too.
TEST_P(CountingRun, LinesHaveTheWorkThatTheySay) {
  const Counts counts = run({.fragment = R"(layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 o;
vec4 twice(float x) {
  vec4 a = texelFetch(t, ivec2(1), 0);
  return a * x;
}
void main() {
  o = twice(2.0);
  if (gl_FragCoord.x < 32.0)
    o += twice(3.0);
  for (int i = 0; i < 5; ++i)
    o -= texelFetch(t, ivec2(i), 0);
}
)"});
  const auto of = [&](uint32_t line) {  // of the text above, before which compile() writes one more
    const auto found = counts.lines.find(line + 1);
    return found == counts.lines.end() ? LineWork{} : found->second;
  };
  EXPECT_EQ(of(4).fetches, all_pixels * 3 / 2);
  EXPECT_EQ(of(4).operations, 0u);
  EXPECT_EQ(of(5).operations, 4 * all_pixels * 3 / 2);
  EXPECT_EQ(of(9).operations, 2 * all_pixels) << "a comparison and a branch";
  EXPECT_EQ(of(10).operations, 4 * all_pixels / 2);
  EXPECT_EQ(of(12).fetches, 5 * all_pixels);
  EXPECT_EQ(of(12).operations, 4 * 5 * all_pixels);
  uint64_t fetches = 0, operations = 0, all_operations = 0;
  for (const auto& [line, work] : counts.lines) fetches += work.fetches, operations += work.operations;
  for (const auto& [name, times] : counts.operations) all_operations += times;
  EXPECT_EQ(fetches, counts.fetches.at(0));
  EXPECT_EQ(operations, all_operations) << "all work has a line";
}

TEST_P(CountingRun, TwoStagesShareABuffer) {
  const CompiledShader vertex = compile(Stage::vertex, api(), R"(
layout(binding = 0) uniform sampler2D t;
void main() {
  gl_Position = vec4(LAMINA_VERTEX_INDEX == 1 ? 3 : -1, LAMINA_VERTEX_INDEX == 2 ? 3 : -1, 0, 1);
  if (LAMINA_VERTEX_INDEX > 0) gl_Position += texelFetch(t, ivec2(0), 0).x * 0.001;
}
)");
  const CompiledShader fragment = compile(Stage::fragment, api(), R"(
layout(binding = 1) uniform sampler2D t;
layout(location = 0) out vec4 o;
void main() { o = vec4(0); for (int i = 0; i < 2; ++i) o += texelFetch(t, ivec2(i), 0); }
)");
  const CountingShader first = add_counters(vertex, api(), {.binding = counter_binding});
  const CountingShader second =
      add_counters(fragment, api(), {.binding = counter_binding, .first_word = 2 + first.words(), .coverage_word = 0});
  const BufferId buffer = make_counters(std::vector<uint32_t>(2 + first.words() + second.words()));
  draw({}, vertex, fragment, first.spirv, second.spirv, buffer);
  const std::vector<uint32_t> words = read_words(buffer);
  EXPECT_EQ(work_of(words, first, 2).fetches.at(0), 2u);
  EXPECT_EQ(counter_at(words, 2), 3u);
  EXPECT_EQ(counter_at(words, 2 + first.words()), all_pixels);
  EXPECT_EQ(work_of(words, second, 2 + first.words()).fetches.at(1), 2 * all_pixels);
}

INSTANTIATE_TEST_SUITE_P(Backends, CountingRun, ::testing::ValuesIn(backend_names().begin(), backend_names().end()),
                         [](const auto& backend) { return std::string(backend.param); });

}  // namespace
}  // namespace lamina
