// SPDX-License-Identifier: Apache-2.0
// What a glTF material says of a surface: base colour with its opacity, normal map, and the thickness of KHR_materials_volume.
#pragma once

#include <string>
#include <vector>

#include "harness/scene/gltf/gltf_file.h"
#include "harness/scene/model_look.h"

namespace lamina {

// `material` may be -1: glTF's default material, white. Alpha of BLEND and MASK materials is opacity (after MASK's cutoff).
// Normal maps are turned from glTF's green-up to green-down. Throws Error(bad_input) naming the material.
ModelLook read_material(const tinygltf::Model& model, int material, std::vector<std::string>& warnings);

}  // namespace lamina
