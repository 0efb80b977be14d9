// SPDX-License-Identifier: Apache-2.0
// What water does to light, in doubles, for its truth; written apart from the shaders. Light is in the unit of lights: a white
// surface shows its irradiance, pi times its radiance. Directions are unit vectors, y up.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "harness/core/image.h"
#include "harness/scene/scene.h"

namespace lamina {

// Fresnel's share of unpolarized light that comes at this cosine (0 to 1) from above. `index`: of the water over that of the
// air.
double reflected_by_water(double cosine, double index);

// A texture of one or two channels of half floats, tiled.
class TiledTable {
 public:
  explicit TiledTable(const TextureImage& table);
  double at(glm::dvec2 uv, uint32_t channel = 0) const;  // bilinear, in the base level

 private:
  uint32_t side_, channels_;
  std::vector<float> texels_;
};

// Light that the bottom shows before the water takes of it: by the sun, as waves gather it, and by all else.
struct BottomLight {
  glm::dvec3 by_sun{0}, by_rest{0};
  glm::dvec3 all() const { return by_sun + by_rest; }
};

class WaterLight {
 public:
  explicit WaterLight(const Scene& scene);  // which has water, and outlives this

  double number(const char* name) const;
  glm::dvec3 extinction() const { return extinction_; }
  bool sunlit() const { return sunlit_; }
  glm::dvec3 to_sun() const { return to_sun_; }                // in the air
  glm::dvec3 sun_in_water() const { return sun_in_water_; }    // towards it, in the water
  glm::dvec3 sky(glm::dvec3 direction) const;                  // what a ray sees that meets nothing
  glm::dvec3 in_scatter(glm::dvec3 into, double way_m) const;  // of a way from the surface down
  double caustic(glm::dvec3 position) const;                   // of the sun's light at the bottom, 1 in the mean
  glm::dvec3 glitter(glm::dvec3 along) const;                  // the sun in a reflected ray, before Fresnel's share
  // A normal of waves with the ripples at a place of the ground without waves: slopes are added.
  glm::dvec3 with_ripples(glm::dvec3 normal, glm::dvec2 ground) const;
  // How much of the surface foam covers: a point of it, what stands behind it in the straight ray, and the way in the water.
  double foam(glm::dvec3 position, glm::dvec3 straight, double way_m) const;
  // What the bottom shows, of an albedo and its irradiance by the sun and by all else, without water.
  BottomLight bottom(glm::dvec3 albedo, glm::dvec3 by_sun, glm::dvec3 by_rest, glm::dvec3 position) const;
  // The share of it that is left at the surface, after the way down of the sun's and of the sky's light and this way up. 0
  // where there is no light.
  glm::dvec3 kept(const BottomLight& light, glm::dvec3 position, double way_m) const;

 private:
  double depth_of(glm::dvec3 position) const;
  const Scene& scene_;
  const EffectValues& values_;
  bool sunlit_ = false;
  glm::dvec3 scattered_{0}, extinction_{0}, to_sun_{0, 1, 0}, sun_in_water_{0, 1, 0}, sunlight_{0}, sunlight_in_water_{0};
  TiledTable caustics_, foam_, ripples_;
  std::vector<glm::dvec3> sky_;  // along its width
};

}  // namespace lamina
