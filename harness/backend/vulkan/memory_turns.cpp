// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/vulkan/memory_turns.h"

#include <algorithm>

namespace lamina::vulkan {
namespace {

using Place = SharedMemory::Place;

bool meet(const Place& a, const Place& b) { return a.begin < b.end && b.begin < a.end; }

bool holds(const Place& place) { return std::ranges::find(place.filled, true) != place.filled.end(); }

}  // namespace

// Null where the texture has memory of its own.
SharedMemory::Place* MemoryTurns::place_of(TextureId id, const Pass& pass) {
  const Texture& texture = resources_.at(id, pass.name);
  if (!texture.shared) return nullptr;
  return &places_.try_emplace(texture.shared, texture.shared->places).first->second[texture.place];
}

void MemoryTurns::need(TextureId id, std::optional<uint32_t> level, const Pass& pass) {
  const Place* place = place_of(id, pass);
  if (!place) return;
  for (uint32_t i = 0; i < place->filled.size(); ++i)
    if ((!level || *level == i) && !place->filled[i])
      throw_bad_input(pass.name, fmt::format("needs level {} of '{}', which holds nothing: no pass has filled it since another "
                                             "texture had its memory",
                                             i, resources_.at(id, pass.name).desc.name));
}

void MemoryTurns::fill(TextureId id, uint32_t level, const Pass& pass) {
  if (Place* place = place_of(id, pass)) place->filled[level] = true;
}

std::vector<TextureId> MemoryTurns::next(const Pass& pass, const std::set<TextureId>& used) {
  // What is there already, before the pass puts anything anywhere.
  for (const Draw& draw : pass.draws)
    for (const TextureBinding& binding : draw.textures) need(binding.texture, binding.level, pass);
  std::vector<Attachment> attachments = pass.colors;
  if (pass.depth) attachments.push_back(*pass.depth);
  for (const Attachment& attachment : attachments)
    if (attachment.load == Load::keep) need(attachment.texture, attachment.level, pass);
  if (pass.kind == PassKind::mips) need(pass.mips_of, 0, pass);
  if (pass.kind == PassKind::copy) need(pass.copy_from, 0, pass);

  std::vector<TextureId> come;
  std::vector<std::pair<const SharedMemory*, const Place*>> here;
  for (const TextureId id : used) {
    Place* place = place_of(id, pass);
    if (!place) continue;
    const Texture& texture = resources_.at(id, pass.name);
    for (const auto& [memory, other] : here)
      if (memory == texture.shared.get() && meet(*place, *other))
        throw_bad_input(pass.name,
                        fmt::format("uses '{}' together with another texture in the same memory", texture.desc.name));
    here.emplace_back(texture.shared.get(), place);
    if (holds(*place)) continue;
    come.push_back(id);
    for (Place& other : places_.at(texture.shared))
      if (&other != place && meet(other, *place)) std::fill(other.filled.begin(), other.filled.end(), false);
  }

  for (const Attachment& attachment : attachments) fill(attachment.texture, attachment.level, pass);
  for (const Draw& draw : pass.draws)
    for (const ImageBinding& binding : draw.images) fill(binding.texture, binding.level, pass);
  if (pass.kind == PassKind::copy) fill(pass.copy_to, 0, pass);
  if (pass.kind == PassKind::mips)
    for (uint32_t level = 1; level < resources_.at(pass.mips_of, pass.name).desc.levels; ++level)
      fill(pass.mips_of, level, pass);
  return come;
}

void MemoryTurns::commit() {
  for (auto& [memory, places] : places_) memory->places = std::move(places);
}

}  // namespace lamina::vulkan
