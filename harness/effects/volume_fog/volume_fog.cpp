// SPDX-License-Identifier: Apache-2.0
// The C++ of fog in hulls: variants/volume_fog/effect.toml names it.
#include "harness/effects/volume_fog/fog_lengths.h"
#include "harness/effects/volume_fog/hull_shapes.h"

namespace lamina {

void add_volume_fog(EffectCode& code);

void add_volume_fog(EffectCode& code) {
  code.truths["fog_lengths"] = fog_lengths_truth;
  code.bakers["hull_shapes"] = &hull_shape_baker;
}

}  // namespace lamina
