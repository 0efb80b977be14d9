// SPDX-License-Identifier: Apache-2.0
// What one SPIR-V instruction does, in operations by class.
//
// Operations are counted by component: a vec4's addition is four. An instruction of vectors or matrices counts as the scalar
// arithmetic of its definition: dot(vec3, vec3) is three multiplications and two additions.
// Sources: Khronos, SPIR-V Specification 1.0, section 3.32 (instructions); Khronos, SPIR-V Extended Instructions for GLSL 1.00.
// Limits: nothing is said of what a driver makes of an instruction: a multiplication and an addition may run as one fma. Moving
// values between registers, and writing a stage's outputs, is no operation. Texture operations are counted as fetches.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "harness/backend/backend.h"

namespace lamina {

class SpirvModule;
struct SpirvInstruction;

enum class OperationClass : uint8_t {
  add,  // and subtract, negate, abs, sign; of floats, as all to `pow`
  multiply,
  fma,
  divide,  // and mod
  root,    // and inverse root
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  hyperbolic,
  exp,  // and exp2
  log,  // and log2
  pow,
  integer,  // arithmetic, shifts and bits
  compare,  // and min, max, logic; clamp is two
  select,   // by a condition, without a branch
  branch,   // by a condition
  convert,  // between types; rounding
  derivative,
  interpolation,  // of a fragment's inputs
  input,          // a vertex's attributes, and inputs that are not interpolated
  uniform,        // read from uniform blocks
  storage,        // read from, written to or changed in storage buffers
  image,          // texels of storage images, likewise
  query           // of a texture's size, levels or level of detail
};
inline constexpr size_t operation_class_count = static_cast<size_t>(OperationClass::query) + 1;

// "add"; the names are the enumerators'.
std::string_view name_of(OperationClass operation);

class Operations {
 public:
  uint64_t& operator[](OperationClass operation) { return counts_[static_cast<size_t>(operation)]; }
  uint64_t operator[](OperationClass operation) const { return counts_[static_cast<size_t>(operation)]; }
  void add(const Operations& other, uint64_t times = 1);
  uint64_t sum() const;
  std::vector<OperationClass> classes() const;      // those that are above 0
  std::map<std::string, uint64_t> by_name() const;  // likewise

 private:
  std::array<uint64_t, operation_class_count> counts_{};
};

// What executing `instruction` of `module` once adds up to.
Operations operations_of(const SpirvModule& module, const SpirvInstruction& instruction, Stage stage);

}  // namespace lamina
