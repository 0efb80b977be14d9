// SPDX-License-Identifier: Apache-2.0
// Facts: what features ask of an object's mesh and textures, by the functions that effect.toml names.
//
//   seen_alpha = "TEXTURE"  the greatest alpha of the texture wherever the mesh shows it, 0 to 1
//   largest = "TEXTURE"     the greatest red of any texel of the texture, 0 to 1
//   largest_channel = "TEXTURE"  the greatest red, green or blue of any texel of the texture, 0 to 1
//   least_alpha = "TEXTURE"      the least alpha of any texel of the texture, 0 to 1
//   largest_bend = "TEXTURE"     how far a normal map's normals bend away from flat at most, 0 to 1; 0 within rounding
#pragma once

#include "harness/manifest/effect_manifest.h"
#include "harness/scene/scene.h"

namespace lamina {

// Finds the facts of the effect's objects anew, after meshes or textures have changed.
void settle_facts(Object& object, const EffectManifest& effect);

}  // namespace lamina
