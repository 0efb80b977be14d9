// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/level_reads.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "harness/shader/spirv_module.h"

namespace lamina {
namespace {

// Words of a texture operation (specification, section 3.32.10): opcode, type, result, image, coordinate; gathers and those
// that compare depths have one operand more before the image operands.
constexpr size_t coordinate_word = 4;

bool has_operand_before_mask(spv::Op op) {
  switch (op) {
    case spv::OpImageSampleDrefImplicitLod:
    case spv::OpImageSampleDrefExplicitLod:
    case spv::OpImageSampleProjDrefImplicitLod:
    case spv::OpImageSampleProjDrefExplicitLod:
    case spv::OpImageGather:
    case spv::OpImageDrefGather:
      return true;
    default:
      return false;
  }
}

LevelReads reads_at(float lambda, uint32_t levels) {
  const float within = std::clamp(std::isnan(lambda) ? 0.0f : lambda, 0.0f, static_cast<float>(levels - 1));
  const float rounded = std::floor(within * level_steps + 0.5f) / level_steps;
  const auto nearer = static_cast<uint32_t>(rounded);
  LevelReads reads{LevelReads::Told::here, {nearer}};
  if (rounded > static_cast<float>(nearer)) reads.levels.push_back(nearer + 1);
  return reads;
}

// The value of a 32-bit constant; nothing where running, or a specialization, decides.
const SpirvInstruction* constant_of(const SpirvModule& module, uint32_t id) {
  const SpirvInstruction& made = module.definition(id);
  const bool is_constant = made.op() == spv::OpConstant || made.op() == spv::OpConstantNull;
  return is_constant ? &made : nullptr;
}
uint32_t bits_of(const SpirvInstruction& constant) { return constant.op() == spv::OpConstantNull ? 0 : constant.words[3]; }

}  // namespace

bool is_texture_operation(const SpirvInstruction& instruction) {
  const spv::Op op = instruction.op();
  return (op >= spv::OpImageSampleImplicitLod && op <= spv::OpImageDrefGather) ||
         (op >= spv::OpImageSparseSampleImplicitLod && op <= spv::OpImageSparseDrefGather);
}

bool is_texel_fetch(const SpirvInstruction& operation) {
  return operation.op() == spv::OpImageFetch || operation.op() == spv::OpImageSparseFetch;
}

bool is_projective(const SpirvInstruction& operation) {
  return operation.op() == spv::OpImageSampleProjImplicitLod || operation.op() == spv::OpImageSampleProjExplicitLod;
}

// Operands follow in the order of their bits; Grad has two.
uint32_t image_operand(const SpirvInstruction& operation, uint32_t mask, uint32_t which) {
  const size_t mask_word = coordinate_word + 1 + (has_operand_before_mask(operation.op()) ? 1 : 0);
  if (operation.words.size() <= mask_word) return 0;
  const uint32_t given = operation.words[mask_word];
  if ((given & mask) == 0) return 0;
  size_t word = mask_word + 1 + which;
  for (uint32_t bit = 1; bit < mask; bit <<= 1)
    if ((given & bit) != 0) word += bit == spv::ImageOperandsGradMask ? 2 : 1;
  return word < operation.words.size() ? operation.words[word] : 0;
}

uint32_t texture_binding(const SpirvModule& module, const SpirvInstruction& operation) {
  constexpr size_t image_word = 3;  // of the operation, and of each instruction that it may reach its variable through
  uint32_t id = operation.words[image_word];
  for (;;) {
    const SpirvInstruction& source = module.definition(id);
    switch (source.op()) {
      case spv::OpVariable: {
        const auto binding = module.decoration(id, spv::DecorationBinding);
        if (!binding)
          throw Error(ErrorKind::failed, "shader", "counting build",
                      fmt::format("texture '{}' has no binding", module.name(id)));
        return *binding;
      }
      case spv::OpLoad:
      case spv::OpAccessChain:
      case spv::OpInBoundsAccessChain:
      case spv::OpCopyObject:
      case spv::OpImage:
      case spv::OpSampledImage:
        id = source.words[image_word];
        break;
      default:
        throw Error(
            ErrorKind::failed, "shader", "counting build",
            fmt::format("cannot tell which texture '{}' is, in a function that cannot be inlined; sample it in the caller",
                        module.name(id)));
    }
  }
}

LevelReads level_reads(const SpirvModule& module, const SpirvInstruction& operation, Stage stage,
                       const LeveledTexture& texture) {
  using enum LevelReads::Told;
  const uint32_t last = texture.levels - 1;
  switch (operation.op()) {
    case spv::OpImageGather:
      return reads_at(0, texture.levels);
    case spv::OpImageFetch: {
      const uint32_t lod = image_operand(operation, spv::ImageOperandsLodMask);
      if (lod == 0 || last == 0) return reads_at(0, texture.levels);
      const SpirvInstruction* constant = constant_of(module, lod);
      return constant ? LevelReads{here, {std::min(bits_of(*constant), last)}} : LevelReads{by_running, {}};
    }
    case spv::OpImageSampleImplicitLod:
    case spv::OpImageSampleProjImplicitLod:
    case spv::OpImageSampleExplicitLod:
    case spv::OpImageSampleProjExplicitLod:
      break;
    default:
      return {};
  }
  if (!texture.mipmapped || last == 0) return reads_at(0, texture.levels);
  if (image_operand(operation, spv::ImageOperandsMinLodMask) != 0) return {};
  if (const uint32_t lod = image_operand(operation, spv::ImageOperandsLodMask); lod != 0) {
    const SpirvInstruction* constant = constant_of(module, lod);
    return constant ? reads_at(std::bit_cast<float>(bits_of(*constant)), texture.levels) : LevelReads{by_running, {}};
  }
  const bool has_gradients = image_operand(operation, spv::ImageOperandsGradMask) != 0;
  return has_gradients || stage == Stage::fragment ? LevelReads{by_running, {}} : LevelReads{};
}

}  // namespace lamina
