// SPDX-License-Identifier: Apache-2.0
// A compiled shader with other numbers in it, as a wrong edit leaves it.
#pragma once

#include "harness/shader/shader.h"

namespace lamina {

// Scales every constant vector of two floats: the offsets of a disc of taps. Returns whether there was one.
bool scale_offsets(CompiledShader& shader, float factor);

// Makes the least and the greatest constant between 0 and 1 change places: weights. Returns whether there are two.
bool swap_weights(CompiledShader& shader);

}  // namespace lamina
