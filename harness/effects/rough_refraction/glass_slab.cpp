// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/rough_refraction/glass_slab.h"

#include <algorithm>
#include <cmath>

#include "harness/truth/beckmann_facets.h"

namespace lamina {
namespace {

// Unpolarized; the cosine outside.
double fresnel_of_glass(double cosine, double index) {
  const double inside = std::sqrt(1 - (1 - cosine * cosine) / (index * index));
  const double s = (cosine - index * inside) / (cosine + index * inside),
               p = (index * cosine - inside) / (index * cosine + inside);
  return (s * s + p * p) / 2;
}

// From index `from` to index `to` through a face whose normal looks against the ray.
std::optional<glm::dvec3> snell(glm::dvec3 along, glm::dvec3 normal, double from, double to) {
  const double ratio = from / to, cosine = -glm::dot(along, normal), squared = 1 - ratio * ratio * (1 - cosine * cosine);
  if (cosine <= 0 || squared <= 0) return std::nullopt;
  return ratio * along + (ratio * cosine - std::sqrt(squared)) * normal;
}

}  // namespace

std::optional<GlassSlab> glass_slab(const Object& object) {
  const auto glass = object.effects.find("rough_refraction");
  if (glass == object.effects.end()) return std::nullopt;
  const auto number = [&](const char* name) { return glass->second.numbers.find(name)->second; };
  return GlassSlab{number("roughness") * number("roughness"),
                   number("thickness"),
                   number("refraction_index"),
                   {number("absorption_red"), number("absorption_green"), number("absorption_blue")}};
}

std::optional<SlabRay> through(const GlassSlab& slab, glm::dvec3 position, glm::dvec3 normal, glm::dvec3 facet,
                               glm::dvec3 to_eye) {
  const auto inside = snell(-to_eye, facet, 1, slab.refraction_index);
  if (!inside) return std::nullopt;
  const auto outside = snell(*inside, normal, slab.refraction_index, 1);
  if (!outside) return std::nullopt;
  return SlabRay{position + *inside * (slab.thickness_m / -glm::dot(*inside, normal)), *outside};
}

glm::dvec3 seen_in_glass(const GlassSlab& slab, const Scene& scene, glm::dvec3 position, glm::dvec3 normal, glm::dvec3 to_eye,
                         glm::dvec3 behind) {
  const double cosine = std::clamp(glm::dot(normal, to_eye), 1e-4, 1.0), n = slab.refraction_index;
  const double reflected = fresnel_of_glass(cosine, n), inside = std::sqrt(1 - (1 - cosine * cosine) / (n * n));
  return behind * glm::exp(-slab.absorption * (slab.thickness_m / inside)) * ((1 - reflected) * (1 - reflected)) +
         reflected * glm::dvec3(scene.ambient) +
         facet_highlights(scene, std::max(slab.slope, 0.02), position, normal, to_eye,
                          [&](double facet) { return fresnel_of_glass(facet, n); });
}

}  // namespace lamina
