// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/scene_resources.h"

#include "harness/graph/uniforms.h"

namespace lamina {

SceneResources::SceneResources(Backend& backend, const Scene& scene, uint32_t width_px, uint32_t height_px)
    : backend_(backend), scene_(scene), width_px_(width_px), height_px_(height_px) {
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

SceneResources::~SceneResources() {
  for (const MeshBuffers& mesh : meshes_)
    for (const BufferId id : {mesh.vertices, mesh.indices, mesh.uniforms}) backend_.destroy(id);
  for (const BufferId id : views_) backend_.destroy(id);
  for (const auto& [image, id] : textures_) backend_.destroy(id);
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

}  // namespace lamina
