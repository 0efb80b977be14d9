// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/scene_resources.h"

#include <glm/gtc/packing.hpp>

#include "harness/caps/cap_table.h"
#include "harness/graph/uniforms.h"

namespace lamina {

SceneResources::SceneResources(Backend& backend, const Scene& scene, uint32_t width_px, uint32_t height_px, Bakes* bakes)
    : backend_(backend), scene_(scene), width_px_(width_px), height_px_(height_px), bakes_(bakes) {
  for (const Object& object : scene.objects) {
    MeshBuffers mesh;
    const auto vertices = std::as_bytes(std::span(object.mesh.vertices));
    const auto indices = std::as_bytes(std::span(object.mesh.indices));
    const ObjectUniforms uniforms = object_uniforms(object);
    mesh.vertices = backend.create_buffer(object.name + " vertices", BufferUse::vertex, vertices.size(), vertices);
    mesh.indices = backend.create_buffer(object.name + " indices", BufferUse::index, indices.size(), indices);
    mesh.uniforms = backend.create_buffer(object.name + " uniforms", BufferUse::uniform, sizeof uniforms,
                                          std::as_bytes(std::span(&uniforms, 1)));
    mesh.index_count = static_cast<uint32_t>(object.mesh.indices.size());
    meshes_.push_back(mesh);
  }
  for (const View& view : scene.views) {
    const FrameUniforms uniforms = frame_uniforms(scene, view, width_px, height_px);
    views_.push_back(backend.create_buffer("view " + view.name, BufferUse::uniform, sizeof uniforms,
                                           std::as_bytes(std::span(&uniforms, 1))));
  }
}

void SceneResources::update(bool vertices) {
  for (size_t i = 0; i < meshes_.size(); ++i) {
    const ObjectUniforms uniforms = object_uniforms(scene_.objects[i]);
    backend_.write_buffer(meshes_[i].uniforms, std::as_bytes(std::span(&uniforms, 1)));
    if (vertices) backend_.write_buffer(meshes_[i].vertices, std::as_bytes(std::span(scene_.objects[i].mesh.vertices)));
  }
  for (size_t i = 0; i < views_.size(); ++i) {
    const FrameUniforms uniforms = frame_uniforms(scene_, scene_.views[i], width_px_, height_px_);
    backend_.write_buffer(views_[i], std::as_bytes(std::span(&uniforms, 1)));
  }
}

SceneResources::~SceneResources() {
  for (const MeshBuffers& mesh : meshes_)
    for (const BufferId id : {mesh.vertices, mesh.indices, mesh.uniforms}) backend_.destroy(id);
  for (const BufferId id : views_) backend_.destroy(id);
  for (const auto& [image, id] : textures_) backend_.destroy(id);
  for (const auto& [key, id] : vertex_apertures_) backend_.destroy(id);
  for (const auto& [key, id] : aperture_maps_) backend_.destroy(id);
}

TextureId SceneResources::texture(const std::shared_ptr<const TextureImage>& image) {
  const auto [entry, is_new] = textures_.try_emplace(image);
  if (is_new) {
    try {
      const TextureDesc desc{image->name,   image->width, image->height, static_cast<uint32_t>(image->levels.size()),
                             image->format, false,        false,         image->depth};
      entry->second = backend_.create_texture(desc, image->levels);
    } catch (...) {
      textures_.erase(entry);
      throw;
    }
  }
  return entry->second;
}

BufferId SceneResources::vertex_apertures(size_t object, ApertureKind kind) {
  BufferId& id = vertex_apertures_[{object, kind}];
  if (!id) {
    const auto bytes = std::as_bytes(std::span(bakes_->apertures(object, kind)));
    id = backend_.create_buffer(scene_.objects[object].name + " apertures", BufferUse::storage, bytes.size(), bytes);
  }
  return id;
}

TextureId SceneResources::aperture_map(size_t object, ApertureKind kind, uint32_t i) {
  TextureId& id = aperture_maps_[{object, kind, i}];
  if (!id) {
    std::vector<uint64_t> halves;
    for (const Aperture& aperture : bakes_->map(object, kind, i)) halves.push_back(glm::packHalf4x16(aperture));
    const uint32_t side = bakes_->surface(object).map_texels;
    const TextureDesc desc{
        fmt::format("{} aperture {}", scene_.objects[object].name, i), side, side, 1, aperture_map_format, false, false};
    const auto bytes = std::as_bytes(std::span(halves));
    const std::vector<std::byte> level(bytes.begin(), bytes.end());
    id = backend_.create_texture(desc, {&level, 1});
  }
  return id;
}

TextureId SceneResources::cap_table() {
  if (!cap_table_) cap_table_ = std::make_shared<const TextureImage>(make_cap_table());
  return texture(cap_table_);
}

}  // namespace lamina
