// SPDX-License-Identifier: Apache-2.0
// The OpenGL 4.5 backend; see backend.h for what it promises. `context` is "osmesa" or "egl".
#pragma once

#include "harness/backend/backend.h"

namespace lamina {

std::unique_ptr<Backend> open_opengl(std::string_view context, const BackendOptions& options);
std::vector<DeviceInfo> list_opengl_devices(std::string_view context);

}  // namespace lamina
