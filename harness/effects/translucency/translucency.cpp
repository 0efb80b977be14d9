// SPDX-License-Identifier: Apache-2.0
// The C++ of light through objects: variants/translucency/effect.toml names its truth and its baker; the families of functions
// that it is made of name their oracles and tables.
#include "harness/effects/translucency/oracles.h"
#include "harness/effects/translucency/ramp_tables.h"
#include "harness/effects/translucency/scattering_truth.h"
#include "harness/effects/translucency/thickness_baker.h"
#include "harness/manifest/effect_code.h"

namespace lamina {

void add_translucency(EffectCode& code);

void add_translucency(EffectCode& code) {
  code.bakers["thickness"] = &thickness_baker;
  code.truths["translucency"] = scattering_truth;
  code.oracles["wrap_lighting"] = &wrap_oracle();
  code.oracles["back_light"] = &back_light_oracle();
  code.oracles["thickness_ramp"] = &ramp_oracle();
  code.oracles["depth_bias"] = &depth_bias_oracle();
  code.tables["ramp_table_unorm8"] = make_ramp_table_unorm8;
  code.tables["ramp_table_srgb8"] = make_ramp_table_srgb8;
  code.tables["ramp_table_half"] = make_ramp_table_half;
  code.tables["ramp_table_squared"] = make_ramp_table_squared;
}

}  // namespace lamina
