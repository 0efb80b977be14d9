// SPDX-License-Identifier: Apache-2.0
// Wrong numbers put into compiled code: which change, and that both forms of a shader change alike.
#include "harness/shader/changed_constants.h"

#include <bit>
#include <set>

#include "harness/shader/spirv_module.h"
#include "tests/shader/shader_files.h"

namespace lamina {
namespace {

class ChangedConstants : public ShaderFiles {};

std::multiset<float> floats_of(const std::vector<uint32_t>& spirv) {
  const SpirvModule module(spirv);
  std::multiset<float> values;
  for (const SpirvInstruction& i : module.instructions())
    if (i.op() == spv::OpConstant && module.definition(i.type).op() == spv::OpTypeFloat)
      values.insert(std::bit_cast<float>(i.words[3]));
  return values;
}

constexpr std::string_view taps = R"(
layout(binding = 4) uniform sampler2D a;
layout(location = 0) out vec4 o;
const vec2 disc[2] = {vec2(3.0, 0.25), vec2(-0.75, 3.0)};
void main() { o = 0.125 * texture(a, disc[0]) + 8.0 * texture(a, disc[1]); }
)";

TEST_F(ChangedConstants, OffsetsAloneAreScaled) {
  for (const Api api : both_apis) {
    CompiledShader shader = compile(Stage::fragment, api, taps);
    EXPECT_TRUE(scale_offsets(shader, 2));
    for (const auto* form : {&shader.spirv, &shader.spirv_with_lines}) {
      const std::multiset<float> now = floats_of(*form);
      EXPECT_TRUE(now.contains(6) && now.contains(0.5f) && now.contains(-1.5f)) << "the disc";
      EXPECT_TRUE(now.contains(0.125f) && now.contains(8)) << "weights";
    }
    validate_spirv(shader.spirv, api, ErrorKind::failed, "test");
  }
}

TEST_F(ChangedConstants, TheLeastAndTheGreatestWeightChangePlaces) {
  for (const Api api : both_apis) {
    const CompiledShader before = compile(Stage::fragment, api, taps);
    CompiledShader shader = before;
    EXPECT_TRUE(swap_weights(shader));
    EXPECT_NE(shader.spirv, before.spirv);
    EXPECT_NE(shader.spirv_with_lines, before.spirv_with_lines);
    EXPECT_EQ(floats_of(shader.spirv), floats_of(before.spirv)) << "the same numbers at other places";
    EXPECT_TRUE(swap_weights(shader));
    EXPECT_EQ(shader.spirv, before.spirv) << "and back";
  }
}

TEST_F(ChangedConstants, WhereNoneIsThereNothingChanges) {
  for (const Api api : both_apis) {
    CompiledShader shader = compile(Stage::fragment, api, "layout(location = 0) out vec4 o;\nvoid main() { o = vec4(1.0); }\n");
    const std::vector<uint32_t> before = shader.spirv;
    EXPECT_FALSE(scale_offsets(shader, 2));
    EXPECT_FALSE(swap_weights(shader));
    EXPECT_EQ(shader.spirv, before);
  }
}

}  // namespace
}  // namespace lamina
