// SPDX-License-Identifier: Apache-2.0
#include <bit>

#include "tests/shader/shader_files.h"

namespace lamina {
namespace {

constexpr Api both_apis[] = {Api::vulkan, Api::opengl};

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
