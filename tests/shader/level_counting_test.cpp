// SPDX-License-Identifier: Apache-2.0
// The levels that textures are read at, counted on every backend that opens here, against closed forms: a texture of 16 x 16
// texels is read at a level of log2 of the texels from a pixel to the next.
#include <spirv-tools/libspirv.hpp>

#include "harness/shader/spirv_module.h"
#include "tests/shader/counting_run.h"

namespace lamina {
namespace {

constexpr uint64_t each = run_width_px * run_height_px;
using Levels = std::vector<uint64_t>;

class LevelsRead : public CountingRun {
 protected:
  // A fragment shader that reads a texture `t`.
  Counts read(const std::string& statements, Filter filter = Filter::trilinear) {
    const std::string source = R"(
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 o;
void main() { vec2 px = gl_FragCoord.xy; o = vec4(0); )" +
                               statements + " }\n";
    return run({.fragment = source, .filter = filter});
  }
  Levels levels_of(const std::string& statements, Filter filter = Filter::trilinear) {
    return read(statements, filter).levels.at(0);
  }
};

TEST_P(LevelsRead, AreTheStepFromAPixelToTheNext) {
  EXPECT_EQ(levels_of("o = texture(t, px * 4.0 / 16.0);"), (Levels{0, 0, each, 0, 0}));
  EXPECT_EQ(levels_of("o = texture(t, px / 16.0);"), (Levels{each, 0, 0, 0, 0}));
  EXPECT_EQ(levels_of("o = texture(t, px / 64.0);"), (Levels{each, 0, 0, 0, 0})) << "magnified";
  EXPECT_EQ(levels_of("o = texture(t, px * vec2(2, 8) / 16.0);"), (Levels{0, 0, 0, each, 0})) << "the longer way";
  EXPECT_EQ(levels_of("o = texture(t, px * 300.0 / 16.0);"), (Levels{0, 0, 0, 0, each})) << "there is no coarser one";
  EXPECT_EQ(levels_of("o = texture(t, px * 2.828427 / 16.0);"), (Levels{0, each, each, 0, 0})) << "halfway between two";
}

TEST_P(LevelsRead, AreThoseThatTheShaderNames) {
  const uint64_t quarter = each / 4;
  EXPECT_EQ(levels_of("o = textureLod(t, px, float(int(px.x) % 4));"), (Levels{quarter, quarter, quarter, quarter, 0}));
  EXPECT_EQ(levels_of("o = textureLod(t, px, 3.0);"), (Levels{0, 0, 0, each})) << "told without running";
  EXPECT_EQ(levels_of("o = textureLod(t, px, 0.5) + textureLod(t, px, 0.5 + px.x * 0.0);"),
            (Levels{2 * each, 2 * each, 0, 0, 0}));
  EXPECT_EQ(levels_of("o = textureLod(t, px, 99.0 + px.x) + textureLod(t, px, -px.x);"), (Levels{each, 0, 0, 0, each}));
  EXPECT_EQ(levels_of("for (int i = 0; i < int(px.x) % 4; ++i) o += textureLod(t, px, float(i));"),
            (Levels{3 * quarter, 2 * quarter, quarter, 0, 0}));
  EXPECT_EQ(levels_of("o = textureLod(t, px, sqrt(-px.x));")[0], each) << "what is not a number";
}

TEST_P(LevelsRead, OfTexelFetchesDoNotAskTheSampler) {
  const uint64_t quarter = each / 4;
  for (const Filter filter : {Filter::nearest, Filter::trilinear}) {
    const Counts counts =
        read("o = texelFetch(t, ivec2(0), int(px.x) % 4) + texelFetch(t, ivec2(1), 2) + texture(t, px / 16.0);", filter);
    EXPECT_EQ(counts.levels.at(0), (Levels{quarter + each, quarter, quarter + each, quarter, 0}));
    EXPECT_EQ(counts.unfiltered.at(0), 2 * each);
    EXPECT_EQ(counts.fetches.at(0), 3 * each);
  }
}

TEST_P(LevelsRead, ObeyBiasGradientsAndProjection) {
  EXPECT_EQ(levels_of("o = texture(t, px / 16.0, 1.0);"), (Levels{0, each, 0, 0, 0}));
  EXPECT_EQ(levels_of("o = texture(t, px / 64.0, 1.0);"), (Levels{each, 0, 0, 0, 0})) << "-2 and 1 is -1";
  EXPECT_EQ(levels_of("o = textureGrad(t, px, vec2(4.0, 0) / 16.0, vec2(0, 2.0) / 16.0);"), (Levels{0, 0, each, 0, 0}));
  EXPECT_EQ(levels_of("o = textureGrad(t, px, vec2(0), vec2(3.0, 4.0) * 1.6 / 16.0);"), (Levels{0, 0, 0, each, 0}));
  EXPECT_EQ(levels_of("o = textureGrad(t, px, vec2(0), vec2(0));"), (Levels{each, 0, 0, 0, 0}));
  EXPECT_EQ(levels_of("o = textureProj(t, vec3(px * 4.0 / 16.0 * 2.0, 2.0));"), (Levels{0, 0, each, 0, 0}));
  EXPECT_EQ(levels_of("o = textureProj(t, vec4(px * 2.0 / 16.0 * 0.5, 7.0, 0.5));"), (Levels{0, each, 0, 0, 0}));
  EXPECT_EQ(levels_of("o = textureOffset(t, px * 4.0 / 16.0, ivec2(3, -2));"), (Levels{0, 0, each, 0, 0}));
}

TEST_P(LevelsRead, AreTheBaseWhereTheSamplerOrTheTextureHasNoOther) {
  for (const Filter filter : {Filter::nearest, Filter::linear})
    EXPECT_EQ(levels_of("o = texture(t, px) + textureLod(t, px, 2.0) + textureLod(t, px, px.x);", filter), Levels{3 * each});
  EXPECT_EQ(levels_of("o = textureGather(t, px * 4.0 / 16.0, 1);"), Levels{each});
  const Counts counts = run({.fragment = R"(
layout(binding = 2) uniform sampler3D volume;
layout(location = 0) out vec4 o;
void main() { o = texture(volume, gl_FragCoord.xyz) + textureLod(volume, gl_FragCoord.xyz, gl_FragCoord.x); }
)"});
  EXPECT_EQ(counts.levels.at(2), Levels{2 * each}) << "a 3D texture has one level";
}

TEST_P(LevelsRead, CountUntilAFragmentIsDiscardedAndInEveryStage) {
  EXPECT_EQ(levels_of("o = textureLod(t, px, px.x * 0.0 + 1.0); if (int(px.x) % 4 == 1) discard; o += textureLod(t, px, px.x * "
                      "0.0 + 2.0);"),
            (Levels{0, each, each * 3 / 4, 0, 0}));
  const Counts counts = run({.vertex = R"(
layout(binding = 0) uniform sampler2D t;
void main() {
  gl_Position = vec4(LAMINA_VERTEX_INDEX == 1 ? 3 : -1, LAMINA_VERTEX_INDEX == 2 ? 3 : -1, 0, 1);
  gl_Position.z = textureLod(t, vec2(0), float(LAMINA_VERTEX_INDEX)).x * 0.001;
}
)",
                             .fragment = "layout(location = 0) out vec4 o; void main() { o = gl_FragCoord; }\n",
                             .count_vertex = true});
  EXPECT_EQ(counts.levels.at(0), (Levels{1, 1, 1, 0, 0}));
}

TEST_P(LevelsRead, OfEachTextureAreItsOwn) {
  const Counts counts = run({.fragment = R"(
layout(binding = 0) uniform sampler2D first;
layout(binding = 1) uniform sampler2D second;
layout(location = 0) out vec4 o;
void main() {
  vec2 px = gl_FragCoord.xy;
  o = textureLod(first, px, float(int(px.x) % 4));
  if (int(px.x) % 2 == 0) o += textureLod(second, px, px.x * 0.0 + 4.0);
}
)"});
  EXPECT_EQ(counts.levels.at(0), (Levels{each / 4, each / 4, each / 4, each / 4, 0}));
  EXPECT_EQ(counts.levels.at(1), (Levels{0, 0, 0, 0, each / 2}));
}

// The edge cuts quads, whose helpers read too, and do not count.
TEST_P(LevelsRead, LeaveHelpersOut) {
  const Counts counts = run({.vertex = R"(
void main() {
  vec2 px = LAMINA_VERTEX_INDEX == 1 ? vec2(32.5, 0) : LAMINA_VERTEX_INDEX == 2 ? vec2(0, 32.5) : vec2(0);
  gl_Position = vec4(px / vec2(64, 48) * 2.0 - 1.0, 0, 1);
}
)",
                             .fragment = R"(
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 o;
void main() { o = texture(t, gl_FragCoord.xy * 4.0 / 16.0); }
)"});
  EXPECT_EQ(counts.levels.at(0), (Levels{0, 0, 32 * 33 / 2, 0, 0}));
}

// What is counted is the level that the device tells. The one that it takes may be another, by no more than this: a texture
// whose texels are their level's number tells which.
TEST_P(LevelsRead, AreNearThoseThatTheDeviceTakes) {
  std::vector<std::vector<std::byte>> levels;
  for (uint32_t level = 0; level < 5; ++level) {
    const std::vector<float> texels(256u >> 2 * level, static_cast<float>(level));
    const auto bytes = std::as_bytes(std::span(texels));
    levels.emplace_back(bytes.begin(), bytes.end());
  }
  const TextureId ramp =
      backend().create_texture({.name = "levels", .width = 16, .height = 16, .levels = 5, .format = Format::r32_float}, levels);
  const CompiledShader vertex = compile(Stage::vertex, api(), full_screen);
  const CompiledShader fragment = compile(Stage::fragment, api(), R"(
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 o;
void main() {
  float step = exp2(gl_FragCoord.x / 16.0 - 0.5 + floor(gl_FragCoord.y / 4.0) / 16.0);
  vec2 uv = vec2(step * gl_FragCoord.y, 0) / 16.0;
  o = vec4(texture(t, uv).r, textureQueryLod(t, uv).y, 0, 1);
}
)");
  PipelineDesc desc{.name = "levels taken"};
  desc.stages = {{Stage::vertex, vertex.spirv}, {Stage::fragment, fragment.spirv}};
  desc.colors = {Format::rgba32_float};
  desc.bindings = {{0, BindingKind::texture}};
  Draw draw;
  draw.pipeline = backend().create_pipeline(desc);
  draw.count = 3;
  draw.textures = {{0, ramp, Sampler{Filter::trilinear, Wrap::repeat}}};
  const TextureId target = backend().create_texture({.name = "target",
                                                     .width = run_width_px,
                                                     .height = run_height_px,
                                                     .levels = 1,
                                                     .format = Format::rgba32_float,
                                                     .target = true});
  Pass pass{.name = "levels taken"};
  pass.colors = {{.texture = target}};
  pass.draws = {draw};
  backend().run({&pass, 1}, Timing::off);
  const std::vector<std::byte> bytes = backend().read_texture(target);
  std::vector<float> picture(bytes.size() / sizeof(float));
  std::memcpy(picture.data(), bytes.data(), bytes.size());
  double worst = 0;
  for (size_t i = 0; i < picture.size(); i += 4)
    worst = std::max(worst, std::abs(double{picture[i]} - std::clamp(double{picture[i + 1]}, 0.0, 4.0)));
  EXPECT_LT(worst, 0.35);
  RecordProperty("worst", fmt::format("{:.3f}", worst));
}

INSTANTIATE_TEST_SUITE_P(Backends, LevelsRead, ::testing::ValuesIn(backend_names().begin(), backend_names().end()),
                         [](const auto& backend) { return std::string(backend.param); });

// ---- Of the module, without running it. -----------------------------------------------------------------------------------

class LevelReadsOf : public ShaderFiles {
 protected:
  CountingShader counted(Api api, const std::string& statement, LeveledTexture texture) {
    const CompiledShader shader = compile(Stage::fragment, api,
                                          "layout(binding = 0) uniform sampler2D t;\nlayout(location = 0) out vec4 o;\n"
                                          "void main() { vec2 px = gl_FragCoord.xy; " +
                                              statement + " }\n");
    return add_counters(shader, api, {.binding = 9, .textures = {{0, texture}}});
  }
};

TEST_F(LevelReadsOf, NeedCountersOnlyWhereRunningTellsThem) {
  const LeveledTexture mips{5, true, {16, 16, 1}}, flat{5, false, {16, 16, 1}}, one{1, true, {16, 16, 1}};
  for (const Api api : both_apis) {
    for (const char* told : {"o = textureLod(t, px, 2.5);", "o = texelFetch(t, ivec2(0), 1);", "o = textureGather(t, px);"})
      EXPECT_EQ(counted(api, told, mips).words(), 2u) << told;
    EXPECT_EQ(counted(api, "o = texture(t, px);", mips).words(), 2u + 2 * 5);
    EXPECT_EQ(counted(api, "o = texture(t, px);", flat).words(), 2u);
    EXPECT_EQ(counted(api, "o = texture(t, px);", one).words(), 2u);
    EXPECT_EQ(counted(api, "o = texelFetch(t, ivec2(0), int(px.x));", flat).words(), 2u + 2 * 5);
    const ShaderWork work = counted(api, "o = textureLod(t, px, 2.5);", mips).work.executed(10, {});
    EXPECT_EQ(work.levels.at(0), (Levels{0, 0, 10, 10}));
  }
}

TEST_F(LevelReadsOf, AreNotToldOfATextureThatNothingIsKnownOf) {
  const CompiledShader shader = compile(Stage::fragment, Api::vulkan,
                                        "layout(binding = 0) uniform sampler2D t;\nlayout(location = 0) out vec4 o;\n"
                                        "void main() { o = textureLod(t, vec2(0), 0.0); }\n");
  const ShaderWork work = add_counters(shader, Api::vulkan, {.binding = 9}).work.executed(10, {});
  EXPECT_EQ(work.fetches.at(0), 10u);
  EXPECT_TRUE(work.levels.empty());
}

// compile_shader() refuses cubes, but a module that has one asks with three coordinates; SPIRV-Tools judges the module made.
TEST_F(LevelReadsOf, ACubeAreAskedForWithItsDirection) {
  constexpr std::string_view text = R"(
OpCapability Shader
OpMemoryModel Logical GLSL450
OpEntryPoint Fragment %main "main" %o %where
OpExecutionMode %main OriginUpperLeft
OpDecorate %o Location 0
OpDecorate %where Location 0
OpDecorate %c DescriptorSet 0
OpDecorate %c Binding 3
%void = OpTypeVoid
%none = OpTypeFunction %void
%float = OpTypeFloat 32
%vec4 = OpTypeVector %float 4
%image = OpTypeImage %float Cube 0 0 0 1 Unknown
%texture = OpTypeSampledImage %image
%texture_p = OpTypePointer UniformConstant %texture
%in_p = OpTypePointer Input %vec4
%out_p = OpTypePointer Output %vec4
%c = OpVariable %texture_p UniformConstant
%where = OpVariable %in_p Input
%o = OpVariable %out_p Output
%main = OpFunction %void None %none
%start = OpLabel
%loaded = OpLoad %texture %c
%at = OpLoad %vec4 %where
%sample = OpImageSampleImplicitLod %vec4 %loaded %at
OpStore %o %sample
OpReturn
OpFunctionEnd
)";
  CompiledShader shader;
  ASSERT_TRUE(spvtools::SpirvTools(SPV_ENV_VULKAN_1_0).Assemble(std::string(text), &shader.spirv_with_lines));
  const LeveledTexture cube{5, true, {16, 16, 1}};
  const CountingShader counting = add_counters(shader, Api::vulkan, {.binding = 9, .textures = {{3, cube}}});
  EXPECT_EQ(counting.words(), 2u + 2 * 5);
  const SpirvModule module(counting.spirv);
  const auto query = std::ranges::find(module.instructions(), spv::OpImageQueryLod, &SpirvInstruction::op);
  ASSERT_NE(query, module.instructions().end());
  const SpirvInstruction& of_type = module.definition(module.definition(query->words[4]).type);
  ASSERT_EQ(of_type.op(), spv::OpTypeVector);
  EXPECT_EQ(of_type.words[3], 3u);
}

}  // namespace
}  // namespace lamina
