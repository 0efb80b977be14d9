// SPDX-License-Identifier: Apache-2.0
// The truth of water: rays from the eye to the exact waves, on along the reflected ray to what it meets and along the refracted
// one to the bottom, in doubles and by Embree, several a pixel. Where a pixel's ray meets the waves is solved by Newton's
// method from the point that the device drew there. As in the variants, not in it: light that meets the water twice, and
// shadows.
//
// A variant's passes with when = "truth" write seen_ground: x and z of the point that a pixel shows as it lies without waves,
// and alpha 1 where there is water; seen_mirrored: the light found above; seen_bottom: the light of what is found below, before
// the water takes of it; seen_kept: the share that comes up; seen_scattered: what the way adds.
#pragma once

#include <memory>

#include "harness/truth/truth.h"

namespace lamina {

std::unique_ptr<Truth> water_rays(const TruthSetting& setting);

}  // namespace lamina
