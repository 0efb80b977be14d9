// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "harness/manifest/library.h"

namespace lamina {

// Maps of a few texels in place of hundreds, for what does not hang on their size.
inline Parameters small_parameters(const Library& library) {
  Parameters small;
  for (const EffectManifest& effect : library.effects)
    for (const VariantManifest& variant : effect.variants)
      for (const ParameterManifest& parameter : variant.parameters)
        if (parameter.whole && parameter.words.empty() && parameter.value >= 64)
          small[variant.name + "." + parameter.name] = std::max(parameter.min, 32.0);
  return small;
}

}  // namespace lamina
