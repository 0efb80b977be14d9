// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/lifetimes.h"

#include <algorithm>

#include "harness/backend/common/shared_memory.h"
#include "harness/shader/early_tests.h"

namespace lamina {
namespace {

// Passes that are left out together: those that depend on meshes and lights alone, where they have been drawn; and the
// repetitions of a step from the first empty one on.
constexpr size_t never = 0, drawn_before = 1, first_until_empty = 2;

size_t left_out_with(const PlannedPass& pass) {
  if (pass.of->pass->until_empty) return first_until_empty + pass.step;
  return pass.of->pass->when == Frequency::mesh_or_lights_move ? drawn_before : never;
}

// A full-screen pass whose shader discards leaves what was there.
bool overwrites(const PlannedPass& pass) {
  return std::ranges::none_of(pass.draws, [](const GraphDraw* draw) {
    return std::ranges::any_of(draw->stages, [](const auto& stage) { return may_discard(stage->spirv); });
  });
}

class Lives {
 public:
  explicit Lives(const FramePasses& passes) : passes_(passes), known_(passes.targets.textures.size()) {
    for (size_t i = 0; i < known_.size(); ++i) known_[i].filled.resize(passes.targets.textures[i].levels);
    for (const TextureId id : passes.frame_buffers)
      if (id) keep(id, "the frame's picture is read back");
    for (const PlannedPass& pass : passes.once.passes) add(pass, true);
    for (const PlannedPass& pass : passes.frame.passes) add(pass, false);
  }

  std::vector<TargetLife> take() const {
    std::vector<TargetLife> lives;
    for (const Known& known : known_) {
      TargetLife& life = lives.emplace_back();
      life.kept = known.kept.empty() && !known.used ? "no pass uses it" : known.kept;
      if (life.kept.empty()) life.lifetime = known.used;
    }
    return lives;
  }

 private:
  struct Known {
    std::string kept;
    std::optional<Lifetime> used;
    bool once = false;                          // by passes done once
    std::vector<std::optional<size_t>> filled;  // by level, with what the pass that does it is left out; none: not filled yet
  };

  void keep(TextureId id, const char* why) {
    if (Known& known = known_[id.value]; known.kept.empty()) known.kept = why;
  }

  Known& use(TextureId id) {
    Known& known = known_[id.value];
    if (known.used && known.once != once_) keep(id, "it is drawn once and read in every frame");
    if (!known.used) known.used = Lifetime{place_, place_}, known.once = once_;
    known.used->last = place_;
    return known;
  }

  void need(TextureId id, std::optional<uint32_t> level) {
    Known& known = use(id);
    for (uint32_t i = 0; i < known.filled.size(); ++i) {
      if (level && *level != i) continue;
      if (!known.filled[i])
        keep(id, "it is read before it is cleared or overwritten");
      else if (*known.filled[i] != never && *known.filled[i] != with_)
        keep(id, "the pass that clears it may be left out");
    }
  }

  void fill(TextureId id, uint32_t level) {
    std::optional<size_t>& filled = use(id).filled[level];
    if (!filled || *filled != never) filled = with_;
  }

  void add(const PlannedPass& planned, bool once) {
    const Pass& pass = planned.pass;
    once_ = once, with_ = left_out_with(planned);
    for (const Draw& draw : pass.draws) {
      for (const TextureBinding& binding : draw.textures)
        if (binding.texture) need(binding.texture, binding.level);
      for (const ImageBinding& binding : draw.images) need(binding.texture, binding.level);
    }
    if (pass.kind == PassKind::mips) {
      need(pass.mips_of, 0);
      for (uint32_t level = 1; level < passes_.targets.textures[pass.mips_of.value].levels; ++level) fill(pass.mips_of, level);
    }
    if (pass.kind == PassKind::copy) {
      need(pass.copy_from, 0);
      fill(pass.copy_to, 0);
    }
    for (const Attachment& color : pass.colors) attach(planned, color);
    if (pass.depth) attach(planned, *pass.depth);
    ++place_;
  }

  void attach(const PlannedPass& pass, const Attachment& attachment) {
    const bool fills = attachment.load == Load::clear || (attachment.load == Load::discard && overwrites(pass));
    if (fills)
      fill(attachment.texture, attachment.level);
    else
      need(attachment.texture, attachment.level);
  }

  const FramePasses& passes_;
  std::vector<Known> known_;
  uint32_t place_ = 0;  // of the pass
  bool once_ = false;
  size_t with_ = never;
};

}  // namespace

std::vector<TargetLife> target_lives(const FramePasses& passes) { return Lives(passes).take(); }

std::vector<TransientDesc> transient_targets(const FramePasses& passes) {
  std::vector<TransientDesc> targets;
  const std::vector<TargetLife> lives = target_lives(passes);
  for (size_t i = 0; i < lives.size(); ++i) targets.push_back({passes.targets.textures[i], lives[i].lifetime});
  return targets;
}

TargetMemory target_memory(const FramePasses& passes) {
  const std::vector<TransientDesc> targets = transient_targets(passes);
  const std::vector<size_t> which = reused_textures(targets);
  TargetMemory memory;
  std::vector<MemoryNeed> transient;
  for (size_t i = 0; i < targets.size(); ++i) {
    const uint64_t bytes = texture_bytes(targets[i].texture);
    memory.alone += bytes;
    if (which[i] == i) memory.reused += bytes;
    if (targets[i].lifetime)
      transient.push_back({bytes, 1, *targets[i].lifetime});
    else
      memory.aliased += bytes;
  }
  memory.aliased += place_in_memory(transient).bytes;
  return memory;
}

}  // namespace lamina
