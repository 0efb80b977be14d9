// SPDX-License-Identifier: Apache-2.0
#include "harness/measure/timer_work.h"

#include <algorithm>

#include "harness/shader/shader.h"

namespace lamina {
namespace {

constexpr uint32_t source_px = 256;
// 64 tiles of 64x64. Threads of a software rasterizer share the tiles of a pass. Where another program holds a core, the thread
// there is late by up to a tile, and all of a pass's others wait for it: of 16 tiles one is a quarter of what two threads need.
constexpr uint32_t target_px = 512;
constexpr int first_taps = 4, max_taps = 1 << 20;

class TapPasses : public TimedWork {
 public:
  TapPasses(Backend& backend, const std::filesystem::path& shaders) : backend_(backend) {
    const Api api = backend.info().api;
    const CompiledShader vertex = compile_shader({shaders / "common/fullscreen.vert", Stage::vertex, api, {}, {shaders}});
    const CompiledShader fragment = compile_shader({shaders / "measure/work.frag", Stage::fragment, api, {}, {shaders}});
    std::vector<std::byte> texels(source_px * source_px * 4);
    std::mt19937 random(1);  // any texture without structure
    for (std::byte& texel : texels) texel = static_cast<std::byte>(random() & 255);
    source_ = backend.create_texture({"timer source", source_px, source_px, 1, Format::rgba8_unorm, false, false}, {{texels}});
    for (TextureId& target : targets_)
      target = backend.create_texture({"timer target", target_px, target_px, 1, Format::rgba8_unorm, true, false});
    for (BufferId& taps : taps_) taps = backend.create_buffer("timer taps", BufferUse::uniform, 4 * sizeof(int));
    pipeline_ = backend.create_pipeline({.name = "timer work",
                                         .stages = {{Stage::vertex, vertex.spirv}, {Stage::fragment, fragment.spirv}},
                                         .bindings = {{3, BindingKind::uniform_buffer}, {4, BindingKind::texture}},
                                         .colors = {Format::rgba8_unorm}});
  }
  ~TapPasses() override {
    backend_.destroy(pipeline_);
    for (const BufferId taps : taps_) backend_.destroy(taps);
    for (const TextureId target : targets_) backend_.destroy(target);
    backend_.destroy(source_);
  }
  TapPasses(const TapPasses&) = delete;
  TapPasses& operator=(const TapPasses&) = delete;

  // Doubles the work until it can be measured. The first run of each compiles and is not looked at.
  void set_duration(double one_ms) override {
    constexpr std::array<size_t, 1> one = {1};
    for (int taps = first_taps;; taps *= 2) {
      set_taps(taps);
      run(one);
      const double ms = std::min(run(one).pass_ms[0], run(one).pass_ms[0]);
      if (ms < one_ms / 4 && taps < max_taps) continue;
      if (ms > 0) set_taps(static_cast<int>(std::clamp(taps * one_ms / ms, 1.0, static_cast<double>(max_taps))));
      break;
    }
    constexpr std::array<size_t, timer_multiples.size()> each = {0, 1, 2, 3, 4};
    run(each);
  }

  RunTimes run(std::span<const size_t> kinds_in_order) override {
    std::vector<Pass> passes;
    for (const size_t kind : kinds_in_order) {
      Pass pass;
      pass.name = "timer work";
      pass.colors = {{targets_[kind], 0, Load::discard, {}}};
      Draw draw;
      draw.pipeline = pipeline_;
      draw.buffers = {{3, taps_[kind], BindingKind::uniform_buffer}};
      draw.textures = {{4, source_, {Filter::linear, Wrap::repeat}}};
      draw.count = 3;
      pass.draws = {draw};
      passes.push_back(std::move(pass));
    }
    return backend_.run(passes, Timing::bracketed);
  }

 private:
  void set_taps(int of_one) {
    for (size_t kind = 0; kind < timer_multiples.size(); ++kind) {
      const std::array<int, 4> block = {of_one * timer_multiples[kind], 0, 0, 0};
      backend_.write_buffer(taps_[kind], std::as_bytes(std::span(block)));
    }
  }

  Backend& backend_;
  TextureId source_;
  PipelineId pipeline_;
  std::array<TextureId, timer_multiples.size()> targets_;
  std::array<BufferId, timer_multiples.size()> taps_;
};

}  // namespace

std::unique_ptr<TimedWork> timer_work(Backend& backend, const std::filesystem::path& shaders) {
  return std::make_unique<TapPasses>(backend, shaders);
}

}  // namespace lamina
