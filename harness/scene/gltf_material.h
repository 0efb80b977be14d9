// SPDX-License-Identifier: Apache-2.0
// A glTF material as a layered one: base colour and normal map become the outer layer, alpha its transparency, and the
// thickness of KHR_materials_volume the distance to an inner layer that is made by code.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/scene/default_layers.h"
#include "harness/scene/gltf_file.h"

namespace lamina {

// What a material says; the texels of its thickness depend on the mesh.
struct MaterialLook {
  LayeredMaterial layers;          // max_transparency not yet settled
  std::optional<float> thickness;  // in the mesh's units, > 0
  std::string name;
};

// `material` may be -1: glTF's default material, white. Alpha of BLEND and MASK materials is opacity, so transparency is 1 -
// alpha (after MASK's cutoff); OPAQUE ones get default_transparency. Normal maps are turned from glTF's green-up to scene.h's
// green-down. Throws Error(bad_input) naming the material.
MaterialLook read_material(const tinygltf::Model& model, int material, std::vector<std::string>& warnings);

}  // namespace lamina
