// SPDX-License-Identifier: Apache-2.0
// A transparent surface as every pass takes it: opacity and colour of the fragment, and how lights meet it. World space, linear
// light. Include after common/frame.glsl, common/surface.glsl and common/mesh_in.glsl.
#include "light.glsl"

layout(std140, binding = 3) uniform Effect {
  float opacity;   // seen straight on, 0 to 1
  float specular;  // factor of the highlights
  float gloss;     // Blinn's exponent
  float slant;     // 1: a sheet of even thickness, which light crosses on a longer way where it is seen at a slant; 0: the same
};                 // opacity everywhere
layout(binding = 4) uniform sampler2D transparent_color;

struct TransparentSurface {
  vec3 color;
  float opacity;
  vec3 normal;  // towards the eye
};

const float least_cosine = 0.05;  // a sheet seen along its surface is not thicker than 20 times its thickness

TransparentSurface transparent_surface() {
  vec4 texel = texture(transparent_color, in_uv);
  vec3 to_eye = normalize(eye_world.xyz - in_position), normal = normalize(in_normal);
  float cosine = dot(normal, to_eye);
  if (cosine < 0.0) normal = -normal;
  float straight = clamp(opacity * texel.a, 0.0, 1.0);
  // Bouguer's law along 1 / cosine of the thickness.
  float longer = mix(1.0, 1.0 / max(abs(cosine), least_cosine), slant);
  float at_slant = straight >= 1.0 ? 1.0 : 1.0 - exp(log(1.0 - straight) * longer);
  return TransparentSurface(texel.rgb, slant > 0.0 ? at_slant : straight, normal);
}

// The fragment's colour, not multiplied by its opacity, and its opacity: shaded forward by all lights.
vec4 shaded_surface() {
  TransparentSurface surface = transparent_surface();
  SurfaceLight light = surface_light(surface.normal, in_position, gloss);
  return vec4(surface.color * light.diffuse + specular * light.specular, surface.opacity);
}
