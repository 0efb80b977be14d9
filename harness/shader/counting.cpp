// SPDX-License-Identifier: Apache-2.0
// The counting build: rewrites SPIR-V so that a shader counts its invocations, its texture operations and its operations by
// class.
//
// In: a module of compile_shader(). Out: the same module, all functions inlined into main. Each invocation counts in an array
// of its own how often it runs some of the basic blocks, as few as tell about all (block_flow.h). Where it ends (returns or is
// discarded) a loop adds these to the counters. The invocation itself is counted at main's beginning. The host multiplies by
// what a block does (block_work.h), which is exact through loops and branches. Levels of textures that only running tells are
// counted too (level_counting.h). What is counted is what the source says: an operation whose result nothing uses still counts,
// though a driver leaves it out of the timed build.
#include <algorithm>
#include <functional>
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
        sums_(code_),
        levels_(code_, sums_, stage, layout.textures) {}

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

  // A private counter for every block that is counted, and behind them for every level.
  void declare_sums() {
    const size_t counters = work_.counters();
    if (counters == 0) return;
    sums_.declare(static_cast<uint32_t>(counters));
    levels_.place(work_.counted_levels(), static_cast<uint32_t>(counter_of_.size()));
    index_ = code_.new_id();
    emit(code_.globals, spv::OpVariable,
         {code_.type(spv::OpTypePointer, {spv::StorageClassPrivate, uint_}), index_, spv::StorageClassPrivate});
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

  void begin_block(uint32_t label) { emit(code_.body, spv::OpLabel, {label}); }
  void go_to(uint32_t label) { emit(code_.body, spv::OpBranch, {label}); }

  // Runs work() where the condition holds. The block that is being written is cut in two.
  void where(uint32_t condition, const std::function<void()>& work) {
    const uint32_t body = code_.new_id(), merge = code_.new_id();
    emit(code_.body, spv::OpSelectionMerge, {merge, spv::SelectionControlMaskNone});
    emit(code_.body, spv::OpBranchConditional, {condition, body, merge});
    begin_block(body);
    work();
    go_to(merge);
    begin_block(merge);
  }

  // Adds to the 64-bit counter at `word`, an id: the one addition that makes the low word wrap carries.
  void count(uint32_t word, uint32_t amount) {
    const uint32_t before = atomic_add(word, amount);
    const uint32_t after = code_.value(spv::OpIAdd, uint_, {before, amount});
    where(code_.value(spv::OpULessThan, bool_, {after, before}), [&] {
      atomic_add(code_.value(spv::OpIAdd, uint_, {word, code_.constant(1)}), code_.constant(1));
    });
  }

  // Of the private counter that for_each_sum() is at.
  uint32_t index() { return code_.value(spv::OpLoad, uint_, {index_}); }

  // Runs work(index) for each private counter. Ends the block that is being written; what follows is the block `merge`.
  void for_each_sum(uint32_t merge, const std::function<void(uint32_t)>& work) {
    const uint32_t head = code_.new_id(), test = code_.new_id(), body = code_.new_id(), next = code_.new_id();
    emit(code_.body, spv::OpStore, {index_, code_.constant(0)});
    go_to(head);
    begin_block(head);
    emit(code_.body, spv::OpLoopMerge, {merge, next, spv::LoopControlDontUnrollMask});
    go_to(test);
    begin_block(test);
    const uint32_t more = code_.value(spv::OpULessThan, bool_, {index(), code_.constant(sums_.count())});
    emit(code_.body, spv::OpBranchConditional, {more, body, merge});
    begin_block(body);
    work(index());
    go_to(next);
    begin_block(next);
    emit(code_.body, spv::OpStore, {index_, code_.value(spv::OpIAdd, uint_, {index(), code_.constant(1)})});
    go_to(head);
    begin_block(merge);
  }

  // The invocation, of which nothing else is counted yet. An array's initial value would be written element by element.
  void begin_main(uint32_t first) {
    count(code_.constant(layout_.first_word), code_.constant(1));
    if (maps_coverage_) map_coverage();
    if (sums_.count() > 0) {
      for_each_sum(first, [&](uint32_t at) { sums_.set(at, code_.constant(0)); });
    } else {
      go_to(first);
      begin_block(first);
    }
  }

  // What an invocation has run, into the counters; before it ends. Nothing follows the block that ends it, so no phi knows it.
  void count_sums() {
    if (sums_.count() == 0) return;
    for_each_sum(code_.new_id(), [&](uint32_t at) {
      const uint32_t times = sums_.value(at);
      where(code_.value(spv::OpINotEqual, bool_, {times, code_.constant(0)}), [&] {
        const uint32_t words = code_.value(spv::OpIMul, uint_, {at, code_.constant(2)});
        count(code_.value(spv::OpIAdd, uint_, {words, code_.constant(layout_.first_word + 2)}), times);
      });
    });
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
    uint32_t first = 0;                    // its label
    std::optional<uint32_t> entered;       // counter of the block whose label was written, until it is counted
    for (const SpirvInstruction& i : instructions) {
      const spv::Op op = i.op();
      if (says_a_place(op)) continue;
      if (op == spv::OpFunction) in_main = begins = i.result == main_;
      if (op == spv::OpLabel && begins) {
        // main begins in a block of its own; its first one keeps its name, and phis know it by that.
        first = i.result;
        begin_block(code_.new_id());
        continue;
      }
      if (op == spv::OpLabel) {
        if (const auto found = counter_of_.find(i.result); found != counter_of_.end()) entered = found->second;
      } else if (op != spv::OpPhi && op != spv::OpVariable && op != spv::OpFunction && op != spv::OpFunctionParameter) {
        if (std::exchange(begins, false)) begin_main(first);
        if (entered) sums_.add(code_.constant(*std::exchange(entered, std::nullopt)), code_.constant(1));
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
  PrivateCounters sums_;  // of the blocks that are counted, then of levels
  LevelCounting levels_;
  uint32_t index_ = 0;  // the variable that goes over them where an invocation ends
  uint32_t main_ = 0, frag_coord_ = 0;
  BlockWork work_;
  std::map<uint32_t, uint32_t> counter_of_;  // label -> counter
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
