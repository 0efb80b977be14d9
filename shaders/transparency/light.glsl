// SPDX-License-Identifier: Apache-2.0
// All lights at a point of a surface: Lambert's cosine, and Blinn's highlight, normalised so that its energy does not depend on
// the exponent (Akenine-Moeller, Haines and Hoffman, "Real-Time Rendering", 3rd edition, 2008, section 7.6: (n + 8) / 8 pi; pi
// cancels as in diffuse_light()). Include after common/frame.glsl.
#ifndef TRANSPARENCY_LIGHT_GLSL
#define TRANSPARENCY_LIGHT_GLSL

struct SurfaceLight {
  vec3 diffuse;   // irradiance, the ambient one too
  vec3 specular;
};

// `normal`: unit, on the eye's side.
SurfaceLight surface_light(vec3 normal, vec3 position, float gloss) {
  SurfaceLight sum = SurfaceLight(ambient.rgb, vec3(0.0));
  vec3 to_eye = normalize(eye_world.xyz - position);
  for (int i = 0; i < light_count.x; ++i) {
    vec3 to_light = light_position[i].xyz - position * light_position[i].w;
    float squared = max(dot(to_light, to_light), 1e-8);
    to_light *= inversesqrt(squared);
    float falloff = light_position[i].w > 0.0 ? 1.0 / squared : 1.0;
    float cosine = max(dot(normal, to_light), 0.0);
    vec3 irradiance = light_radiance[i].rgb * (cosine * falloff);
    vec3 halfway = to_light + to_eye;
    float across = max(dot(normal, halfway) * inversesqrt(max(dot(halfway, halfway), 1e-8)), 0.0);
    sum.diffuse += irradiance;
    sum.specular += irradiance * ((gloss + 8.0) / 8.0 * pow(across, gloss));
  }
  return sum;
}

#endif
