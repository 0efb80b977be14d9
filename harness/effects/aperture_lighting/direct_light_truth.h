// SPDX-License-Identifier: Apache-2.0
// The truth of aperture lighting: the device draws which point each pixel shows, and the light there is computed offline.
//
// A variant's passes with when = "truth" write targets of four floats, as large as the frame: seen_point (world; alpha above 0
// where there is one), seen_normal, seen_albedo, and seen_aperture_0, ..., as many as its [bake] asks for.
#pragma once

#include <memory>

#include "harness/truth/truth.h"

namespace lamina {

std::unique_ptr<Truth> direct_light_truth(const TruthSetting& setting);

}  // namespace lamina
