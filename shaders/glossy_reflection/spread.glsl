// SPDX-License-Identifier: Apache-2.0
// How far rays that the facets reflect spread on the mirror's picture. Facets that the eye sees lean towards it: with s their
// standard deviation of slopes and t the tangent of the view's angle, by s^2 t in the mean, whose variance is s^2 - s^4 t^2. Both
// are those of the distribution times n.v + x sin, of which what is below 0 is cut off; at grazing angles nearly half is, and they
// end at s sqrt(pi/2) and s^2 (2 - pi/2), Rayleigh's.
#include "facets.glsl"
#include "picture_pyramid/spread.glsl"

struct SeenFacets {
  float lean;                // mean slope towards the eye
  float along, across;       // standard deviations
};
SeenFacets seen_facets(SurfacePoint at, vec3 to_eye) {
  float cosine = max(dot(at.normal, to_eye), 1e-4), s = slope_deviation();
  float lean = min(s * sqrt(max(1.0 - cosine * cosine, 0.0)) / cosine, 1.2533);
  return SeenFacets(s * lean, s * sqrt(max(1.0 - lean * lean, 0.4292)), s);
}

Spread spread_of(SurfacePoint at, vec3 to_eye, SeenFacets seen) {
  return spread_of_rays(reflected_by(at, to_eye, vec2(seen.lean, 0.0)), reflected_by(at, to_eye, vec2(seen.lean + seen.along, 0.0)),
                        reflected_by(at, to_eye, vec2(seen.lean, seen.across)), at.position);
}

// Fresnel's share at the middle facet.
float middle_share(SurfacePoint at, vec3 to_eye, SeenFacets seen) {
  float cosine = dot(at.normal, to_eye);
  return reflected_share((cosine + seen.lean * sqrt(max(1.0 - cosine * cosine, 0.0))) * inversesqrt(1.0 + seen.lean * seen.lean));
}
