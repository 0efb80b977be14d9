// SPDX-License-Identifier: Apache-2.0
// The C++ of the atmosphere: variants/atmosphere/effect.toml names it.
#include "harness/effects/atmosphere/single_scattering_truth.h"

namespace lamina {

void add_atmosphere(EffectCode& code);

void add_atmosphere(EffectCode& code) { code.truths["single_scattering"] = single_scattering_truth; }

}  // namespace lamina
