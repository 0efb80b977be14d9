// SPDX-License-Identifier: Apache-2.0
// The counting build as a module, without running it. counting_run_test.cpp runs it.
#include <gmock/gmock.h>

#include <algorithm>
#include <spirv-tools/libspirv.hpp>

#include "harness/shader/spirv_module.h"
#include "tests/shader/shader_files.h"

namespace lamina {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view three_taps = R"(
layout(binding = 4) uniform sampler2D a;
layout(binding = 1) uniform sampler2D b;
layout(location = 0) out vec4 o;
void main() { o = texture(a, vec2(0)) + texture(b, vec2(1)) + texture(a, vec2(0.5)); }
)";

size_t count_of(const std::vector<uint32_t>& spirv, spv::Op op) {
  const SpirvModule module(spirv);
  return static_cast<size_t>(std::ranges::count(module.instructions(), op, &SpirvInstruction::op));
}

class Counting : public ShaderFiles {};

// The bindings of the textures that the shader reads somewhere.
std::vector<uint32_t> textures_of(const CountingShader& counting) {
  std::vector<uint32_t> bindings;
  const std::vector<uint64_t> none(counting.counters());
  for (const auto& [binding, fetches] : counting.work.executed(0, none).fetches) bindings.push_back(binding);
  return bindings;
}

TEST_F(Counting, CodeWithoutBranchesNeedsNoCounterButTheInvocations) {
  for (const Api api : both_apis) {
    const CountingShader counting = add_counters(compile(Stage::fragment, api, three_taps), api, {.binding = 9});
    EXPECT_EQ(counting.words(), 2u);
    EXPECT_EQ(count_of(counting.spirv, spv::OpAtomicIAdd), 2u) << "two halves";
    const ShaderWork work = counting.work.executed(10, {});
    EXPECT_EQ(work.fetches, (std::map<uint32_t, uint64_t>{{1, 10}, {4, 20}}));
    EXPECT_EQ(work.operations.by_name(), (std::map<std::string, uint64_t>{{"add", 80}}));
  }
}

TEST_F(Counting, ABranchAndALoopNeedACounterEach) {
  for (const Api api : both_apis) {
    const CountingShader counting = add_counters(compile(Stage::fragment, api, R"(
layout(binding = 4) uniform sampler2D a;
layout(location = 0) out vec4 o;
void main() {
  o = texture(a, vec2(0));
  if (o.x > 0.5) o += texture(a, vec2(1)); else o *= 2.0;
  for (int i = 0; i < int(o.y * 8.0); ++i) o += texture(a, vec2(i));
}
)"),
                                                 api, {.binding = 9});
    EXPECT_EQ(counting.counters(), 2u);
  }
}

TEST_F(Counting, TheCounterBufferIsReflectedAtItsBinding) {
  const CountingShader counting = add_counters(compile(Stage::fragment, Api::vulkan, three_taps), Api::vulkan, {.binding = 9});
  const Reflection r = reflect(counting.spirv);
  ASSERT_EQ(r.resources.size(), 3u);
  EXPECT_EQ(r.resources[2].binding, 9u);
  EXPECT_EQ(r.resources[2].kind, BindingKind::storage_buffer);
}

TEST_F(Counting, CoverageAddsFragCoordOnceWhetherTheShaderHasItOrNot) {
  // How often variables are FragCoord, and how often one of those is in the entry point's interface.
  const auto frag_coords = [](const std::vector<uint32_t>& spirv) {
    const SpirvModule module(spirv);
    std::pair<int, int> counts;
    uint32_t variable = 0;
    for (const SpirvInstruction& i : module.instructions())
      if (i.op() == spv::OpDecorate && i.words[2] == spv::DecorationBuiltIn && i.words[3] == spv::BuiltInFragCoord) {
        ++counts.first;
        variable = i.words[1];
      }
    const auto entry = std::ranges::find(module.instructions(), spv::OpEntryPoint, &SpirvInstruction::op);
    constexpr size_t interface_word = 5;  // behind opcode, model, function and the two words of "main"
    counts.second = static_cast<int>(std::ranges::count(entry->words.subspan(interface_word), variable));
    return counts;
  };
  constexpr std::string_view uses_it = "layout(location = 0) out vec4 o;\nvoid main() { o = gl_FragCoord; }\n";
  constexpr auto once = std::pair(1, 1), never = std::pair(0, 0);
  for (const Api api : both_apis)
    for (const std::string_view source : {three_taps, uses_it}) {
      const CompiledShader shader = compile(Stage::fragment, api, source);
      EXPECT_EQ(frag_coords(add_counters(shader, api, {.binding = 9, .coverage_word = 8}).spirv), once);
      EXPECT_EQ(frag_coords(add_counters(shader, api, {.binding = 9}).spirv), source == uses_it ? once : never);
    }
}

TEST_F(Counting, EarlyTestsAreForcedOnlyWhereTheyChangeNothing) {
  struct Case {
    std::string_view declaration, statement;
    bool early;
  };
  const Case cases[] = {
      {"", "o = vec4(1);", true},
      {"layout(binding = 1, r32ui) uniform readonly uimage2D i;", "o = vec4(imageLoad(i, ivec2(0)));", true},
      {"layout(binding = 1) readonly buffer B { float x; };", "o = vec4(x);", true},
      {"", "o = vec4(gl_SampleMaskIn[0]);", true},
      {"", "if (gl_FragCoord.x > 9.0) discard; o = vec4(1);", false},
      {"", "gl_FragDepth = 0.5; o = vec4(1);", false},
      {"", "gl_SampleMask[0] = 1; o = vec4(1);", false},
      {"layout(binding = 1, r32ui) uniform writeonly uimage2D i;", "imageStore(i, ivec2(0), uvec4(1)); o = vec4(1);", false},
      {"layout(binding = 1, r32ui) uniform uimage2D i;", "imageAtomicAdd(i, ivec2(0), 1u); o = vec4(1);", false},
      {"layout(binding = 1) buffer B { float x; };", "x = 2.0; o = vec4(1);", false},
      {"layout(binding = 1) buffer B { uint x; };", "atomicMax(x, 2u); o = vec4(1);", false},
      {"layout(early_fragment_tests) in;", "if (gl_FragCoord.x > 9.0) discard; o = vec4(1);", true},
  };
  for (const Case& c : cases)
    for (const Api api : both_apis) {
      const auto source =
          fmt::format("{}\nlayout(location = 0) out vec4 o;\nvoid main() {{ {} }}\n", c.declaration, c.statement);
      const CountingShader counting = add_counters(compile(Stage::fragment, api, source), api, {.binding = 9});
      EXPECT_EQ(counting.early_fragment_tests, c.early) << source;
      const SpirvModule module(counting.spirv);
      const auto modes = std::ranges::count_if(module.instructions(), [](const SpirvInstruction& i) {
        return i.op() == spv::OpExecutionMode && i.words[2] == spv::ExecutionModeEarlyFragmentTests;
      });
      EXPECT_EQ(modes, c.early ? 1 : 0) << source;
    }
}

TEST_F(Counting, ADeadFunctionDoesNotMakeADiscardingShader) {
  const auto shader = compile(Stage::fragment, Api::vulkan, R"(
layout(location = 0) out vec4 o;
void never() { discard; }
void main() { o = vec4(1); }
)");
  EXPECT_TRUE(add_counters(shader, Api::vulkan, {.binding = 9}).early_fragment_tests);
}

TEST_F(Counting, OtherStagesHaveNoFragmentTestsAndNoCoverage) {
  for (const Api api : both_apis) {
    const auto shader = compile(Stage::vertex, api, R"(
layout(binding = 2) uniform sampler2D heights;
void main() { gl_Position = texelFetch(heights, ivec2(LAMINA_VERTEX_INDEX, 0), 0); }
)");
    const CountingShader counting = add_counters(shader, api, {.binding = 9, .coverage_word = 100});
    EXPECT_FALSE(counting.early_fragment_tests);
    EXPECT_EQ(textures_of(counting), std::vector<uint32_t>{2});
  }
}

TEST_F(Counting, AShaderWithoutTexturesCountsItsInvocationsOnly) {
  const auto shader = compile(Stage::compute, Api::opengl, "layout(local_size_x = 1) in; void main() {}\n");
  const CountingShader counting = add_counters(shader, Api::opengl, {.binding = 0});
  EXPECT_TRUE(textures_of(counting).empty());
  EXPECT_EQ(counting.words(), 2u);
}

TEST_F(Counting, TexturesOfThreeDimensionsCountAsOthers) {
  for (const Api api : both_apis) {
    const auto shader = compile(Stage::fragment, api, R"(
layout(binding = 3) uniform sampler3D volume;
layout(binding = 1) uniform sampler3D fetched;
layout(location = 0) out vec4 o;
float at(sampler3D s, vec3 where) { return textureLod(s, where, 0.0).r; }
void main() { o = texture(volume, vec3(0)) + at(volume, vec3(1)) + texelFetch(fetched, ivec3(0), 0); }
)");
    const CountingShader counting = add_counters(shader, api, {.binding = 9});
    EXPECT_EQ(textures_of(counting), (std::vector<uint32_t>{1, 3}));
  }
}

TEST_F(Counting, QueriesAndStorageImagesAreNoTextureOperations) {
  const auto shader = compile(Stage::fragment, Api::vulkan, R"(
layout(binding = 0) uniform sampler2D a;
layout(binding = 1, rgba8) uniform readonly image2D i;
layout(location = 0) out vec4 o;
void main() { o = vec4(textureSize(a, 0), textureQueryLevels(a), textureQueryLod(a, vec2(0)).x) + imageLoad(i, ivec2(0)); }
)");
  EXPECT_TRUE(textures_of(add_counters(shader, Api::vulkan, {.binding = 9})).empty());
}

TEST_F(Counting, ATakenBindingIsRefusedByName) {
  const Error error =
      error_of([&] { add_counters(compile(Stage::fragment, Api::vulkan, three_taps), Api::vulkan, {.binding = 4}); });
  EXPECT_EQ(error.kind(), ErrorKind::failed);
  EXPECT_THAT(error.message(), HasSubstr("binding 4 is taken by 'a'"));
}

// A function that discards cannot be inlined into a loop's continuing part, so its parameter stays a parameter.
TEST_F(Counting, ATextureThatCannotBeTracedIsRefused) {
  const auto shader = compile(Stage::fragment, Api::vulkan, R"(
layout(binding = 0) uniform sampler2D a;
layout(location = 0) out vec4 o;
int step_of(sampler2D s) { if (texture(s, vec2(0)).x > 0.5) discard; return 1; }
void main() { o = vec4(0); for (int i = 0; i < 4; i += step_of(a)) o += vec4(1); }
)");
  const Error error = error_of([&] { add_counters(shader, Api::vulkan, {.binding = 9}); });
  EXPECT_THAT(error.message(), HasSubstr("'s'"));
}

// compile_shader() refuses arrays of textures, but a module that has one counts all its elements together.
TEST_F(Counting, AnArrayOfTexturesIsOneCount) {
  constexpr std::string_view text = R"(
OpCapability Shader
OpMemoryModel Logical GLSL450
OpEntryPoint Fragment %main "main" %o
OpExecutionMode %main OriginUpperLeft
OpDecorate %o Location 0
OpDecorate %a DescriptorSet 0
OpDecorate %a Binding 3
%void = OpTypeVoid
%none = OpTypeFunction %void
%float = OpTypeFloat 32
%int = OpTypeInt 32 1
%uint = OpTypeInt 32 0
%vec2 = OpTypeVector %float 2
%vec4 = OpTypeVector %float 4
%image = OpTypeImage %float 2D 0 0 0 1 Unknown
%texture = OpTypeSampledImage %image
%two = OpConstant %uint 2
%one = OpConstant %int 1
%textures = OpTypeArray %texture %two
%textures_p = OpTypePointer UniformConstant %textures
%texture_p = OpTypePointer UniformConstant %texture
%vec4_p = OpTypePointer Output %vec4
%half = OpConstant %float 0.5
%where = OpConstantComposite %vec2 %half %half
%here = OpConstantNull %vec2
%a = OpVariable %textures_p UniformConstant
%o = OpVariable %vec4_p Output
%main = OpFunction %void None %none
%start = OpLabel
%element = OpAccessChain %texture_p %a %one
%loaded = OpLoad %texture %element
%copy = OpCopyObject %texture %loaded
%sample = OpImageSampleImplicitLod %vec4 %copy %where
%again = OpImageSampleImplicitLod %vec4 %loaded %here
%sum = OpFAdd %vec4 %sample %again
OpStore %o %sum
OpReturn
OpFunctionEnd
)";
  CompiledShader shader;
  ASSERT_TRUE(spvtools::SpirvTools(SPV_ENV_VULKAN_1_0).Assemble(std::string(text), &shader.spirv_with_lines));
  const CountingShader counting = add_counters(shader, Api::vulkan, {.binding = 9, .coverage_word = 6});
  EXPECT_EQ(textures_of(counting), std::vector<uint32_t>{3});
  EXPECT_EQ(count_of(counting.spirv, spv::OpAtomicIAdd), 2u + 1) << "and one of the coverage map";
}

TEST(CountingWords, RefusesWhatIsNoSpirv) {
  CompiledShader shader;
  shader.spirv_with_lines = {1, 2, 3};
  EXPECT_THROW(add_counters(shader, Api::vulkan, {}), Error);
}

}  // namespace
}  // namespace lamina
