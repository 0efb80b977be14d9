// SPDX-License-Identifier: Apache-2.0
// A backend that counts what is asked of another one.
#pragma once

#include "harness/backend/backend.h"

namespace lamina {

struct BackendTally {
  size_t pipelines = 0, shaders = 0, shader_words = 0;
  size_t textures = 0, targets = 0, buffers = 0;
  uint64_t texture_bytes = 0, target_bytes = 0, buffer_bytes = 0;  // of textures and buffers those that are put on the device
  size_t runs = 0, passes = 0, draws = 0, bindings = 0;
  bool operator==(const BackendTally&) const = default;
};

class TallyBackend final : public Backend {
 public:
  explicit TallyBackend(Backend& of) : of_(of) {}
  BackendTally tally;

  const DeviceInfo& info() const override { return of_.info(); }
  TextureId create_texture(const TextureDesc& desc, std::span<const std::vector<std::byte>> levels) override {
    ++tally.textures;
    for (const std::vector<std::byte>& level : levels) tally.texture_bytes += level.size();
    return of_.create_texture(desc, levels);
  }
  PlacedTextures create_textures(std::span<const TransientDesc> descs) override {
    PlacedTextures placed = of_.create_textures(descs);
    tally.targets += descs.size(), tally.target_bytes += placed.bytes;
    return placed;
  }
  BufferId create_buffer(std::string name, BufferUse use, size_t size_bytes, std::span<const std::byte> data) override {
    ++tally.buffers, tally.buffer_bytes += size_bytes;
    return of_.create_buffer(std::move(name), use, size_bytes, data);
  }
  PipelineId create_pipeline(const PipelineDesc& desc) override {
    ++tally.pipelines;
    for (const ShaderStage& stage : desc.stages) ++tally.shaders, tally.shader_words += stage.spirv.size();
    return of_.create_pipeline(desc);
  }
  void destroy(TextureId id) override { of_.destroy(id); }
  void destroy(BufferId id) override { of_.destroy(id); }
  void destroy(PipelineId id) override { of_.destroy(id); }
  void write_buffer(BufferId id, std::span<const std::byte> data) override {
    tally.buffer_bytes += data.size();
    of_.write_buffer(id, data);
  }
  RunTimes run(std::span<const Pass> passes, Timing timing) override {
    ++tally.runs, tally.passes += passes.size();
    for (const Pass& pass : passes) {
      tally.draws += pass.draws.size();
      for (const Draw& draw : pass.draws) tally.bindings += draw.textures.size() + draw.buffers.size() + draw.images.size();
    }
    return of_.run(passes, timing);
  }
  std::vector<std::byte> read_texture(TextureId id, uint32_t level) override { return of_.read_texture(id, level); }
  std::vector<std::byte> read_buffer(BufferId id) override { return of_.read_buffer(id); }
  std::vector<std::string> take_messages() override { return of_.take_messages(); }

 private:
  Backend& of_;
};

}  // namespace lamina
