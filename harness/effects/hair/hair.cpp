// SPDX-License-Identifier: Apache-2.0
// The C++ of hair: variants/hair/effect.toml names its baker and its truth; the families of
// functions that it is made of name their oracles.
#include "harness/effects/hair/hair_oracles.h"
#include "harness/effects/hair/hair_truth.h"
#include "harness/effects/hair/strand_baker.h"
#include "harness/manifest/effect_code.h"

namespace lamina {

void add_hair(EffectCode& code);

void add_hair(EffectCode& code) {
  code.bakers["strands"] = &strand_baker;
  code.truths["sorted_cards"] = hair_truth;
  code.oracles["kajiya_kay"] = &kajiya_kay_oracle();
  code.oracles["ward_reflection"] = &ward_reflection_oracle();
  code.oracles["karis_reflection"] = &karis_reflection_oracle();
  code.oracles["ordered_dither"] = &ordered_dither_oracle();
  code.oracles["gradient_noise"] = &gradient_noise_oracle();
}

}  // namespace lamina
