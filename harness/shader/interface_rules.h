// SPDX-License-Identifier: Apache-2.0
// What a shader may ask of the backends, checked once on its SPIR-V so that every backend may rely on it.
#pragma once

#include <span>
#include <string>

#include "harness/shader/spirv_module.h"

namespace lamina {

// Throws Error(bad_input) about `file`, naming the resource, unless every resource, reachable or not, is a 2D texture, a 3D
// texture of floats, a 2D storage image, a uniform block or a storage block, not an array, in set 0, at a binding of its own,
// and every specialization constant is a 32-bit scalar or a boolean.
void check_interface(std::span<const uint32_t> spirv, const std::string& file);

}  // namespace lamina
