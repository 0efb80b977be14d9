// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/volume_fog/fog_color.h"

#include <algorithm>
#include <cmath>

#include "harness/scene/textures.h"

namespace lamina {

FogColor::FogColor(const Scene& scene) {
  const EffectValues& fog = scene.effects.at("volume_fog");
  density_ = fog_number(scene, "density");
  ramp_length_m_ = fog_number(scene, "ramp_length");
  color_ = glm::dvec3(base_texels(*fog.textures.at("fog_color")).rgba.at(0));
  if (ramp_length_m_ <= 0) return;
  const Texels ramp = base_texels(*fog.textures.at("ramp"));
  for (uint32_t i = 0; i < ramp.width; ++i) ramp_.emplace_back(ramp.rgba[size_t(ramp.height / 2) * ramp.width + i]);
}

glm::dvec3 FogColor::over(glm::dvec3 behind, double thickness_m) const {
  if (!(thickness_m > 0) || !(density_ > 0)) return behind;
  if (ramp_.empty()) return color_ + (behind - color_) * std::exp(-density_ * thickness_m);
  const double at = std::min(thickness_m / ramp_length_m_, 1.0) * static_cast<double>(ramp_.size() - 1);
  const size_t left = std::min(static_cast<size_t>(at), ramp_.size() - 1), right = std::min(left + 1, ramp_.size() - 1);
  const glm::dvec4 texel = ramp_[left] + (ramp_[right] - ramp_[left]) * (at - static_cast<double>(left));
  return glm::dvec3(texel) * texel.a + behind * (1 - texel.a);
}

double fog_number(const Scene& scene, std::string_view name) {
  const auto& numbers = scene.effects.at("volume_fog").numbers;
  const auto found = numbers.find(name);
  return found == numbers.end() ? 0 : found->second;
}

}  // namespace lamina
