// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/frame.h"

#include <algorithm>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <numeric>

#include "harness/graph/frame_builder.h"
#include "harness/graph/pass_makeup.h"

namespace lamina {

Frame::Frame(SceneResources& resources, const Graph& graph, Build build, TargetSharing sharing, const Frame* like)
    : resources_(resources), backend_(resources.backend()), build_(build) {
  try {
    FrameBuilder(*this, graph).build(sharing, like);
  } catch (...) {
    release();
    throw;
  }
}

Frame::~Frame() { release(); }

void Frame::release() {
  for (const PipelineId id : pipelines_) backend_.destroy(id);
  for (const BufferId id : made_.buffers) backend_.destroy(id);
  for (const TextureId id : made_.textures) backend_.destroy(id);
}

// The passes of a view that run. A pass with until_empty is run in full once for every state of the scene, and its samples are
// counted. From then on the first empty repetition and all after it are left out. Where repetitions take turns in two buffers,
// they are left out in pairs, so that later passes read the buffer that they were built for.
const std::vector<size_t>& Frame::running(Sequence& sequence, size_t view) {
  Sequence::Running& running = sequence.running.at(view);
  const bool known = !running.passes.empty() && (!sequence.stops_early || running.of_update == resources_.updates());
  if (known) return running.passes;
  const std::vector<Pass>& passes = sequence.passes_by_view.at(view);
  running.of_update = resources_.updates();
  running.passes.resize(passes.size());
  std::iota(running.passes.begin(), running.passes.end(), size_t{0});
  if (!sequence.stops_early) return running.passes;
  const RunTimes counted = backend_.run(passes, Timing::off);
  std::vector<uint32_t> kept(sequence.steps.size(), UINT32_MAX);  // repetitions of each step
  std::map<std::pair<size_t, uint32_t>, uint64_t> drawn;
  for (size_t i = 0; i < passes.size(); ++i)
    if (passes[i].count_samples) drawn[{sequence.step_of_pass[i], sequence.repetition_of_pass[i]}] += counted.samples[i];
  running.unfinished.clear();
  for (const auto& [which, samples] : drawn) {
    const auto next = drawn.find({which.first, which.second + 1});
    if (samples > 0 && next == drawn.end()) running.unfinished.push_back(which.first);
  }
  for (const auto& [which, samples] : drawn)
    if (samples == 0 && kept[which.first] == UINT32_MAX)
      kept[which.first] = sequence.steps[which.first].turns ? (which.second + 1) / 2 * 2 : which.second;
  std::erase_if(running.passes, [&](size_t i) { return sequence.repetition_of_pass[i] >= kept[sequence.step_of_pass[i]]; });
  return running.passes;
}

FrameTimes Frame::run_sequence(Sequence& sequence, size_t view, Timing timing) {
  std::vector<size_t> which = running(sequence, view);
  sequence.ran = which, sequence.ran_view = view;
  // What depends on meshes and lights alone is the same in all views: where nothing is timed, it is drawn and counted once.
  const bool is_there = timing == Timing::off && sequence.complete_at == resources_.updates();
  const auto is_left = [&](const Step& step) { return is_there && step.pass->pass->when == Frequency::mesh_or_lights_move; };
  std::erase_if(which, [&](size_t i) { return is_left(sequence.steps[sequence.step_of_pass[i]]); });
  for (const Step& step : sequence.steps)
    if (step.counters && !is_left(step)) backend_.write_buffer(step.counters, std::as_bytes(std::span(step.cleared)));
  const std::vector<Pass>& all = sequence.passes_by_view.at(view);
  std::vector<Pass> fewer;
  if (which.size() < all.size())
    for (const size_t i : which) fewer.push_back(all[i]);
  const RunTimes times = backend_.run(which.size() < all.size() ? fewer : all, timing);
  sequence.complete_at = resources_.updates();
  take_issued(sequence, which, times);
  FrameTimes sums;
  sums.wall_ms = times.wall_ms;
  if (timing == Timing::off) return sums;
  sums.pass_ms.assign(sequence.steps.size(), 0);
  for (size_t i = 0; i < times.pass_ms.size(); ++i) sums.pass_ms[sequence.step_of_pass[which[i]]] += times.pass_ms[i];
  return sums;
}

void Frame::take_issued(Sequence& sequence, const std::vector<size_t>& which, const RunTimes& times) {
  if (times.issued_fragments.empty()) return;
  for (const size_t i : which) sequence.steps[sequence.step_of_pass[i]].issued_fragments = 0;
  for (size_t i = 0; i < which.size(); ++i)
    *sequence.steps[sequence.step_of_pass[which[i]]].issued_fragments += times.issued_fragments[i];
}

std::vector<const GraphPass*> Frame::unfinished(size_t view) const {
  std::vector<const GraphPass*> passes;
  for (const size_t step : frame_.running.at(view).unfinished) passes.push_back(frame_.steps[step].pass);
  return passes;
}

void Frame::set_background(glm::vec3 linear) {
  for (std::vector<Pass>& passes : frame_.passes_by_view)
    for (size_t i = 0; i < passes.size(); ++i)
      for (Attachment& color : passes[i].colors)
        if ((color.texture == frame_buffers_[0] || color.texture == frame_buffers_[1]) &&
            !frame_.steps[frame_.step_of_pass[i]].pass->pass->clear)
          color.clear = {linear.r, linear.g, linear.b, 0};
}

FrameTimes Frame::run_once(Timing timing) { return run_sequence(once_, 0, timing); }

FrameTimes Frame::run(size_t view, Timing timing) {
  if (frame_.steps.empty()) {  // nothing is called for, and what is there is the background
    const glm::vec3& around = resources_.scene().background;
    Pass cleared;
    cleared.name = "nothing to draw";
    cleared.colors.push_back({picture_, 0, Load::clear, {around.r, around.g, around.b, 0}});
    backend_.run({&cleared, 1}, Timing::off);
  }
  return run_sequence(frame_, view, timing);
}

namespace {

// Strips repeat the vertex stage, which must then have no effect but the picture.
bool can_be_cut(const Pass& pass) {
  const auto is_smaller_level = [](const Attachment& color) { return color.level > 0; };
  return pass.kind == PassKind::raster && !pass.colors.empty() &&
         std::none_of(pass.colors.begin(), pass.colors.end(), is_smaller_level) &&
         std::all_of(pass.draws.begin(), pass.draws.end(), [](const Draw& draw) {
           return draw.images.empty() &&
                  std::all_of(draw.buffers.begin(), draw.buffers.end(),
                              [](const BufferBinding& binding) { return binding.kind == BindingKind::uniform_buffer; });
         });
}

}  // namespace

std::vector<Frame::Slice> Frame::slices(size_t view, std::span<const uint32_t> parts) {
  std::vector<Slice> slices;
  const std::vector<Pass>& passes = frame_.passes_by_view.at(view);
  for (const size_t i : running(frame_, view)) {
    const size_t step = frame_.step_of_pass[i];
    if (!can_be_cut(passes[i])) {
      slices.push_back({step, passes[i]});
      continue;
    }
    const TextureDesc& whole = made_.targets.at(passes[i].colors.front().texture);
    const uint32_t count = std::clamp(parts[step], 1u, whole.height);
    for (uint32_t strip = 0; strip < count; ++strip) {
      const auto row = [&](uint32_t edge) { return static_cast<uint32_t>(uint64_t{whole.height} * edge / count); };
      Slice& slice = slices.emplace_back(Slice{step, passes[i]});
      slice.piece.area = Area{0, row(strip), whole.width, row(strip + 1) - row(strip)};
    }
  }
  return slices;
}

Image Frame::picture() {
  return image_from_rgba16(resources_.width_px(), resources_.height_px(), backend_.read_texture(picture_));
}

Image Frame::target(const VariantManifest& variant, const std::string& name) {
  const auto found = made_.frame_sized.find({&variant, name});
  const Format format = found == made_.frame_sized.end() ? Format::r8_unorm : made_.targets.at(found->second).format;
  if (format != Format::rgba16_float && format != Format::rgba32_float)
    throw Error(ErrorKind::failed, "graph", name,
                "is no target of four floats as large as the frame, or another target has its memory by now");
  const std::vector<std::byte> bytes = backend_.read_texture(found->second);
  if (format == Format::rgba16_float) return image_from_rgba16(resources_.width_px(), resources_.height_px(), bytes);
  Image image{static_cast<int>(resources_.width_px()), static_cast<int>(resources_.height_px()), {}};
  image.rgba.resize(bytes.size() / sizeof(float));
  std::memcpy(image.rgba.data(), bytes.data(), bytes.size());
  return image;
}

std::map<std::string, Image> Frame::targets_of(const VariantManifest& variant) {
  std::map<std::string, Image> images;
  for (const auto& [key, texture] : made_.frame_sized) {
    const Format format = made_.targets.at(texture).format;
    if (key.first == &variant && (format == Format::rgba16_float || format == Format::rgba32_float))
      images[key.second] = target(variant, key.second);
  }
  return images;
}

std::vector<PassCounts> Frame::counts(Sequence& sequence) {
  std::vector<PassCounts> all;
  for (const Step& step : sequence.steps) {
    PassCounts& pass = all.emplace_back();
    pass.issued_fragments = step.issued_fragments;
    if (step.counters) add_counted(pass, step);
  }
  const std::vector<Pass>& passes = sequence.passes_by_view.at(sequence.ran_view);
  for (const size_t i : sequence.ran) {
    const size_t step = sequence.step_of_pass[i];
    add_makeup(all[step], passes[i], *sequence.steps[step].pass->pass, made_.targets);
  }
  return all;
}

void Frame::add_counted(PassCounts& pass, const Step& step) {
  const std::vector<std::byte> bytes = backend_.read_buffer(step.counters);
  const auto counter = [&](uint32_t word) {
    uint64_t value = 0;  // low word first, as the host's order is
    std::memcpy(&value, bytes.data() + size_t{word} * 4, 8);
    return value;
  };
  ShaderWork work;  // of all stages
  Operations all_issued, vertex_issued;
  FetchesByTexture fetches(pass.by_texture);
  for (const Counted& counted : step.counted) {
    const uint64_t invocations = counter(counted.first_word);
    (counted.stage == Stage::vertex ? pass.vertices : pass.fragments) += invocations;
    pass.early_tests = pass.early_tests && (counted.stage != Stage::fragment || counted.early_tests);
    std::vector<uint64_t> counts(counted.work.counters());
    for (size_t i = 0; i < counts.size(); ++i) counts[i] = counter(counted.first_word + 2 + static_cast<uint32_t>(2 * i));
    const ShaderWork done = counted.work.executed(invocations, counts), issued = counted.work.issued(invocations, counts);
    for (const auto& [binding, texture] : counted.textures)
      if (done.fetches.contains(binding)) fetches.add(texture, binding, done, issued);
    work.add(done, 1);
    all_issued.add(issued.operations);
    if (counted.stage == Stage::vertex) vertex_issued.add(issued.operations);
  }
  pass.operations = work.operations.by_name();
  pass.issued = all_issued.by_name();
  pass.vertex_issued = vertex_issued.by_name();
  for (const auto& [line, done] : work.lines) {
    const std::filesystem::path file = std::filesystem::path(line.file).lexically_relative(resources_.library().shaders);
    const bool within = !file.empty() && *file.begin() != "..";
    pass.lines[{within ? file.generic_string() : line.file, line.line}].add(done);
  }
}

Mask Frame::coverage(std::string_view effect) {
  Mask mask{static_cast<int>(resources_.width_px()), static_cast<int>(resources_.height_px()), {}};
  mask.on.assign(size_t{resources_.width_px()} * resources_.height_px(), 0);
  for (const Step& step : frame_.steps) {
    if (step.pass->variant->effect != effect || step.coverage_word == 0) continue;
    const std::vector<std::byte> bytes = backend_.read_buffer(step.counters);
    for (size_t i = 0; i < mask.on.size(); ++i) {
      uint32_t times = 0;
      std::memcpy(&times, bytes.data() + (step.coverage_word + i) * 4, 4);
      if (times > 0) mask.on[i] = 1;
    }
  }
  return mask;
}

Image image_from_rgba16(uint32_t width, uint32_t height, std::span<const std::byte> halves) {
  Image image{static_cast<int>(width), static_cast<int>(height), {}};
  image.rgba.resize(size_t{width} * height * 4);
  for (size_t i = 0; i < image.rgba.size(); ++i) {
    uint16_t half = 0;
    std::memcpy(&half, halves.data() + i * 2, 2);
    image.rgba[i] = glm::unpackHalf1x16(half);
  }
  return image;
}

}  // namespace lamina
