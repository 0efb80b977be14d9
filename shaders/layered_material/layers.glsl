// SPDX-License-Identifier: Apache-2.0
// What the variants of the layered material share: where the eye sees each layer, and how layers are joined. Layer 1 is the outer
// one, layer 2 the inner one, then 3 to 6.
// Source: Chris Oat, "Rendering Gooney Materials with Multiple Layers", SIGGRAPH 2006 course, chapter 4, listings 1 to 3.
//
// Definitions set by the plan, per object:
//   INNER_LAYER    the outer layer lets the inner one show somewhere
//   LAYER_DEPTH    the outer two layers are apart (thickness above 0)
//   LAYER_3 to _6  there are that many layers
//   LAYER_SHADOWS  layers shade what lies below them

layout(std140, binding = 3) uniform Effect {
  float thickness;   // texels of inner_albedo's base level, as all distances: from layer 1 to layer 2
  float scattering;  // radius of the light's blur per texel of depth
  float shadowing;   // share of a layer's opacity that shades what lies below
#ifdef LAYER_3
  float layer_3_distance;  // from layer 2
#endif
#ifdef LAYER_4
  float layer_4_distance;
#endif
#ifdef LAYER_5
  float layer_5_distance;
#endif
#ifdef LAYER_6
  float layer_6_distance;
#endif
};
layout(binding = 4) uniform sampler2D outer_albedo;  // rgb linear; alpha = transparency
layout(binding = 5) uniform sampler2D outer_normal;
layout(binding = 6) uniform sampler2D inner_albedo;  // alpha = transparency, where layers lie below it
#ifdef LAYER_3
layout(binding = 12) uniform sampler2D layer_3_albedo;
#endif
#ifdef LAYER_4
layout(binding = 13) uniform sampler2D layer_4_albedo;
#endif
#ifdef LAYER_5
layout(binding = 14) uniform sampler2D layer_5_albedo;
#endif
#ifdef LAYER_6
layout(binding = 15) uniform sampler2D layer_6_albedo;
#endif

// Depth of a layer below the surface, in texels.
float depth_of(int layer) {
  float depth = 0.0;
  if (layer >= 2) depth += thickness;
#ifdef LAYER_3
  if (layer >= 3) depth += layer_3_distance;
#endif
#ifdef LAYER_4
  if (layer >= 4) depth += layer_4_distance;
#endif
#ifdef LAYER_5
  if (layer >= 5) depth += layer_5_distance;
#endif
#ifdef LAYER_6
  if (layer >= 6) depth += layer_6_distance;
#endif
  return depth;
}

// |T.z| below this is taken as this: the transmission distance is at most 32 thicknesses and stays finite as the transmitted ray
// becomes parallel to the layers, where N.V has already handed the pixel to the outer layer.
const float min_transmission_cosine = 1.0 / 32.0;

struct InnerPoint {
  vec2 uv;                 // where the transmitted ray meets the inner layer
  float distance_texels;   // length of the ray between the layers, in texels of the inner layer
};

// The transmission vector is the view vector reflected about the mapped normal, with z turned down into the material; it meets the
// inner layer after s = d / |T.z| (listing 1, with the texel size of the texture that is bound).
// view_tangent: unit, from the surface to the eye. normal_tangent: unit. texel: size of one texel of the layer in texture coordinates.
InnerPoint inner_point(vec2 uv, vec3 view_tangent, vec3 normal_tangent, float thickness_texels, vec2 texel) {
  vec3 reflected = reflect(-view_tangent, normal_tangent);
  vec3 transmitted = vec3(reflected.xy, -reflected.z);
  float s = thickness_texels / max(abs(transmitted.z), min_transmission_cosine);
  return InnerPoint(uv + s * transmitted.xy * texel, s);
}

// Listing 3 names this channel opacity, but lerps towards the inner layer by it: it is the outer layer's transparency. N.V lets the
// outer layer win at grazing angles.
vec3 join_layers(vec3 outer, vec3 inner, float transparency, float n_dot_v) {
  return mix(outer, inner, transparency * n_dot_v);
}
