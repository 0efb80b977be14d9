// SPDX-License-Identifier: Apache-2.0
// The families of functions that transparent surfaces are made of: shaders/compositing, moment_transmittance and
// step_reconstruction have what their inputs mean.
#pragma once

#include "harness/stress/formula_oracle.h"

namespace lamina {

const Oracle& compositing_oracle();
const Oracle& moment_transmittance_oracle();
const Oracle& step_reconstruction_oracle();

}  // namespace lamina
