// SPDX-License-Identifier: Apache-2.0
// Direct light of spherical lights and a sky on diffuse points, offline: the truth of aperture lighting, and the same with one
// of its assumptions at a time, so that each assumption's share of the error is known.
//
// A light of angular radius r that gives irradiance E at normal incidence has the radiance E / (pi sin^2 r). The sky's radiance
// is ambient / pi wherever no light stands in front of it.
#pragma once

#include <span>
#include <vector>

#include "harness/bake/occluders.h"
#include "harness/effects/aperture_lighting/shading_points.h"

namespace lamina {

// From what visibility is taken, and how it is weighed.
enum class LightModel : uint8_t {
  exact_intersection,  // apertures; the exact area that they share with a light, the cosine at the middle: what exact_cap
                       // computes
  integrated_cosine,   // apertures; the cosine integrated over what they share
  traced_share,        // rays; the share of a light that is seen, the cosine at the middle: for tests of the apertures alone
  traced,              // rays and the cosine integrated: the truth
};

struct DirectLightOptions {
  size_t light_rays = 256, sky_rays = 256;  // a point and light, a point; not for exact_intersection
  uint64_t seed = 1;
  float bias_m = 0;  // how far rays start above the surface
};

// Irradiance over pi, times the albedo, of every point: linear light, in the points' order. Lights and ambient as Lambert's N.L
// takes them (shaders/common/surface.glsl). Points are independent of each other and of threads.
std::vector<glm::vec3> direct_light(const ShadingPoints& points, const Scene& scene, const Occluders& occluders,
                                    LightModel model, const DirectLightOptions& options, const ProgressFunction& progress);

// A light as a point sees it: a cap around a unit direction, and the irradiance at normal incidence.
struct LightCap {
  glm::vec3 direction;
  double radius;          // angular, radians, above 0 to pi / 2
  float distance_m;       // to the centre; infinite for a directional light
  float sphere_radius_m;  // 0 for a directional light
  glm::vec3 irradiance;
};
LightCap light_cap(const Light& light, glm::vec3 position);

}  // namespace lamina
