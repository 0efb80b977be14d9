// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/opengl/opengl_backend.h"

#include <algorithm>
#include <utility>

#include "harness/backend/common/choose_device.h"
#include "harness/backend/opengl/commands.h"
#include "harness/backend/opengl/debug_log.h"
#include "harness/backend/opengl/device.h"

namespace lamina {
namespace {

using namespace gl;

// A context that is known to do, current and with its entry points loaded.
struct Device {
  std::unique_ptr<gl::Context> context;
  DeviceInfo info;
};

const Platform& platform_of(std::string_view backend) { return backend == "osmesa" ? osmesa_platform : egl_platform; }

Device open_device(std::string_view backend, size_t index, bool debug) {
  Device device;
  device.context = platform_of(backend).open(index, debug);
  device.info = load_and_describe(*device.context, backend);
  return device;
}

class OpenGlBackend : public Backend {
 public:
  OpenGlBackend(Device device, bool validation)
      : context_(std::move(device.context)), info_(std::move(device.info)), samples_(info_.issued_fragment_counts) {
    if (validation) debug_log_.listen();
    set_conventions();
    alive = this;
  }
  ~OpenGlBackend() override { alive = nullptr; }

  const DeviceInfo& info() const override { return info_; }

  TextureId create_texture(const TextureDesc& desc, std::span<const std::vector<std::byte>> levels) override {
    return resources_.textures.add(make_texture(desc, levels, info_.max_texture_size));
  }
  BufferId create_buffer(std::string name, BufferUse, size_t size_bytes, std::span<const std::byte> data) override {
    return resources_.buffers.add(make_buffer(std::move(name), size_bytes, data));
  }
  PipelineId create_pipeline(const PipelineDesc& desc) override { return resources_.pipelines.add(make_pipeline(desc)); }

  void destroy(TextureId id) override {
    resources_.framebuffers.forget(id);
    resources_.textures.erase(id);
  }
  void destroy(BufferId id) override { resources_.buffers.erase(id); }
  void destroy(PipelineId id) override { resources_.pipelines.erase(id); }

  void write_buffer(BufferId id, std::span<const std::byte> data) override {
    write(resources_.buffers.at(id, "write_buffer"), data);
  }
  RunTimes run(std::span<const Pass> passes, Timing timing) override {
    return run_passes(resources_, timer_, samples_, passes, timing);
  }
  std::vector<std::byte> read_texture(TextureId id, uint32_t level) override {
    return read(resources_.textures.at(id, "read_texture"), level);
  }
  std::vector<std::byte> read_buffer(BufferId id) override { return read(resources_.buffers.at(id, "read_buffer")); }
  std::vector<std::string> take_messages() override { return debug_log_.take(); }

  // Another context takes this thread for a while; resume() undoes it.
  void suspend() { context_->release(); }
  void resume() {
    context_->make_current();
    gladLoadGL(context_->loader());
  }

  // glad's entry points belong to one context at a time, and so does this backend's thread.
  static inline OpenGlBackend* alive = nullptr;

 private:
  DebugLog debug_log_;  // outlives the context, which reports to it
  std::unique_ptr<gl::Context> context_;
  DeviceInfo info_;
  Resources resources_;
  PassTimer timer_;
  SampleCounts samples_;
};

// The devices of a platform, and the indices of the usable ones among all.
struct PlatformSurvey {
  DeviceSurvey devices;
  std::vector<size_t> indices;
};

PlatformSurvey survey(std::string_view backend) {
  PlatformSurvey found;
  for (size_t i = 0; i < platform_of(backend).device_count(); ++i) {
    try {
      found.devices.usable.push_back(open_device(backend, i, false).info);
      found.indices.push_back(i);
    } catch (const Error& error) {
      found.devices.refused.push_back({error.subject(), error.message()});
    }
  }
  return found;
}

// The index among all devices of the one that choose_device() names.
size_t choose(std::string_view backend, std::string_view wanted) {
  const auto [devices, indices] = survey(backend);
  std::string refusals;
  for (const RefusedDevice& one : devices.refused) refusals += fmt::format("{}: {}; ", one.device, one.reason);
  if (devices.usable.empty())
    throw Error(ErrorKind::no_device, std::string(backend), "OpenGL 4.5 core with GL_ARB_gl_spirv",
                fmt::format("no device offers it: {}{}", refusals.empty() ? "the platform names none; " : refusals,
                            platform_of(backend).remedy));
  return indices[choose_device(backend, devices.usable, wanted)];
}

}  // namespace

std::unique_ptr<Backend> open_opengl(std::string_view backend, const BackendOptions& options) {
  if (OpenGlBackend::alive)
    throw Error(ErrorKind::failed, std::string(backend), "context",
                fmt::format("the {} backend is still open; close it first, as one process drives one OpenGL context at a time",
                            OpenGlBackend::alive->info().backend));
  const size_t device = choose(backend, options.device);
  return std::make_unique<OpenGlBackend>(open_device(backend, device, options.validation), options.validation);
}

DeviceSurvey survey_opengl_devices(std::string_view backend) {
  if (OpenGlBackend::alive) OpenGlBackend::alive->suspend();
  DeviceSurvey found = survey(backend).devices;
  if (OpenGlBackend::alive) OpenGlBackend::alive->resume();
  return found;
}

}  // namespace lamina
