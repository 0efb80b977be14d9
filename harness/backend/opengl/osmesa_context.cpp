// SPDX-License-Identifier: Apache-2.0
// OpenGL in memory through libOSMesa (Mesa before 25.1).
#include "harness/backend/opengl/context.h"

// osmesa.h includes GL/gl.h, which glad has replaced; only its types and entry points are wanted.
#include <GL/osmesa.h>

#include <array>

#include "harness/core/error.h"

namespace lamina::gl {
namespace {

class OsmesaContext : public Context {
 public:
  OsmesaContext() {
    const std::array<int, 9> attributes = {OSMESA_FORMAT,
                                           OSMESA_RGBA,
                                           OSMESA_PROFILE,
                                           OSMESA_CORE_PROFILE,
                                           OSMESA_CONTEXT_MAJOR_VERSION,
                                           4,
                                           OSMESA_CONTEXT_MINOR_VERSION,
                                           5,
                                           0};
    context_ = OSMesaCreateContextAttribs(attributes.data(), nullptr);
    if (!context_)
      throw Error(ErrorKind::no_device, "osmesa", "device 0", "OSMesaCreateContextAttribs makes no OpenGL 4.5 core context");
    try {
      make_current();
    } catch (...) {
      OSMesaDestroyContext(context_);
      throw;
    }
  }
  ~OsmesaContext() override {
    release();
    OSMesaDestroyContext(context_);
  }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  void make_current() override {
    if (!OSMesaMakeCurrent(context_, window_.data(), GL_UNSIGNED_BYTE, 1, 1))
      throw Error(ErrorKind::failed, "osmesa", "device 0", "OSMesaMakeCurrent refuses the context");
  }
  void release() override { OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }
  GLADloadfunc loader() const override { return OSMesaGetProcAddress; }

 private:
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 4> window_ = {};  // one RGBA pixel: OSMesa wants a window, all drawing goes to framebuffer objects
};

}  // namespace

const Platform osmesa_platform = {
    [] { return size_t{1}; },
    // OSMesa has no debug attribute; Mesa's debug output works in every context.
    [](size_t, bool) -> std::unique_ptr<Context> { return std::make_unique<OsmesaContext>(); },
    "install libosmesa6 (Mesa 20 to 25.0), or use the egl backend",
};

}  // namespace lamina::gl
