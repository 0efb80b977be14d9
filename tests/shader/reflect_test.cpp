// SPDX-License-Identifier: Apache-2.0
#include <bit>

#include "tests/shader/shader_files.h"

namespace lamina {
namespace {

class Reflect : public ShaderFiles {};

TEST_F(Reflect, NamesKindsAndBindingsInOrder) {
  for (const Api api : both_apis) {
    const Reflection r = compile(Stage::compute, api, R"(
layout(local_size_x = 1) in;
layout(binding = 7) uniform sampler2D skin;
layout(binding = 2, rgba16f) uniform writeonly image2D result;
layout(binding = 5) buffer Tally { uint words[]; } tally;
layout(binding = 3) uniform Frame { mat4 clip_from_world; };
void main() {
  imageStore(result, ivec2(0), texelFetch(skin, ivec2(0), 0) * clip_from_world);
  tally.words[0] = 1u;
}
)")
                             .reflection;
    ASSERT_EQ(r.resources.size(), 4u);
    const std::tuple<const char*, uint32_t, BindingKind> expected[] = {{"result", 2, BindingKind::storage_image},
                                                                       {"Frame", 3, BindingKind::uniform_buffer},
                                                                       {"Tally", 5, BindingKind::storage_buffer},
                                                                       {"skin", 7, BindingKind::texture}};
    for (size_t i = 0; i < 4; ++i)
      EXPECT_EQ(std::tie(r.resources[i].name, r.resources[i].binding, r.resources[i].kind), expected[i]);
  }
}

TEST_F(Reflect, TellsThreeDimensionsFromTwo) {
  for (const Api api : both_apis) {
    const Reflection r = compile(Stage::fragment, api, R"(
layout(binding = 1) uniform sampler3D volume;
layout(binding = 2) uniform sampler2D plane;
layout(location = 0) out vec4 o;
void main() { o = texture(volume, vec3(0)) + texture(plane, vec2(0)); }
)")
                             .reflection;
    ASSERT_EQ(r.resources.size(), 2u);
    EXPECT_EQ(r.resources[0].slot(), (BindingSlot{1, BindingKind::texture, 3}));
    EXPECT_EQ(r.resources[1].slot(), (BindingSlot{2, BindingKind::texture, 2}));
  }
}

// Offsets by OpenGL 4.5 core profile, 7.6.2.2: a vec3 aligns to 16 and is 12 long, arrays stride 16, the block pads to 16.
TEST_F(Reflect, OffsetsFollowStd140) {
  for (const Api api : both_apis) {
    const Reflection r = compile(Stage::fragment, api, R"(
struct Light { vec3 where; float power; };
layout(std140, binding = 0) uniform Block {
  float a;
  vec3 b;
  vec3 c;
  float d;
  float e[3];
  vec2 f;
  mat3 g;
  Light lights[2];
  float last;
} block;
layout(location = 0) out vec4 o;
void main() { o = vec4(block.last); }
)")
                             .reflection;
    ASSERT_EQ(r.resources.size(), 1u);
    const std::pair<const char*, uint32_t> expected[] = {{"a", 0},  {"b", 16},  {"c", 32},       {"d", 44},    {"e", 48},
                                                         {"f", 96}, {"g", 112}, {"lights", 160}, {"last", 192}};
    const auto& members = r.resources[0].members;
    ASSERT_EQ(members.size(), std::size(expected));
    for (size_t i = 0; i < members.size(); ++i) {
      EXPECT_EQ(members[i].name, expected[i].first);
      EXPECT_EQ(members[i].offset_bytes, expected[i].second) << members[i].name;
    }
    EXPECT_EQ(r.resources[0].size_bytes, 208u);  // 196 padded to 16
  }
}

// Strides by the same section: an array's and a matrix's are those of a vec4 or more; size: to the end of the last column.
TEST_F(Reflect, MembersHaveTheirTypes) {
  for (const Api api : both_apis) {
    const Reflection r = compile(Stage::fragment, api, R"(
layout(std140, binding = 0) uniform Block {
  float a;
  vec2 b;
  vec3 c;
  vec4 d;
  int e;
  ivec4 f;
  uint g;
  mat3 h;
  mat4 i;
  mat2x3 j;
  vec4 k[5];
  float l[3];
  mat4 m[2];
  mat3 n[2];
  ivec2 o[1];
} block;
layout(location = 0) out vec4 colour;
void main() { colour = vec4(block.a); }
)")
                             .reflection;
    using enum BlockMember::Scalar;
    struct Expected {
      const char* name;
      BlockMember::Scalar scalar;
      uint32_t rows, columns, array_count, array_stride, matrix_stride, size;
    };
    const Expected expected[] = {{"a", real, 1, 1, 0, 0, 0, 4},
                                 {"b", real, 2, 1, 0, 0, 0, 8},
                                 {"c", real, 3, 1, 0, 0, 0, 12},
                                 {"d", real, 4, 1, 0, 0, 0, 16},
                                 {"e", integer, 1, 1, 0, 0, 0, 4},
                                 {"f", integer, 4, 1, 0, 0, 0, 16},
                                 {"g", unsigned_integer, 1, 1, 0, 0, 0, 4},
                                 {"h", real, 3, 3, 0, 0, 16, 48},
                                 {"i", real, 4, 4, 0, 0, 16, 64},
                                 {"j", real, 3, 2, 0, 0, 16, 32},
                                 {"k", real, 4, 1, 5, 16, 0, 80},
                                 {"l", real, 1, 1, 3, 16, 0, 48},
                                 {"m", real, 4, 4, 2, 64, 16, 128},
                                 {"n", real, 3, 3, 2, 48, 16, 96},
                                 {"o", integer, 2, 1, 1, 16, 0, 16}};
    ASSERT_EQ(r.resources.size(), 1u);
    const auto& members = r.resources[0].members;
    ASSERT_EQ(members.size(), std::size(expected));
    for (size_t i = 0; i < members.size(); ++i) {
      const BlockMember& member = members[i];
      const Expected& right = expected[i];
      EXPECT_EQ(member.name, right.name);
      EXPECT_TRUE(member.supported) << member.name;
      EXPECT_EQ(member.scalar, right.scalar) << member.name;
      EXPECT_EQ(member.rows, right.rows) << member.name;
      EXPECT_EQ(member.columns, right.columns) << member.name;
      EXPECT_EQ(member.array_count, right.array_count) << member.name;
      EXPECT_EQ(member.array_stride_bytes, right.array_stride) << member.name;
      EXPECT_EQ(member.matrix_stride_bytes, right.matrix_stride) << member.name;
      EXPECT_EQ(member.size_bytes, right.size) << member.name;
    }
  }
}

TEST_F(Reflect, MembersOfOtherTypesAreKeptAsUnsupported) {
  for (const Api api : both_apis) {
    const Reflection r = compile(Stage::fragment, api, R"(
struct Light { vec3 where; float power; };
layout(constant_id = 1) const int taps = 3;
layout(std140, binding = 0) uniform Block {
  Light light;
  Light lights[2];
  float nested[2][3];
  layout(row_major) mat4 by_rows;
  double wide;
  float of_constant_length[taps];
  bool on;
  float last;
} block;
layout(binding = 1) buffer Tally { uint count; float open_ended[]; } tally;
layout(location = 0) out vec4 colour;
void main() { colour = vec4(block.last * tally.open_ended[0]); }
)")
                             .reflection;
    ASSERT_EQ(r.resources.size(), 2u);
    const std::tuple<const char*, bool, uint32_t> expected[] = {{"light", false, 16},  {"lights", false, 32},
                                                                {"nested", false, 96}, {"by_rows", false, 64},
                                                                {"wide", false, 8},    {"of_constant_length", false, 48},
                                                                {"on", true, 4},       {"last", true, 4}};
    const auto& members = r.resources[0].members;
    ASSERT_EQ(members.size(), std::size(expected));
    for (size_t i = 0; i < members.size(); ++i)
      EXPECT_EQ(std::tie(members[i].name, members[i].supported, members[i].size_bytes), expected[i]) << members[i].name;
    EXPECT_EQ(members[6].scalar, BlockMember::Scalar::unsigned_integer) << "a bool is a uint in SPIR-V";
    const auto& tally = r.resources[1].members;
    ASSERT_EQ(tally.size(), 2u);
    EXPECT_TRUE(tally[0].supported);
    EXPECT_EQ(std::tie(tally[1].name, tally[1].supported, tally[1].size_bytes), std::tuple("open_ended", false, 0u));
  }
}

TEST_F(Reflect, OnlyWhatTheEntryPointReaches) {
  for (const Api api : both_apis) {
    const Reflection r = compile(Stage::fragment, api, R"(
layout(binding = 0) uniform sampler2D unused;
layout(binding = 1) uniform sampler2D reached;
layout(binding = 2) uniform sampler2D in_dead_function;
layout(binding = 3) uniform Unused { vec4 v; };
layout(location = 0) out vec4 o;
vec4 never() { return texture(in_dead_function, vec2(0)); }
vec4 sometimes(sampler2D s) { return texture(s, vec2(0)); }
void main() { o = sometimes(reached); }
)")
                             .reflection;
    ASSERT_EQ(r.resources.size(), 1u);
    EXPECT_EQ(r.resources[0].name, "reached");
  }
}

TEST_F(Reflect, SpecializationConstantsHaveNamesTypesAndDefaults) {
  for (const Api api : both_apis) {
    const auto constants = compile(Stage::fragment, api, R"(
layout(constant_id = 9) const float thickness = 0.25;
layout(constant_id = 1) const int taps = -3;
layout(constant_id = 4) const uint mask = 0x80000001u;
layout(constant_id = 2) const bool on = true;
layout(constant_id = 3) const bool off = false;
layout(location = 0) out vec4 o;
void main() { o = vec4(thickness, taps, mask, on || off); }
)")
                               .reflection.constants;
    using Type = SpecConstantInfo::Type;
    const std::tuple<const char*, uint32_t, Type, uint32_t> expected[] = {
        {"taps", 1, Type::integer, 0xfffffffdu},
        {"on", 2, Type::boolean, 1},
        {"off", 3, Type::boolean, 0},
        {"mask", 4, Type::unsigned_integer, 0x80000001u},
        {"thickness", 9, Type::real, std::bit_cast<uint32_t>(0.25f)}};
    ASSERT_EQ(constants.size(), std::size(expected));
    for (size_t i = 0; i < constants.size(); ++i)
      EXPECT_EQ(std::tie(constants[i].name, constants[i].id, constants[i].type, constants[i].default_bits), expected[i]);
  }
}

TEST_F(Reflect, InputsAndOutputsAreSortedAndLeaveOutBuiltIns) {
  for (const Api api : both_apis) {
    const Reflection r = compile(Stage::vertex, api, R"(
layout(location = 3) in vec2 uv;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 declared_only;
layout(location = 2) out vec2 uv_out;
void main() { gl_Position = vec4(position, LAMINA_VERTEX_INDEX); uv_out = uv; }
)")
                             .reflection;
    EXPECT_EQ(r.input_locations, (std::vector<uint32_t>{0, 1, 3}));
    EXPECT_EQ(r.output_locations, std::vector<uint32_t>{2});
  }
}

TEST_F(Reflect, ArraysAndMatricesTakeALocationAColumn) {
  const Reflection r = compile(Stage::vertex, Api::vulkan, R"(
layout(location = 4) in mat3 frame;
layout(location = 0) in vec4 corners[2];
void main() { gl_Position = vec4(frame[0], 1) + corners[0] + corners[1]; }
)")
                           .reflection;
  EXPECT_EQ(r.input_locations, (std::vector<uint32_t>{0, 1, 4, 5, 6}));
}

TEST_F(Reflect, AFragmentShadersOutputsAreItsAttachments) {
  const Reflection r = compile(Stage::fragment, Api::opengl, R"(
layout(location = 1) out vec4 second;
layout(location = 0) out vec4 first;
void main() { first = gl_FragCoord; second = vec4(0); gl_FragDepth = 0.5; }
)")
                           .reflection;
  EXPECT_EQ(r.output_locations, (std::vector<uint32_t>{0, 1}));
  EXPECT_TRUE(r.input_locations.empty());
}

TEST(ReflectWords, RefusesWhatIsNoSpirv) { EXPECT_THROW(reflect({1, 2, 3, 4, 5, 6}), Error); }

}  // namespace
}  // namespace lamina
