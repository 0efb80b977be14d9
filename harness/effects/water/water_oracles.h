// SPDX-License-Identifier: Apache-2.0
// Exact values of the functions that water is made of, in 200 bits: shaders/gerstner, wave_phase, water_in_scatter,
// water_extinction, rgbm8 and refraction_way have what their inputs mean.
#pragma once

#include "harness/stress/formula_oracle.h"

namespace lamina {

Formula gerstner_formula();
Formula wave_phase_formula();
Formula water_in_scatter_formula();
Formula water_extinction_formula();
Formula rgbm8_formula();
Formula refraction_way_formula();

}  // namespace lamina
