// SPDX-License-Identifier: Apache-2.0
// The C++ of rough glass: variants/rough_refraction/effect.toml names its truth.
#include "harness/effects/rough_refraction/slab_rays.h"
#include "harness/manifest/effect_code.h"

namespace lamina {

void add_rough_refraction(EffectCode& code);

void add_rough_refraction(EffectCode& code) { code.truths["slab_rays"] = slab_rays; }

}  // namespace lamina
