// SPDX-License-Identifier: Apache-2.0
// The C++ of light through objects: variants/translucency/effect.toml names it.
#include "harness/effects/translucency/scattering_truth.h"
#include "harness/manifest/effect_code.h"

namespace lamina {

void add_translucency(EffectCode& code);

void add_translucency(EffectCode& code) { code.truths["translucency"] = scattering_truth; }

}  // namespace lamina
