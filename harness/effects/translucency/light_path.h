// SPDX-License-Identifier: Apache-2.0
// The light of a lamp that reaches a point inside an object without having been scattered: its path through everything on the
// way, what boundaries reflect of it, and how refraction spreads or gathers it. In doubles, by rays; shares no code with
// shaders.
#pragma once

#include "harness/effects/translucency/solids.h"

namespace lamina {

// Of unpolarized light that comes from outside at this cosine (Fresnel). 1 at cosine 0 where eta > 1.
double fresnel_reflectance(double cosine_outside, double eta);
// By Snell's law.
double cosine_inside(double cosine_outside, double eta);
// The way on of light that travels along `direction` into a surface whose normal points against it.
glm::dvec3 refracted_into(glm::dvec3 direction, glm::dvec3 normal, double eta);

// Towards a light, and its irradiance at normal incidence there.
struct LightHere {
  glm::dvec3 direction;
  double distance_m;  // to a point light; else 1e30
  glm::dvec3 irradiance;
};
LightHere light_here(const Light& light, glm::dvec3 position);

struct LightPath {
  glm::dvec3 optical_depth{0};
  double share = 0;  // of the irradiance at normal incidence; above 1 where refraction gathers light
  glm::dvec3 transmitted() const { return share * glm::exp(-optical_depth); }
};

enum class Refraction {
  flat,    // along the straight line, each surface taken as flat (Jensen and others, SIGGRAPH 2001)
  solved,  // the refracted ray that meets the point, found by Newton's method, and how much wider a thin beam is there
};

// `object` is the one that the point is in, and `normal` the surface's that it lies just below, for where no surface is found.
// Solved: one ray, the one next to the straight line; none (share 0) where Newton finds none, as behind a caustic.
LightPath light_path(const Solids& solids, glm::dvec3 point, glm::dvec3 normal, size_t object, const Light& light,
                     Refraction refraction);

}  // namespace lamina
