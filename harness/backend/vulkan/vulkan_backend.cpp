// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/vulkan/vulkan_backend.h"

#include "harness/backend/vulkan/frame.h"
#include "harness/backend/vulkan/instance.h"

namespace lamina {
namespace {

class VulkanBackend final : public Backend {
 public:
  explicit VulkanBackend(const BackendOptions& options)
      : instance_(options.validation),
        device_(instance_, vulkan::choose(vulkan::find_candidates(instance_), options.device)),
        resources_(device_),
        runner_(device_, resources_, pipelines_) {}

  const DeviceInfo& info() const override { return device_.info(); }

  TextureId create_texture(const TextureDesc& desc, std::span<const std::vector<std::byte>> levels) override {
    return resources_.create_texture(desc, levels);
  }
  PlacedTextures create_textures(std::span<const TransientDesc> descs) override { return resources_.create_textures(descs); }
  BufferId create_buffer(std::string name, BufferUse use, size_t size_bytes, std::span<const std::byte> data) override {
    return resources_.create_buffer(std::move(name), use, size_bytes, data);
  }
  PipelineId create_pipeline(const PipelineDesc& desc) override { return pipelines_.add(vulkan::make_pipeline(device_, desc)); }
  void destroy(TextureId id) override { resources_.destroy(id); }
  void destroy(BufferId id) override { resources_.destroy(id); }
  void destroy(PipelineId id) override { pipelines_.erase(id); }

  void write_buffer(BufferId id, std::span<const std::byte> data) override { resources_.write_buffer(id, data); }
  RunTimes run(std::span<const Pass> passes, Timing timing) override { return runner_.run(passes, timing); }
  std::vector<std::byte> read_texture(TextureId id, uint32_t level) override { return resources_.read_texture(id, level); }
  std::vector<std::byte> read_buffer(BufferId id) override { return resources_.read_buffer(id); }
  std::vector<std::string> take_messages() override { return instance_.take_messages(); }

 private:
  // Destroyed from the last to the first.
  vulkan::Instance instance_;
  vulkan::Device device_;
  vulkan::Resources resources_;
  vulkan::Pipelines pipelines_{"pipeline"};
  vulkan::FrameRunner runner_;
};

}  // namespace

std::unique_ptr<Backend> open_vulkan(const BackendOptions& options) { return std::make_unique<VulkanBackend>(options); }

DeviceSurvey survey_vulkan_devices() {
  DeviceSurvey found;
  try {
    const vulkan::Instance instance(/*validation=*/false);
    for (vulkan::Candidate& candidate : vulkan::find_candidates(instance, &found.refused))
      found.usable.push_back(std::move(candidate.info));
  } catch (const Error& error) {
    found.refused.push_back({error.subject(), error.message()});
  }
  return found;
}

}  // namespace lamina
