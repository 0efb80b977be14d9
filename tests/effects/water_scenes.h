// SPDX-License-Identifier: Apache-2.0
// Water whose light can be worked out by hand: still, over a level bottom of one colour, and with waves.
#pragma once

#include <cmath>
#include <numbers>

#include "harness/effects/water/water_light.h"
#include "harness/scene/made/water_grid.h"
#include "harness/scene/place_objects.h"
#include "tests/effects/backends_agree.h"
#include "tests/effects/hair_scenes.h"

namespace lamina {

inline constexpr uint32_t water_size = 48;
// What 8-bit codes of sRGB hold: about 0.6, 0.5 and 0.4.
inline float light_of_code(float code) { return std::pow((code / 255 + 0.055f) / 1.055f, 2.4f); }
inline const glm::vec3 bottom_albedo(light_of_code(203), light_of_code(188), light_of_code(170));
inline constexpr glm::vec3 water_sky(0.2f, 0.3f, 0.5f), water_sun(0.9f, 0.8f, 0.7f), water_around(0.3f, 0.35f, 0.4f);

using WaterNumbersSaid = std::map<std::string, double>;

// Still water over a level bottom of one colour, seen from `above_m` straight down, or at a slant.
inline Scene still_pool(double depth_m, const WaterNumbersSaid& numbers = {}, bool slant = false) {
  Scene scene;
  std::vector<Object> objects;
  objects.push_back(water_object(scene, water_rectangle({-6, -6}, {6, 6}, 0.25f), 0.25f, 0));
  Object bottom;
  bottom.name = "bottom";
  bottom.mesh = water_rectangle({-60, -60}, {60, 60}, 10);
  bottom.world_from_object[3] = glm::vec4(0, -depth_m, 0, 1);
  bottom.said.values = {{"albedo", {bottom_albedo}}};
  objects.push_back(std::move(bottom));
  Keys said = std::move(scene.said["water"]);
  for (const auto& [name, value] :
       WaterNumbersSaid{{"wave_1_amplitude", 0}, {"wave_2_amplitude", 0}, {"caustics", 0}, {"specular", 0}, {"soft_edge", 0}})
    said.values[name] = {value};
  for (const auto& [name, value] : numbers) said.values[name] = {value};
  scene = declared_scene(std::move(objects));
  scene.said["water"] = std::move(said);
  declare_said(scene, builtin_library());
  scene.lights.push_back({"sun", Light::Kind::directional, glm::normalize(glm::vec3(-0.4f, -0.8f, 0.2f)), {}, water_sun});
  scene.ambient = water_around, scene.background = water_sky;
  View& view = scene.views[0];
  view.fov_y_degrees = 30, view.near_m = 0.1f, view.far_m = 200;
  view.eye = slant ? glm::vec3(0, 1.5f, 5) : glm::vec3(0, 4, 0), view.target = glm::vec3(0, 0, 0);
  view.up = slant ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
  return scene;
}

inline WaterNumbersSaid waves_on(WaterNumbersSaid numbers = {}) {
  numbers.insert({{"wave_1_amplitude", 0.02},
                  {"wave_1_length", 2.1},
                  {"wave_1_steepness", 0.1},
                  {"wave_2_amplitude", 0.015},
                  {"wave_2_length", 1.4}});
  return numbers;
}

// What still water shows of a level bottom, by the formulas: a ray that comes at this angle to the vertical.
inline glm::dvec3 still_light(double depth_m, double angle, bool reflects = true) {
  const double n = 1.333, inside = std::asin(std::sin(angle) / n), way = depth_m / std::cos(inside);
  const glm::dvec3 to_sun = -glm::normalize(glm::dvec3(-0.4, -0.8, 0.2));
  const double sun_cosine = std::sqrt(1 - (1 - to_sun.y * to_sun.y) / (n * n));
  const glm::dvec3 b(.012, .014, .016), c = glm::dvec3(.30, .049, .002) + b;
  const double share = reflects ? reflected_by_water(std::cos(angle), n) : 0;
  glm::dvec3 light;
  for (int i = 0; i < 3; ++i) {
    const double e = double(water_sun[i]), k = c[i] * (1 + std::cos(inside) / sun_cosine),
                 k_sky = c[i] * (1 + std::cos(inside) / .83);
    const double bottom =
        double(bottom_albedo[i]) *
        (e * to_sun.y * std::exp(-c[i] * depth_m / sun_cosine) + double(water_around[i]) * std::exp(-c[i] * depth_m / .83)) *
        std::exp(-c[i] * way);
    const double in =
        b[i] / 4 * e * to_sun.y / sun_cosine * (1 - reflected_by_water(to_sun.y, n)) * (1 - std::exp(-k * way)) / k +
        b[i] / 2 * .9336 * double(water_around[i]) * (1 - std::exp(-k_sky * way)) / k_sky;
    light[i] = (1 - share) * (bottom + in) + share * double(water_sky[i]);
  }
  return light;
}

// In radians, of a pixel seen straight down from still_pool's eye.
inline double angle_of(int x, int y) {
  const double half = std::tan(15 * std::numbers::pi / 180), middle = water_size / 2.0;
  return std::atan(half * std::hypot(x + .5 - middle, y + .5 - middle) / middle);
}

inline double decibels(const Image& a, const Image& b) { return psnr_db(to_display(a), to_display(b)); }

}  // namespace lamina
