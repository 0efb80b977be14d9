// SPDX-License-Identifier: Apache-2.0
// Where a scene file's [objects.NAME] puts an object: position (metres), rotation_degrees and scale, on top of its own place.
#pragma once

#include <glm/glm.hpp>

#include "harness/core/toml_table.h"

namespace lamina {

struct Placement {
  glm::vec3 position{0}, rotation_degrees{0}, scale{1};

  // Scaled, turned about x, then y, then z, then moved.
  glm::mat4 applied(const glm::mat4& world_from_object) const;
};

// Throws Error(bad_input) with file and line.
Placement read_placement(const TomlTable& table);

}  // namespace lamina
