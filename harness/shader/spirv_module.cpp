// SPDX-License-Identifier: Apache-2.0
#define SPV_ENABLE_UTILITY_CODE  // for spv::HasResultAndType
#include "harness/shader/spirv_module.h"

#include <spirv-tools/libspirv.hpp>

namespace lamina {
namespace {

[[noreturn]] void refuse_module(std::string message) { throw Error(ErrorKind::failed, "shader", "SPIR-V", std::move(message)); }

// A string literal: UTF-8, four bytes a word, closed by a zero byte.
std::string literal_string(std::span<const uint32_t> words) {
  std::string text;
  for (const uint32_t word : words)
    for (int shift = 0; shift < 32; shift += 8) {
      const char c = static_cast<char>(word >> shift & 0xffu);
      if (c == '\0') return text;
      text += c;
    }
  return text;
}

}  // namespace

SpirvModule::SpirvModule(std::span<const uint32_t> words) {
  if (words.size() < spirv_header_words || words[0] != spv::MagicNumber) refuse_module("not a SPIR-V module");
  const uint32_t bound = words[3];
  definitions_.resize(bound);
  for (size_t at = spirv_header_words; at < words.size();) {
    const size_t count = words[at] >> spv::WordCountShift;
    if (count == 0 || count > words.size() - at) refuse_module("an instruction reaches past the end of the module");
    SpirvInstruction instruction{.words = words.subspan(at, count)};
    bool has_result = false, has_type = false;
    spv::HasResultAndType(instruction.op(), &has_result, &has_type);
    if (count < 1u + has_type + has_result) refuse_module("an instruction lacks its result");
    if (has_type) instruction.type = words[at + 1];
    if (has_result) {
      instruction.result = words[at + 1 + has_type];
      if (instruction.result >= bound) refuse_module("an id lies over the bound that the header states");
      definitions_[instruction.result] = instructions_.size() + 1;
    }
    instructions_.push_back(instruction);
    at += count;
  }
}

const SpirvInstruction& SpirvModule::definition(uint32_t id) const {
  if (id >= definitions_.size() || definitions_[id] == 0) refuse_module(fmt::format("nothing makes id %{}", id));
  return instructions_[definitions_[id] - 1];
}

std::optional<uint32_t> SpirvModule::decoration(uint32_t id, spv::Decoration decoration) const {
  for (const SpirvInstruction& i : instructions_) {
    if (i.op() == spv::OpFunction) break;  // decorations come before all functions
    if (i.op() == spv::OpDecorate && i.words[1] == id && i.words[2] == decoration) return i.words.size() > 3 ? i.words[3] : 0;
  }
  return std::nullopt;
}

std::string SpirvModule::name(uint32_t id) const {
  for (const SpirvInstruction& i : instructions_)
    if (i.op() == spv::OpName && i.words[1] == id) return literal_string(i.words.subspan(2));
  return {};
}

std::string SpirvModule::string(const SpirvInstruction& instruction, size_t word) {
  return literal_string(instruction.words.subspan(word));
}

std::string SpirvModule::text(uint32_t id) const { return literal_string(definition(id).words.subspan(2)); }

void validate_spirv(std::span<const uint32_t> words, Api api, ErrorKind kind, std::string_view subject) {
  spvtools::SpirvTools tools(api == Api::vulkan ? SPV_ENV_VULKAN_1_0 : SPV_ENV_OPENGL_4_5);
  std::string complaint;
  tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&, const char* message) {
    if (complaint.empty()) complaint = message;
  });
  if (!tools.Validate(words.data(), words.size()))
    throw Error(kind, "shader", std::string(subject), "SPIRV-Tools finds the module invalid: " + complaint);
}

}  // namespace lamina
