// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/made/kept.h"

#include <elf.h>
#include <link.h>

#include <filesystem>

#include "harness/core/disk_cache.h"
#include "harness/core/error.h"

namespace lamina {
namespace {

// The note of the first object that the dynamic linker lists, which is the program: a hash over all that was linked.
int find_build_id(dl_phdr_info* program, size_t, void* into) {
  for (int i = 0; i < program->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = program->dlpi_phdr[i];
    if (segment.p_type != PT_NOTE) continue;
    const char* at = reinterpret_cast<const char*>(program->dlpi_addr + segment.p_vaddr);
    const char* const end = at + segment.p_memsz;
    const auto padded = [](size_t bytes) { return (bytes + 3) & ~size_t{3}; };
    while (at + sizeof(ElfW(Nhdr)) <= end) {
      ElfW(Nhdr) note;
      std::memcpy(&note, at, sizeof note);
      const char *name = at + sizeof note, *id = name + padded(note.n_namesz);
      if (note.n_type == NT_GNU_BUILD_ID && std::string_view(name, note.n_namesz) == std::string_view("GNU", 4))
        static_cast<std::string*>(into)->assign(id, note.n_descsz);
      at = id + padded(note.n_descsz);
    }
  }
  return 1;  // the program alone
}

const std::string& build_id() {
  static const std::string id = [] {
    std::string found;
    ::dl_iterate_phdr(find_build_id, &found);
    return found;
  }();
  return id;
}

// Each part behind its length.
std::string packed(const Parts& parts) {
  std::string bytes;
  for (const std::string& part : parts) bytes += bytes_of(uint64_t{part.size()}), bytes += part;
  return bytes;
}

Parts unpacked(std::string_view bytes) {
  Parts parts;
  while (!bytes.empty()) {
    uint64_t size = 0;
    std::memcpy(&size, bytes.data(), sizeof size);
    parts.emplace_back(bytes.substr(sizeof size, size));
    bytes.remove_prefix(sizeof size + size);
  }
  return parts;
}

}  // namespace

Parts kept(const std::string& name, const std::function<Parts()>& make) {
  std::error_code unknown;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  if (unknown || build_id().empty()) return make();
  DiskCache cache(default_cache_folder());
  // One entry for each program, so that many builds of it do not fill the cache.
  const std::string key = fmt::format("made_{}_{}", name, hash_hex(program.native()));
  if (const std::optional<std::string> found = cache.find(key)) {
    Parts parts = unpacked(*found);
    if (!parts.empty() && parts.back() == build_id()) {
      parts.pop_back();
      return parts;
    }
  }
  Parts made = make();
  made.push_back(build_id());
  cache.keep(key, packed(made));
  made.pop_back();
  return made;
}

std::vector<std::shared_ptr<const TextureImage>> kept_textures(
    const std::string& name, const std::function<std::vector<std::shared_ptr<const TextureImage>>()>& make) {
  struct Head {
    uint32_t format;  // a Format
    uint32_t width, height, depth, levels;
  };
  static_assert(sizeof(Head) == 20);
  const Parts parts = kept(name, [&] {
    Parts made;
    for (const auto& texture : make()) {
      made.push_back(texture->name);
      const Head head{static_cast<uint32_t>(texture->format), texture->width, texture->height, texture->depth,
                      static_cast<uint32_t>(texture->levels.size())};
      made.emplace_back(bytes_of(head));
      for (const std::vector<std::byte>& level : texture->levels) made.emplace_back(bytes_of(level));
    }
    return made;
  });
  std::vector<std::shared_ptr<const TextureImage>> textures;
  for (size_t at = 0; at < parts.size();) {
    auto texture = std::make_shared<TextureImage>();
    texture->name = parts[at++];
    const Head head = values_in<Head>(parts[at++]).front();
    texture->format = static_cast<Format>(head.format);
    texture->width = head.width, texture->height = head.height, texture->depth = head.depth;
    for (uint32_t level = 0; level < head.levels; ++level) texture->levels.push_back(values_in<std::byte>(parts[at++]));
    textures.push_back(std::move(texture));
  }
  return textures;
}

Mesh kept_mesh(const std::string& name, const std::function<Mesh()>& make) {
  const Parts parts = kept(name, [&] {
    const Mesh mesh = make();
    return Parts{std::string(bytes_of(mesh.vertices)), std::string(bytes_of(mesh.indices))};
  });
  return {values_in<Vertex>(parts[0]), values_in<uint32_t>(parts[1])};
}

}  // namespace lamina
