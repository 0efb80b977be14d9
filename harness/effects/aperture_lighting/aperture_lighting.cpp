// SPDX-License-Identifier: Apache-2.0
// The C++ of ambient aperture lighting: variants/aperture_lighting/effect.toml names it.
#include "harness/effects/aperture_lighting/aperture_baker.h"
#include "harness/effects/aperture_lighting/direct_light_truth.h"

namespace lamina {

void add_aperture_lighting(EffectCode& code) {
  code.bakers["apertures"] = &aperture_baker;
  code.truths["direct_light"] = direct_light_truth;
}

}  // namespace lamina
