// SPDX-License-Identifier: Apache-2.0
// See far_ridges.h.
#include "harness/scene/made/far_ridges.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "harness/scene/made/day.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/height_field.h"
#include "harness/scene/made/kept.h"
#include "harness/scene/made/noise.h"
#include "harness/scene/textures.h"

namespace lamina {
namespace {

constexpr uint32_t ridge_columns = 241, ridge_rows = 321, ridge_seed = 7;
constexpr float nearest_ridge_m = 250, furthest_ridge_m = 54000, ridge_earth_radius_m = 6.36e6f;

// Crests, as one comes to them.
struct MountainRange {
  float distance_m, width_m, height_m;
};
constexpr std::array<MountainRange, 6> mountain_ranges = {
    {{1100, 500, 190}, {4200, 1300, 430}, {9500, 2300, 760}, {18500, 3600, 1250}, {31500, 5000, 1900}, {49500, 5500, 3000}}};

// Of the sea, where nothing rises.
constexpr float ridge_plain_m = 60;

// Sharp crests where the noise passes 0.
float ridged_noise(glm::vec2 p, float length_m) {
  return 1 - 2.2f * std::abs(fractal_noise(glm::vec3(p / length_m, 0.5f), 6, ridge_seed));
}

// p: metres west and south.
float ridge_height_m(glm::vec2 p) {
  float height = ridge_plain_m + 25 * fractal_noise(glm::vec3(p / 700.0f, 3.5f), 4, ridge_seed + 1);
  for (const MountainRange& range : mountain_ranges) {
    const float bent =
        0.5f * range.width_m * fractal_noise(glm::vec3(p.y / (3 * range.width_m), 0.5f, range.height_m), 3, ridge_seed + 2);
    const float off = (p.x - range.distance_m - bent) / range.width_m;
    height += range.height_m * std::exp(-off * off) * std::max(0.0f, 0.2f + 0.8f * ridged_noise(p, 1.3f * range.width_m));
  }
  return height;
}

// Rows lie closer together near the eye; columns fan out.
glm::vec2 ridge_place(float column, float row) {
  const float t = row / (ridge_rows - 1), distance = nearest_ridge_m + (furthest_ridge_m - nearest_ridge_m) * t * t;
  return {distance, (2 * column / (ridge_columns - 1) - 1) * (1.1f * distance + 900)};
}

glm::vec2 ridge_slope(glm::vec2 p) {
  const float step = 4 + 1e-3f * p.x;
  const auto difference = [&](glm::vec2 d) { return (ridge_height_m(p + d) - ridge_height_m(p - d)) / (2 * step); };
  return {difference({step, 0}), difference({0, step})};
}

Mesh ridge_mesh() {
  Mesh mesh;
  // Columns run north as seen from the eye, so that triangles face up.
  add_grid(mesh, ridge_columns, ridge_rows, [](uint32_t column, uint32_t row) {
    const glm::vec2 p = ridge_place(static_cast<float>(column), static_cast<float>(row)), slope = ridge_slope(p);
    // Straight down from the level plane to the round earth.
    const float drop = glm::dot(p, p) / (2 * ridge_earth_radius_m);
    const glm::vec2 uv = (glm::vec2(column, row) + 0.5f) / glm::vec2(ridge_columns, ridge_rows);
    return height_vertex({-p.x, ridge_height_m(p) - drop, p.y}, {-slope.x, slope.y}, uv);
  });
  return mesh;
}

// Linear: meadows, woods, rock, snow.
glm::vec3 ridge_ground(glm::vec2 p) {
  const float steep = glm::length(ridge_slope(p)), height = ridge_height_m(p);
  const float patch = fractal_noise(glm::vec3(p / (300 + 0.05f * p.x), 0.5f), 4, ridge_seed + 3);
  glm::vec3 colour = glm::mix(glm::vec3(0.11f, 0.14f, 0.05f), glm::vec3(0.035f, 0.06f, 0.028f),
                              glm::smoothstep(0.02f, 0.22f, steep + 0.2f * patch));
  colour = glm::mix(colour, glm::vec3(0.19f, 0.175f, 0.16f) * (1 + 0.3f * patch),
                    std::max(glm::smoothstep(0.55f, 0.85f, steep), glm::smoothstep(900.0f, 1400.0f, height + 400 * patch)));
  return glm::mix(colour, glm::vec3(0.74f, 0.77f, 0.82f), glm::smoothstep(1350.0f, 1750.0f, height + 350 * patch));
}

std::shared_ptr<const TextureImage> ridge_albedo() {
  Texels texels{ridge_columns, ridge_rows, {}};
  for (uint32_t row = 0; row < ridge_rows; ++row)
    for (uint32_t column = 0; column < ridge_columns; ++column)
      texels.rgba.push_back(
          glm::vec4(glm::clamp(ridge_ground(ridge_place(static_cast<float>(column), static_cast<float>(row))), 0.0f, 1.0f), 1));
  return make_texture("land albedo", texels, TexelMeaning::colour);
}

// What time does not change, made once.
const Object& made_ridges() {
  static const Object object = [] {
    Object made;
    made.name = "land";
    made.mesh = kept_mesh("ridges", ridge_mesh);
    made.said.values["albedo"] = {kept_textures("ridges_albedo", [] { return std::vector{ridge_albedo()}; }).front()};
    return made;
  }();
  return object;
}

// Above the air, and what is left at the sea's level after the earth's air straight up (the optical depths of clear air with
// some haze and ozone).
constexpr float ridge_sun_above_air = 2;
constexpr glm::vec3 ridge_optical_depth{0.0615f, 0.1420f, 0.2714f};

}  // namespace

Scene make_far_ridges(float time_s) {
  const Daylight day = daylight(time_s);
  const float elevation = glm::degrees(std::asin(std::clamp(day.to_sun.y, -1.0f, 1.0f)));
  Scene scene;
  scene.name = scene.source = "far_ridges";
  scene.time_s = time_s;
  scene.objects.push_back(made_ridges());
  const glm::vec3 sun =
      elevation > 0 ? ridge_sun_above_air * glm::exp(-ridge_optical_depth * air_mass(elevation)) : glm::vec3(0);
  scene.lights.push_back(directional_light("sun", day.to_sun, sun, glm::radians(0.2665f)));
  scene.ambient = day.ambient;
  scene.background = glm::vec3(0);  // space
  Keys& air = scene.said["atmosphere"];
  for (const char* channel : {"sun.red", "sun.green", "sun.blue"}) air.values[channel] = {double{ridge_sun_above_air}};
  scene.views = {{"ridges", {0, 520, 0}, {-1000, 530, 0}, {0, 1, 0}, 20},
                 {"sky", {0, 520, 0}, {-1000, 900, 0}, {0, 1, 0}, 55},
                 {"high", {-2000, 5200, 0}, {-22000, 900, 0}, {0, 1, 0}, 45}};
  for (View& view : scene.views) view.near_m = 40, view.far_m = 75000;
  scene.lights_move = true;
  return scene;
}

}  // namespace lamina
