// SPDX-License-Identifier: Apache-2.0
// The transfer functions of sRGB.
// Source: IEC 61966-2-1:1999, "Default RGB colour space - sRGB", with its five constants.
#pragma once

#include <cstdint>

namespace lamina {

// For arguments in [0,1].
float srgb_encode(float linear);
float srgb_decode(float encoded);
double srgb_decode(double encoded);
// The nearest of 256 codes: from code k to k + 1 it changes at the decoded (k + 1/2) / 255. Values outside [0,1] are clamped;
// NaN gives 0.
uint8_t srgb_code(float linear);

}  // namespace lamina
