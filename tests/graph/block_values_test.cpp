// SPDX-License-Identifier: Apache-2.0
// Values of uniform blocks by name: the bytes that little shaders' blocks get on both APIs, against std140 by hand, and every
// mistake with its message.
#include "harness/graph/block_values.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "tests/shader/shader_files.h"

namespace lamina {
namespace {

constexpr Api both_apis[] = {Api::vulkan, Api::opengl};

class BlockValuesTest : public ShaderFiles {
 protected:
  // The block named Frame with these members, and `last` behind them.
  ShaderResource block(Api api, const std::string& members, const std::string& name = "Frame", int binding = 0) const {
    const CompiledShader shader =
        compile(Stage::fragment, api,
                "struct Light { vec3 where; float power; };\nlayout(std140, binding = " + std::to_string(binding) +
                    ") uniform " + name + " {\n" + members + "\n  float last;\n};\nlayout(location = 0) out vec4 o;\n" +
                    "void main() { o = vec4(last); }\n");
    return shader.reflection.resources.at(0);
  }
  static std::string message(const ShaderResource& block, BlockValues values) {
    values.set("last", 0.0f);
    const Error filling = error_of([&] { fill_block(block, values, "heart.frag"); });
    const Error checking = error_of([&] { check_block(block, values, "heart.frag"); });
    EXPECT_STREQ(filling.what(), checking.what());
    EXPECT_EQ(filling.kind(), ErrorKind::bad_input);
    EXPECT_EQ(filling.stage(), "variants");
    EXPECT_EQ(filling.subject(), "heart.frag");
    return filling.message();
  }
  // The message for one member that is declared like this.
  std::string message(const std::string& member, const BlockValues& values) const {
    const std::string vulkan = message(block(Api::vulkan, member), values);
    EXPECT_EQ(message(block(Api::opengl, member), values), vulkan);
    return vulkan;
  }
  // The bytes, read as numbers of this type.
  template <class Number>
  static std::vector<Number> words(const std::vector<std::byte>& bytes) {
    std::vector<Number> result(bytes.size() / sizeof(Number));
    std::memcpy(result.data(), bytes.data(), bytes.size());
    return result;
  }
  // A member alone, the value last = 7 behind it.
  template <class Number>
  std::vector<Number> filled(Api api, const std::string& member, BlockValues values) const {
    values.set("last", 7.0f);
    return words<Number>(fill_block(block(api, member), values, "heart.frag"));
  }
};

template <class Value>
BlockValues one(const Value& value) {
  BlockValues values;
  values.set("x", value);
  return values;
}
glm::mat4 counted4(float first) {
  glm::mat4 m;
  for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = first + float(i);
  return m;
}
const glm::mat3 counted3(1, 2, 3, 4, 5, 6, 7, 8, 9);

using Floats = std::vector<float>;

// By OpenGL 4.5 core profile, 7.6.2.2: `last` follows at once where there is room in the vec4, behind arrays and matrices in
// the next one; the block is padded to a vec4.
TEST_F(BlockValuesTest, EachTypeOfRealsLiesAsStd140Says) {
  for (const Api api : both_apis) {
    EXPECT_EQ(filled<float>(api, "float x;", one(1.5f)), (Floats{1.5f, 7, 0, 0}));
    EXPECT_EQ(filled<float>(api, "vec2 x;", one(glm::vec2(1, 2))), (Floats{1, 2, 7, 0}));
    EXPECT_EQ(filled<float>(api, "vec3 x;", one(glm::vec3(1, 2, 3))), (Floats{1, 2, 3, 7}));
    EXPECT_EQ(filled<float>(api, "vec4 x;", one(glm::vec4(1, 2, 3, 4))), (Floats{1, 2, 3, 4, 7, 0, 0, 0}));
    EXPECT_EQ(filled<float>(api, "mat3 x;", one(counted3)), (Floats{1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 7, 0, 0, 0}));
    EXPECT_EQ(filled<float>(api, "mat4 x;", one(counted4(1))),
              (Floats{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 7, 0, 0, 0}));
  }
}

TEST_F(BlockValuesTest, EachTypeOfIntegersLiesAsStd140Says) {
  const int seven = std::bit_cast<int>(7.0f);
  using Ints = std::vector<int>;
  for (const Api api : both_apis) {
    EXPECT_EQ(filled<int>(api, "int x;", one(-5)), (Ints{-5, seven, 0, 0}));
    EXPECT_EQ(filled<int>(api, "ivec2 x;", one(glm::ivec2(1, -2))), (Ints{1, -2, seven, 0}));
    EXPECT_EQ(filled<int>(api, "ivec3 x;", one(glm::ivec3(1, -2, 3))), (Ints{1, -2, 3, seven}));
    EXPECT_EQ(filled<int>(api, "ivec4 x;", one(glm::ivec4(1, -2, 3, 4))), (Ints{1, -2, 3, 4, seven, 0, 0, 0}));
    EXPECT_EQ(filled<int>(api, "uint x;", one(2147483647)), (Ints{2147483647, seven, 0, 0}));
    EXPECT_EQ(filled<int>(api, "uvec2 x;", one(glm::ivec2(1, 2))), (Ints{1, 2, seven, 0}));
  }
}

TEST_F(BlockValuesTest, EachArrayLiesAsStd140Says) {
  const std::array numbers{1.0f, 2.0f};
  const std::vector vectors{glm::vec4(1, 2, 3, 4), glm::vec4(5, 6, 7, 8)};
  const std::vector integers{glm::ivec4(1, 2, 3, 4), glm::ivec4(-5, 6, 7, 8)};
  const std::vector matrices{counted4(1), counted4(17)};
  for (const Api api : both_apis) {
    EXPECT_EQ(filled<float>(api, "float x[2];", one(numbers)), (Floats{1, 0, 0, 0, 2, 0, 0, 0, 7, 0, 0, 0}));
    EXPECT_EQ(filled<float>(api, "vec4 x[2];", one(vectors)), (Floats{1, 2, 3, 4, 5, 6, 7, 8, 7, 0, 0, 0}));
    EXPECT_EQ(filled<int>(api, "ivec4 x[2];", one(integers)),
              (std::vector<int>{1, 2, 3, 4, -5, 6, 7, 8, std::bit_cast<int>(7.0f), 0, 0, 0}));
    Floats counted(36, 0);
    for (size_t i = 0; i < 32; ++i) counted[i] = float(i + 1);
    counted[32] = 7;
    EXPECT_EQ(filled<float>(api, "mat4 x[2];", one(matrices)), counted);
  }
}

TEST_F(BlockValuesTest, AnArrayMayBeDeclaredShorter) {
  const std::vector<glm::vec4> vectors(8, glm::vec4(3));
  for (const Api api : both_apis) EXPECT_EQ(filled<float>(api, "vec4 x[1];", one(vectors)), (Floats{3, 3, 3, 3, 7, 0, 0, 0}));
}

TEST_F(BlockValuesTest, MembersStandInAnyOrderAndValuesMayBeLeftOut) {
  BlockValues values;
  values.set("clip_from_world", counted4(1));
  values.set("eye_world", glm::vec3(20, 21, 22));
  values.set("count", 3);
  values.set("ambient", glm::vec3(30, 31, 32));
  values.set("eye_offset", 0.5f);
  values.set("last", 7.0f);
  for (const Api api : both_apis) {
    const ShaderResource declared = block(api, "  vec3 ambient; int count; float eye_offset; vec3 eye_world;");
    const Floats lie = words<float>(fill_block(declared, values, "heart.frag"));
    EXPECT_EQ(lie, (Floats{30, 31, 32, std::bit_cast<float>(3), 0.5f, 0, 0, 0, 20, 21, 22, 7}));
    EXPECT_NO_THROW(check_block(declared, values, "heart.frag"));
  }
}

TEST_F(BlockValuesTest, ExplicitOffsetsCount) {
  for (const Api api : both_apis)
    EXPECT_EQ(filled<float>(api, "layout(offset = 16) float x;", one(1.5f)), (Floats{0, 0, 0, 0, 1.5f, 7, 0, 0}));
}

TEST_F(BlockValuesTest, NamesKeepTheirOrderAndTheLastValueCounts) {
  BlockValues values;
  values.set("z", 1.0f);
  values.set("x", 2.0f);
  values.set("z", glm::vec2(3, 4));
  EXPECT_EQ(values.names(), (std::vector<std::string>{"z", "x"}));
  values.set("x", 5.0f);
  for (const Api api : both_apis) EXPECT_EQ(filled<float>(api, "float x;", values), (Floats{5, 7, 0, 0}));
}

TEST_F(BlockValuesTest, AWholeNumberMayBeDeclaredAnInteger) {
  for (const Api api : both_apis) {
    EXPECT_EQ(filled<int>(api, "int x;", one(-12.0f))[0], -12);
    EXPECT_EQ(filled<int>(api, "int x;", one(-2147483648.0f))[0], std::numeric_limits<int>::min());
    EXPECT_EQ(filled<uint32_t>(api, "uint x;", one(3e9f))[0], 3'000'000'000u);
    EXPECT_EQ(filled<int>(api, "int x[2];", one(std::array{1.0f, 2.0f}))[4], 2);
  }
  EXPECT_EQ(message("int x;", one(2.5f)), "block 'Frame': 'x' is declared as int, and 2.5 is no whole number");
  EXPECT_EQ(message("int x;", one(NAN)), "block 'Frame': 'x' is declared as int, and nan is no whole number");
  EXPECT_EQ(message("int x;", one(-INFINITY)), "block 'Frame': 'x' is declared as int, and -inf is no whole number");
  EXPECT_EQ(message("uint x;", one(-1.0f)), "block 'Frame': 'x' is declared as uint, and -1 is negative");
  EXPECT_EQ(message("uvec2 x;", one(glm::ivec2(1, -2))), "block 'Frame': 'x' is declared as uvec2, and -2 is negative");
  EXPECT_EQ(message("int x;", one(3e9f)), "block 'Frame': 'x' is declared as int, and 3e+09 does not fit into 32 bits");
  EXPECT_EQ(message("int x;", one(-3e9f)), "block 'Frame': 'x' is declared as int, and -3e+09 does not fit into 32 bits");
  EXPECT_EQ(message("uint x;", one(8e9f)), "block 'Frame': 'x' is declared as uint, and 8e+09 does not fit into 32 bits");
  EXPECT_EQ(message("ivec2 x;", one(glm::vec2(1, 2))), "block 'Frame': 'x' is declared as ivec2, and it is a vec2");
}

TEST_F(BlockValuesTest, AnotherTypeIsRefused) {
  BlockValues eye;
  eye.set("eye_world", glm::vec4(1));
  EXPECT_EQ(message("vec3 eye_world;", eye), "block 'Frame': 'eye_world' is declared as vec3, and it is a vec4");
  EXPECT_EQ(message("float x;", one(3)), "block 'Frame': 'x' is declared as float, and it is an int");
  EXPECT_EQ(message("vec4 x;", one(glm::ivec4(3))), "block 'Frame': 'x' is declared as vec4, and it is an ivec4");
  EXPECT_EQ(message("uint x;", one(glm::vec2(3))), "block 'Frame': 'x' is declared as uint, and it is a vec2");
  EXPECT_EQ(message("mat4 x;", one(counted3)), "block 'Frame': 'x' is declared as mat4, and it is a mat3");
  EXPECT_EQ(message("mat2x3 x;", one(counted3)), "block 'Frame': 'x' is declared as mat2x3, and it is a mat3");
  EXPECT_EQ(message("mat3 x;", one(glm::vec3(1))), "block 'Frame': 'x' is declared as mat3, and it is a vec3");
  EXPECT_EQ(message("vec4 x[2];", one(glm::vec4(1))), "block 'Frame': 'x' is declared as vec4[2], and it is a vec4");
  EXPECT_EQ(message("vec4 x;", one(std::vector<glm::vec4>(8))), "block 'Frame': 'x' is declared as vec4, and it is a vec4[8]");
  EXPECT_EQ(message("vec4 x[8];", one(std::vector<glm::ivec4>(8))),
            "block 'Frame': 'x' is declared as vec4[8], and it is an ivec4[8]");
}

TEST_F(BlockValuesTest, ALongerArrayIsRefused) {
  EXPECT_EQ(message("vec4 x[9];", one(std::vector<glm::vec4>(8))),
            "block 'Frame': 'x' is declared as vec4[9], and there are 8 elements");
  EXPECT_EQ(message("mat4 x[1];", one(std::vector<glm::mat4>())),
            "block 'Frame': 'x' is declared as mat4[1], and there are 0 elements");
}

TEST_F(BlockValuesTest, ATypeThatNoValueHasIsRefused) {
  for (const std::string member : {"Light x;", "Light x[2];", "float x[2][2];", "double x;", "layout(row_major) mat4 x;"})
    EXPECT_EQ(message(member, one(1.0f)), "block 'Frame': 'x' is declared with a type that no value has, and it is a float");
}

TEST_F(BlockValuesTest, AnUnknownMemberIsToldWithTheNearestName) {
  BlockValues values;
  values.set("eye_world", glm::vec4(1));
  values.set("ambient", glm::vec4(1));
  EXPECT_EQ(message("vec4 eye_wrld;", values), "unknown member of block 'Frame' 'eye_wrld' (did you mean 'eye_world'?)");
  EXPECT_EQ(message("vec4 q;", values), "unknown member of block 'Frame' 'q' (known: eye_world, ambient, last)");
}

TEST_F(BlockValuesTest, BlocksLaidOutAlikeHaveOneKey) {
  const std::string members = "vec4 a; mat4 b; float c[3];";
  const std::string key = layout_key(block(Api::vulkan, members));
  EXPECT_EQ(layout_key(block(Api::opengl, members)), key);
  EXPECT_EQ(layout_key(block(Api::vulkan, members, "Frame", 5)), key) << "wherever it is bound";
  EXPECT_NE(layout_key(block(Api::vulkan, members, "Object")), key);
  for (const std::string other : {"vec4 d; mat4 b; float c[3];", "mat4 b; vec4 a; float c[3];", "ivec4 a; mat4 b; float c[3];",
                                  "vec4 a; mat4 b; float c[2];", "vec3 a; mat4 b; float c[3];", "vec4 a; mat4x3 b; float c[3];",
                                  "vec4 a; mat4 b; layout(offset = 96) float c[3];"})
    EXPECT_NE(layout_key(block(Api::vulkan, other)), key) << other;
  EXPECT_NE(layout_key(block(Api::vulkan, "float a; float b;")),
            layout_key(block(Api::vulkan, "float a; layout(offset = 8) float b;")))
      << "of one size";
}

}  // namespace
}  // namespace lamina
