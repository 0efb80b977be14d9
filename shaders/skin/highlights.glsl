// SPDX-License-Identifier: Apache-2.0
// The models of highlights that variants choose from: HIGHLIGHT names one. Each gives reflection times N.L.
#ifndef HIGHLIGHTS_GLSL
#define HIGHLIGHTS_GLSL
#include "facets.glsl"

// Kelemen and Szirmay-Kalos (d'Eon and Luebke, GPU Gems 3, chapter 14).
float kelemen(Facets f) { return f.nl * schlick(f.hv, f.f0) * beckmann_without_angles(f.nh, f.m) / f.squared; }

// Clement's four lobes. Where his table has m, Beckmann has m^2: these are the roots.
const vec4 clement_slopes = vec4(1.0, 0.34641016, 0.15165751, 0.10954451);
const vec4 clement_weights = vec4(1.0, 0.625, 0.075, 0.005);

vec4 four_beckmann(float nh, vec4 m) {
  float squared = max(nh * nh, 1e-7), tangent = max((1.0 - nh) * (1.0 + nh), 0.0) / squared;
  vec4 rough = m * m;
  return exp(-tangent / rough) / (rough * squared * squared);
}
float four_lobes_printed(Facets f) {
  vec4 lobes = four_beckmann(f.nh, clement_slopes * f.m);
  return f.nl * schlick(f.hv, f.f0) * dot(lobes, clement_weights) / f.squared;
}
float four_lobes(Facets f) { return four_lobes_printed(f) / 1.705; }  // weights that sum to 1

#ifdef BECKMANN_TABLE
layout(binding = 11) uniform sampler2D beckmann_table;  // 0.5 PH^0.1 of the four lobes, over N.H and the slope
const float table_texels = float(BECKMANN_TABLE);

float table_lobes(Facets f, vec2 place) {
  vec4 root = 2.0 * texture(beckmann_table, place), squared = root * root, fourth = squared * squared;
  return f.nl * schlick(f.hv, f.f0) * dot(fourth * fourth * squared, clement_weights) / (1.705 * f.squared);
}
// The first and the last texel's centres hold the ends of the range.
float four_lobes_table(Facets f) { return table_lobes(f, (vec2(f.nh, f.m) * (table_texels - 1.0) + 0.5) / table_texels); }
// As printed: the coordinate is the value, so that N.H = 1 falls half a texel behind the last centre.
float four_lobes_table_printed(Facets f) { return table_lobes(f, vec2(f.nh, f.m)); }
#endif

// Two lobes of Blinn and Phong (Drobot, "Skin rendering", 2011), with Schlick's factor and Hoffman's (n + 8) / 8, half and
// half.
float blinn_phong_pair(Facets f) {
  vec2 power = 2.0 / (f.m * f.m * vec2(1.0, 0.15)) - 2.0;
  return f.nl * schlick(f.hv, f.f0) * dot(exp2(power * log2(max(f.nh, 1e-6))) * (power + 8.0) / 8.0, vec2(0.5));
}

// Cook and Torrance with Beckmann's distribution.
float cook_torrance(Facets f) {
  float valley = 2.0 * f.nh / max(f.hv, 1e-4), shadowed = min(1.0, valley * min(f.nl, f.nv));
  return schlick(f.hv, f.f0) * shadowed * beckmann_without_angles(f.nh, f.m) / (4.0 * max(f.nv, 0.02));
}

// Two lobes of GGX, 0.75 and 1.30 times as rough, mixed by 0.85, as Unreal's subsurface profiles have them; Smith's joint term.
float ggx(Facets f, float a) {
  float squared = a * a, d = (f.nh * squared - f.nh) * f.nh + 1.0;
  float joint = f.nl * sqrt(f.nv * f.nv * (1.0 - squared) + squared) + f.nv * sqrt(f.nl * f.nl * (1.0 - squared) + squared);
  return f.nl * schlick(f.hv, f.f0) * squared / (d * d) * 0.5 / max(joint, 1e-4);
}
float ggx_pair(Facets f) {
  float rough = sqrt(f.m);  // Unreal's roughness: its square is the slope
  float sharp = 0.75 * rough, wide = min(1.3 * rough, 1.0);
  return mix(ggx(f, wide * wide), ggx(f, sharp * sharp), 0.85);
}

#endif
