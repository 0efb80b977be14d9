// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/facts.h"

#include <algorithm>
#include <cmath>

#include "harness/scene/mesh/seen_alpha.h"
#include "harness/scene/textures.h"

namespace lamina {
namespace {

template <class Visit>
void each_texel(const TextureImage& texture, Visit visit) {
  const Texels base = base_texels(texture);
  for (const glm::vec4 texel : base.rgba) visit(texel);
}

double largest(const Texture& texture, bool of_all_channels) {
  float greatest = 0;
  each_texel(*texture, [&](glm::vec4 texel) {
    greatest = std::max(greatest, of_all_channels ? std::max({texel.r, texel.g, texel.b}) : texel.r);
  });
  return double(greatest);
}

double least_alpha(const Texture& texture) {
  float least = 1;
  each_texel(*texture, [&](glm::vec4 texel) { least = std::min(least, texel.a); });
  return double(least);
}

// Flat is a code of 127 or 128: 1/2 is none.
double largest_bend(const Texture& texture) {
  float greatest = 0;
  each_texel(*texture, [&](glm::vec4 texel) {
    greatest = std::max({greatest, std::abs(texel.r - 0.5f), std::abs(texel.g - 0.5f)});
  });
  return greatest > 0.6f / 255 ? 2 * double(greatest) : 0;
}

// Of the mesh too, whose texture loses an alpha that it does not show.
double value_of(const std::string& function, const Mesh& mesh, Texture& texture) {
  if (function == "seen_alpha") return double(settle_seen_alpha(mesh, texture));
  if (function == "largest_bend") return largest_bend(texture);
  if (function == "least_alpha") return least_alpha(texture);
  return largest(texture, function == "largest_channel");
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
    values->second.facts[fact.name] = value_of(fact.function, object.mesh, texture);
  }
}

}  // namespace lamina
