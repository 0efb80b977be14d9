// SPDX-License-Identifier: Apache-2.0
// A SPIR-V module as a list of instructions, to be searched.
//
// Source: Khronos, SPIR-V Specification 1.0, sections 2.3 (physical layout) and 2.4 (logical layout).
// Limits: SpirvModule takes its words to be valid SPIR-V; validate_spirv() says whether they are.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <spirv/unified1/spirv.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "harness/backend/backend.h"

namespace lamina {

// A view of one instruction's words; the module's words own them.
struct SpirvInstruction {
  std::span<const uint32_t> words;  // the first holds word count and opcode
  uint32_t type = 0;                // id of the result's type, or 0
  uint32_t result = 0;              // id, or 0 where the instruction makes none

  spv::Op op() const { return static_cast<spv::Op>(words[0] & spv::OpCodeMask); }
};

class SpirvModule {
 public:
  // `words` must outlive the module. Throws Error(failed) where they are no SPIR-V in this machine's byte order.
  explicit SpirvModule(std::span<const uint32_t> words);

  const std::vector<SpirvInstruction>& instructions() const { return instructions_; }
  // The instruction that makes `id`. Throws Error(failed) where none does.
  const SpirvInstruction& definition(uint32_t id) const;
  // The first literal of `decoration` on `id` (0 where the decoration has none); nothing where `id` is not so decorated.
  std::optional<uint32_t> decoration(uint32_t id, spv::Decoration decoration) const;
  // Debug name of `id`, or "".
  std::string name(uint32_t id) const;
  // What the OpString that makes `id` says: a file's name. Throws Error(failed) where none makes it.
  std::string text(uint32_t id) const;
  // The string literal from this word of an instruction on.
  static std::string string(const SpirvInstruction& instruction, size_t word);

 private:
  std::vector<SpirvInstruction> instructions_;
  std::vector<size_t> definitions_;  // by id: index of the instruction that makes it plus 1, or 0
};

// Throws Error(kind) about `subject`, with the words of SPIRV-Tools, where the module is not valid for Vulkan 1.0 or
// OpenGL 4.5.
void validate_spirv(std::span<const uint32_t> words, Api api, ErrorKind kind, std::string_view subject);

}  // namespace lamina
