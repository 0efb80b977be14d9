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

void check_blends(const PipelineDesc& desc) {
  if (desc.blend.empty() || desc.blend.size() == desc.colors.size()) return;
  throw Error(
      ErrorKind::bad_input, "backend", desc.name,
      fmt::format("{} blends for {} colour targets; give one for each, or none", desc.blend.size(), desc.colors.size()));
}

void check_levels(const Pass& pass) {
  if (pass.kind != PassKind::raster) return;
  std::vector<std::pair<TextureId, uint32_t>> drawn;
  for (const Attachment& color : pass.colors) drawn.emplace_back(color.texture, color.level);
  if (pass.depth) drawn.emplace_back(pass.depth->texture, pass.depth->level);
  for (const Draw& draw : pass.draws)
    for (const TextureBinding& read : draw.textures)
      if (read.level && std::find(drawn.begin(), drawn.end(), std::pair{read.texture, *read.level}) != drawn.end())
        throw Error(
            ErrorKind::bad_input, "backend", pass.name,
            fmt::format("binding {} reads level {} of a texture, which the pass draws into", read.binding, *read.level));
}

void check_copy(const Pass& pass, const TextureDesc& from, const TextureDesc& to) {
  const auto refuse = [&](std::string why) { throw Error(ErrorKind::bad_input, "backend", pass.name, std::move(why)); };
  if (pass.copy_from == pass.copy_to) refuse(fmt::format("it copies '{}' into itself", from.name));
  if (is_3d(from) || is_3d(to)) refuse(fmt::format("'{}' or '{}' is a 3D texture, which is not copied", from.name, to.name));
  if (from.width != to.width || from.height != to.height || from.format != to.format)
    refuse(fmt::format("'{}' is {}x{} of {}, '{}' is {}x{} of {}; a copy takes two alike", from.name, from.width, from.height,
                       name_of(from.format), to.name, to.width, to.height, name_of(to.format)));
}

void check_area(const Pass& pass, uint32_t width, uint32_t height) {
  if (!pass.area) return;
  const Area& area = *pass.area;
  const auto fits = [](uint32_t at, uint32_t size, uint32_t whole) { return size > 0 && at < whole && size <= whole - at; };
  if (!fits(area.x, area.width, width) || !fits(area.y, area.height, height))
    throw Error(ErrorKind::bad_input, "backend", pass.name,
                fmt::format("the area of {}x{} pixels at {},{} is empty or reaches out of targets of {}x{}", area.width,
                            area.height, area.x, area.y, width, height));
}

std::span<const std::string_view> backend_names() { return names; }

std::unique_ptr<Backend> open_backend(std::string_view name, const BackendOptions& options) {
  check_name(name);
  return name == "vulkan" ? open_vulkan(options) : open_opengl(name, options);
}

std::vector<DeviceInfo> list_devices(std::string_view name) {
  check_name(name);
  return name == "vulkan" ? list_vulkan_devices() : list_opengl_devices(name);
}

}  // namespace lamina
