// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/frame_builder.h"

#include <algorithm>

#include "harness/backend/common/shared_memory.h"
#include "harness/core/text.h"
#include "harness/graph/lifetimes.h"
#include "harness/graph/spec_constants.h"

namespace lamina {
namespace {

// Above what shaders declare, used or not, and below the fewest storage buffer bindings that drivers offer.
constexpr uint32_t first_counter_binding = 16;
constexpr uint32_t counter_header_words = 2;  // shader.h's CountingLayout: width of the coverage map, 0

// Every target of the pass, which is a place in `textures`, becomes the texture that is there.
void put_textures(Pass& pass, std::span<const TextureId> textures) {
  const auto put = [&](TextureId& id) {
    if (id) id = textures[id.value];
  };
  for (Attachment& color : pass.colors) put(color.texture);
  if (pass.depth) put(pass.depth->texture);
  for (TextureId* id : {&pass.mips_of, &pass.copy_from, &pass.copy_to}) put(*id);
  for (Draw& draw : pass.draws) {
    for (TextureBinding& binding : draw.textures) put(binding.texture);
    for (ImageBinding& binding : draw.images) put(binding.texture);
  }
}

}  // namespace

FrameBuilder::FrameBuilder(Frame& frame, const Graph& graph)
    : frame_(frame), resources_(frame.resources_), backend_(frame.backend_), scene_(frame.resources_.scene()), graph_(graph) {}

void FrameBuilder::build(TargetSharing sharing, const Frame* like) {
  FramePasses passes = make_frame_passes(graph_, scene_, {resources_.width_px(), resources_.height_px()});
  make_targets(passes, sharing, like);
  build_sequence(passes.once, frame_.once_);
  build_sequence(passes.frame, frame_.frame_);
}

void FrameBuilder::make_targets(FramePasses& passes, TargetSharing sharing, const Frame* like) {
  std::vector<TransientDesc> targets = transient_targets(passes);
  if (sharing == TargetSharing::off)
    for (TransientDesc& target : targets) target.lifetime.reset();
  const bool is_alike = like && like->made_.asked == targets;
  Frame::Made& made = frame_.made_;
  made.placed = is_alike ? like->made_.placed : backend_.create_textures(targets);
  made.asked = targets;
  const PlacedTextures& placed = made.placed;
  made.memory_bytes += placed.bytes;
  made.memory_bytes_alone += placed.bytes_alone;
  for (size_t i = 0; i < targets.size(); ++i) {
    const TextureDesc& desc = targets[i].texture;
    made.bytes += texture_bytes(desc);
    if (made.targets.try_emplace(placed.textures[i], desc).second && !is_alike) made.textures.push_back(placed.textures[i]);
  }
  for (const auto& [key, id] : passes.targets.frame_sized)
    if (!targets[id.value].lifetime) made.frame_sized[key] = placed.textures[id.value];
  for (PlannedSequence* sequence : {&passes.once, &passes.frame})
    for (PlannedPass& pass : sequence->passes) put_textures(pass.pass, placed.textures);
  for (size_t i = 0; i < passes.frame_buffers.size(); ++i)
    if (passes.frame_buffers[i]) frame_.frame_buffers_[i] = placed.textures[passes.frame_buffers[i].value];
  frame_.picture_ = placed.textures[passes.picture.value];
}

void FrameBuilder::build_sequence(PlannedSequence& planned, Frame::Sequence& sequence) {
  sequence.passes_by_view.emplace_back();
  for (size_t step = 0, next = 0; step < planned.steps.size(); ++step) {
    Frame::Step& into = begin_step(planned.steps[step], sequence);
    const size_t first_pass = sequence.passes_by_view[0].size();
    for (; next < planned.passes.size() && planned.passes[next].step == step; ++next) {
      PlannedPass& pass = planned.passes[next];
      Pass ready = pass.pass;
      ready.count_issued_fragments = frame_.build_ == Build::counting && !pass.prepares;
      for (size_t i = 0; i < ready.draws.size(); ++i) finish_draw({pass, into}, *pass.draws[i], pass.pass, ready.draws[i]);
      sequence.passes_by_view[0].push_back(std::move(ready));
      sequence.step_of_pass.push_back(step);
      sequence.repetition_of_pass.push_back(pass.repetition);
    }
    end_step(first_pass, sequence);
  }
  const bool once = &sequence == &frame_.once_;
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

Frame::Step& FrameBuilder::begin_step(const PlannedSequence::Step& planned, Frame::Sequence& sequence) {
  Frame::Step& step = sequence.steps.emplace_back();
  step.pass = planned.pass;
  step.turns = planned.turns;
  sequence.names.push_back(step.pass->pass->name);
  sequence.stops_early = sequence.stops_early || step.pass->pass->until_empty;
  next_word_ = counter_header_words;
  if (writes(*step.pass->pass, "frame")) {
    step.coverage_word = next_word_;
    next_word_ += resources_.width_px() * resources_.height_px();
  }
  return step;
}

void FrameBuilder::end_step(size_t first_pass, Frame::Sequence& sequence) {
  Frame::Step& step = sequence.steps.back();
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

void FrameBuilder::finish_draw(const Place& place, const GraphDraw& draw, const Pass& into, Draw& command) {
  bind(place, draw, command);
  command.pipeline = pipeline(place, draw, into, command);
  const DrawKind kind = place.pass().pass->draw;
  if (kind == DrawKind::compute || kind == DrawKind::fullscreen) return;
  const SceneResources::MeshBuffers& mesh = resources_.mesh(*draw.object);
  command.vertices = mesh.vertices;
  command.indices = mesh.indices;
  command.count = mesh.index_count;
}

void FrameBuilder::bind(const Place& place, const GraphDraw& draw, Draw& command) {
  for (size_t i = 0; i < draw.reads.size(); ++i) {
    const auto image = resources_.image_of(draw.reads[i].source, draw.object);
    if (!image) continue;
    TextureBinding& binding = command.textures[i];
    binding.texture = resources_.texture(image);
    if (image->wraps) binding.sampler.wrap = image->wraps->u, binding.sampler.wrap_v = image->wraps->v;
  }
  for (const ResolvedBuffer& storage : draw.buffers)
    command.buffers.push_back({storage.binding, buffer(place.pass(), draw, storage), BindingKind::storage_buffer});
  std::vector<uint32_t> bound;
  for (const auto& stage : draw.stages)
    for (const ShaderResource& resource : stage->reflection.resources) {
      if (resource.kind != BindingKind::uniform_buffer) continue;
      if (std::find(bound.begin(), bound.end(), resource.binding) != bound.end()) continue;
      bind_block(place, draw, resource, command);
      bound.push_back(resource.binding);
    }
}

void FrameBuilder::bind_block(const Place& place, const GraphDraw& draw, const ShaderResource& block, Draw& command) {
  const GraphPass& pass = place.pass();
  const glm::ivec4 iteration(static_cast<int>(place.planned.repetition), static_cast<int>(place.planned.repetitions), 0, 0);
  const BufferId id =
      resources_.block(block, {*pass.effect, pass.pass->where, 0, pass.pass->view, draw.light, draw.object, iteration});
  if (block.name == "Frame") frame_blocks_.try_emplace(id, FrameBlock{block, &pass, draw.light});
  command.buffers.push_back({block.binding, id, BindingKind::uniform_buffer});
}

BufferId FrameBuilder::buffer(const GraphPass& pass, const GraphDraw& draw, const ResolvedBuffer& buffer) {
  if (buffer.source.kind == Source::Kind::baked) return resources_.baked_buffer(buffer.source, *draw.object);
  const auto manifest = std::find_if(pass.variant->buffers.begin(), pass.variant->buffers.end(),
                                     [&](const BufferManifest& known) { return known.name == buffer.source.name; });
  const std::optional<size_t> owner = manifest->scope == Scope::object ? draw.object : std::nullopt;
  BufferId& id = buffers_[{pass.variant, manifest->name, owner, std::nullopt}];
  if (id) return id;
  const std::vector<std::byte> zeros(buffer_bytes(*manifest, scene_, {resources_.width_px(), resources_.height_px()}, owner));
  id = backend_.create_buffer(pass.variant->name + "." + manifest->name, BufferUse::storage, zeros.size(), zeros);
  Frame::Made& made = frame_.made_;
  made.buffers.push_back(id);
  for (uint64_t* bytes : {&made.bytes, &made.memory_bytes, &made.memory_bytes_alone}) *bytes += zeros.size();
  return id;
}

PipelineId FrameBuilder::pipeline(const Place& place, const GraphDraw& draw, const Pass& into, Draw& command) {
  const GraphPass& pass = place.pass();
  PipelineDesc desc;
  desc.name = pass_label(pass, draw, scene_, true);
  std::string key = fmt::format("{}|{}|{}", pass.variant->effect, pass.variant->name, pass.pass - pass.variant->passes.data());
  for (const auto& stage : draw.stages) {
    desc.stages.push_back({stage->stage, stage->spirv});
    key += fmt::format("|{}", static_cast<const void*>(stage.get()));
    for (const ShaderResource& resource : stage->reflection.resources) desc.bindings.push_back(resource.slot());
    if (stage->stage == Stage::vertex) desc.vertex_locations = stage->reflection.input_locations;
  }
  for (const Attachment& color : into.colors) desc.colors.push_back(frame_.made_.targets.at(color.texture).format);
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
    for (size_t read = 0; read < draw.reads.size(); ++read) {
      const CountedTexture& texture = textures[draw.reads[read].binding] = counted_texture(draw, command, read);
      key += "|" + key_of(texture);
    }
    if (!pipelines_.contains(key)) count(place, draw, binding, textures, desc);
  }
  std::sort(desc.bindings.begin(), desc.bindings.end());
  desc.bindings.erase(std::unique(desc.bindings.begin(), desc.bindings.end()), desc.bindings.end());
  if (pipelines_.contains(key)) return pipelines_.at(key);
  const PipelineId id = backend_.create_pipeline(desc);
  frame_.pipelines_.push_back(id);
  pipelines_[key] = id;
  return id;
}

CountedTexture FrameBuilder::counted_texture(const GraphDraw& draw, const Draw& command, size_t read) {
  const auto& [binding, sampler, source] = draw.reads[read];
  const TextureBinding& bound = command.textures[read];
  const Filter filter = source.sampler.filter;
  if (const auto image = resources_.image_of(source, draw.object))
    return lamina::counted_texture(sampler, filter, image->format, {image->width, image->height, image->depth},
                                   static_cast<uint32_t>(image->levels.size()), bound.level);
  const TextureDesc& target = frame_.made_.targets.at(bound.texture);
  return lamina::counted_texture(sampler, filter, target.format, {target.width, target.height, 1}, target.levels, bound.level);
}

void FrameBuilder::count(const Place& place, const GraphDraw& draw, uint32_t binding,
                         const std::map<uint32_t, CountedTexture>& textures, PipelineDesc& desc) {
  Frame::Step& step = place.step;
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

}  // namespace lamina
