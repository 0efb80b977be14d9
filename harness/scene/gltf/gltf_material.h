// SPDX-License-Identifier: Apache-2.0
// What a glTF material says of a surface: base colour with its opacity, normal map, and the thickness of KHR_materials_volume.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "harness/scene/gltf/gltf_file.h"
#include "harness/scene/model_look.h"

namespace lamina {

// A material's look and what it asks of the meshes that it is on.
struct GltfMaterial {
  ModelLook look;
  int uv_set = 0;                 // of its base colour, or else of its normal map
  glm::dmat3 texture_from_uv{1};  // KHR_texture_transform of the same
  bool double_sided = false;
  glm::vec4 factor{1};    // of its base colour, with its opacity
  bool masked = false;    // alphaMode MASK
  bool textured = false;  // it has a picture
};

// `material` may be -1: glTF's default material, white. Alpha of BLEND and MASK materials is opacity (after MASK's cutoff).
// Normal maps are turned from glTF's green-up to green-down. Pictures with a sampler of NEAREST are enlarged, each texel
// repeated, so that they look like it under any filter. Borders are held or mirrored as samplers say. Throws Error(bad_input)
// naming the material.
GltfMaterial read_material(const tinygltf::Model& model, int material, std::vector<std::string>& warnings);

}  // namespace lamina
