// SPDX-License-Identifier: Apache-2.0
// In: a module. First SPIRV-Tools makes all functions part of main, keeps local variables in registers and takes away what has
// no effect. Then the entry point is written down in the order of execution. An id becomes the number of its first use, and
// what defines it (a type, a constant, a variable) is written there too. So neither numbering nor order of declarations shows.
#include "harness/shader/executable_form.h"

#include <spirv-tools/libspirv.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "harness/shader/spirv_module.h"
#include "harness/shader/spirv_passes.h"

namespace lamina {
namespace {

using Words = std::vector<uint32_t>;

// Marks what follows a number that is used for the first time. No number of an id is as large.
constexpr uint32_t defined_here = 0xffffffff;

Words without_what_does_not_run(const Words& spirv, Api api) {
  spvtools::Optimizer optimizer = optimizer_for(api);
  register_inlining(optimizer);
  optimizer.RegisterPass(spvtools::CreatePrivateToLocalPass())
      .RegisterPass(spvtools::CreateDeadBranchElimPass())
      .RegisterPass(spvtools::CreateScalarReplacementPass())
      .RegisterPass(spvtools::CreateLocalAccessChainConvertPass())
      .RegisterPass(spvtools::CreateLocalSingleBlockLoadStoreElimPass())
      .RegisterPass(spvtools::CreateLocalSingleStoreElimPass())
      .RegisterPass(spvtools::CreateLocalMultiStoreElimPass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass())
      .RegisterPass(spvtools::CreateBlockMergePass());
  return rewrite(optimizer, spirv, "executable form");
}

bool is_id(spv_operand_type_t type) {
  return type == SPV_OPERAND_TYPE_ID || type == SPV_OPERAND_TYPE_TYPE_ID || type == SPV_OPERAND_TYPE_RESULT_ID ||
         type == SPV_OPERAND_TYPE_MEMORY_SEMANTICS_ID || type == SPV_OPERAND_TYPE_SCOPE_ID;
}

struct Instruction {
  spv::Op op = spv::OpNop;
  uint32_t result = 0;
  Words words;              // operands, the result's id among them
  std::vector<bool> is_id;  // beside words
};

class ExecutableForm {
 public:
  explicit ExecutableForm(const Words& spirv) {
    const std::unique_ptr<spv_context_t, decltype(&spvContextDestroy)> context(spvContextCreate(SPV_ENV_UNIVERSAL_1_0),
                                                                               spvContextDestroy);
    const auto take = [](void* form, const spv_parsed_instruction_t* parsed) {
      static_cast<ExecutableForm*>(form)->read(*parsed);
      return SPV_SUCCESS;
    };
    spvBinaryParse(context.get(), this, spirv.data(), spirv.size(), nullptr, take, nullptr);
  }

  Words write() {
    for (const Instruction& i : modes_) put_words(i, entry_);
    to_write_ = {entry_};
    for (size_t next = 0; next < to_write_.size(); ++next)  // a function that could not be inlined follows main
      for (const Instruction& i : functions_.at(to_write_[next])) put(i);
    std::set<Words> outputs;  // those that nothing writes too
    for (const uint32_t id : interface_)
      if (definitions_.at(id).words.at(2) == spv::StorageClassOutput)
        outputs.insert(decorations_[id].begin(), decorations_[id].end());
    put_said(outputs);
    return std::move(out_);
  }

 private:
  // What an instruction says of the id that is its first operand.
  static Words said_by(const Instruction& i) {
    Words words = i.words;
    words[0] = static_cast<uint32_t>(i.op);
    return words;
  }

  void read(const spv_parsed_instruction_t& parsed) {
    Instruction i{static_cast<spv::Op>(parsed.opcode), parsed.result_id, {}, {}};
    for (uint16_t k = 0; k < parsed.num_operands; ++k) {
      const spv_parsed_operand_t& operand = parsed.operands[k];
      for (uint16_t word = 0; word < operand.num_words; ++word) {
        i.words.push_back(parsed.words[operand.offset + word]);
        i.is_id.push_back(lamina::is_id(operand.type));
      }
    }
    switch (i.op) {
      case spv::OpEntryPoint:
        entry_ = i.words[1];
        for (size_t k = 2; k < i.words.size(); ++k)
          if (i.is_id[k]) interface_.push_back(i.words[k]);
        return;
      case spv::OpExecutionMode:
        modes_.push_back(std::move(i));
        return;
      case spv::OpName:
      case spv::OpMemberName:
        names_[i.words[0]].insert(said_by(i));
        return;
      case spv::OpDecorate:
      case spv::OpMemberDecorate:
        decorations_[i.words[0]].insert(said_by(i));
        return;
      case spv::OpLine:
      case spv::OpNoLine:
      case spv::OpSource:
      case spv::OpSourceExtension:
      case spv::OpSourceContinued:
      case spv::OpString:
      case spv::OpCapability:
      case spv::OpMemoryModel:
      case spv::OpExtension:
        return;
      default:
        break;
    }
    if (i.op == spv::OpFunction) function_ = i.result;
    // Local variables are written where they are first used, as those of the module are.
    if (i.result != 0 && (function_ == 0 || i.op == spv::OpVariable))
      definitions_[i.result] = std::move(i);
    else if (function_ != 0)
      functions_[function_].push_back(std::move(i));
    if (static_cast<spv::Op>(parsed.opcode) == spv::OpFunctionEnd) function_ = 0;
  }

  // Whether values are found by the id's name.
  bool is_found_by_name(uint32_t id) const {
    const auto definition = definitions_.find(id);
    if (definition == definitions_.end()) return false;
    const Instruction& i = definition->second;
    if (i.op == spv::OpVariable) return i.words.at(2) == spv::StorageClassUniformConstant;
    if (i.op == spv::OpTypeStruct) {
      const auto decorations = decorations_.find(id);
      return decorations != decorations_.end() && (decorations->second.contains({spv::OpDecorate, spv::DecorationBlock}) ||
                                                   decorations->second.contains({spv::OpDecorate, spv::DecorationBufferBlock}));
    }
    return i.op == spv::OpSpecConstant || i.op == spv::OpSpecConstantTrue || i.op == spv::OpSpecConstantFalse;
  }

  void put_words(const Instruction& i, uint32_t left_out) {
    out_.push_back(static_cast<uint32_t>(i.op));
    out_.push_back(static_cast<uint32_t>(i.words.size()));
    for (size_t k = 0; k < i.words.size(); ++k)
      if (i.is_id[k] && i.words[k] == left_out)
        out_.push_back(0);
      else if (i.is_id[k])
        put_id(i.words[k]);
      else
        out_.push_back(i.words[k]);
  }

  void put(const Instruction& i) {
    put_words(i, 0);
    if (i.op == spv::OpFunctionCall && std::ranges::find(to_write_, i.words.at(2)) == to_write_.end())
      to_write_.push_back(i.words.at(2));
  }

  void put_said(const std::set<Words>& said) {
    for (const Words& words : said) out_.insert(out_.end(), words.begin(), words.end());
  }

  void put_id(uint32_t id) {
    const auto [number, is_new] = numbers_.try_emplace(id, static_cast<uint32_t>(numbers_.size()));
    out_.push_back(number->second);
    if (!is_new) return;
    out_.push_back(defined_here);
    if (const auto definition = definitions_.find(id); definition != definitions_.end()) put_words(definition->second, id);
    put_said(decorations_[id]);
    if (is_found_by_name(id)) put_said(names_[id]);
  }

  uint32_t entry_ = 0, function_ = 0;  // function_: the one that is being read, or 0
  Words interface_;
  std::vector<Instruction> modes_;
  std::map<uint32_t, std::set<Words>> names_;               // by id: of it and of its members
  std::map<uint32_t, std::set<Words>> decorations_;         // by id: of it and of its members
  std::map<uint32_t, Instruction> definitions_;             // by id: types, constants and variables
  std::map<uint32_t, std::vector<Instruction>> functions_;  // by id
  std::map<uint32_t, uint32_t> numbers_;                    // by id
  std::vector<uint32_t> to_write_;                          // functions
  Words out_;
};

}  // namespace

std::vector<uint32_t> executable_form(const std::vector<uint32_t>& spirv, Api api) {
  try {
    return ExecutableForm(without_what_does_not_run(spirv, api)).write();
  } catch (const Error&) {
    return spirv;
  }
}

}  // namespace lamina
