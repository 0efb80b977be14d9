// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/level_counting.h"

#include <algorithm>

namespace lamina {

void LevelCounting::place(const std::map<uint32_t, uint32_t>& counted, uint32_t first) {
  for (const auto& [binding, levels] : counted) {
    first_of_[binding] = first;
    first += levels;
  }
}

bool LevelCounting::needs_query() const {
  return asks_ && std::ranges::none_of(code_.module().instructions(), [](const SpirvInstruction& i) {
           return i.op() == spv::OpCapability && i.words[1] == spv::CapabilityImageQuery;
         });
}

void LevelCounting::add(uint32_t binding, uint32_t level, uint32_t amount) {
  counters_.add(code_.value(spv::OpIAdd, code_.uint_type(), {level, code_.constant(first_of_.at(binding))}), amount);
}

void LevelCounting::count(const SpirvInstruction& operation) {
  const uint32_t binding = texture_binding(code_.module(), operation);
  const auto texture = textures_.find(binding);
  if (texture == textures_.end()) return;
  if (level_reads(code_.module(), operation, stage_, texture->second).told != LevelReads::Told::by_running) return;
  const uint32_t levels = texture->second.levels, of_type = code_.uint_type(), real = code_.float_type();
  // Nothing may reach beyond the counters, whatever a shader asks for.
  const auto within = [&](uint32_t level) { return code_.glsl(GLSLstd450UMin, of_type, {level, code_.constant(levels - 1)}); };
  const uint32_t one = code_.constant(1);
  if (is_texel_fetch(operation)) {
    const uint32_t lod = image_operand(operation, spv::ImageOperandsLodMask);
    const bool is_unsigned = code_.module().definition(lod).type == of_type;
    add(binding, within(is_unsigned ? lod : code_.value(spv::OpBitcast, of_type, {lod})), one);
    return;
  }
  const uint32_t lambda = lambda_of(operation, texture->second);
  // What is not a number is level 0, as NClamp has it.
  const uint32_t clamped =
      code_.glsl(GLSLstd450NClamp, real, {lambda, code_.number(0), code_.number(static_cast<float>(levels - 1))});
  const uint32_t steps = code_.value(spv::OpFMul, real, {clamped, code_.number(level_steps)});
  const uint32_t nearest = code_.glsl(GLSLstd450Floor, real, {code_.value(spv::OpFAdd, real, {steps, code_.number(0.5f)})});
  const uint32_t rounded = code_.value(spv::OpFMul, real, {nearest, code_.number(1 / level_steps)});
  const uint32_t nearer = within(code_.value(spv::OpConvertFToU, of_type, {rounded}));
  const uint32_t rest = code_.value(spv::OpConvertUToF, real, {nearer});
  const uint32_t between = code_.value(spv::OpFOrdGreaterThan, code_.type(spv::OpTypeBool, {}), {rounded, rest});
  const uint32_t farther = within(code_.value(spv::OpIAdd, of_type, {nearer, one}));
  const uint32_t blended = code_.value(spv::OpSelect, of_type, {between, one, code_.constant(0)});
  add(binding, nearer, one);
  add(binding, farther, blended);
}

// The level of detail before it is clamped.
uint32_t LevelCounting::lambda_of(const SpirvInstruction& operation, const LeveledTexture& texture) {
  const uint32_t real = code_.float_type();
  if (const uint32_t lod = image_operand(operation, spv::ImageOperandsLodMask); lod != 0) return lod;
  if (const uint32_t dx = image_operand(operation, spv::ImageOperandsGradMask); dx != 0) {
    const uint32_t along_x = texels_of(dx, texture);
    const uint32_t along_y = texels_of(image_operand(operation, spv::ImageOperandsGradMask, 1), texture);
    return code_.glsl(GLSLstd450Log2, real, {code_.glsl(GLSLstd450FMax, real, {along_x, along_y})});
  }
  asks_ = true;
  const uint32_t asked = code_.value(spv::OpImageQueryLod, vector(2), {operation.words[3], coordinates_of(operation)});
  const uint32_t lambda = code_.value(spv::OpCompositeExtract, real, {asked, 1});
  const uint32_t bias = image_operand(operation, spv::ImageOperandsBiasMask);
  return bias == 0 ? lambda : code_.value(spv::OpFAdd, real, {lambda, bias});
}

uint32_t LevelCounting::vector(uint32_t components) {
  return components == 1 ? code_.float_type() : code_.type(spv::OpTypeVector, {code_.float_type(), components});
}

// How many texels of level 0 a gradient is long.
uint32_t LevelCounting::texels_of(uint32_t gradient, const LeveledTexture& texture) {
  const uint32_t of_type = code_.module().definition(gradient).type;
  const auto side = [&](size_t k) { return code_.number(static_cast<float>(texture.size[k])); };
  const SpirvInstruction& made = code_.module().definition(of_type);
  const uint32_t components = made.op() == spv::OpTypeVector ? made.words[3] : 1;
  uint32_t size = side(0);
  if (components > 1) {
    const uint32_t width = size, height = side(1), depth = side(2);
    size = code_.new_id();
    if (components == 2)
      emit(code_.globals, spv::OpConstantComposite, {of_type, size, width, height});
    else
      emit(code_.globals, spv::OpConstantComposite, {of_type, size, width, height, depth});
  }
  return code_.glsl(GLSLstd450Length, code_.float_type(), {code_.value(spv::OpFMul, of_type, {gradient, size})});
}

// As OpImageQueryLod takes them: as many components as the image has dimensions, and projected.
uint32_t LevelCounting::coordinates_of(const SpirvInstruction& operation) {
  const SpirvModule& module = code_.module();
  const uint32_t given = operation.words[4], real = code_.float_type();
  const SpirvInstruction& sampled = module.definition(module.definition(operation.words[3]).type);
  const auto dim = static_cast<spv::Dim>(module.definition(sampled.words[2]).words[3]);
  const uint32_t dimensions = dim == spv::Dim1D ? 1 : dim == spv::Dim3D || dim == spv::DimCube ? 3 : 2;
  const SpirvInstruction& of_type = module.definition(module.definition(given).type);
  const uint32_t components = of_type.op() == spv::OpTypeVector ? of_type.words[3] : 1;
  if (components == dimensions) return given;
  const auto at = [&](uint32_t k) {
    const uint32_t one = code_.value(spv::OpCompositeExtract, real, {given, k});
    if (!is_projective(operation)) return one;
    const uint32_t by = code_.value(spv::OpCompositeExtract, real, {given, dimensions});
    return code_.value(spv::OpFDiv, real, {one, by});
  };
  const uint32_t x = at(0);
  if (dimensions == 1) return x;
  const uint32_t y = at(1);
  if (dimensions == 2) return code_.value(spv::OpCompositeConstruct, vector(2), {x, y});
  return code_.value(spv::OpCompositeConstruct, vector(3), {x, y, at(2)});
}

}  // namespace lamina
