// SPDX-License-Identifier: Apache-2.0
// See terrain.h.
#include "harness/scene/made/terrain.h"

#include <algorithm>
#include <cmath>

#include "harness/scene/default_views.h"
#include "harness/scene/made/day.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/erosion.h"
#include "harness/scene/made/height_field.h"
#include "harness/scene/made/noise.h"
#include "harness/scene/textures.h"

namespace lamina {
namespace {

constexpr Erosion erosion{.side = 257, .extent_m = 5120, .relief_m = 1650, .steepest = 0.88f, .seed = 5};
constexpr uint32_t texture_texels = 512;

// Linear, as seen on the ground.
constexpr glm::vec3 meadow{0.105f, 0.145f, 0.045f}, forest{0.040f, 0.065f, 0.028f}, scree{0.26f, 0.235f, 0.205f},
    rock{0.185f, 0.170f, 0.160f}, snow{0.74f, 0.77f, 0.82f};

// Gravel fills the valley's bottom, rising gently from the outlet; frost breaks up what stands above.
void weather(Terrain& terrain) {
  for (uint32_t row = 0; row < terrain.side; ++row)
    for (uint32_t column = 0; column < terrain.side; ++column) {
      float& height = terrain.height_m[row * terrain.side + column];
      const glm::vec2 p = terrain.spacing_m * glm::vec2(column, row);
      const float fill = 20 + 0.02f * (erosion.extent_m - p.y);
      const float rough = 45 * fractal_noise(glm::vec3(p / 420.0f, 0.5f), 5, erosion.seed + 11);
      const float high = std::clamp((height - fill) / 300, 0.0f, 1.0f);
      const float broken = height + high * rough;
      // A smooth maximum, 30 m around where they meet.
      constexpr float width = 30;
      const float t = std::clamp(0.5f + (broken - fill) / (2 * width), 0.0f, 1.0f);
      height = fill + (broken - fill) * t + width * t * (1 - t);
    }
}

// Differences to the neighbours, one-sided at the edges.
glm::vec2 slope_at(const Terrain& terrain, uint32_t column, uint32_t row) {
  const uint32_t last = terrain.side - 1;
  const uint32_t left = column > 0 ? column - 1 : 0, right = std::min(column + 1, last);
  const uint32_t up = row > 0 ? row - 1 : 0, down = std::min(row + 1, last);
  return {(terrain.at(right, row) - terrain.at(left, row)) / (terrain.spacing_m * static_cast<float>(right - left)),
          (terrain.at(column, down) - terrain.at(column, up)) / (terrain.spacing_m * static_cast<float>(down - up))};
}

// Half a cell of margin, so that no filter reaches the opposite edge.
glm::vec2 uv_at(const Terrain& terrain, uint32_t column, uint32_t row) {
  return (glm::vec2(column, row) + 0.5f) / static_cast<float>(terrain.side);
}

Mesh mesh_of(const Terrain& terrain) {
  Mesh mesh;
  const float middle = erosion.extent_m / 2;
  add_grid(mesh, terrain.side, terrain.side, [&](uint32_t column, uint32_t row) {
    const glm::vec2 p = terrain.spacing_m * glm::vec2(column, row) - middle;
    return height_vertex({p.x, terrain.at(column, row), p.y}, slope_at(terrain, column, row), uv_at(terrain, column, row));
  });
  return mesh;
}

// What grows or lies at a height and a slope (rise over run); `p` in metres.
glm::vec3 ground(glm::vec2 p, float height, glm::vec2 slope, float drained_m2) {
  const float steep = glm::length(slope);
  const float patch = fractal_noise(glm::vec3(p / 300.0f, 0.5f), 5, erosion.seed + 21);
  const float grain = fractal_noise(glm::vec3(p / 45.0f, 0.5f), 3, erosion.seed + 31);
  const float trees = glm::smoothstep(0.08f, 0.20f, steep) * (1 - glm::smoothstep(470.0f, 640.0f, height + 300 * patch));
  const float bare =
      std::max(glm::smoothstep(0.70f, 0.86f, steep + 0.35f * patch), glm::smoothstep(620.0f, 900.0f, height + 260 * patch));
  const float gravel = glm::smoothstep(5.9f, 6.5f, std::log10(drained_m2)) * (1 - glm::smoothstep(0.25f, 0.5f, steep));
  // Snow stays where it is high, flat enough, and turned away from the sun.
  const float lies = height + 260 * patch + 130 * slope.y / (1 + steep);
  const float white = glm::smoothstep(560.0f, 740.0f, lies) * (1 - glm::smoothstep(0.92f, 1.25f, steep + 0.5f * grain));
  glm::vec3 colour = glm::mix(meadow * (1 + 0.5f * patch), forest, trees);
  colour = glm::mix(colour, glm::mix(scree, rock, glm::smoothstep(0.5f, 0.9f, steep)) * (1 + 0.35f * patch), bare);
  colour = glm::mix(colour, scree, 0.65f * gravel);
  return glm::mix(colour * (1 + 0.45f * grain), snow, white);
}

std::shared_ptr<const TextureImage> albedo_of(const Terrain& terrain) {
  Texels texels{texture_texels, texture_texels, std::vector<glm::vec4>(texture_texels * texture_texels)};
  const uint32_t last = terrain.side - 1;
  for (uint32_t y = 0; y < texture_texels; ++y)
    for (uint32_t x = 0; x < texture_texels; ++x) {
      // The place on the grid whose uv is this texel's centre.
      const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / static_cast<float>(texture_texels);
      const glm::vec2 grid = glm::clamp(uv * static_cast<float>(terrain.side) - 0.5f, 0.0f, static_cast<float>(last));
      const uint32_t column = std::min(static_cast<uint32_t>(grid.x), last - 1);
      const uint32_t row = std::min(static_cast<uint32_t>(grid.y), last - 1);
      const glm::vec2 t = grid - glm::vec2(column, row);
      const auto between = [&](const auto& value) {
        return glm::mix(glm::mix(value(column, row), value(column + 1, row), t.x),
                        glm::mix(value(column, row + 1), value(column + 1, row + 1), t.x), t.y);
      };
      const float height = between([&](uint32_t c, uint32_t r) { return terrain.at(c, r); });
      const glm::vec2 slope = between([&](uint32_t c, uint32_t r) { return slope_at(terrain, c, r); });
      const float drained = between([&](uint32_t c, uint32_t r) { return terrain.drained_m2[r * terrain.side + c]; });
      const glm::vec3 colour = ground(grid * terrain.spacing_m, height, slope, drained);
      texels.rgba[y * texture_texels + x] = glm::vec4(glm::clamp(colour, 0.0f, 1.0f), 1);
    }
  return make_texture("terrain albedo", texels, TexelMeaning::colour);
}

// What time does not change, made once.
const Object& valley() {
  static const Object object = [] {
    Terrain terrain = eroded_valley(erosion);
    weather(terrain);
    Object made;
    made.name = "terrain";
    made.mesh = mesh_of(terrain);
    made.said.values["albedo"] = {albedo_of(terrain)};
    made.said.calls.insert("aperture_lighting");
    return made;
  }();
  return object;
}

}  // namespace

Scene make_terrain(float time_s) {
  const Daylight day = daylight(time_s);
  Scene scene;
  scene.name = scene.source = "terrain";
  scene.time_s = time_s;
  scene.objects.push_back(valley());
  scene.lights.push_back(directional_light("sun", day.to_sun, day.radiance, glm::radians(day_sun_radius_degrees)));
  scene.ambient = day.ambient;
  scene.background = day.background;
  scene.views = {{"valley", {200, 620, 2250}, {-170, 390, -300}, {0, 1, 0}, 45},
                 {"grazing", {-1790, 390, 1260}, {-1450, 330, -900}, {0, 1, 0}, 42},
                 {"above", {0, 8600, 900}, {0, 100, 30}, {0, 0, -1}, 36}};
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) fit_depth(view, bounds);
  scene.lights_move = true;
  return scene;
}

}  // namespace lamina
