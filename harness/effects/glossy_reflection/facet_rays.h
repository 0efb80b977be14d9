// SPDX-License-Identifier: Apache-2.0
// The truth of a glossy plane: rays from the eye, reflected by microfacets, on to what is opaque, in doubles and by Embree.
// First each ray shows what the mirror's picture shows where it lands; then what it lands on, hidden or outside that picture
// too. Not in it, as in the variants: light that is reflected more than once.
//
// A variant's passes with when = "truth" write seen_in_mirror, the mirror's picture turned so that each point of the mirror
// stands at its own pixel.
#pragma once

#include <memory>

#include "harness/truth/truth.h"

namespace lamina {

std::unique_ptr<Truth> facet_rays(const TruthSetting& setting);

}  // namespace lamina
