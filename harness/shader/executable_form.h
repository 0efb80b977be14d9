// SPDX-License-Identifier: Apache-2.0
// What a device executes of a shader, in a form that is equal for shaders that differ only in how they are written.
//
// Equal: other names of variables, functions and arguments; other comments, places and include files; functions and
// declarations in another order; functions in place of their bodies; code that has no effect.
// Different: a constant, an operation, an operand or its place; a decoration such as RelaxedPrecision; a binding or a location;
// the name of a resource, of a block's member or of a specialization constant, since the values are found by it.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/backend/backend.h"

namespace lamina {

// Words to be compared or hashed; they are no module. `spirv` is a valid module with its names, as compile_shader() gives it.
// A module that SPIRV-Tools cannot inline gives its own words.
std::vector<uint32_t> executable_form(const std::vector<uint32_t>& spirv, Api api);

}  // namespace lamina
