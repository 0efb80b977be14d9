// SPDX-License-Identifier: Apache-2.0
// The families of functions that light through objects is made of: shaders/wrap_lighting, back_light, thickness_ramp
// and depth_bias have what their inputs mean.
#pragma once

#include "harness/stress/formula_oracle.h"

namespace lamina {

const Oracle& wrap_oracle();
const Oracle& back_light_oracle();
const Oracle& ramp_oracle();
const Oracle& depth_bias_oracle();

}  // namespace lamina
