// SPDX-License-Identifier: Apache-2.0
// What a scene puts on a device and all variants share: meshes, uniforms of objects and views, and the textures that some
// shader reaches (uploaded at their first use, so that what a plan left out is never there).
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/bake/bakes.h"
#include "harness/scene/scene.h"

namespace lamina {

class SceneResources {
 public:
  // All must outlive this. Size of the frame in pixels. Bakes are asked where a scene has objects with apertures.
  SceneResources(Backend& backend, const Scene& scene, uint32_t width_px, uint32_t height_px, Bakes* bakes = nullptr);
  ~SceneResources();
  SceneResources(const SceneResources&) = delete;
  SceneResources& operator=(const SceneResources&) = delete;

  // After numbers of the scene changed: writes the uniforms again, and, where `vertices` says that they moved, the vertices.
  // Objects, views, textures and numbers of vertices must be the same as before.
  void update(bool vertices);

  struct MeshBuffers {
    BufferId vertices, indices, uniforms;
    uint32_t index_count = 0;
  };
  const MeshBuffers& mesh(size_t object) const { return meshes_[object]; }
  BufferId view_uniforms(size_t view) const { return views_[view]; }
  TextureId texture(const std::shared_ptr<const TextureImage>& image);
  // A storage buffer of vec4 apertures, [vertex * count + i].
  BufferId vertex_apertures(size_t object, ApertureKind kind);
  // rgba16_float, over the object's unwrap.
  static constexpr Format aperture_map_format = Format::rgba16_float;
  TextureId aperture_map(size_t object, ApertureKind kind, uint32_t i);
  // harness/caps/cap_table.h's, of three dimensions, r16_float.
  TextureId cap_table();
  size_t textures_uploaded() const { return textures_.size(); }

  Backend& backend() const { return backend_; }
  const Scene& scene() const { return scene_; }
  uint32_t width_px() const { return width_px_; }
  uint32_t height_px() const { return height_px_; }

 private:
  Backend& backend_;
  const Scene& scene_;
  uint32_t width_px_, height_px_;
  Bakes* bakes_;
  std::vector<MeshBuffers> meshes_;
  std::vector<BufferId> views_;
  std::map<std::shared_ptr<const TextureImage>, TextureId> textures_;
  std::shared_ptr<const TextureImage> cap_table_;  // made at its first use
  std::map<std::pair<size_t, ApertureKind>, BufferId> vertex_apertures_;
  std::map<std::tuple<size_t, ApertureKind, uint32_t>, TextureId> aperture_maps_;
};

}  // namespace lamina
