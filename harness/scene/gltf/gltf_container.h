// SPDX-License-Identifier: Apache-2.0
// The container of a glTF 2.0 file (Khronos Group, "glTF 2.0 Specification", 2021, section 4.4): JSON alone, or a .glb, whose
// first chunk is the JSON and whose second may hold its first buffer.
#pragma once

#include <string>
#include <string_view>

namespace lamina {

struct GltfContainer {
  std::string_view json, binary;  // of the file's bytes; `binary` is empty where there is none
};

// Chunks of other types are ignored. Throws Error(bad_input) about `subject` where a length promises more than there is.
GltfContainer container_of(std::string_view bytes, const std::string& subject);

// A .glb of both.
std::string as_glb(std::string json, std::string_view binary);

}  // namespace lamina
