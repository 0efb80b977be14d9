// SPDX-License-Identifier: Apache-2.0
// A slab of glass in doubles: a rough front with Beckmann's distribution of slopes, a smooth back parallel to it.
#pragma once

#include <optional>

#include "harness/scene/scene.h"

namespace lamina {

struct GlassSlab {
  double slope = 0;  // of microfacets: per axis a Gaussian of variance slope^2 / 2
  double thickness_m = 0, refraction_index = 1.5;
  glm::dvec3 absorption{0};  // 1/m
};

// What the object is of; nothing where it is not of rough glass.
std::optional<GlassSlab> glass_slab(const Object& object);

struct SlabRay {
  glm::dvec3 from, direction;  // behind the slab; unit
};
// The ray from the eye through the front's microfacet with this unit normal, at `position`. `normal`: the slab's, towards the
// eye. Nothing where the facet looks away or all is reflected. By Snell's law in vectors (Glassner, An Introduction to Ray
// Tracing, 1989, section 4.4).
std::optional<SlabRay> through(const GlassSlab& slab, glm::dvec3 position, glm::dvec3 normal, glm::dvec3 facet,
                               glm::dvec3 to_eye);

// What is seen where `behind` comes through: less by both faces' Fresnel and by absorption, plus what the front reflects.
glm::dvec3 seen_in_glass(const GlassSlab& slab, const Scene& scene, glm::dvec3 position, glm::dvec3 normal, glm::dvec3 to_eye,
                         glm::dvec3 behind);

}  // namespace lamina
