// SPDX-License-Identifier: Apache-2.0
// The C++ of glossy reflections: variants/glossy_reflection/effect.toml names its truth.
#include "harness/effects/glossy_reflection/facet_rays.h"
#include "harness/manifest/effect_code.h"

namespace lamina {

void add_glossy_reflection(EffectCode& code);

void add_glossy_reflection(EffectCode& code) { code.truths["facet_rays"] = facet_rays; }

}  // namespace lamina
