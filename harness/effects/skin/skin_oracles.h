// SPDX-License-Identifier: Apache-2.0
// Exact values for the families of functions that skin is made of.
#pragma once

#include "harness/stress/oracle.h"

namespace lamina {

const Oracle& beckmann_oracle();            // nh, m
const Oracle& kelemen_reflection_oracle();  // nl, nv, lv, m; reflectance 0.028
const Oracle& blended_normals_oracle();     // vertex, bump, red, rest
const Oracle& shadow_powers_oracle();       // s, px, py, amount
const Oracle& burley_radius_oracle();       // u
const Oracle& gaussian_sum_oracle();        // r in mm

}  // namespace lamina
