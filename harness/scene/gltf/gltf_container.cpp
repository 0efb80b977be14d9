// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/gltf/gltf_container.h"

#include <fmt/format.h>

#include <cstdint>

#include "harness/scene/gltf/gltf_json.h"

namespace lamina {
namespace {

constexpr uint32_t json_chunk = 0x4e4f534a, binary_chunk = 0x004e4942;  // "JSON", "BIN\0": section 4.4.3

uint32_t little_endian(std::string_view bytes, size_t offset) {
  uint32_t value = 0;
  for (size_t i = 0; i < 4; ++i) value |= uint32_t(uint8_t(bytes[offset + i])) << (8 * i);
  return value;
}

void append_word(std::string& bytes, size_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xff);
}

}  // namespace

GltfContainer container_of(std::string_view bytes, const std::string& subject) {
  if (!bytes.starts_with("glTF")) return {bytes, {}};
  constexpr size_t header_bytes = 12, chunk_header_bytes = 8;
  if (bytes.size() < header_bytes + chunk_header_bytes)
    refuse_gltf(subject, fmt::format("truncated: {} bytes are too few for a .glb's header", bytes.size()));
  if (const uint32_t version = little_endian(bytes, 4); version != 2)
    refuse_gltf(subject, fmt::format("is glTF version {}; only version 2 is read", version));
  const uint64_t promised = little_endian(bytes, 8);
  if (promised > bytes.size())
    refuse_gltf(subject, fmt::format("truncated: its header promises {} bytes, the file has {}", promised, bytes.size()));
  GltfContainer container;
  size_t offset = header_bytes;
  for (size_t chunk = 0; offset < promised; ++chunk) {
    if (offset + chunk_header_bytes > promised) refuse_gltf(subject, fmt::format("chunk {} is cut short", chunk));
    const uint64_t length = little_endian(bytes, offset);
    const uint32_t type = little_endian(bytes, offset + 4);
    offset += chunk_header_bytes;
    if (offset + length > promised)
      refuse_gltf(subject, fmt::format("chunk {} promises {} bytes, {} are left", chunk, length, promised - offset));
    if (chunk == 0 && type != json_chunk) refuse_gltf(subject, "its first chunk is not JSON");
    if (chunk == 0) container.json = bytes.substr(offset, length);
    if (chunk == 1 && type == binary_chunk) container.binary = bytes.substr(offset, length);
    offset += length;
  }
  return container;
}

std::string as_glb(std::string json, std::string_view binary) {
  const auto whole_words = [](size_t bytes) { return (bytes + 3) / 4 * 4; };
  json.resize(whole_words(json.size()), ' ');
  const size_t binary_bytes = whole_words(binary.size());
  std::string glb = "glTF";
  append_word(glb, 2);
  append_word(glb, 12 + 8 + json.size() + 8 + binary_bytes);
  append_word(glb, json.size()), append_word(glb, json_chunk);
  glb += json;
  append_word(glb, binary_bytes), append_word(glb, binary_chunk);
  glb += binary;
  glb.resize(glb.size() + binary_bytes - binary.size(), '\0');
  return glb;
}

}  // namespace lamina
