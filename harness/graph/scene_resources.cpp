// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/scene_resources.h"

namespace lamina {

SceneResources::SceneResources(Backend& backend, const Scene& scene, const Library& library, uint32_t width_px,
                               uint32_t height_px, Bakes* bakes)
    : backend_(backend), scene_(scene), library_(library), width_px_(width_px), height_px_(height_px), bakes_(bakes) {
  for (const Object& object : scene.objects) {
    MeshBuffers mesh;
    const auto vertices = std::as_bytes(std::span(object.mesh.vertices));
    const auto indices = std::as_bytes(std::span(object.mesh.indices));
    mesh.vertices = backend.create_buffer(object.name + " vertices", BufferUse::vertex, vertices.size(), vertices);
    mesh.indices = backend.create_buffer(object.name + " indices", BufferUse::index, indices.size(), indices);
    mesh.index_count = static_cast<uint32_t>(object.mesh.indices.size());
    meshes_.push_back(mesh);
  }
}

SceneResources::~SceneResources() {
  for (const MeshBuffers& mesh : meshes_)
    for (const BufferId id : {mesh.vertices, mesh.indices}) backend_.destroy(id);
  for (const auto& [key, block] : blocks_) backend_.destroy(block.buffer);
  for (const auto& [image, id] : textures_) backend_.destroy(id);
  for (const auto& [bytes, id] : baked_buffers_) backend_.destroy(id);
}

void SceneResources::update(bool vertices) {
  ++updates_;
  for (size_t i = 0; i < meshes_.size() && vertices; ++i)
    backend_.write_buffer(meshes_[i].vertices, std::as_bytes(std::span(scene_.objects[i].mesh.vertices)));
  for (const auto& [key, block] : blocks_) backend_.write_buffer(block.buffer, bytes_of(block));
}

std::vector<std::byte> SceneResources::bytes_of(const Block& block) const {
  const BlockContext context{scene_,      library_,     *block.effect, block.where, block.view,     block.from,
                             block.light, block.object, width_px_,     height_px_,  block.iteration};
  return fill_block(block.layout, block_values(block.layout, context), block.where);
}

BufferId SceneResources::block(const ShaderResource& block, const BlockUse& use) {
  // What the block's values depend on: see blocks.h.
  std::string key = layout_key(block);
  const auto index = [](std::optional<size_t> i) { return i ? fmt::format(" {}", *i) : std::string(" -"); };
  if (block.name == "Frame")
    key += fmt::format(" {} {}", use.view, static_cast<int>(use.from)) + index(use.light) +
           (use.effect.mirror ? " " + use.effect.name : "");
  else if (block.name == "Pass")
    key += fmt::format(" {} {} {} {}", use.iteration.x, use.iteration.y, use.iteration.z, use.iteration.w);
  else if (block.name == "Object")
    key += index(use.object);
  else
    key += " " + use.effect.name + index(use.object);
  const auto [entry, is_new] = blocks_.try_emplace(key);
  if (!is_new) return entry->second.buffer;
  try {
    Block& made = entry->second;
    made = {block, &use.effect, use.where, use.view, use.from, use.light, use.object, use.iteration, {}};
    made.buffer = backend_.create_buffer(block.name + " block", BufferUse::uniform, block.size_bytes, bytes_of(made));
    return made.buffer;
  } catch (...) {
    blocks_.erase(entry);
    throw;
  }
}

TextureId SceneResources::texture(const std::shared_ptr<const TextureImage>& image) {
  const auto [entry, is_new] = textures_.try_emplace(image);
  if (is_new) {
    try {
      TextureDesc desc;
      desc.name = image->name;
      desc.width = image->width, desc.height = image->height, desc.depth = image->depth;
      desc.levels = static_cast<uint32_t>(image->levels.size());
      desc.format = image->format;
      entry->second = backend_.create_texture(desc, image->levels);
    } catch (...) {
      textures_.erase(entry);
      throw;
    }
  }
  return entry->second;
}

uint64_t SceneResources::texture_bytes() const {
  uint64_t bytes = 0;
  for (const auto& [image, id] : textures_)
    for (const std::vector<std::byte>& level : image->levels) bytes += level.size();
  return bytes;
}

std::shared_ptr<const TextureImage> SceneResources::image_of(const Source& source, std::optional<size_t> object) {
  switch (source.kind) {
    case Source::Kind::object_texture:
      return scene_.objects[*object].effects.at(source.effect->name).textures.at(source.name);
    case Source::Kind::scene_texture:
      return scene_.effects.at(source.effect->name).textures.at(source.name);
    case Source::Kind::baked: {
      const Baked& baked = bakes_->baked(*source.effect, *object, source.variant->bake);
      const auto found = baked.textures.find(source.name);
      if (found == baked.textures.end())
        throw Error(ErrorKind::failed, "bake", fmt::format("object '{}'", scene_.objects[*object].name),
                    fmt::format("{} gives no texture '{}' for it", source.effect->baker, source.name));
      return found->second;
    }
    case Source::Kind::table: {
      auto& table = tables_[source.name];
      if (!table) table = std::make_shared<const TextureImage>(library_.code->tables.at(source.name)());
      return table;
    }
    default:
      return nullptr;
  }
}

BufferId SceneResources::baked_buffer(const Source& source, size_t object) {
  const Baked& baked = bakes_->baked(*source.effect, object, source.variant->bake);
  const auto found = baked.buffers.find(source.name);
  if (found == baked.buffers.end())
    throw Error(ErrorKind::failed, "bake", fmt::format("object '{}'", scene_.objects[object].name),
                fmt::format("{} gives no buffer '{}' for it", source.effect->baker, source.name));
  BufferId& id = baked_buffers_[&found->second];
  if (!id)
    id = backend_.create_buffer(scene_.objects[object].name + " " + source.name, BufferUse::storage, found->second.size(),
                                found->second);
  return id;
}

}  // namespace lamina
