// SPDX-License-Identifier: Apache-2.0
// The families of functions that hair is made of: shaders/kajiya_kay, ward_reflection, karis_reflection, ordered_dither and
// gradient_noise have what their inputs mean.
#pragma once

#include "harness/stress/formula_oracle.h"

namespace lamina {

const Oracle& kajiya_kay_oracle();
const Oracle& ward_reflection_oracle();
const Oracle& karis_reflection_oracle();
const Oracle& ordered_dither_oracle();
const Oracle& gradient_noise_oracle();

}  // namespace lamina
