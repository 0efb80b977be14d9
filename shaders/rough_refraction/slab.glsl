// SPDX-License-Identifier: Apache-2.0
// A slab of glass: its front is rough, its back smooth and parallel to the front. A ray meets a microfacet of the front, is
// refracted by it, crosses the slab, and is refracted by the back (Snell). Microfacets have Beckmann's distribution of slopes
// (Beckmann and Spizzichino 1963): per axis a Gaussian of variance a^2 / 2, a = roughness squared.
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"

layout(std140, binding = 3) uniform Effect {
  float roughness, thickness, refraction_index, absorption_red, absorption_green, absorption_blue;
};

// The picture is the eye's, of what is opaque.
vec4 on_picture(vec4 world) { return clip_from_world * world; }
#include "picture_pyramid/landing.glsl"

// Through the microfacet of these slopes along the surface's axes. It does not pass where the facet looks away or all is reflected.
LeavingRay through_slab(SurfacePoint at, vec3 to_eye, vec2 slopes) {
  vec3 facet = normalize(at.world_from_tangent * vec3(-slopes, 1.0));
  vec3 inside = refract(-to_eye, facet, 1.0 / refraction_index);
  vec3 outside = refract(inside, at.normal, refraction_index);
  float down = -dot(inside, at.normal);
  bool passes = dot(facet, to_eye) > 0.0 && down > 1e-3 && dot(outside, outside) > 0.5;
  return LeavingRay(at.position + inside * (thickness / max(down, 1e-3)), outside, passes);
}

// Fresnel's reflectance of the front, unpolarized.
float reflected_share(float c) {
  float g = sqrt(refraction_index * refraction_index - 1.0 + c * c), across = (c - g) / (c + g),
        along = (refraction_index * refraction_index * c - g) / (refraction_index * refraction_index * c + g);
  return 0.5 * (across * across + along * along);
}

#include "common/facet_highlights.glsl"

// The glass's light: what comes through, less what both faces reflect and what is absorbed on the way, and what the front
// reflects of the lights and of the surroundings.
vec3 light_of_glass(SurfacePoint at, vec3 to_eye, vec3 behind) {
  float cosine = clamp(dot(at.normal, to_eye), 1e-4, 1.0), reflected = reflected_share(cosine);
  float inside = sqrt(1.0 - (1.0 - cosine * cosine) / (refraction_index * refraction_index));
  vec3 kept = exp(-vec3(absorption_red, absorption_green, absorption_blue) * (thickness / inside));
  return behind * kept * ((1.0 - reflected) * (1.0 - reflected)) + reflected * ambient.rgb +
         facet_highlights(at, to_eye, max(roughness * roughness, 0.02));
}
