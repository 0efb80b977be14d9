// SPDX-License-Identifier: Apache-2.0
// Writes instructions that are put into a module: types and constants of its own beside the module's, and code.
#pragma once

#include <spirv/unified1/GLSL.std.450.h>

#include <initializer_list>
#include <map>
#include <vector>

#include "harness/shader/spirv_module.h"

namespace lamina {

// The instruction of this opcode and these operands, result type and result among them, behind `out`.
void emit(std::vector<uint32_t>& out, spv::Op op, std::initializer_list<uint32_t> operands);

class SpirvWriter {
 public:
  // `bound`: the first id that is free. The module must outlive this.
  SpirvWriter(const SpirvModule& module, uint32_t bound);

  std::vector<uint32_t> globals;  // types, constants and variables, for the end of the module's own
  std::vector<uint32_t> body;     // code, the module's functions copied among it

  uint32_t new_id() { return bound_++; }
  uint32_t bound() const { return bound_; }
  const SpirvModule& module() const { return module_; }

  // The id of the type of these operands. Two ids may not name the same type, so one that is there is taken.
  uint32_t type(spv::Op op, std::initializer_list<uint32_t> operands);
  uint32_t uint_type() { return type(spv::OpTypeInt, {32, 0}); }
  uint32_t float_type() { return type(spv::OpTypeFloat, {32}); }
  uint32_t constant(uint32_t value);
  uint32_t number(float value);

  // An instruction that makes a value of `result_type`, in the body; returns the value's id.
  uint32_t value(spv::Op op, uint32_t result_type, std::initializer_list<uint32_t> operands);
  // Likewise one of GLSL.std.450.
  uint32_t glsl(GLSLstd450 instruction, uint32_t result_type, std::initializer_list<uint32_t> operands);
  // Where code uses GLSL.std.450 and the module does not: its import, behind `out`.
  void import_glsl(std::vector<uint32_t>& out) const;

 private:
  const SpirvModule& module_;
  uint32_t bound_;
  uint32_t glsl_ = 0;
  bool imports_glsl_ = false;
  std::map<uint32_t, uint32_t> constants_, numbers_;  // bits of the value -> id
  std::map<std::vector<uint32_t>, uint32_t> types_;   // that were made: operands and opcode -> id
};

}  // namespace lamina
