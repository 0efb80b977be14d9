// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "harness/plan/plan.h"

namespace lamina {

// Of a library, what a scene's plan calls for, and what draws the objects that no other effect draws.
inline Library library_called_for(const Library& library, const Plan& plan) {
  Library own = library;
  std::erase_if(own.effects,
                [&](const EffectManifest& effect) { return !effect.otherwise && !plan.of(effect.name)->called_for; });
  for (EffectManifest& effect : own.effects)
    std::erase_if(effect.instead_of, [&](const std::string& other) { return !plan.of(other)->called_for; });
  return own;
}

}  // namespace lamina
