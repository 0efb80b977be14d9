// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/frame_builder.h"

#include <algorithm>
#include <bit>

#include "harness/core/text.h"
#include "harness/graph/spec_constants.h"
#include "harness/graph/uniforms.h"

namespace lamina {
namespace {

// Above what shaders declare, used or not, and below the fewest storage buffer bindings that drivers offer.
constexpr uint32_t first_counter_binding = 16;
constexpr uint32_t counter_header_words = 2;  // shader.h's CountingLayout: width of the coverage map, 0

bool writes_frame(const GraphPass& pass) {
  return std::find(pass.pass->writes.begin(), pass.pass->writes.end(), "frame") != pass.pass->writes.end();
}

bool reads_target(const GraphDraw& draw, const std::string& name) {
  return std::any_of(draw.reads.begin(), draw.reads.end(), [&](const ResolvedRead& read) {
    return (read.source.kind == Source::Kind::target || read.source.kind == Source::Kind::frame) && read.source.name == name;
  });
}

std::string label_of(const GraphPass& pass, const Scene& scene, std::optional<size_t> object) {
  return pass.variant->name + "." + pass.pass->name + (object ? "." + scene.objects[*object].name : "");
}

}  // namespace

FrameBuilder::FrameBuilder(Frame& frame, const Graph& graph, const Parameters& parameters)
    : frame_(frame), backend_(frame.backend_), scene_(frame.resources_.scene()), graph_(graph), parameters_(parameters) {}

void FrameBuilder::build() {
  const uint32_t width = frame_.resources_.width_px(), height = frame_.resources_.height_px();
  bool ping_pong = false;
  for (const GraphPass& pass : graph_.passes)
    for (const GraphDraw& draw : pass.draws) ping_pong = ping_pong || (writes_frame(pass) && reads_target(draw, "frame"));
  targets_[{nullptr, "frame", {}}] = make_target("frame", width, height, Format::rgba16_float, false, ping_pong ? 2 : 1, false);
  targets_[{nullptr, "depth", {}}] = make_target("depth", width, height, Format::d32_float, false, 1, false);
  build_sequence(true, frame_.once_);
  build_sequence(false, frame_.frame_);
  const Target& picture = targets_.at({nullptr, "frame", {}});
  frame_.picture_ = picture.buffers[picture.current];
}

void FrameBuilder::build_sequence(bool once, Frame::Sequence& sequence) {
  for (auto& [key, target] : targets_) target.written = false;
  sequence.passes_by_view.emplace_back();
  for (const GraphPass& pass : graph_.passes)
    if (pass.once == once) build_step(pass, sequence);
  if (once) return;
  // The other views differ by one uniform buffer.
  const BufferId first_view = frame_.resources_.view_uniforms(0);
  for (size_t view = 1; view < scene_.views.size(); ++view) {
    std::vector<Pass> passes = sequence.passes_by_view[0];
    for (Pass& pass : passes)
      for (Draw& draw : pass.draws)
        for (BufferBinding& binding : draw.buffers)
          if (binding.buffer == first_view) binding.buffer = frame_.resources_.view_uniforms(view);
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
    next_word_ += frame_.resources_.width_px() * frame_.resources_.height_px();
  }
  const size_t first_pass = sequence.passes_by_view[0].size();
  const uint32_t count = repetitions(pass);
  for (uint32_t iteration = 0; iteration < count; ++iteration) build_repetition(pass, iteration, count, sequence);
  sequence.step_of_pass.resize(sequence.passes_by_view[0].size(), sequence.steps.size() - 1);
  if (frame_.build_ == Build::counting && !step.counted.empty()) give_counters(step, first_pass, sequence);
}

// The counters' buffer can be made only when every draw of the step has its words: until then its bindings hold no buffer.
void FrameBuilder::give_counters(Frame::Step& step, size_t first_pass, Frame::Sequence& sequence) {
  step.cleared.assign(next_word_, 0);
  step.cleared[0] = frame_.resources_.width_px();
  step.counters = backend_.create_buffer("counters " + step.pass->pass->name, BufferUse::storage, step.cleared.size() * 4);
  frame_.buffers_.push_back(step.counters);
  for (size_t i = first_pass; i < sequence.passes_by_view[0].size(); ++i)
    for (Draw& draw : sequence.passes_by_view[0][i].draws)
      for (BufferBinding& binding : draw.buffers)
        if (!binding.buffer) binding.buffer = step.counters;
}

uint32_t FrameBuilder::repetitions(const GraphPass& pass) {
  if (pass.pass->repeat_log2_of.empty()) return pass.pass->repeat;
  uint32_t longest = 1;
  for (const GraphDraw& draw : pass.draws) {
    const Target& sized = target(pass, pass.pass->repeat_log2_of, draw.object);
    longest = std::max({longest, sized.width, sized.height});
  }
  return static_cast<uint32_t>(std::bit_width(longest - 1));
}

void FrameBuilder::build_repetition(const GraphPass& pass, uint32_t iteration, uint32_t count, Frame::Sequence& sequence) {
  std::vector<Pass>& passes = sequence.passes_by_view[0];
  Frame::Step& step = sequence.steps.back();
  const BufferId uniforms = iteration_uniforms(iteration, count);
  if (pass.pass->draw == DrawKind::objects) {  // all objects in one pass
    Pass into = begin_pass(pass, pass.draws.front());
    for (const GraphDraw& draw : pass.draws) into.draws.push_back(make_draw(pass, draw, into, step, uniforms));
    passes.push_back(std::move(into));
    return;
  }
  for (const GraphDraw& draw : pass.draws) {
    // The ping-pong target turns over after the draw has been told what to read.
    std::vector<Target*> turned;
    for (const std::string& name : pass.pass->writes)
      if (reads_target(draw, name)) turned.push_back(&target(pass, name, draw.object));
    Pass into = begin_pass(pass, draw);
    if (pass.pass->draw != DrawKind::mips) into.draws.push_back(make_draw(pass, draw, into, step, uniforms));
    passes.push_back(std::move(into));
    for (Target* written : turned) written->current = 1 - written->current;
  }
}

Pass FrameBuilder::begin_pass(const GraphPass& pass, const GraphDraw& draw) {
  Pass into;
  into.name = label_of(pass, scene_, pass.pass->draw == DrawKind::objects ? std::nullopt : draw.object);
  if (pass.pass->draw == DrawKind::mips) {
    Target& mipped = target(pass, pass.pass->writes.front(), draw.object);
    into.kind = PassKind::mips;
    into.mips_of = mipped.buffers[mipped.current];
  } else if (pass.pass->draw == DrawKind::compute) {
    into.kind = PassKind::compute;
  } else {
    attach(pass, draw, into);
  }
  return into;
}

void FrameBuilder::attach(const GraphPass& pass, const GraphDraw& draw, Pass& into) {
  for (const std::string& name : pass.pass->writes) {
    Target& written = target(pass, name, draw.object);
    const bool turns = reads_target(draw, name);
    if (turns && !written.buffers[1])
      throw Error(ErrorKind::bad_input, "variants", pass.pass->where,
                  fmt::format("reads and writes '{}', which needs buffers = 2", name));
    Attachment attachment;
    attachment.texture = written.buffers[turns ? 1 - written.current : written.current];
    const bool covers_all = pass.pass->draw == DrawKind::fullscreen && pass.pass->blend == Blend::none;
    attachment.load = covers_all ? Load::discard : written.written && !pass.pass->clear ? Load::keep : Load::clear;
    if (pass.pass->clear)
      attachment.clear = *pass.pass->clear;
    else if (name == "frame")
      attachment.clear = {scene_.background.r, scene_.background.g, scene_.background.b, 0};
    written.written = true;
    into.colors.push_back(attachment);
  }
  if (pass.pass->depth == Depth::none) return;
  Target& depth = targets_.at({nullptr, "depth", {}});
  into.depth = Attachment{depth.buffers[0], 0, depth.written ? Load::keep : Load::clear, {1, 0, 0, 0}};
  depth.written = true;
}

Draw FrameBuilder::make_draw(const GraphPass& pass, const GraphDraw& draw, const Pass& into, Frame::Step& step,
                             BufferId pass_uniforms) {
  Draw command;
  bind(pass, draw, pass_uniforms, command);
  command.pipeline = pipeline(pass, draw, into, step, command);
  if (pass.pass->draw == DrawKind::compute) {
    command.groups = pass.pass->groups;
    if (!pass.pass->threads_over.empty()) {
      const Target& over = target(pass, pass.pass->threads_over, draw.object);
      const auto& local = pass.pass->local_size;
      command.groups = {(over.width + local[0] - 1) / local[0], (over.height + local[1] - 1) / local[1], 1};
    }
  } else if (pass.pass->draw == DrawKind::fullscreen) {
    command.count = 3;
  } else {
    const SceneResources::MeshBuffers& mesh = frame_.resources_.mesh(*draw.object);
    command.vertices = mesh.vertices;
    command.indices = mesh.indices;
    command.count = mesh.index_count;
  }
  return command;
}

void FrameBuilder::bind(const GraphPass& pass, const GraphDraw& draw, BufferId pass_uniforms, Draw& command) {
  for (const ResolvedRead& read : draw.reads)
    command.textures.push_back({read.binding, texture_of(pass, draw, read.source), read.source.sampler});
  std::vector<uint32_t> bound;
  for (const auto& stage : draw.stages)
    for (const ShaderResource& resource : stage->reflection.resources) {
      if (resource.kind == BindingKind::texture || std::find(bound.begin(), bound.end(), resource.binding) != bound.end())
        continue;
      bound.push_back(resource.binding);
      if (resource.kind == BindingKind::storage_image) {
        const Target& image = target(pass, resource.name, draw.object);
        command.images.push_back({resource.binding, image.buffers[image.current], 0});
      } else if (resource.kind == BindingKind::storage_buffer) {
        command.buffers.push_back({resource.binding, storage_buffer(pass, resource.name, draw.object), resource.kind});
      } else if (resource.name == "Frame") {
        command.buffers.push_back({resource.binding, frame_.resources_.view_uniforms(0), resource.kind});
      } else if (resource.name == "Object" && draw.object) {
        command.buffers.push_back({resource.binding, frame_.resources_.mesh(*draw.object).uniforms, resource.kind});
      } else if (resource.name == "Pass") {
        command.buffers.push_back({resource.binding, pass_uniforms, resource.kind});
      } else {
        const std::vector<std::string> blocks = {"Frame", "Object", "Pass"};
        throw Error(ErrorKind::bad_input, "variants", pass.pass->where,
                    resource.name == "Object" ? "block 'Object' is only there where a pass draws objects"
                                              : unknown_name("uniform block", resource.name, blocks));
      }
    }
}

PipelineId FrameBuilder::pipeline(const GraphPass& pass, const GraphDraw& draw, const Pass& into, Frame::Step& step,
                                  Draw& command) {
  PipelineDesc desc;
  desc.name = label_of(pass, scene_, draw.object);
  std::string key = fmt::format("{}|{}", pass.variant->effect, desc.name.substr(0, desc.name.find('.')));
  key += fmt::format("|{}", pass.pass->where);
  for (const auto& stage : draw.stages) {
    desc.stages.push_back({stage->stage, stage->spirv});
    key += fmt::format("|{}", static_cast<const void*>(stage.get()));
    for (const ShaderResource& resource : stage->reflection.resources) desc.bindings.push_back(resource.slot());
    if (stage->stage == Stage::vertex) desc.vertex_locations = stage->reflection.input_locations;
  }
  for (const std::string& name : pass.pass->writes)
    if (!into.colors.empty()) desc.colors.push_back(target(pass, name, draw.object).format);
  if (into.depth) desc.depth_format = Format::d32_float;
  desc.constants = spec_constants(pass, draw, parameters_);
  desc.blend = pass.pass->blend;
  desc.depth = pass.pass->depth;
  desc.cull = pass.pass->cull;
  const bool counting = frame_.build_ == Build::counting;
  if (counting) count(pass, draw, step, desc, command);
  std::sort(desc.bindings.begin(), desc.bindings.end());
  desc.bindings.erase(std::unique(desc.bindings.begin(), desc.bindings.end()), desc.bindings.end());
  // A counting pipeline has its draw's own counters built in, so it is never shared.
  if (!counting && pipelines_.contains(key)) return pipelines_.at(key);
  const PipelineId id = backend_.create_pipeline(desc);
  frame_.pipelines_.push_back(id);
  pipelines_[key] = id;
  return id;
}

void FrameBuilder::count(const GraphPass& pass, const GraphDraw& draw, Frame::Step& step, PipelineDesc& desc, Draw& command) {
  uint32_t binding = first_counter_binding;
  for (const BindingSlot& slot : desc.bindings) binding = std::max(binding, slot.binding + 1);
  for (size_t i = 0; i < draw.stages.size(); ++i) {
    const CompiledShader& shader = *draw.stages[i];
    const uint32_t coverage = shader.stage == Stage::fragment ? step.coverage_word : 0;
    CountingShader counting = add_counters(shader, backend_.info().api, {binding, next_word_, coverage});
    Frame::Counted& counted =
        step.counted.emplace_back(Frame::Counted{shader.stage, next_word_, {}, counting.early_fragment_tests});
    next_word_ += counting.words;
    for (const uint32_t slot : counting.slots)
      for (const ResolvedRead& read : draw.reads)
        if (read.binding == slot)
          counted.slots.push_back({read.sampler, std::string(name_of(format_of(pass, draw, read.source))),
                                   std::string(name_of(read.source.sampler.filter)), 0});
    desc.stages[i].spirv = std::move(counting.spirv);
  }
  desc.bindings.push_back({binding, BindingKind::storage_buffer});
  command.buffers.push_back({binding, {}, BindingKind::storage_buffer});
}

FrameBuilder::Target& FrameBuilder::target(const GraphPass& pass, const std::string& name, Object object) {
  if (name == "frame" || name == "depth") return targets_.at({nullptr, name, {}});
  const TargetManifest* manifest = pass.variant->target(name);
  if (!manifest)
    throw Error(ErrorKind::bad_input, "variants", pass.pass->where, fmt::format("'{}' is not a target of this variant", name));
  const Object owner = manifest->scope == Scope::object ? object : std::nullopt;
  const Key key{pass.variant, name, owner};
  if (const auto found = targets_.find(key); found != targets_.end()) return found->second;
  const auto [width, height] = size_of(manifest->size, owner);
  bool storage = false;
  for (const PassManifest& other : pass.variant->passes)
    storage = storage || (other.draw == DrawKind::compute &&
                          std::find(other.writes.begin(), other.writes.end(), name) != other.writes.end());
  const std::string label = pass.variant->name + "." + name + (owner ? "." + scene_.objects[*owner].name : "");
  Target& made = targets_[key] =
      make_target(label, width, height, manifest->format, manifest->mips, manifest->buffers, storage);
  if (!owner && width == frame_.resources_.width_px() && height == frame_.resources_.height_px())
    frame_.targets_[name] = {made.buffers[0], made.format};
  return made;
}

FrameBuilder::Target FrameBuilder::make_target(const std::string& label, uint32_t width, uint32_t height, Format format,
                                               bool mips, uint32_t buffers, bool storage) {
  Target made;
  made.width = width;
  made.height = height;
  made.levels = mips ? full_mip_levels(width, height) : 1;
  made.format = format;
  for (uint32_t i = 0; i < buffers; ++i) {
    made.buffers[i] = backend_.create_texture({label, width, height, made.levels, format, true, storage});
    frame_.textures_.push_back(made.buffers[i]);
    frame_.whole_[made.buffers[i]] = {0, 0, width, height};
  }
  return made;
}

std::pair<uint32_t, uint32_t> FrameBuilder::size_of(const SizeRule& rule, Object object) const {
  double width = rule.width, height = rule.height;
  if (rule.kind == SizeRule::Kind::frame) width = frame_.resources_.width_px(), height = frame_.resources_.height_px();
  if (rule.kind == SizeRule::Kind::texture) {
    const auto texture = object_texture(scene_.objects[*object], rule.texture);
    if (!texture)
      throw Error(ErrorKind::bad_input, "variants", rule.texture,
                  fmt::format("object '{}' has no texture of this name", scene_.objects[*object].name));
    width = texture->width, height = texture->height;
  }
  const auto scaled = [&](double size) { return static_cast<uint32_t>(std::max(1.0, size * rule.scale + 0.5)); };
  return {scaled(width), scaled(height)};
}

BufferId FrameBuilder::storage_buffer(const GraphPass& pass, const std::string& name, Object object) {
  std::vector<std::string> names;
  if (pass.variant->apertures && object) {
    if (name == "Apertures") return frame_.resources_.vertex_apertures(*object, *pass.variant->apertures);
    names.push_back("Apertures");
  }
  for (const BufferManifest& manifest : pass.variant->buffers) {
    names.push_back(manifest.name);
    if (manifest.name != name) continue;
    const Object owner = manifest.scope == Scope::object ? object : std::nullopt;
    BufferId& id = buffers_[{pass.variant, name, owner}];
    if (!id) {
      const uint64_t pixels = uint64_t{frame_.resources_.width_px()} * frame_.resources_.height_px();
      const uint64_t vertices = owner ? scene_.objects[*owner].mesh.vertices.size() : 0;
      const uint64_t bytes = manifest.bytes + manifest.bytes_per_vertex * vertices + manifest.bytes_per_pixel * pixels;
      const std::vector<std::byte> zeros(bytes);
      id = backend_.create_buffer(pass.variant->name + "." + name, BufferUse::storage, bytes, zeros);
      frame_.buffers_.push_back(id);
    }
    return id;
  }
  throw Error(ErrorKind::bad_input, "variants", pass.pass->where, unknown_name("storage buffer", name, names));
}

BufferId FrameBuilder::iteration_uniforms(uint32_t iteration, uint32_t count) {
  BufferId& id = iterations_[{iteration, count}];
  if (!id) {
    const PassUniforms uniforms{{static_cast<int>(iteration), static_cast<int>(count), 0, 0}};
    id = backend_.create_buffer("pass uniforms", BufferUse::uniform, sizeof uniforms, std::as_bytes(std::span(&uniforms, 1)));
    frame_.buffers_.push_back(id);
  }
  return id;
}

Format FrameBuilder::format_of(const GraphPass& pass, const GraphDraw& draw, const Source& source) {
  if (source.kind == Source::Kind::object_texture) return object_texture(scene_.objects[*draw.object], source.name)->format;
  if (source.kind == Source::Kind::aperture_map) return SceneResources::aperture_map_format;
  if (source.kind == Source::Kind::cap_table) return Format::r16_float;
  return target(pass, source.name, draw.object).format;
}

TextureId FrameBuilder::texture_of(const GraphPass& pass, const GraphDraw& draw, const Source& source) {
  if (source.kind == Source::Kind::object_texture)
    return frame_.resources_.texture(object_texture(scene_.objects[*draw.object], source.name));
  if (source.kind == Source::Kind::aperture_map)
    return frame_.resources_.aperture_map(*draw.object, *pass.variant->apertures, source.aperture);
  if (source.kind == Source::Kind::cap_table) return frame_.resources_.cap_table();
  const Target& read = target(pass, source.name, draw.object);
  return read.buffers[read.current];
}

}  // namespace lamina
