// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/frame_builder.h"

#include <algorithm>
#include <bit>

#include "harness/core/text.h"
#include "harness/graph/spec_constants.h"

namespace lamina {
namespace {

// Above what shaders declare, used or not, and below the fewest storage buffer bindings that drivers offer.
constexpr uint32_t first_counter_binding = 16;
constexpr uint32_t counter_header_words = 2;  // shader.h's CountingLayout: width of the coverage map, 0

bool writes_frame(const GraphPass& pass) {
  return std::find(pass.pass->writes.begin(), pass.pass->writes.end(), "frame") != pass.pass->writes.end();
}

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

}  // namespace

FrameBuilder::FrameBuilder(Frame& frame, const Graph& graph)
    : frame_(frame),
      resources_(frame.resources_),
      backend_(frame.backend_),
      scene_(frame.resources_.scene()),
      graph_(graph),
      targets_(frame.resources_, graph, frame.made_) {}

void FrameBuilder::build() {
  build_sequence(true, frame_.once_);
  build_sequence(false, frame_.frame_);
  frame_.frame_buffers_ = targets_.frame().buffers;
  frame_.picture_ = targets_.frame().buffers[targets_.frame().current];
}

void FrameBuilder::build_sequence(bool once, Frame::Sequence& sequence) {
  targets_.begin_sequence();
  sequence.passes_by_view.emplace_back();
  for (const GraphPass& pass : graph_.passes)
    if (pass.once == once) build_step(pass, sequence);
  sequence.running.resize(once ? 1 : scene_.views.size());
  // The other views differ by their blocks Frame.
  for (size_t view = 1; view < scene_.views.size() && !once; ++view) {
    std::vector<Pass> passes = sequence.passes_by_view[0];
    for (Pass& pass : passes)
      for (Draw& draw : pass.draws)
        for (BufferBinding& binding : draw.buffers)
          if (const auto block = frame_blocks_.find(binding.buffer); block != frame_blocks_.end()) {
            const auto& [layout, of, light] = block->second;
            binding.buffer = resources_.block(layout, {*of->effect, of->pass->where, view, of->pass->view, light, {}});
          }
    sequence.passes_by_view.push_back(std::move(passes));
  }
}

void FrameBuilder::build_step(const GraphPass& pass, Frame::Sequence& sequence) {
  Frame::Step& step = sequence.steps.emplace_back();
  step.pass = &pass;
  sequence.names.push_back(pass.pass->name);
  next_word_ = counter_header_words;
  if (writes_frame(pass)) {
    step.coverage_word = next_word_;
    next_word_ += resources_.width_px() * resources_.height_px();
  }
  std::vector<Pass>& passes = sequence.passes_by_view[0];
  const size_t first_pass = passes.size();
  const uint32_t count = repetitions(pass);
  for (uint32_t index = 0; index < count; ++index) {
    build_repetition({pass, step, index, count, passes});
    sequence.repetition_of_pass.resize(passes.size(), index);
  }
  sequence.step_of_pass.resize(passes.size(), sequence.steps.size() - 1);
  sequence.stops_early = sequence.stops_early || pass.pass->until_empty;
  if (frame_.build_ == Build::counting && !step.counted.empty()) give_counters(step, first_pass, sequence);
}

// The counters' buffer can be made only when every draw of the step has its words: until then its bindings hold no buffer.
void FrameBuilder::give_counters(Frame::Step& step, size_t first_pass, Frame::Sequence& sequence) {
  step.cleared.assign(next_word_, 0);
  step.cleared[0] = resources_.width_px();
  step.counters = backend_.create_buffer("counters " + step.pass->pass->name, BufferUse::storage, step.cleared.size() * 4);
  frame_.made_.buffers.push_back(step.counters);
  for (size_t i = first_pass; i < sequence.passes_by_view[0].size(); ++i)
    for (Draw& draw : sequence.passes_by_view[0][i].draws)
      for (BufferBinding& binding : draw.buffers)
        if (!binding.buffer) binding.buffer = step.counters;
}

uint32_t FrameBuilder::repetitions(const GraphPass& pass) {
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

void FrameBuilder::build_repetition(const Repetition& repetition) {
  const std::span<const GraphDraw> draws = repetition.pass.draws;
  const bool together = repetition.pass.pass->draw == DrawKind::objects;  // all objects of a view in one pass
  for (size_t begin = 0; begin < draws.size();) {
    size_t end = begin + 1;
    while (together && end < draws.size() && draws[end].light == draws[begin].light) ++end;
    build_pass(repetition, draws.subspan(begin, end - begin));
    begin = end;
  }
}

void FrameBuilder::build_pass(const Repetition& repetition, std::span<const GraphDraw> draws) {
  const PassManifest& manifest = *repetition.pass.pass;
  // Any object of the pass may read back what it writes, so targets are swapped only after the reads of all draws are bound.
  std::vector<FrameTarget*> turning;
  for (const GraphDraw& draw : draws) {
    clear_unwritten(repetition, draw);
    prepare_read_back(repetition, draw, turning);
  }
  Pass into = begin_pass(repetition, draws.front());
  for (size_t i = 0; i < draws.size() && manifest.draw != DrawKind::mips; ++i)
    if (!draws[i].stages.empty()) into.draws.push_back(make_draw(repetition, draws[i], into));
  into.count_samples = manifest.until_empty;
  into.count_issued_fragments = frame_.build_ == Build::counting;
  repetition.passes.push_back(std::move(into));
  for (FrameTarget* target : turning) target->current = 1 - target->current;
  repetition.step.turns = repetition.step.turns || !turning.empty();
}

// The frame and its depth may be read where nothing has been drawn: they are then empty.
void FrameBuilder::clear_unwritten(const Repetition& repetition, const GraphDraw& draw) {
  for (const ResolvedRead& read : draw.reads) {
    const bool depth = read.source.kind == Source::Kind::depth;
    if (!depth && (read.source.kind != Source::Kind::frame || writes_frame(repetition.pass))) continue;
    FrameTarget& target = depth ? targets_.depth() : targets_.frame();
    if (target.written) continue;
    target.written = true;
    Pass cleared;
    cleared.name = label_of(repetition.pass, draw, false) + " before";
    const glm::vec3& around = scene_.background;
    if (depth)
      cleared.depth = Attachment{target.buffers[target.current], 0, Load::clear, {1, 0, 0, 0}};
    else
      cleared.colors.push_back({target.buffers[target.current], 0, Load::clear, {around.r, around.g, around.b, 0}});
    repetition.passes.push_back(cleared);
  }
}

// For a draw that reads what it writes: clears the buffer that it reads, if nothing is in it yet, and copies it into the buffer
// that it writes where objects are drawn, for these need not cover all.
void FrameBuilder::prepare_read_back(const Repetition& repetition, const GraphDraw& draw, std::vector<FrameTarget*>& turning) {
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
    Pass before;
    before.name = label_of(repetition.pass, draw, false) + " before";
    if (!target.written) {
      before.kind = PassKind::raster;
      const Attachment cleared{now, 0, Load::clear,
                               depth ? std::array<float, 4>{0, 0, 0, 0} : clear_of(manifest, name, scene_)};
      if (depth)
        before.depth = cleared;
      else
        before.colors.push_back(cleared);
      repetition.passes.push_back(before);
    }
    target.written = true;
    if (depth || manifest.draw != DrawKind::objects || manifest.clear) continue;
    Pass copy;
    copy.name = before.name;
    copy.kind = PassKind::copy;
    copy.copy_from = now, copy.copy_to = next;
    repetition.passes.push_back(copy);
  }
}

Pass FrameBuilder::begin_pass(const Repetition& repetition, const GraphDraw& draw) {
  const PassManifest& manifest = *repetition.pass.pass;
  Pass into;
  into.name = label_of(repetition.pass, draw, manifest.draw != DrawKind::objects);
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

void FrameBuilder::attach(const Repetition& repetition, const GraphDraw& draw, Pass& into) {
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

Draw FrameBuilder::make_draw(const Repetition& repetition, const GraphDraw& draw, const Pass& into) {
  const PassManifest& manifest = *repetition.pass.pass;
  Draw command;
  bind(repetition, draw, command);
  command.pipeline = pipeline(repetition, draw, into, command);
  if (manifest.draw == DrawKind::compute) {
    command.groups = manifest.groups;
    if (!manifest.threads_over.empty()) {
      const FrameTarget& over = targets_.target(repetition.pass, draw, manifest.threads_over);
      const auto& local = manifest.local_size;
      command.groups = {(over.width + local[0] - 1) / local[0], (over.height + local[1] - 1) / local[1], 1};
    }
  } else if (manifest.draw == DrawKind::fullscreen) {
    command.count = 3;
  } else {
    const SceneResources::MeshBuffers& mesh = resources_.mesh(*draw.object);
    command.vertices = mesh.vertices;
    command.indices = mesh.indices;
    command.count = mesh.index_count;
  }
  return command;
}

std::optional<uint32_t> FrameBuilder::level_read(const Repetition& repetition, const GraphDraw& draw,
                                                 const ResolvedRead& read) {
  const PassManifest& manifest = *repetition.pass.pass;
  const bool walks = manifest.levels != LevelWalk::none && read.source.kind == Source::Kind::target &&
                     std::find(manifest.writes.begin(), manifest.writes.end(), read.source.name) != manifest.writes.end();
  if (!walks) return std::nullopt;
  return lamina::read_level(manifest.levels, repetition.index,
                            targets_.source_target(repetition.pass, draw, read.source).levels);
}

void FrameBuilder::bind(const Repetition& repetition, const GraphDraw& draw, Draw& command) {
  const GraphPass& pass = repetition.pass;
  for (const ResolvedRead& read : draw.reads) {
    TextureBinding binding{read.binding, {}, read.source.sampler, {}};
    if (const auto image = resources_.image_of(read.source, draw.object)) {
      binding.texture = resources_.texture(image);
      if (image->wraps) binding.sampler.wrap = image->wraps->u, binding.sampler.wrap_v = image->wraps->v;
    } else {
      const FrameTarget& target = targets_.source_target(pass, draw, read.source);
      binding.texture = target.buffers[target.current];
      binding.level = level_read(repetition, draw, read);
    }
    command.textures.push_back(binding);
  }
  for (const ResolvedBuffer& buffer : draw.buffers)
    command.buffers.push_back({buffer.binding, targets_.buffer(pass, draw, buffer), BindingKind::storage_buffer});
  std::vector<uint32_t> bound;
  for (const auto& stage : draw.stages)
    for (const ShaderResource& resource : stage->reflection.resources) {
      if (std::find(bound.begin(), bound.end(), resource.binding) != bound.end()) continue;
      if (resource.kind == BindingKind::storage_image) {
        const FrameTarget& image = targets_.target(pass, draw, resource.name);
        command.images.push_back({resource.binding, image.buffers[image.current], 0});
      } else if (resource.kind == BindingKind::uniform_buffer) {
        bind_block(repetition, draw, resource, command);
      } else {
        continue;
      }
      bound.push_back(resource.binding);
    }
}

void FrameBuilder::bind_block(const Repetition& repetition, const GraphDraw& draw, const ShaderResource& block, Draw& command) {
  const GraphPass& pass = repetition.pass;
  const glm::ivec4 iteration(static_cast<int>(repetition.index), static_cast<int>(repetition.count), 0, 0);
  const BufferId id =
      resources_.block(block, {*pass.effect, pass.pass->where, 0, pass.pass->view, draw.light, draw.object, iteration});
  if (block.name == "Frame") frame_blocks_.try_emplace(id, FrameBlock{block, &pass, draw.light});
  command.buffers.push_back({block.binding, id, BindingKind::uniform_buffer});
}

PipelineId FrameBuilder::pipeline(const Repetition& repetition, const GraphDraw& draw, const Pass& into, Draw& command) {
  const GraphPass& pass = repetition.pass;
  PipelineDesc desc;
  desc.name = label_of(pass, draw, true);
  std::string key = fmt::format("{}|{}|{}", pass.variant->effect, pass.variant->name, pass.pass - pass.variant->passes.data());
  for (const auto& stage : draw.stages) {
    desc.stages.push_back({stage->stage, stage->spirv});
    key += fmt::format("|{}", static_cast<const void*>(stage.get()));
    for (const ShaderResource& resource : stage->reflection.resources) desc.bindings.push_back(resource.slot());
    if (stage->stage == Stage::vertex) desc.vertex_locations = stage->reflection.input_locations;
  }
  for (const std::string& name : pass.pass->writes)
    if (!into.colors.empty()) desc.colors.push_back(targets_.target(pass, draw, name).format);
  if (into.depth) desc.depth_format = Format::d32_float;
  desc.constants = spec_constants(pass, draw, graph_.parameters);
  if (!desc.colors.empty()) desc.blend = pass.pass->blend;
  desc.depth = pass.pass->depth;
  desc.depth_test = pass.pass->depth_test;
  desc.cull = pass.pass->cull;
  if (frame_.build_ == Build::counting) {
    uint32_t binding = first_counter_binding;
    for (const BindingSlot& slot : desc.bindings) binding = std::max(binding, slot.binding + 1);
    desc.bindings.push_back({binding, BindingKind::storage_buffer});
    command.buffers.push_back({binding, {}, BindingKind::storage_buffer});
    // Its counters are built in, and they count by format, filter, size and level: draws and repetitions that are alike in
    // these share both.
    std::map<uint32_t, CountedTexture> textures;
    for (const ResolvedRead& read : draw.reads) {
      const CountedTexture& texture = textures[read.binding] = counted_texture(repetition, draw, read);
      key += "|" + key_of(texture);
    }
    if (!pipelines_.contains(key)) count(repetition, draw, binding, textures, desc);
  }
  std::sort(desc.bindings.begin(), desc.bindings.end());
  desc.bindings.erase(std::unique(desc.bindings.begin(), desc.bindings.end()), desc.bindings.end());
  if (pipelines_.contains(key)) return pipelines_.at(key);
  const PipelineId id = backend_.create_pipeline(desc);
  frame_.pipelines_.push_back(id);
  pipelines_[key] = id;
  return id;
}

CountedTexture FrameBuilder::counted_texture(const Repetition& repetition, const GraphDraw& draw, const ResolvedRead& read) {
  const std::optional<uint32_t> level = level_read(repetition, draw, read);
  const Filter filter = read.source.sampler.filter;
  if (const auto image = resources_.image_of(read.source, draw.object))
    return lamina::counted_texture(read.sampler, filter, image->format, {image->width, image->height, image->depth},
                                   static_cast<uint32_t>(image->levels.size()), level);
  const FrameTarget& target = targets_.source_target(repetition.pass, draw, read.source);
  return lamina::counted_texture(read.sampler, filter, target.format, {target.width, target.height, 1}, target.levels, level);
}

void FrameBuilder::count(const Repetition& repetition, const GraphDraw& draw, uint32_t binding,
                         const std::map<uint32_t, CountedTexture>& textures, PipelineDesc& desc) {
  Frame::Step& step = repetition.step;
  CountingLayout layout{.binding = binding};
  for (const auto& [at, texture] : textures) layout.textures[at] = texture.leveled;
  for (size_t i = 0; i < draw.stages.size(); ++i) {
    const CompiledShader& shader = *draw.stages[i];
    layout.first_word = next_word_;
    layout.coverage_word = shader.stage == Stage::fragment ? step.coverage_word : 0;
    CountingShader counting = add_counters(shader, backend_.info().api, layout);
    next_word_ += counting.words();
    step.counted.push_back(
        {shader.stage, layout.first_word, textures, std::move(counting.work), counting.early_fragment_tests});
    desc.stages[i].spirv = std::move(counting.spirv);
  }
}

std::string FrameBuilder::label_of(const GraphPass& pass, const GraphDraw& draw, bool with_object) const {
  std::string label = pass.variant->name + "." + pass.pass->name;
  if (with_object && draw.object) label += "." + scene_.objects[*draw.object].name;
  if (draw.light) label += "." + scene_.lights[*draw.light].name;
  return label;
}

}  // namespace lamina
