// SPDX-License-Identifier: Apache-2.0
// The truth of the effect `atmosphere`: the device draws which point each pixel shows and what light it gives, and the air
// before it is integrated offline. Rays are computed from the view, in doubles, so nothing is shared with the shaders.
//
// A variant's passes with when = "truth" write targets of four floats, as large as the frame: seen_point (world; alpha above 0
// where there is a solid thing) and seen_light (what the pixel shows without air).
#pragma once

#include <memory>
#include <optional>

#include "harness/effects/atmosphere/single_scattering.h"
#include "harness/truth/truth.h"

namespace lamina {

std::unique_ptr<Truth> single_scattering_truth(const TruthSetting& setting);

// Unit, towards the first directional light; none without one, and then the air scatters nothing.
std::optional<glm::dvec3> direction_to_sun(const Scene& scene);

}  // namespace lamina
