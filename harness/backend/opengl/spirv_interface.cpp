// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/opengl/spirv_interface.h"

#include <spirv/unified1/spirv.hpp>

#include "harness/backend/opengl/object.h"

namespace lamina::gl {
namespace {

// Calls visit(opcode, operands...) with the place of every instruction's first word.
template <class Visit>
void for_each_instruction(const std::vector<uint32_t>& spirv, std::string_view subject, Visit visit) {
  constexpr size_t header_words = 5;
  for (size_t at = header_words; at < spirv.size();) {
    const size_t words = spirv[at] >> spv::WordCountShift;
    if (words == 0 || words > spirv.size() - at)
      throw_failed(subject, fmt::format("the SPIR-V module breaks off at word {}", at));
    visit(static_cast<spv::Op>(spirv[at] & spv::OpCodeMask), at, words);
    at += words;
  }
}

}  // namespace

std::set<uint32_t> specialization_ids(const std::vector<uint32_t>& spirv, std::string_view subject) {
  std::set<uint32_t> ids;
  for_each_instruction(spirv, subject, [&](spv::Op op, size_t at, size_t words) {
    if (op == spv::OpDecorate && words == 4 && spirv[at + 2] == spv::DecorationSpecId) ids.insert(spirv[at + 3]);
  });
  return ids;
}

std::vector<uint32_t> with_units(std::vector<uint32_t> spirv, const std::map<uint32_t, uint32_t>& units,
                                 std::string_view subject) {
  for_each_instruction(spirv, subject, [&](spv::Op op, size_t at, size_t words) {
    if (op == spv::OpDecorate && words == 4 && spirv[at + 2] == spv::DecorationBinding) {
      if (const auto unit = units.find(spirv[at + 3]); unit != units.end()) spirv[at + 3] = unit->second;
    } else if (op == spv::OpExecutionMode && spirv[at + 2] == spv::ExecutionModeOriginUpperLeft) {
      spirv[at + 2] = spv::ExecutionModeOriginLowerLeft;
    }
  });
  return spirv;
}

}  // namespace lamina::gl
