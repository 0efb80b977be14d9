// SPDX-License-Identifier: Apache-2.0
// Bakes how thick an object is below each point of its surface, by rays inward: the mean over a cone around the inward normal
// of the length inside, up to where the ray first leaves. It does not depend on lights. What a variant's [bake] may say: rays,
// 1 to 4096 a point (default 64), and cone_degrees, the cone's half angle, 0 to 90 (default 60).
//
// An object whose thickness_texels is 0 has the storage buffer Thickness, a float a vertex, in metres; any other has the map
// `baked_thickness` over its unwrap, thickness_texels on a side.
#pragma once

#include "harness/bake/baker.h"

namespace lamina {

extern const BakerCode thickness_baker;

}  // namespace lamina
