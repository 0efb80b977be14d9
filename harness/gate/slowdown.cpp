// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/slowdown.h"

namespace lamina {

Library with_extra_fetches(Library library, const VariantManifest& variant, const std::string& pass, uint32_t fetches) {
  for (EffectManifest& effect : library.effects)
    for (VariantManifest& candidate : effect.variants)
      for (PassManifest& each : candidate.passes)
        if (candidate.effect == variant.effect && candidate.name == variant.name && each.name == pass)
          each.defines["LAMINA_EXTRA_FETCHES"] = std::to_string(fetches);
  return library;
}

}  // namespace lamina
