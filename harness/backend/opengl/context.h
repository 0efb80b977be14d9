// SPDX-License-Identifier: Apache-2.0
// Where an OpenGL 4.5 core context without a window comes from. Each platform has its own small file (osmesa_context.cpp,
// egl_context.cpp), as Mesa 25.1 and later have no OSMesa: the rest of the backend knows neither.
#pragma once

#include <glad/gl.h>

#include <cstddef>
#include <memory>

namespace lamina::gl {

// A context, current on the thread that opened it. Destroying it releases it first, so that another platform's dispatch finds
// the thread free: OSMesa and Mesa's EGL keep the current context in one thread-local variable of libglapi.
class Context {
 public:
  virtual ~Context() = default;
  virtual void make_current() = 0;  // throws Error(failed)
  virtual void release() = 0;       // leaves no context current
  virtual GLADloadfunc loader() const = 0;
};

// A platform offers devices 0 .. device_count() - 1. open() throws Error(no_device) with the platform's words where a device
// has no OpenGL 4.5 core context. `debug` asks for a debug context where the platform knows the difference.
struct Platform {
  size_t (*device_count)();
  std::unique_ptr<Context> (*open)(size_t device, bool debug);
  const char* remedy;  // what to do where no device can be opened
};

extern const Platform osmesa_platform;  // one device: the rasterizer in libOSMesa
extern const Platform egl_platform;     // the devices of EGL_EXT_device_enumeration, else Mesa's surfaceless platform

}  // namespace lamina::gl
