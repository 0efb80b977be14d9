// SPDX-License-Identifier: Apache-2.0
// The truth of light through objects: path lengths by rays through the meshes, holes included; then refraction as it is at
// curved surfaces; then a random walk for all light that is scattered more than once.
//
// A variant's passes with when = "truth" write seen_point (world; alpha above 0 where there is one), seen_normal and
// seen_albedo.
#pragma once

#include <memory>

#include "harness/truth/truth.h"

namespace lamina {

std::unique_ptr<Truth> scattering_truth(const TruthSetting& setting);

}  // namespace lamina
