// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/backend.h"

#include <algorithm>

#include "harness/backend/opengl/opengl_backend.h"
#include "harness/backend/vulkan/vulkan_backend.h"
#include "harness/core/text.h"

namespace lamina {
namespace {

constexpr std::array<std::string_view, 3> names = {"vulkan", "osmesa", "egl"};

void check_name(std::string_view name) {
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  const std::vector<std::string> known(names.begin(), names.end());
  throw Error(ErrorKind::bad_input, "backend", std::string(name), unknown_name("backend", name, known));
}

}  // namespace

std::span<const std::string_view> backend_names() { return names; }

std::unique_ptr<Backend> open_backend(std::string_view name, const BackendOptions& options) {
  check_name(name);
  return name == "vulkan" ? open_vulkan(options) : open_opengl(name, options);
}

DeviceSurvey survey_devices(std::string_view name) {
  check_name(name);
  return name == "vulkan" ? survey_vulkan_devices() : survey_opengl_devices(name);
}

}  // namespace lamina
