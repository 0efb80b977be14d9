// SPDX-License-Identifier: Apache-2.0
// What a scene puts on a device and all variants share: meshes, uniform blocks, and the textures that some shader reaches
// (uploaded at their first use, so that what a plan left out is never there).
#pragma once

#include <map>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/bake/bakes.h"
#include "harness/graph/blocks.h"
#include "harness/graph/sources.h"
#include "harness/scene/scene.h"

namespace lamina {

class SceneResources {
 public:
  // All must outlive this. Size of the frame in pixels. Bakes are asked where an effect bakes.
  SceneResources(Backend& backend, const Scene& scene, const Library& library, uint32_t width_px, uint32_t height_px,
                 Bakes* bakes = nullptr);
  ~SceneResources();
  SceneResources(const SceneResources&) = delete;
  SceneResources& operator=(const SceneResources&) = delete;

  // After numbers of the scene changed: writes the uniform blocks again, and, where `vertices` says that they moved, the
  // vertices. Objects, views, textures and numbers of vertices must be the same as before.
  void update(bool vertices);
  // How often that was.
  uint64_t updates() const { return updates_; }

  struct MeshBuffers {
    BufferId vertices, indices;
    uint32_t index_count = 0;
  };
  const MeshBuffers& mesh(size_t object) const { return meshes_[object]; }

  // A uniform block as `block` lays it out; draws that ask alike share a buffer.
  struct BlockUse {
    const EffectManifest& effect;
    const std::string& where;  // of the pass, for messages
    size_t view = 0;
    PassView from = PassView::eye;
    std::optional<size_t> light, object;
    glm::ivec4 iteration{0, 1, 0, 0};
  };
  BufferId block(const ShaderResource& block, const BlockUse& use);

  // The texture of a source that is the scene's: an object's, a baked one, the scene's own or a table; null for others.
  std::shared_ptr<const TextureImage> image_of(const Source& source, std::optional<size_t> object);
  TextureId texture(const std::shared_ptr<const TextureImage>& image);
  BufferId baked_buffer(const Source& source, size_t object);
  size_t textures_uploaded() const { return textures_.size(); }
  uint64_t texture_bytes() const;  // of them, all levels, as their formats say

  Backend& backend() const { return backend_; }
  const Scene& scene() const { return scene_; }
  const Library& library() const { return library_; }
  uint32_t width_px() const { return width_px_; }
  uint32_t height_px() const { return height_px_; }

 private:
  struct Block {
    ShaderResource layout;
    const EffectManifest* effect;
    std::string where;
    size_t view;
    PassView from;
    std::optional<size_t> light, object;
    glm::ivec4 iteration;
    BufferId buffer;
  };
  std::vector<std::byte> bytes_of(const Block& block) const;

  Backend& backend_;
  const Scene& scene_;
  const Library& library_;
  uint32_t width_px_, height_px_;
  Bakes* bakes_;
  uint64_t updates_ = 0;
  std::vector<MeshBuffers> meshes_;
  std::map<std::string, Block> blocks_;
  std::map<std::shared_ptr<const TextureImage>, TextureId> textures_;
  std::map<std::string, std::shared_ptr<const TextureImage>> tables_;  // made at their first use
  std::map<const std::vector<std::byte>*, BufferId> baked_buffers_;
};

}  // namespace lamina
