// SPDX-License-Identifier: Apache-2.0
// The truth of rough glass: rays through microfacets of its front, through the slab and on to what is opaque, in doubles and by
// Embree. First each ray shows what the picture shows where it lands; then what it lands on, hidden or outside the picture too.
// Not in it, as in the variants: light between the faces, other glass behind.
//
// A variant's passes with when = "truth" write seen_behind, the picture before any glass.
#pragma once

#include <memory>

#include "harness/truth/truth.h"

namespace lamina {

std::unique_ptr<Truth> slab_rays(const TruthSetting& setting);

}  // namespace lamina
