// SPDX-License-Identifier: Apache-2.0
// The light that an object scatters towards the eye, at one point of its surface, by models that drop one assumption after
// another. In units of what a Lambert albedo gives: pi times the radiance.
#pragma once

#include <cstdint>

#include "harness/effects/translucency/light_path.h"

namespace lamina {

struct LitPoint {
  size_t object = 0;
  glm::dvec3 position{0}, normal{0};  // on the surface; unit
  glm::dvec3 to_eye{0};               // unit
  glm::dvec3 albedo{0};               // scattering over extinction
};

// Light that is scattered once, integrated along the eye's refracted ray, from all lights. Isotropic scattering.
glm::dvec3 single_scattering(const Solids& solids, const Scene& scene, const LitPoint& point, Refraction refraction);

// Light that is scattered more often, as the shaders stand for it: diffuse light through a slab as thick as the path.
glm::dvec3 slab_scattering(const Solids& solids, const Scene& scene, const LitPoint& point, Refraction refraction);

// The same by a random walk of `walks` paths, with all the inner reflections of the eye's path. Left out: light that a surface
// reflects inside before it is scattered for the first time, and light that has left an object and enters again.
glm::dvec3 multiple_scattering(const Solids& solids, const Scene& scene, const LitPoint& point, size_t walks, uint64_t seed);

// All around: the ambient light as the shaders take it, and of lights that do not cast Lambert's share.
glm::dvec3 unshadowed_light(const Medium& medium, const Scene& scene, const LitPoint& point);

// The dipole's total diffuse reflectance (Jensen and others, SIGGRAPH 2001).
double diffuse_reflectance(double albedo, double eta);

}  // namespace lamina
