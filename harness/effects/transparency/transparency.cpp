// SPDX-License-Identifier: Apache-2.0
// The C++ of transparent surfaces: variants/transparency/effect.toml names its truth, families of functions their oracles.
#include "harness/effects/transparency/layer_oracles.h"
#include "harness/effects/transparency/transparent_layers.h"
#include "harness/manifest/effect_code.h"

namespace lamina {

void add_transparency(EffectCode& code);

void add_transparency(EffectCode& code) {
  code.truths["transparent_layers"] = transparent_layers_truth;
  code.oracles["compositing"] = &compositing_oracle();
  code.oracles["moment_transmittance"] = &moment_transmittance_oracle();
  code.oracles["step_reconstruction"] = &step_reconstruction_oracle();
}

}  // namespace lamina
