// SPDX-License-Identifier: Apache-2.0
// What a scene puts on a device and all variants share: meshes, uniforms of objects and views, and the textures that some
// shader reaches (uploaded at their first use, so that what a plan left out is never there).
#pragma once

#include <map>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/scene/scene.h"

namespace lamina {

class SceneResources {
 public:
  // Both must outlive this. Size of the frame in pixels.
  SceneResources(Backend& backend, const Scene& scene, uint32_t width_px, uint32_t height_px);
  ~SceneResources();
  SceneResources(const SceneResources&) = delete;
  SceneResources& operator=(const SceneResources&) = delete;

  struct MeshBuffers {
    BufferId vertices, indices, uniforms;
    uint32_t index_count = 0;
  };
  const MeshBuffers& mesh(size_t object) const { return meshes_[object]; }
  BufferId view_uniforms(size_t view) const { return views_[view]; }
  TextureId texture(const std::shared_ptr<const TextureImage>& image);
  size_t textures_uploaded() const { return textures_.size(); }

  Backend& backend() const { return backend_; }
  const Scene& scene() const { return scene_; }
  uint32_t width_px() const { return width_px_; }
  uint32_t height_px() const { return height_px_; }

 private:
  Backend& backend_;
  const Scene& scene_;
  uint32_t width_px_, height_px_;
  std::vector<MeshBuffers> meshes_;
  std::vector<BufferId> views_;
  std::map<std::shared_ptr<const TextureImage>, TextureId> textures_;
};

}  // namespace lamina
