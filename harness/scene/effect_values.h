// SPDX-License-Identifier: Apache-2.0
// What an object, or a scene, has for one effect: a value for everything that the effect declares.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "harness/core/image.h"

namespace lamina {

using Texture = std::shared_ptr<const TextureImage>;

struct EffectValues {
  std::map<std::string, double, std::less<>> numbers;  // by name; one that is not known is not there
  std::map<std::string, std::string, std::less<>> words;
  std::map<std::string, Texture, std::less<>> textures;  // never null
  std::map<std::string, double, std::less<>> facts;
};

// What a fact or number is worth where it is asked whether it is above 0; 0 for one that is not known.
double fact_or_number(const EffectValues& values, std::string_view name);

}  // namespace lamina
