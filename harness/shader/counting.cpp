// SPDX-License-Identifier: Apache-2.0
// The counting build: rewrites SPIR-V so that a shader counts its invocations, its texture operations and its operations by
// class.
//
// In: a module of compile_shader(). Out: the same module, all functions inlined into main. Each invocation counts in variables
// of its own how often it runs some of the basic blocks, as few as tell about all (block_flow.h). Where it ends (returns or is
// discarded) it adds these to the counters. The invocation itself is counted at main's beginning. The host multiplies by what
// a block does (block_work.h), which is exact through loops and branches. Levels of textures that only running tells are
// counted too (level_counting.h). What is counted is what the source says: an operation whose result nothing uses still counts,
// though a driver leaves it out of the timed build.
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "harness/shader/early_tests.h"
#include "harness/shader/level_counting.h"
#include "harness/shader/shader.h"
#include "harness/shader/spirv_module.h"
#include "harness/shader/spirv_passes.h"

namespace lamina {
namespace {

using Words = std::vector<uint32_t>;

constexpr size_t bound_word = 3;  // of a module's header

// A texture that is passed to a function is a variable at the call, so the calls must go.
Words inlined(const Words& spirv, Api api) {
  spvtools::Optimizer optimizer = optimizer_for(api);
  register_inlining(optimizer);
  return rewrite(optimizer, spirv, "counting build");
}

class Instrumenter {
 public:
  Instrumenter(std::span<const uint32_t> spirv, Stage stage, const CountingLayout& layout)
      : header_(spirv.first(spirv_header_words)),
        module_(spirv),
        stage_(stage),
        layout_(layout),
        code_(module_, spirv[bound_word]),
        levels_(code_, stage, layout.textures) {}

  CountingShader instrument() {
    read();
    declare();
    write();
    CountingShader result;
    result.spirv = std::move(out_);
    result.work = std::move(work_);
    result.early_fragment_tests = early_;
    return result;
  }

 private:
  // What there is to count.
  void read() {
    for (const SpirvInstruction& i : module_.instructions()) {
      if (i.op() == spv::OpEntryPoint) main_ = i.words[2];
      if (i.op() == spv::OpDecorate && i.words[2] == spv::DecorationBinding && i.words[3] == layout_.binding)
        throw Error(ErrorKind::failed, "shader", "counting build",
                    fmt::format("binding {} is taken by '{}'; the counters need one of their own", layout_.binding,
                                module_.name(i.words[1])));
      if (i.op() == spv::OpDecorate && i.words[2] == spv::DecorationBuiltIn && i.words[3] == spv::BuiltInFragCoord)
        frag_coord_ = i.words[1];
    }
    work_ = BlockWork(module_, stage_, layout_.textures);
    for (const uint32_t label : work_.counted_labels()) counter_of_.emplace(label, static_cast<uint32_t>(counter_of_.size()));
    early_ = stage_ == Stage::fragment && (demands_early_tests(module_) || allows_early_tests(module_));
    maps_coverage_ = stage_ == Stage::fragment && layout_.coverage_word != 0;
  }

  // The counter buffer, and the types and constants that counting needs.
  void declare() {
    uint_ = code_.type(spv::OpTypeInt, {32, 0});
    bool_ = code_.type(spv::OpTypeBool, {});
    float_ = code_.type(spv::OpTypeFloat, {32});
    uint_pointer_ = code_.type(spv::OpTypePointer, {spv::StorageClassUniform, uint_});
    declare_sums();
    levels_.declare(work_.counted_levels());
    const uint32_t array = code_.new_id(), block = code_.new_id(), pointer = code_.new_id();
    counters_ = code_.new_id();
    emit(code_.globals, spv::OpTypeRuntimeArray, {array, uint_});
    emit(code_.globals, spv::OpTypeStruct, {block, array});
    emit(code_.globals, spv::OpTypePointer, {pointer, spv::StorageClassUniform, block});
    emit(code_.globals, spv::OpVariable, {pointer, counters_, spv::StorageClassUniform});
    emit(decorations_, spv::OpDecorate, {array, spv::DecorationArrayStride, sizeof(uint32_t)});
    emit(decorations_, spv::OpMemberDecorate, {block, 0, spv::DecorationOffset, 0});
    emit(decorations_, spv::OpDecorate, {block, spv::DecorationBufferBlock});  // a storage buffer, as SPIR-V 1.0 says it
    emit(decorations_, spv::OpDecorate, {counters_, spv::DecorationDescriptorSet, 0});
    emit(decorations_, spv::OpDecorate, {counters_, spv::DecorationBinding, layout_.binding});

    if (!maps_coverage_) return;
    float4_ = code_.type(spv::OpTypeVector, {float_, 4});
    if (frag_coord_ != 0) return;
    frag_coord_ = code_.new_id();
    const uint32_t input = code_.type(spv::OpTypePointer, {spv::StorageClassInput, float4_});
    emit(code_.globals, spv::OpVariable, {input, frag_coord_, spv::StorageClassInput});
    emit(decorations_, spv::OpDecorate, {frag_coord_, spv::DecorationBuiltIn, spv::BuiltInFragCoord});
  }

  // A private variable for every block that is counted: how often this invocation has run it so far.
  void declare_sums() {
    if (counter_of_.empty()) return;
    const uint32_t pointer = code_.type(spv::OpTypePointer, {spv::StorageClassPrivate, uint_});
    while (sums_.size() < counter_of_.size()) {
      sums_.push_back(code_.new_id());
      emit(code_.globals, spv::OpVariable, {pointer, sums_.back(), spv::StorageClassPrivate, code_.constant(0)});
    }
  }

  uint32_t word_pointer(uint32_t index) {
    return code_.value(spv::OpAccessChain, uint_pointer_, {counters_, code_.constant(0), index});
  }

  // Adds `amount` to the word at `index`; returns what it was before. Order does not matter to a sum: relaxed semantics.
  uint32_t atomic_add(uint32_t index, uint32_t amount) {
    const uint32_t pointer = word_pointer(index);
    return code_.value(spv::OpAtomicIAdd, uint_,
                       {pointer, code_.constant(spv::ScopeDevice), code_.constant(spv::MemorySemanticsMaskNone), amount});
  }

  // Adds to the 64-bit counter at `word`: the one addition that makes the low word wrap carries. There is no branch, so the
  // shader's blocks, and with them its phis and merges, stay as they are.
  void count(uint32_t word, uint32_t amount) {
    const uint32_t before = atomic_add(code_.constant(word), amount);
    const uint32_t after = code_.value(spv::OpIAdd, uint_, {before, amount});
    const uint32_t wraps = code_.value(spv::OpULessThan, bool_, {after, before});
    const uint32_t carry = code_.value(spv::OpSelect, uint_, {wraps, code_.constant(1), code_.constant(0)});
    atomic_add(code_.constant(word + 1), carry);
  }

  void add_to_sum(uint32_t counter) {
    const uint32_t sum =
        code_.value(spv::OpIAdd, uint_, {code_.value(spv::OpLoad, uint_, {sums_[counter]}), code_.constant(1)});
    emit(code_.body, spv::OpStore, {sums_[counter], sum});
  }

  // What an invocation has run, into the counters; before it ends.
  void count_sums() {
    uint32_t word = layout_.first_word + 2;
    for (const uint32_t sum : sums_) {
      count(word, code_.value(spv::OpLoad, uint_, {sum}));
      word += 2;
    }
    for (const auto& [binding, levels] : work_.counted_levels())
      for (uint32_t level = 0; level < levels; ++level) {
        count(word, levels_.sum(binding, level));
        word += 2;
      }
  }

  void map_coverage() {
    const uint32_t position = code_.value(spv::OpLoad, float4_, {frag_coord_});
    const uint32_t x = code_.value(spv::OpConvertFToU, uint_, {code_.value(spv::OpCompositeExtract, float_, {position, 0})});
    const uint32_t y = code_.value(spv::OpConvertFToU, uint_, {code_.value(spv::OpCompositeExtract, float_, {position, 1})});
    const uint32_t width = code_.value(spv::OpLoad, uint_, {word_pointer(code_.constant(0))});
    const uint32_t rows = code_.value(spv::OpIMul, uint_, {y, width});
    const uint32_t pixel = code_.value(spv::OpIAdd, uint_, {rows, x});
    atomic_add(code_.value(spv::OpIAdd, uint_, {pixel, code_.constant(layout_.coverage_word)}), code_.constant(1));
  }

  // Copies the module. The functions are written first, for they say which constants the sections before them must hold.
  void write() {
    const std::span<const SpirvInstruction> all = module_.instructions();
    const auto functions = std::ranges::find(all, spv::OpFunction, &SpirvInstruction::op);
    write_functions({functions, all.end()});

    out_.assign(header_.begin(), header_.end());
    out_[bound_word] = code_.bound();
    write_preamble({all.begin(), functions});
    append(out_, code_.globals);
    append(out_, code_.body);
  }

  void write_functions(std::span<const SpirvInstruction> instructions) {
    bool in_main = false, begins = false;  // begins: main's first block has not begun
    std::optional<uint32_t> entered;       // counter of the block whose label was written, until it is counted
    for (const SpirvInstruction& i : instructions) {
      const spv::Op op = i.op();
      if (says_a_place(op)) continue;
      if (op == spv::OpFunction) in_main = begins = i.result == main_;
      if (op == spv::OpLabel) {
        if (const auto found = counter_of_.find(i.result); found != counter_of_.end()) entered = found->second;
      } else if (op != spv::OpPhi && op != spv::OpVariable && op != spv::OpFunction && op != spv::OpFunctionParameter) {
        if (std::exchange(begins, false)) {
          count(layout_.first_word, code_.constant(1));
          if (maps_coverage_) map_coverage();
        }
        if (entered) add_to_sum(*std::exchange(entered, std::nullopt));
      }
      if (is_texture_operation(i)) levels_.count(i);
      if (op == spv::OpKill || (in_main && op == spv::OpReturn)) count_sums();
      append(code_.body, i.words);
    }
  }

  // Capabilities to global variables. Decorations close the section before the types.
  void write_preamble(std::span<const SpirvInstruction> instructions) {
    bool decorated = false;
    if (levels_.needs_query()) emit(out_, spv::OpCapability, {spv::CapabilityImageQuery});
    for (const SpirvInstruction& i : instructions) {
      if (i.op() == spv::OpMemoryModel) code_.import_glsl(out_);
      if (says_a_place(i.op())) continue;
      if (!decorated && i.result != 0 && i.op() != spv::OpExtInstImport && i.op() != spv::OpDecorationGroup) {
        append(out_, decorations_);
        decorated = true;
      }
      append(out_, i.words);
      if (i.op() == spv::OpEntryPoint) finish_entry_point(i);
    }
  }

  void finish_entry_point(const SpirvInstruction& entry) {
    // Execution model, function and a name come before the interface; the name's last word ends in a zero byte.
    const auto name_end = std::ranges::find_if(entry.words.subspan(3), [](uint32_t word) { return word >> 24 == 0; });
    if (maps_coverage_ && std::find(name_end + 1, entry.words.end(), frag_coord_) == entry.words.end()) {
      out_[out_.size() - entry.words.size()] += 1u << spv::WordCountShift;
      out_.push_back(frag_coord_);
    }
    if (early_ && !demands_early_tests(module_))
      emit(out_, spv::OpExecutionMode, {main_, spv::ExecutionModeEarlyFragmentTests});
  }

  static void append(Words& to, std::span<const uint32_t> words) { to.insert(to.end(), words.begin(), words.end()); }

  // A device is not told where the source stands.
  static bool says_a_place(spv::Op op) {
    return op == spv::OpLine || op == spv::OpNoLine || op == spv::OpString || op == spv::OpSource ||
           op == spv::OpSourceContinued || op == spv::OpModuleProcessed;
  }

  const std::span<const uint32_t> header_;
  const SpirvModule module_;
  const Stage stage_;
  const CountingLayout& layout_;
  SpirvWriter code_;
  LevelCounting levels_;
  uint32_t main_ = 0, frag_coord_ = 0;
  BlockWork work_;
  std::map<uint32_t, uint32_t> counter_of_;  // label -> counter
  std::vector<uint32_t> sums_;               // beside the counters: the variable
  bool early_ = false, maps_coverage_ = false;
  uint32_t uint_ = 0, bool_ = 0, float_ = 0, float4_ = 0, uint_pointer_ = 0, counters_ = 0;
  Words decorations_, out_;
};

}  // namespace

CountingShader add_counters(const CompiledShader& shader, Api api, const CountingLayout& layout) {
  const Words spirv = inlined(shader.spirv_with_lines, api);
  CountingShader result = Instrumenter(spirv, shader.stage, layout).instrument();
  validate_spirv(result.spirv, api, ErrorKind::failed, "counting build");
  return result;
}

}  // namespace lamina
