// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/opengl/opengl_backend.h"
namespace lamina {
std::unique_ptr<Backend> open_opengl(std::string_view, const BackendOptions&) { throw Error(ErrorKind::no_device, "gl", "", "to do"); }
std::vector<DeviceInfo> list_opengl_devices(std::string_view) { return {}; }
}  // namespace lamina
