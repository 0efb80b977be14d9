// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/early_tests.h"

#include <algorithm>

namespace lamina {
namespace {

spv::StorageClass storage_class(const SpirvModule& module, uint32_t pointer) {
  return static_cast<spv::StorageClass>(module.definition(module.definition(pointer).type).words[2]);
}

bool is_memory(spv::StorageClass storage) {
  return storage == spv::StorageClassUniform || storage == spv::StorageClassStorageBuffer;
}

bool prevents_early_tests(const SpirvModule& module, const SpirvInstruction& i) {
  switch (i.op()) {
    case spv::OpKill:
    case spv::OpTerminateInvocation:
    case spv::OpDemoteToHelperInvocation:
    case spv::OpImageWrite:
    case spv::OpAtomicFAddEXT:
    case spv::OpAtomicFMinEXT:
    case spv::OpAtomicFMaxEXT:
      return true;
    case spv::OpStore:
    case spv::OpCopyMemory:
      return is_memory(storage_class(module, i.words[1]));
    case spv::OpDecorate:
      if (i.words[2] != spv::DecorationBuiltIn) return false;
      return i.words[3] == spv::BuiltInFragDepth || i.words[3] == spv::BuiltInFragStencilRefEXT ||
             (i.words[3] == spv::BuiltInSampleMask && storage_class(module, i.words[1]) == spv::StorageClassOutput);
    default:
      return i.op() >= spv::OpAtomicStore && i.op() <= spv::OpAtomicXor;
  }
}

}  // namespace

bool demands_early_tests(const SpirvModule& module) {
  return std::ranges::any_of(module.instructions(), [](const SpirvInstruction& i) {
    return i.op() == spv::OpExecutionMode && i.words[2] == spv::ExecutionModeEarlyFragmentTests;
  });
}

bool allows_early_tests(const SpirvModule& module) {
  return std::ranges::none_of(module.instructions(),
                              [&](const SpirvInstruction& i) { return prevents_early_tests(module, i); });
}

// An instruction's first word has its length in the upper half (SPIR-V specification, section 2.3).
bool may_discard(std::span<const uint32_t> spirv) {
  for (size_t at = spirv_header_words; at < spirv.size(); at += std::max(spirv[at] >> 16, 1u)) {
    const uint32_t op = spirv[at] & 0xffffu;
    if (op == spv::OpKill || op == spv::OpTerminateInvocation || op == spv::OpDemoteToHelperInvocation) return true;
  }
  return false;
}

}  // namespace lamina
