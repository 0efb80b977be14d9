// SPDX-License-Identifier: Apache-2.0
// What the current context is, and whether it will do.
#pragma once

#include <string>
#include <string_view>

#include "harness/backend/backend.h"
#include "harness/backend/opengl/context.h"

namespace lamina::gl {

// Loads the entry points of the current context and describes its device. `backend` is "osmesa" or "egl".
// Throws Error(no_device) naming what it lacks of OpenGL 4.5 core and GL_ARB_gl_spirv.
DeviceInfo load_and_describe(const Context& context, std::string_view backend);

}  // namespace lamina::gl
