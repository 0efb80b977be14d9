// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/spirv_writer.h"

#include <algorithm>
#include <bit>

namespace lamina {
namespace {

constexpr std::string_view glsl_name = "GLSL.std.450";

uint32_t first_word(size_t words, spv::Op op) {
  return static_cast<uint32_t>(words) << spv::WordCountShift | static_cast<uint32_t>(op);
}

}  // namespace

void emit(std::vector<uint32_t>& out, spv::Op op, std::initializer_list<uint32_t> operands) {
  out.push_back(first_word(operands.size() + 1, op));
  out.insert(out.end(), operands);
}

SpirvWriter::SpirvWriter(const SpirvModule& module, uint32_t bound) : module_(module), bound_(bound) {
  for (const SpirvInstruction& i : module.instructions())
    if (i.op() == spv::OpExtInstImport && SpirvModule::string(i, 2) == glsl_name) glsl_ = i.result;
}

uint32_t SpirvWriter::type(spv::Op op, std::initializer_list<uint32_t> operands) {
  for (const SpirvInstruction& i : module_.instructions())
    if (i.op() == op && std::ranges::equal(i.words.subspan(2), operands)) return i.result;
  std::vector<uint32_t> key(operands);
  key.push_back(static_cast<uint32_t>(op));
  const auto [known, fresh] = types_.emplace(std::move(key), 0);
  if (!fresh) return known->second;
  globals.push_back(first_word(operands.size() + 2, op));
  globals.push_back(known->second = new_id());
  globals.insert(globals.end(), operands);
  return known->second;
}

uint32_t SpirvWriter::constant(uint32_t value) {
  const uint32_t of_type = uint_type();
  const auto [known, fresh] = constants_.emplace(value, 0);
  if (fresh) emit(globals, spv::OpConstant, {of_type, known->second = new_id(), value});
  return known->second;
}

uint32_t SpirvWriter::number(float value) {
  const uint32_t of_type = float_type();
  const auto [known, fresh] = numbers_.emplace(std::bit_cast<uint32_t>(value), 0);
  if (fresh) emit(globals, spv::OpConstant, {of_type, known->second = new_id(), known->first});
  return known->second;
}

uint32_t SpirvWriter::value(spv::Op op, uint32_t result_type, std::initializer_list<uint32_t> operands) {
  const uint32_t id = new_id();
  body.push_back(first_word(operands.size() + 3, op));
  body.push_back(result_type);
  body.push_back(id);
  body.insert(body.end(), operands);
  return id;
}

uint32_t SpirvWriter::glsl(GLSLstd450 instruction, uint32_t result_type, std::initializer_list<uint32_t> operands) {
  if (glsl_ == 0) glsl_ = new_id(), imports_glsl_ = true;
  const uint32_t id = new_id();
  body.push_back(first_word(operands.size() + 5, spv::OpExtInst));
  body.insert(body.end(), {result_type, id, glsl_, static_cast<uint32_t>(instruction)});
  body.insert(body.end(), operands);
  return id;
}

// The name's words hold four characters each, the first lowest, and end in a zero byte.
void SpirvWriter::import_glsl(std::vector<uint32_t>& out) const {
  if (!imports_glsl_) return;
  std::vector<uint32_t> words((glsl_name.size() + 4) / 4);
  for (size_t k = 0; k < glsl_name.size(); ++k)
    words[k / 4] |= static_cast<uint32_t>(static_cast<unsigned char>(glsl_name[k])) << 8 * (k % 4);
  out.push_back(first_word(words.size() + 2, spv::OpExtInstImport));
  out.push_back(glsl_);
  out.insert(out.end(), words.begin(), words.end());
}

}  // namespace lamina
