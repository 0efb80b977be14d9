// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/shader.h"
#include "harness/shader/spirv_module.h"

namespace lamina {

CompiledShader rebound(const CompiledShader& shader, uint32_t from, uint32_t to) {
  // Words of OpDecorate: the instruction, its target, the decoration, the binding (specification, section 3.32.3).
  constexpr size_t decoration_word = 2, binding_word = 3;
  CompiledShader result = shader;
  for (size_t at = spirv_header_words; at < result.spirv.size();) {
    const uint32_t op = result.spirv[at] & 0xffff, words = result.spirv[at] >> 16;
    if (op == spv::OpDecorate && result.spirv[at + decoration_word] == spv::DecorationBinding &&
        result.spirv[at + binding_word] == from)
      result.spirv[at + binding_word] = to;
    at += words;
  }
  for (ShaderResource& resource : result.reflection.resources)
    if (resource.binding == from) resource.binding = to;
  return result;
}

}  // namespace lamina
