// SPDX-License-Identifier: Apache-2.0
// The truth of skin: the light that enters it, convolved over the surface with the profile, at exactly the points that the
// device drew. Distances are chords, so light also crosses thin parts, such as an ear. Lines through the surface find the
// points that light comes from (King and others, "BSSRDF Importance Sampling", SIGGRAPH 2013 talks): half along the normal, a
// quarter along each tangent.
//
// Passes with when = "truth" write seen_point (world; alpha: the object's place + 1), seen_normal (with the normal map; alpha:
// red of the specular map) and seen_albedo (with melanin; alpha: green of that map). Light diffuses within one object.
// Clement's back scattering, an artist's addition, is not in it.
#pragma once

#include <memory>

#include "harness/truth/truth.h"

namespace lamina {

// setting.rays lines a point.
std::unique_ptr<Truth> skin_truth(const TruthSetting& setting);

}  // namespace lamina
