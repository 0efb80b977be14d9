// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/facts.h"

#include <algorithm>

#include "harness/scene/mesh/seen_alpha.h"
#include "harness/scene/textures.h"

namespace lamina {
namespace {

double largest(const Texture& texture, bool of_all_channels) {
  float greatest = 0;
  for (const glm::vec4& texel : base_texels(*texture).rgba)
    greatest = std::max(greatest, of_all_channels ? std::max({texel.r, texel.g, texel.b}) : texel.r);
  return double(greatest);
}

}  // namespace

double fact_or_number(const EffectValues& values, std::string_view name) {
  if (const auto fact = values.facts.find(name); fact != values.facts.end()) return fact->second;
  const auto number = values.numbers.find(name);
  return number == values.numbers.end() ? 0 : number->second;
}

void settle_facts(Object& object, const EffectManifest& effect) {
  const auto values = object.effects.find(effect.name);
  if (values == object.effects.end()) return;
  for (const FactManifest& fact : effect.facts) {
    Texture& texture = values->second.textures.at(fact.texture);
    values->second.facts[fact.name] = fact.function == "seen_alpha" ? double(settle_seen_alpha(object.mesh, texture))
                                                                    : largest(texture, fact.function == "largest_channel");
  }
}

}  // namespace lamina
