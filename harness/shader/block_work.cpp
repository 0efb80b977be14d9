// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/block_work.h"

#include <algorithm>

#include "harness/shader/shader.h"
#include "harness/shader/spirv_module.h"

namespace lamina {
namespace {

// Labels that may follow a block that ends so.
std::vector<uint32_t> labels_behind(const SpirvInstruction& end) {
  switch (end.op()) {
    case spv::OpBranch:
      return {end.words[1]};
    case spv::OpBranchConditional:
      return {end.words[2], end.words[3]};
    case spv::OpSwitch: {
      std::vector<uint32_t> labels;
      for (size_t word = 2; word < end.words.size(); word += 2) labels.push_back(end.words[word]);  // default; value and label
      return labels;
    }
    default:
      return {};
  }
}

}  // namespace

void ShaderWork::add(const ShaderWork& other, uint64_t times) {
  for (const auto& [binding, count] : other.fetches) fetches[binding] += times * count;
  for (const auto& [binding, count] : other.unfiltered) unfiltered[binding] += times * count;
  for (const auto& [binding, reads] : other.levels) {
    std::vector<uint64_t>& sums = levels[binding];
    sums.resize(std::max(sums.size(), reads.size()));
    for (size_t level = 0; level < reads.size(); ++level) sums[level] += times * reads[level];
  }
  operations.add(other.operations, times);
  if (times > 0)
    for (const auto& [line, work] : other.lines) lines[line].add(work, times);
}

// A block stands between the header and the merge block of every construct that it lies in.
BlockWork::Issue BlockWork::issue_of(uint32_t block, std::span<const Construct> open) {
  const auto innermost = std::find_if(open.rbegin(), open.rend(), [](const Construct& construct) { return construct.loop; });
  if (innermost == open.rend()) return {};
  const auto branch = innermost.base();  // the first construct within that loop
  return {branch == open.end() ? block : branch->header, innermost->before};
}

BlockWork::BlockWork(const SpirvModule& module, Stage stage, const LeveledTextures& textures) {
  std::map<uint32_t, uint32_t> block_of;  // by label
  for (const SpirvInstruction& i : module.instructions())
    if (i.op() == spv::OpLabel) block_of.emplace(i.result, static_cast<uint32_t>(block_of.size())), labels_.push_back(i.result);
  work_.resize(labels_.size());
  issues_.resize(labels_.size());
  std::vector<FlowBlock> blocks(labels_.size());

  bool calls = false, in_function = false;
  uint32_t block = 0;
  SourceLine line;              // 0: the module does not say
  std::vector<Construct> open;  // the innermost last
  for (const SpirvInstruction& i : module.instructions()) {
    if (i.op() == spv::OpFunction) in_function = true;
    if (!in_function || i.op() == spv::OpFunction || i.op() == spv::OpFunctionParameter) continue;
    if (i.op() == spv::OpLine) line = {module.text(i.words[1]), i.words[2]};
    if (i.op() == spv::OpNoLine) line.line = 0;
    if (i.op() == spv::OpFunctionCall) calls = true;
    if (i.op() == spv::OpLabel) {
      block = block_of.at(i.result);
      line.line = 0;
      while (!open.empty() && open.back().merge == i.result) open.pop_back();
      blocks[block].loops = static_cast<uint32_t>(std::ranges::count(open, true, &Construct::loop));
      issues_[block] = issue_of(block, open);
    }
    if (i.op() == spv::OpSelectionMerge) open.push_back({false, i.words[1], block, block});
    if (i.op() == spv::OpLoopMerge) {
      open.push_back({true, i.words[1], block, std::max(block, 1U) - 1});
      ++blocks[block].loops;
      issues_[block] = issue_of(block, open);
    }
    for (const uint32_t next : labels_behind(i)) blocks[block].next.push_back(block_of.at(next));
    LineWork done;
    if (is_texture_operation(i)) {
      add_fetch(work_[block], module, i, stage, textures);
      done.fetches = 1;
    } else {
      const Operations operations = operations_of(module, i, stage);
      work_[block].operations.add(operations);
      done.operations = operations.sum();
    }
    if (done.fetches + done.operations == 0) continue;
    blocks[block].asked = true;
    if (line.line > 0) work_[block].lines[line].add(done);
  }
  // A function that is called may discard, and then what comes into the block of the call does not leave it.
  if (calls)
    for (block = 0; block < blocks.size(); ++block) blocks[block].next = {block}, issues_[block] = {block, block};
  flow_ = BlockFlow(blocks);
}

void BlockWork::add_fetch(ShaderWork& of_block, const SpirvModule& module, const SpirvInstruction& operation, Stage stage,
                          const LeveledTextures& textures) {
  const uint32_t binding = texture_binding(module, operation);
  ++of_block.fetches[binding];
  if (is_texel_fetch(operation)) ++of_block.unfiltered[binding];
  const auto texture = textures.find(binding);
  const LevelReads reads = texture == textures.end() ? LevelReads{} : level_reads(module, operation, stage, texture->second);
  if (reads.told == LevelReads::Told::never) without_levels_.insert(binding);
  if (reads.told == LevelReads::Told::by_running) counted_levels_[binding] = texture->second.levels;
  for (const uint32_t level : reads.levels) {
    std::vector<uint64_t>& known = of_block.levels[binding];
    known.resize(std::max(known.size(), size_t{level} + 1));
    ++known[level];
  }
}

size_t BlockWork::counters() const {
  size_t sum = flow_.counted().size();
  for (const auto& [binding, levels] : counted_levels_) sum += levels;
  return sum;
}

std::vector<uint32_t> BlockWork::counted_labels() const {
  std::vector<uint32_t> labels;
  for (const uint32_t block : flow_.counted()) labels.push_back(labels_[block]);
  return labels;
}

ShaderWork BlockWork::issued(uint64_t invocations, std::span<const uint64_t> counts) const {
  ShaderWork sum;
  const std::vector<uint64_t> times = flow_.times(invocations, counts);
  const auto issued_times = [&](auto&& self, size_t block) -> uint64_t {
    const Issue& issue = issues_[block];
    if (!issue.by) return invocations;
    return issue.around == block ? times[block] : std::max(times[*issue.by], self(self, issue.around));
  };
  for (size_t block = 0; block < work_.size(); ++block) {
    const uint64_t issued = issued_times(issued_times, block);
    for (const auto& [binding, count] : work_[block].fetches) sum.fetches[binding] += issued * count;
    sum.operations.add(work_[block].operations, issued);
  }
  return sum;
}

ShaderWork BlockWork::executed(uint64_t invocations, std::span<const uint64_t> counts) const {
  ShaderWork sum;
  const std::vector<uint64_t> times = flow_.times(invocations, counts);
  for (size_t block = 0; block < work_.size(); ++block) sum.add(work_[block], times[block]);
  size_t counter = flow_.counted().size();
  for (const auto& [binding, levels] : counted_levels_) {
    std::vector<uint64_t>& reads = sum.levels[binding];
    reads.resize(std::max(reads.size(), size_t{levels}));
    for (uint32_t level = 0; level < levels; ++level) reads[level] += counts[counter++];
  }
  for (const uint32_t binding : without_levels_) sum.levels.erase(binding);
  return sum;
}

}  // namespace lamina
