// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/frame_passes.h"

#include <algorithm>
#include <bit>

namespace lamina {
namespace {

std::array<float, 4> clear_of(const PassManifest& pass, const std::string& target, const Scene& scene) {
  if (pass.clear) return *pass.clear;
  if (target == "frame") return {scene.background.r, scene.background.g, scene.background.b, 0};
  return {0, 0, 0, 0};
}

// The level that repetition `index` writes, and the one that it reads, of a target that the pass walks along.
uint32_t written_level(LevelWalk walk, uint32_t index, uint32_t levels) {
  return walk == LevelWalk::down ? index + 1 : walk == LevelWalk::up ? levels - 2 - index : 0;
}
uint32_t read_level(LevelWalk walk, uint32_t index, uint32_t levels) {
  return walk == LevelWalk::down ? index : levels - 1 - index;
}

class PassPlanner {
 public:
  PassPlanner(const Graph& graph, const Scene& scene, FramePx size, TargetTextures& made)
      : graph_(graph), scene_(scene), targets_(graph, scene, size, made) {}

  PlannedSequence sequence(bool once) {
    targets_.begin_sequence();
    PlannedSequence sequence;
    for (const GraphPass& pass : graph_.passes)
      if (pass.once == once) add_step(pass, sequence);
    return sequence;
  }

  const FrameTarget& frame() { return targets_.frame(); }

 private:
  // One repetition of a pass.
  struct Repetition {
    const GraphPass& pass;
    uint32_t index, count;
    PlannedSequence& sequence;  // that is added to
  };

  void add_step(const GraphPass& pass, PlannedSequence& sequence) {
    sequence.steps.push_back({&pass});
    const uint32_t count = repetitions(pass);
    for (uint32_t index = 0; index < count; ++index) add_repetition({pass, index, count, sequence});
  }

  uint32_t repetitions(const GraphPass& pass) {
    if (pass.pass->levels != LevelWalk::none)
      return targets_.target(pass, pass.draws.front(), pass.pass->writes.front()).levels - 1;
    if (pass.pass->repeat_log2_of.empty())
      return static_cast<uint32_t>(pass.variant->value_of(pass.pass->repeat, graph_.parameters));
    uint32_t longest = 1;
    for (const GraphDraw& draw : pass.draws) {
      const FrameTarget& sized = targets_.target(pass, draw, pass.pass->repeat_log2_of);
      longest = std::max({longest, sized.width, sized.height});
    }
    return static_cast<uint32_t>(std::bit_width(longest - 1));
  }

  void add_repetition(const Repetition& repetition) {
    const std::span<const GraphDraw> draws = repetition.pass.draws;
    const bool together = repetition.pass.pass->draw == DrawKind::objects;  // all objects of a view in one pass
    for (size_t begin = 0; begin < draws.size();) {
      size_t end = begin + 1;
      while (together && end < draws.size() && draws[end].light == draws[begin].light) ++end;
      add_pass(repetition, draws.subspan(begin, end - begin));
      begin = end;
    }
  }

  PlannedPass& push(const Repetition& repetition, Pass pass) {
    PlannedPass& planned = repetition.sequence.passes.emplace_back();
    planned.pass = std::move(pass), planned.of = &repetition.pass;
    planned.step = repetition.sequence.steps.size() - 1;
    planned.repetition = repetition.index, planned.repetitions = repetition.count;
    return planned;
  }

  // Draws of one backend pass: all objects of a view, or one thing's.
  void add_pass(const Repetition& repetition, std::span<const GraphDraw> draws) {
    const PassManifest& manifest = *repetition.pass.pass;
    // Any object of the pass may read back what it writes, so targets are swapped only after the reads of all draws are bound.
    std::vector<FrameTarget*> turning;
    for (const GraphDraw& draw : draws) {
      clear_unwritten(repetition, draw);
      prepare_read_back(repetition, draw, turning);
    }
    Pass into = begin_pass(repetition, draws.front());
    std::vector<const GraphDraw*> drawn;
    for (size_t i = 0; i < draws.size() && manifest.draw != DrawKind::mips; ++i) {
      if (draws[i].stages.empty()) continue;
      into.draws.push_back(make_draw(repetition, draws[i]));
      drawn.push_back(&draws[i]);
    }
    into.count_samples = manifest.until_empty;
    push(repetition, std::move(into)).draws = std::move(drawn);
    for (FrameTarget* target : turning) target->current = 1 - target->current;
    PlannedSequence::Step& step = repetition.sequence.steps.back();
    step.turns = step.turns || !turning.empty();
  }

  // The frame and its depth may be read where nothing has been drawn: they are then empty.
  void clear_unwritten(const Repetition& repetition, const GraphDraw& draw) {
    for (const ResolvedRead& read : draw.reads) {
      const bool depth = read.source.kind == Source::Kind::depth;
      if (!depth && (read.source.kind != Source::Kind::frame || writes(*repetition.pass.pass, "frame"))) continue;
      FrameTarget& target = depth ? targets_.depth() : targets_.frame();
      if (target.written) continue;
      target.written = true;
      Pass cleared;
      cleared.name = pass_label(repetition.pass, draw, scene_, false) + " before";
      const glm::vec3& around = scene_.background;
      if (depth)
        cleared.depth = Attachment{target.buffers[target.current], 0, Load::clear, {1, 0, 0, 0}};
      else
        cleared.colors.push_back({target.buffers[target.current], 0, Load::clear, {around.r, around.g, around.b, 0}});
      push(repetition, std::move(cleared)).prepares = true;
    }
  }

  // For a draw that reads what it writes: clears the buffer that it reads, if nothing is in it yet, and copies it into the
  // buffer that it writes where objects are drawn, for these need not cover all.
  void prepare_read_back(const Repetition& repetition, const GraphDraw& draw, std::vector<FrameTarget*>& turning) {
    const PassManifest& manifest = *repetition.pass.pass;
    for (const std::string& name : manifest.written()) {
      if (!reads_back(repetition.pass, draw, name)) continue;
      FrameTarget& target = targets_.target(repetition.pass, draw, name);
      if (std::find(turning.begin(), turning.end(), &target) != turning.end()) continue;
      turning.push_back(&target);
      if (!target.buffers[1])
        throw Error(ErrorKind::bad_input, "variants", manifest.where,
                    fmt::format("reads and writes '{}', which needs buffers = 2", name));
      const bool depth = name == manifest.depth_target;
      const TextureId now = target.buffers[target.current], next = target.buffers[1 - target.current];
      const std::string label = pass_label(repetition.pass, draw, scene_, false) + " before";
      if (!target.written) {
        Pass before;
        before.name = label;
        const Attachment cleared{now, 0, Load::clear,
                                 depth ? std::array<float, 4>{0, 0, 0, 0} : clear_of(manifest, name, scene_)};
        if (depth)
          before.depth = cleared;
        else
          before.colors.push_back(cleared);
        push(repetition, std::move(before)).prepares = true;
      }
      target.written = true;
      if (depth || manifest.draw != DrawKind::objects || manifest.clear) continue;
      Pass copy;
      copy.name = label;
      copy.kind = PassKind::copy;
      copy.copy_from = now, copy.copy_to = next;
      push(repetition, std::move(copy)).prepares = true;
    }
  }

  Pass begin_pass(const Repetition& repetition, const GraphDraw& draw) {
    const PassManifest& manifest = *repetition.pass.pass;
    Pass into;
    into.name = pass_label(repetition.pass, draw, scene_, manifest.draw != DrawKind::objects);
    if (manifest.draw == DrawKind::mips) {
      const FrameTarget& mipped = targets_.target(repetition.pass, draw, manifest.writes.front());
      into.kind = PassKind::mips;
      into.mips_of = mipped.buffers[mipped.current];
    } else if (manifest.draw == DrawKind::compute) {
      into.kind = PassKind::compute;
      for (const std::string& name : manifest.writes) targets_.target(repetition.pass, draw, name).written = true;
    } else {
      attach(repetition, draw, into);
    }
    return into;
  }

  void attach(const Repetition& repetition, const GraphDraw& draw, Pass& into) {
    const PassManifest& manifest = *repetition.pass.pass;
    for (const std::string& name : manifest.writes) {
      FrameTarget& written = targets_.target(repetition.pass, draw, name);
      const bool turns = reads_back(repetition.pass, draw, name);
      Attachment attachment;
      attachment.texture = written.buffers[turns ? 1 - written.current : written.current];
      attachment.level = written_level(manifest.levels, repetition.index, written.levels);
      const Blend blend = manifest.blend[into.colors.size()];
      const bool covers_all = manifest.draw == DrawKind::fullscreen && blend == Blend::none;
      const bool keeps = written.written && !manifest.clear && (attachment.level == 0 || manifest.levels == LevelWalk::up);
      attachment.load = covers_all ? Load::discard : keeps ? Load::keep : Load::clear;
      attachment.clear = clear_of(manifest, name, scene_);
      written.written = true;
      into.colors.push_back(attachment);
    }
    if (manifest.depth == Depth::none) return;
    const bool own = !manifest.depth_target.empty();
    FrameTarget& depth = own ? targets_.target(repetition.pass, draw, manifest.depth_target) : targets_.depth();
    const bool turns = own && reads_back(repetition.pass, draw, manifest.depth_target);
    const bool keeps = depth.written && !turns && !manifest.clear_depth_again;
    into.depth = Attachment{depth.buffers[turns ? 1 - depth.current : depth.current],
                            0,
                            keeps ? Load::keep : Load::clear,
                            {manifest.clear_depth, 0, 0, 0}};
    depth.written = true;
  }

  Draw make_draw(const Repetition& repetition, const GraphDraw& draw) {
    const GraphPass& pass = repetition.pass;
    const PassManifest& manifest = *pass.pass;
    Draw command;
    for (const ResolvedRead& read : draw.reads) {
      TextureBinding binding{read.binding, {}, read.source.sampler, {}};
      if (is_target(read.source)) {
        const FrameTarget& target = targets_.source_target(pass, draw, read.source);
        binding.texture = target.buffers[target.current];
        if (manifest.levels != LevelWalk::none && read.source.kind == Source::Kind::target &&
            writes(manifest, read.source.name))
          binding.level = read_level(manifest.levels, repetition.index, target.levels);
      }
      command.textures.push_back(binding);
    }
    for (const auto& stage : draw.stages)
      for (const ShaderResource& resource : stage->reflection.resources) {
        if (resource.kind != BindingKind::storage_image) continue;
        if (std::ranges::find(command.images, resource.binding, &ImageBinding::binding) != command.images.end()) continue;
        const FrameTarget& image = targets_.target(pass, draw, resource.name);
        command.images.push_back({resource.binding, image.buffers[image.current], 0});
      }
    if (manifest.draw == DrawKind::fullscreen) command.count = 3;
    if (manifest.draw != DrawKind::compute) return command;
    command.groups = manifest.groups;
    if (!manifest.threads_over.empty()) {
      const FrameTarget& over = targets_.target(pass, draw, manifest.threads_over);
      const auto& local = manifest.local_size;
      command.groups = {(over.width + local[0] - 1) / local[0], (over.height + local[1] - 1) / local[1], 1};
    }
    return command;
  }

  const Graph& graph_;
  const Scene& scene_;
  Targets targets_;
};

}  // namespace

FramePasses make_frame_passes(const Graph& graph, const Scene& scene, FramePx size) {
  FramePasses passes;
  PassPlanner planner(graph, scene, size, passes.targets);
  passes.once = planner.sequence(true);
  passes.frame = planner.sequence(false);
  passes.frame_buffers = planner.frame().buffers;
  passes.picture = planner.frame().buffers[planner.frame().current];
  return passes;
}

std::string pass_label(const GraphPass& pass, const GraphDraw& draw, const Scene& scene, bool with_object) {
  std::string label = pass.variant->name + "." + pass.pass->name;
  if (with_object && draw.object) label += "." + scene.objects[*draw.object].name;
  if (draw.light) label += "." + scene.lights[*draw.light].name;
  return label;
}

}  // namespace lamina
