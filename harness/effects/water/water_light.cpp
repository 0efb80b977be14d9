// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/water/water_light.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <numbers>

#include "harness/effects/water/caustic_table.h"
#include "harness/scene/textures.h"

namespace lamina {
namespace {

// Of the sky's light in water: its mean way down is depth / 0.83; 0.9336 of it passes into the water.
constexpr double sky_cosine = 0.83, sky_passes = 0.9336;

double smooth(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// Metres of a way that count, where light is lost at c along it and at c / sun_cosine of each metre further down.
double counted_m(double c, double way_m, double down, double sun_cosine) {
  const double k = c * (1 + down / sun_cosine);
  return k * way_m < 1e-12 ? way_m : -std::expm1(-k * way_m) / k;
}

double henyey_greenstein(double g, double cosine) {
  return (1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * cosine, 1.5));
}

}  // namespace

double reflected_by_water(double cosine, double index) {
  const double sine = std::sqrt(std::max(1 - cosine * cosine, 0.0)) / index, inside = std::sqrt(1 - sine * sine);
  const double across = (cosine - index * inside) / (cosine + index * inside),
               along = (index * cosine - inside) / (index * cosine + inside);
  return (across * across + along * along) / 2;
}

TiledTable::TiledTable(const TextureImage& table)
    : side_(table.width),
      channels_(table.format == Format::rg16_float ? 2 : 1),
      texels_(size_t(table.width) * table.height * channels_) {
  for (size_t i = 0; i < texels_.size(); ++i) {
    uint16_t half = 0;
    std::memcpy(&half, &table.levels.front()[2 * i], 2);
    texels_[i] = glm::unpackHalf1x16(half);
  }
}

double TiledTable::at(glm::dvec2 uv, uint32_t channel) const {
  const double side = side_;
  const glm::dvec2 texel = (uv - glm::floor(uv)) * side - 0.5, low = glm::floor(texel), share = texel - low;
  const auto fetch = [&](double x, double y) {
    const auto wrapped = [&](double i) { return static_cast<size_t>(i < 0 ? i + side : i >= side ? i - side : i); };
    return double(texels_[(wrapped(y) * side_ + wrapped(x)) * channels_ + channel]);
  };
  return (1 - share.y) * ((1 - share.x) * fetch(low.x, low.y) + share.x * fetch(low.x + 1, low.y)) +
         share.y * ((1 - share.x) * fetch(low.x, low.y + 1) + share.x * fetch(low.x + 1, low.y + 1));
}

WaterLight::WaterLight(const Scene& scene)
    : scene_(scene),
      values_(scene.effects.at("water")),
      caustics_(make_caustic_table()),
      foam_(make_foam_table()),
      ripples_(make_ripple_table()) {
  const auto channels = [&](const char* red, const char* green, const char* blue) {
    return glm::dvec3(number(red), number(green), number(blue));
  };
  scattered_ = number("scattering") * channels("scattering_red", "scattering_green", "scattering_blue");
  extinction_ = channels("absorption_red", "absorption_green", "absorption_blue") + scattered_;
  const Texels sky = base_texels(*values_.textures.at("sky"));
  for (uint32_t x = 0; x < sky.width; ++x) sky_.push_back(glm::dvec3(sky.rgba[x]));
  if (scene.lights.empty() || scene.lights[0].kind != Light::Kind::directional || scene.lights[0].direction.y >= 0) return;
  const double index = number("refraction_index");
  sunlit_ = true;
  to_sun_ = -glm::dvec3(scene.lights[0].direction);
  sunlight_ = glm::dvec3(scene.lights[0].radiance);
  sun_in_water_ = {to_sun_.x / index, 0, to_sun_.z / index};
  sun_in_water_.y = std::sqrt(1 - glm::dot(sun_in_water_, sun_in_water_));
  sunlight_in_water_ = sunlight_ * ((1 - reflected_by_water(to_sun_.y, index)) * to_sun_.y / sun_in_water_.y);
}

double WaterLight::number(const char* name) const { return values_.numbers.find(name)->second; }
double WaterLight::depth_of(glm::dvec3 position) const { return std::max(number("height") - position.y, 0.0); }

glm::dvec3 WaterLight::sky(glm::dvec3 direction) const {
  const double factor = number("sky_light");
  if (!(factor > 0)) return glm::dvec3(scene_.background);
  const double last = static_cast<double>(sky_.size()) - 1;
  const double at = std::clamp(std::sqrt(std::clamp(direction.y, 0.0, 1.0)) * (last + 1) - 0.5, 0.0, last);
  const auto low = static_cast<size_t>(at), high = std::min(low + 1, sky_.size() - 1);
  return factor * glm::mix(sky_[low], sky_[high], at - static_cast<double>(low));
}

glm::dvec3 WaterLight::in_scatter(glm::dvec3 into, double way_m) const {
  const double down = std::max(-into.y, 0.0), phase = henyey_greenstein(number("scattering_g"), glm::dot(into, -sun_in_water_));
  glm::dvec3 sum(0);
  for (int c = 0; c < 3; ++c)
    sum[c] = scattered_[c] *
             (std::numbers::pi * phase * sunlight_in_water_[c] * counted_m(extinction_[c], way_m, down, sun_in_water_.y) +
              0.5 * sky_passes * double(scene_.ambient[c]) * counted_m(extinction_[c], way_m, down, sky_cosine));
  return sum;
}

double WaterLight::caustic(glm::dvec3 position) const {
  const double contrast = number("caustics"), time = double(scene_.time_s), depth = depth_of(position);
  if (!(contrast > 0)) return 1;
  const glm::dvec2 entry =
      (glm::dvec2(position.x, position.z) + glm::dvec2(sun_in_water_.x, sun_in_water_.z) / sun_in_water_.y * depth) /
      number("caustic_size");
  const double pattern = std::min(caustics_.at(entry + glm::dvec2(0.031, 0.017) * time),
                                  caustics_.at(glm::dvec2(-entry.y, entry.x) * 0.83 + glm::dvec2(-0.023, 0.029) * time));
  return std::max(1 + (pattern / caustic_lesser_mean - 1) * contrast * smooth(0, 0.3, depth), 0.0);
}

glm::dvec3 WaterLight::with_ripples(glm::dvec3 normal, glm::dvec2 ground) const {
  const double rms = number("ripples"), time = double(scene_.time_s);
  if (!(rms > 0)) return normal;
  const glm::dvec2 at = ground / number("ripple_size"), first = at + glm::dvec2(0.05, 0.021) * time,
                   second = 1.31 * glm::dvec2(-at.y, at.x) + glm::dvec2(-0.037, 0.043) * time;
  const glm::dvec2 ripple(ripples_.at(first, 0) + ripples_.at(second, 1), ripples_.at(first, 1) - ripples_.at(second, 0));
  const glm::dvec2 slopes = -glm::dvec2(normal.x, normal.z) / std::max(normal.y, 0.05) + rms / std::sqrt(2.0) * ripple;
  return glm::normalize(glm::dvec3(-slopes.x, 1, -slopes.y));
}

glm::dvec3 WaterLight::glitter(glm::dvec3 along) const {
  const double strength = number("specular");
  if (!sunlit_ || !(strength > 0)) return glm::dvec3(0);
  const double off = std::acos(std::clamp(glm::dot(along, to_sun_), -1.0, 1.0)), size = double(scene_.lights[0].angular_radius),
               width = number("specular_width") * std::numbers::pi / 180, variance = width * width + size * size / 4;
  double sum = 0;
  for (const double wider : {1.0, 4.0, 16.0}) sum += std::exp(-off * off / (2 * wider * variance)) / (2 * wider * variance) / 3;
  return strength * sunlight_ * sum;
}

double WaterLight::foam(glm::dvec3 position, glm::dvec3 straight, double way_m) const {
  const double most = number("foam"), crest_m = number("foam_height"), shore_m = number("foam_depth");
  if (!(most > 0)) return 0;
  double thick = crest_m > 0 ? smooth(crest_m, 2 * crest_m, position.y - number("height")) : 0;
  if (shore_m > 0)
    thick = std::max({thick, 1 - smooth(0, shore_m, std::max(position.y - straight.y, 0.0)),
                      1 - smooth(0, shore_m, std::min(glm::distance(straight, position), way_m))});
  thick *= most;
  const double bubbles =
      foam_.at(glm::dvec2(position.x, position.z) / number("foam_size") + glm::dvec2(0.02, 0.013) * double(scene_.time_s));
  return std::min(4 * thick, 1.0) * smooth(-0.15, 0.15, thick - bubbles);
}

BottomLight WaterLight::bottom(glm::dvec3 albedo, glm::dvec3 by_sun, glm::dvec3 by_rest, glm::dvec3 position) const {
  return {albedo * by_sun * caustic(position), albedo * by_rest};
}

glm::dvec3 WaterLight::kept(const BottomLight& light, glm::dvec3 position, double way_m) const {
  const double depth = depth_of(position);
  const glm::dvec3 left = light.by_sun * glm::exp(-extinction_ * (depth / sun_in_water_.y + way_m)) +
                          light.by_rest * glm::exp(-extinction_ * (depth / sky_cosine + way_m));
  return left / glm::max(light.all(), glm::dvec3(1e-300));
}

}  // namespace lamina
