// SPDX-License-Identifier: Apache-2.0
// A head-like form made by code: a face with closed eyes, nose and mouth, two ears and a neck, in one mesh with one chart each.
// Metres, y up; it looks along +z, and is 0.23 m high without its neck.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// What of the head a place is, each from 0 to 1.
struct HeadRegions {
  float lips = 0, nose = 0, cheeks = 0, brows = 0, lids = 0, ears = 0, forehead = 0;
};
// A place of the surface, by texture coordinates; the margins around charts continue them.
struct HeadPlace {
  glm::vec3 position;
  HeadRegions regions;
};
HeadPlace head_place(glm::vec2 uv);

// `detail`: vertices along a parallel of the head, 64 or more; 256 shows lids and lips well.
Mesh head_mesh(uint32_t detail);

}  // namespace lamina
