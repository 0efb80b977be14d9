// SPDX-License-Identifier: Apache-2.0
// The truth of hair: every card along every ray, blended in order by its filtered opacity, over the picture before any hair.
// First with one ray a pixel, then with 64 (or as many as are asked for, where these are fewer).
//
// A variant's passes with when = "truth" write seen_behind.
#pragma once

#include <memory>

#include "harness/truth/truth.h"

namespace lamina {

std::unique_ptr<Truth> hair_truth(const TruthSetting& setting);

}  // namespace lamina
