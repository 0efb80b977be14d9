// SPDX-License-Identifier: Apache-2.0
// A flat glossy surface of microfacets with Beckmann's distribution of slopes (Beckmann and Spizzichino 1963): per axis a Gaussian
// of variance a^2 / 2, a = roughness squared. A ray from the eye is reflected by the facet that it meets.
#define FRAME_MEMBERS mat4 mirror_clip_from_world;
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"

layout(std140, binding = 3) uniform Effect { float roughness, reflectance, height; };

// The picture is the mirror's, turned back from left to right: see base.frag.
vec4 on_picture(vec4 world) { return mirror_clip_from_world * world * vec4(-1.0, 1.0, 1.0, 1.0); }
#include "picture_pyramid/landing.glsl"

float slope_deviation() { return roughness * roughness * 0.70710678; }

// By the facet of these slopes: x towards the eye, y across.
LeavingRay reflected_by(SurfacePoint at, vec3 to_eye, vec2 slopes) {
  vec3 across = cross(at.normal, to_eye);
  across = dot(across, across) > 1e-12 ? normalize(across) : at.world_from_tangent[1];
  vec3 facet = normalize(at.normal + slopes.x * cross(across, at.normal) + slopes.y * across), along = reflect(-to_eye, facet);
  return LeavingRay(at.position, along, dot(facet, to_eye) > 0.0 && dot(along, at.normal) > 0.0);
}

// Fresnel's share at a facet (Schlick, Eurographics 1994).
float reflected_share(float cosine) { return reflectance + (1.0 - reflectance) * pow(1.0 - clamp(cosine, 0.0, 1.0), 5.0); }

#include "common/facet_highlights.glsl"

layout(binding = 7) uniform sampler2D albedo;

// Whether the point lies in the mirror's plane and faces up: within a millimetre and a degree.
bool in_mirror(SurfacePoint at) { return abs(at.position.y - height) < 1e-3 && at.normal.y > 0.9998; }

// The surface's light: `reflected`, of which Fresnel's share is in it, diffuse light of what is not reflected, and highlights.
// Beside the mirror's plane it is the ambient light that is reflected.
vec3 light_of_surface(SurfacePoint at, vec3 to_eye, vec3 reflected) {
  float share = reflected_share(dot(at.normal, to_eye));
  vec3 diffuse = texture(albedo, at.uv).rgb * diffuse_light(at.normal, at.position);
  return (in_mirror(at) ? reflected : ambient.rgb * share) + diffuse * (1.0 - share) +
         facet_highlights(at, to_eye, max(roughness * roughness, 0.02));
}
