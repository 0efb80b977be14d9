// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/digest.h"

#include <map>
#include <mutex>

#include "harness/core/bytes.h"
#include "harness/core/text.h"

namespace lamina {
namespace {

void add_numbers(std::string& text, const EffectValues& values) {
  for (const auto& [name, value] : values.numbers) text += fmt::format(" {}={}", name, value);
  for (const auto& [name, word] : values.words) text += fmt::format(" {}={}", name, word);
}

void add_textures(std::string& text, const EffectValues& values) {
  for (const auto& [name, texture] : values.textures) text += fmt::format(" {}={}", name, texture_digest(texture));
}

}  // namespace

std::string texture_digest(const Texture& texture) {
  struct Known {
    std::weak_ptr<const TextureImage> texture;
    std::string digest;
  };
  static std::mutex guard;
  static std::map<const TextureImage*, Known> known;
  const std::lock_guard lock(guard);
  Known& entry = known[texture.get()];
  if (entry.texture.lock() == texture) return entry.digest;
  std::string text =
      fmt::format("{} {} {} {}", static_cast<int>(texture->format), texture->width, texture->height, texture->depth);
  if (texture->wraps) text += fmt::format(" {} {}", name_of(texture->wraps->u), name_of(texture->wraps->v));
  for (const std::vector<std::byte>& level : texture->levels) text += hash_hex(bytes_of(level));
  entry = {texture, hash_hex(text)};
  std::string digest = entry.digest;
  std::erase_if(known, [](const auto& other) { return other.second.texture.expired(); });
  return digest;
}

std::string meshes_digest(const Scene& scene) {
  std::string text;
  for (const Object& object : scene.objects)
    text += hash_hex(bytes_of(object.mesh.vertices)) + hash_hex(bytes_of(object.mesh.indices));
  return hash_hex(text);
}

std::string device_digest(const Scene& scene, const Library& library) {
  std::string text;
  bool rays = false;  // are cast
  for (const Object& object : scene.objects) {
    text += fmt::format("{} {} {}", object.name, object.mesh.vertices.size(), object.mesh.indices.size());
    for (const auto& [name, values] : object.effects) {
      text += "|" + name;
      add_textures(text, values);
      const EffectManifest& effect = library.effect(name);
      rays = rays || !effect.baker.empty() || !effect.truth.empty();
      if (!effect.baker.empty()) add_numbers(text, values);
    }
  }
  for (const auto& [name, values] : scene.effects) text += "|" + name, add_textures(text, values);
  if (!rays) return hash_hex(text);
  text += meshes_digest(scene);  // what rays meet
  for (const Object& object : scene.objects) text += bytes_of(object.world_from_object);
  return hash_hex(text);
}

std::string scene_digest(const Scene& scene) {
  std::string text = scene.name + meshes_digest(scene);
  for (const Object& object : scene.objects) {
    text += object.name;
    text += bytes_of(object.world_from_object);
    for (const auto& [name, values] : object.effects) {
      text += "|" + name;
      add_numbers(text, values);
      add_textures(text, values);
    }
  }
  for (const auto& [name, values] : scene.effects) {
    text += "|" + name;
    add_numbers(text, values);
    add_textures(text, values);
  }
  for (const Light& light : scene.lights) {
    text += light.name;
    text += fmt::format(" {} {} {} {}", static_cast<int>(light.kind), light.angular_radius, light.radius_m, light.casts);
    for (const glm::vec3& v : {light.direction, light.position, light.radiance}) text += bytes_of(v);
  }
  for (const View& view : scene.views) {
    text += view.name;
    for (const glm::vec3& v : {view.eye, view.target, view.up}) text += bytes_of(v);
    text += fmt::format(" {} {} {}", view.fov_y_degrees, view.near_m, view.far_m);
  }
  text += bytes_of(scene.ambient), text += bytes_of(scene.background);
  return hash_hex(text);
}

}  // namespace lamina
