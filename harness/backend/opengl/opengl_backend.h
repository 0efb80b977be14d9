// SPDX-License-Identifier: Apache-2.0
// The OpenGL 4.5 backend; see backend.h for what it promises. `context` is "osmesa" or "egl". It needs GL_ARB_gl_spirv.
//
// One is alive at a time in a process, on the thread that opened it: its entry points and the thread's current context are
// global. Limits: a level of a texture is read back only up to 2 GiB; arrays of textures or images in a shader are not bound.
#pragma once

#include "harness/backend/backend.h"

namespace lamina {

// Throws Error(failed) while another OpenGL backend is alive, Error(no_device) with each device's reason where none will do.
std::unique_ptr<Backend> open_opengl(std::string_view context, const BackendOptions& options);
// Opens each device for a moment, also beside a backend that is alive. Throws Error(failed) only where such a backend cannot
// have its context back.
DeviceSurvey survey_opengl_devices(std::string_view context);

}  // namespace lamina
