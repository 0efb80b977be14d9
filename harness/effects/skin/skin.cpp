// SPDX-License-Identifier: Apache-2.0
// The C++ of skin: variants/skin/effect.toml names its truth, its baker and the makers of its layers' maps;
// the families of functions that it is made of name their oracles and tables.
#include "harness/effects/skin/beckmann_tables.h"
#include "harness/effects/skin/layer_maps.h"
#include "harness/effects/skin/skin_baker.h"
#include "harness/effects/skin/skin_oracles.h"
#include "harness/effects/skin/skin_truth.h"
#include "harness/manifest/effect_code.h"

namespace lamina {

void add_skin(EffectCode& code);

void add_skin(EffectCode& code) {
  code.bakers["skin"] = &skin_baker;
  code.truths["skin"] = skin_truth;
  code.makers["skin_epidermal"] = epidermal_map;
  code.makers["skin_subdermal"] = subdermal_map;
  code.tables["beckmann_unorm8"] = make_beckmann_unorm8;
  code.tables["beckmann_unorm16"] = make_beckmann_unorm16;
  code.tables["beckmann_half"] = make_beckmann_half;
  code.tables["beckmann_centres"] = make_beckmann_centres;
  code.oracles["beckmann"] = &beckmann_oracle();
  code.oracles["kelemen_reflection"] = &kelemen_reflection_oracle();
  code.oracles["blended_normals"] = &blended_normals_oracle();
  code.oracles["shadow_powers"] = &shadow_powers_oracle();
  code.oracles["burley_radius"] = &burley_radius_oracle();
  code.oracles["gaussian_sum"] = &gaussian_sum_oracle();
}

}  // namespace lamina
