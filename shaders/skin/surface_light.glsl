// SPDX-License-Identifier: Apache-2.0
// What the surface itself does with light: highlights, and what they take from the light that enters. Included after
// material.glsl and soft_shadow.glsl; HIGHLIGHT names the model.
#include "highlights.glsl"

layout(binding = 10) uniform sampler2D reflected_share;  // of all light from a direction: over its cosine and the slope

// Factors of the highlight's strength and slope; oil and rim have their own.
vec2 specular_map(vec2 uv) {
#ifdef SPECULAR
  return texture(skin_specular, uv).rg;
#else
  return vec2(1.0);
#endif
}

#ifdef SPECULAR
float reflected_by_slope(float cosine, float m) {
  vec2 place = vec2(clamp(cosine, 0.0, 1.0), clamp(m, 0.0, 1.0));
  return texture(reflected_share, (place * 31.0 + 0.5) / 32.0).r;
}
#endif

// The share of light from (or to) this direction that goes into the skin (d'Eon and Luebke's 1 - rho_s rho_dt). LOBES: the
// highlight is Clement's, whose lobes are the table's at other slopes; a factor of their weights.
float entering(float cosine, vec2 map) {
#ifdef SPECULAR
  float share = 0.0;
#ifdef LOBES
  for (int i = 0; i < 4; ++i) share += LOBES * clement_weights[i] * reflected_by_slope(cosine, clement_slopes[i] * roughness * map.g);
#else
  share = reflected_by_slope(cosine, roughness * map.g);
#endif
  return max(1.0 - specular * map.r * share, 0.0);
#else
  return 1.0;
#endif
}

// Of one light, a unit of irradiance.
float highlight(SkinPoint point, vec2 map, vec3 to_light, vec3 to_eye) {
  float sum = 0.0;
  Facets facets = facets_of(point.normal, to_light, to_eye, max(roughness * map.g, 0.02), reflectance);
#ifdef SPECULAR
  sum += specular * map.r * HIGHLIGHT(facets);
#endif
#ifdef OIL
  Facets oily = facets;
  oily.m = oil_roughness;
  sum += oil * kelemen(oily);
#endif
#ifdef RIM
  // Clement: smoothstep(0, .5, F(N.V)) (N.H)^p N.L.
  sum += rim * smoothstep(0.0, 0.5, schlick(facets.nv, reflectance)) * exp2(rim_power * log2(max(facets.nh, 1e-6))) * facets.nl;
#endif
  return sum;
}

// Light from behind, as Clement adds it: (t - .4)(1 - N.L) where t, the subdermal map's alpha, is above .4.
vec3 back_scattered(SkinPoint point, vec3 to_light) {
#ifdef BACK_SCATTERING
  vec4 subdermal = texture(skin_subdermal, point.uv);
  float c = dot(point.normal, to_light);
  return back_scattering * clamp(max(subdermal.a - 0.4, 0.0) * (1.0 - c), 0.0, 1.0) * subdermal.rgb;
#else
  return vec3(0.0);
#endif
}
