// SPDX-License-Identifier: Apache-2.0
// Bakes apertures: rays are cast once for an object, or read from the disk cache, and every kind of aperture is made of the
// same rays. What a variant's [bake] may say: count, 1 to 4 apertures a point; anti = 1 for one of what is blocked; soft = 1
// for one with an edge that fades; choice = 1 for one of what is open, one of what is blocked, and which to take (apertures.h).
//
// An object whose map_texels is 0 has the storage buffer Apertures, [vertex * count + i], four floats each; any other has the
// maps aperture_0, aperture_1, ... over its unwrap, map_texels on a side.
#pragma once

#include "harness/bake/baker.h"
#include "harness/effects/aperture_lighting/apertures.h"

namespace lamina {

extern const BakerCode aperture_baker;

// Of options that the baker has no problem with.
ApertureKind aperture_kind(const BakeOptions& options);

}  // namespace lamina
