// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/shader.h"
#include "harness/shader/spirv_module.h"

namespace lamina {

CompiledShader rebound(const CompiledShader& shader, uint32_t from, uint32_t to) {
  // Words of OpDecorate: the instruction, its target, the decoration, the binding (specification, section 3.32.3).
  constexpr size_t decoration_word = 2, binding_word = 3;
  CompiledShader result = shader;
  for (std::vector<uint32_t>* words : {&result.spirv, &result.spirv_with_lines}) {
    const SpirvModule module(*words);
    for (const SpirvInstruction& i : module.instructions())
      if (i.op() == spv::OpDecorate && i.words[decoration_word] == spv::DecorationBinding && i.words[binding_word] == from)
        (*words)[static_cast<size_t>(&i.words[binding_word] - words->data())] = to;
  }
  for (ShaderResource& resource : result.reflection.resources)
    if (resource.binding == from) resource.binding = to;
  return result;
}

}  // namespace lamina
