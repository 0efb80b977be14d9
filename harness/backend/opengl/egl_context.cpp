// SPDX-License-Identifier: Apache-2.0
// OpenGL without a window through EGL 1.5. Devices come from EGL_EXT_device_enumeration and EGL_EXT_platform_device, the only
// way that every vendor has (NVIDIA has no other); where EGL enumerates none, from EGL_MESA_platform_surfaceless.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "harness/backend/opengl/context.h"
#include "harness/core/error.h"

namespace lamina::gl {
namespace {

// EGL 1.5, section 3.1: the error codes are consecutive from EGL_SUCCESS.
std::string egl_error() {
  static constexpr std::array<std::string_view, 15> names = {
      "EGL_SUCCESS",           "EGL_NOT_INITIALIZED",   "EGL_BAD_ACCESS",          "EGL_BAD_ALLOC",   "EGL_BAD_ATTRIBUTE",
      "EGL_BAD_CONFIG",        "EGL_BAD_CONTEXT",       "EGL_BAD_CURRENT_SURFACE", "EGL_BAD_DISPLAY", "EGL_BAD_MATCH",
      "EGL_BAD_NATIVE_PIXMAP", "EGL_BAD_NATIVE_WINDOW", "EGL_BAD_PARAMETER",       "EGL_BAD_SURFACE", "EGL_CONTEXT_LOST"};
  const auto index = static_cast<size_t>(eglGetError() - EGL_SUCCESS);
  return index < names.size() ? std::string(names[index]) : fmt::format("EGL error 0x{:04x}", index + EGL_SUCCESS);
}

// Whether a list of names separated by spaces holds `name`.
bool has_extension(const char* list, std::string_view name) {
  const std::string padded = fmt::format(" {} ", list ? list : "");
  return padded.find(fmt::format(" {} ", name)) != std::string::npos;
}

struct Target {  // what a display is made from
  EGLenum platform;
  void* native;
};

std::vector<Target> targets() {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  std::vector<Target> found;
  if ((has_extension(extensions, "EGL_EXT_device_enumeration") || has_extension(extensions, "EGL_EXT_device_base")) &&
      has_extension(extensions, "EGL_EXT_platform_device")) {
    const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLint count = 0;
    if (query && query(0, nullptr, &count) && count > 0) {
      std::vector<EGLDeviceEXT> devices(static_cast<size_t>(count));
      if (query(count, devices.data(), &count))
        for (EGLint i = 0; i < count; ++i) found.push_back({EGL_PLATFORM_DEVICE_EXT, devices[static_cast<size_t>(i)]});
    }
  }
  if (found.empty() && has_extension(extensions, "EGL_MESA_platform_surfaceless"))
    found.push_back({EGL_PLATFORM_SURFACELESS_MESA, nullptr});
  return found;
}

class EglContext : public Context {
 public:
  EglContext(const Target& target, std::string subject, bool debug) : subject_(std::move(subject)) {
    display_ = eglGetPlatformDisplay(target.platform, target.native, nullptr);
    if (display_ == EGL_NO_DISPLAY) refuse("eglGetPlatformDisplay");
    if (!eglInitialize(display_, nullptr, nullptr)) refuse("eglInitialize");
    if (!has_extension(eglQueryString(display_, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
      throw Error(ErrorKind::no_device, "egl", subject_, "the driver lacks EGL_KHR_surfaceless_context");
    if (!eglBindAPI(EGL_OPENGL_API)) refuse("eglBindAPI(EGL_OPENGL_API)");

    // No surface is ever made, so any configuration that renders desktop OpenGL will do.
    const std::array<EGLint, 5> wanted = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display_, wanted.data(), &config, 1, &count) || count == 0) refuse("eglChooseConfig");

    const std::array<EGLint, 9> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                              4,
                                              EGL_CONTEXT_MINOR_VERSION,
                                              5,
                                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                              EGL_CONTEXT_OPENGL_DEBUG,
                                              debug ? EGL_TRUE : EGL_FALSE,
                                              EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, attributes.data());
    if (context_ == EGL_NO_CONTEXT) refuse("no OpenGL 4.5 core context: eglCreateContext");
    try {
      make_current();
    } catch (...) {
      eglDestroyContext(display_, context_);
      throw;
    }
  }
  // The display stays initialized: it belongs to the process (others may have opened the same one), and terminating it unloads
  // the driver, which then finds its thread-local state gone when it is loaded again.
  ~EglContext() override {
    release();
    eglDestroyContext(display_, context_);
    eglReleaseThread();
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void make_current() override {
    if (!eglBindAPI(EGL_OPENGL_API) || !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
      throw Error(ErrorKind::failed, "egl", subject_, fmt::format("eglMakeCurrent: {}", egl_error()));
  }
  void release() override {
    eglBindAPI(EGL_OPENGL_API);
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  GLADloadfunc loader() const override { return eglGetProcAddress; }

 private:
  [[noreturn]] void refuse(std::string_view what) {
    throw Error(ErrorKind::no_device, "egl", subject_, fmt::format("{}: {}", what, egl_error()));
  }

  std::string subject_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

const Platform egl_platform = {
    [] { return targets().size(); },
    [](size_t device, bool debug) -> std::unique_ptr<Context> {
      return std::make_unique<EglContext>(targets().at(device), fmt::format("device {}", device), debug);
    },
    "install libegl1 and libgl1-mesa-dri, or the OpenGL driver of the GPU's vendor",
};

}  // namespace lamina::gl
