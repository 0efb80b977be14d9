// SPDX-License-Identifier: Apache-2.0
// What the three variants of the layered material share: where the eye sees the inner layer, and how the two layers are joined.
// Source: Chris Oat, "Rendering Gooney Materials with Multiple Layers", SIGGRAPH 2006 course, chapter 4, listings 1 to 3.
//
// Definitions set by the plan, per object:
//   INNER_LAYER  the outer layer lets the inner one show somewhere
//   LAYER_DEPTH  the layers are apart (thickness above 0)

layout(std140, binding = 3) uniform Effect {
  float thickness;   // texels of inner_albedo's base level
  float scattering;  // radius of the light's blur per texel of thickness
};
layout(binding = 4) uniform sampler2D outer_albedo;  // rgb linear; alpha = transparency
layout(binding = 5) uniform sampler2D outer_normal;
layout(binding = 6) uniform sampler2D inner_albedo;

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
