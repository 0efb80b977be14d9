// SPDX-License-Identifier: Apache-2.0
// Clement's layers: light wrapped for the epidermis and the subdermis, .5, .3 and .2 of the diffuse, epidermal and subdermal
// maps. SHADOWS names what shadows do to each layer.
const vec3 layer_weights = vec3(0.5, 0.3, 0.2);
const vec3 layer_wraps = vec3(0.0, 0.85, 0.75);

// As it is.
vec3 plain_shadow(float lit, vec2 power) { return vec3(lit); }
// Powers for red and for the rest, where `power.x` is the smaller; a quarter of the chroma is left. The slides' luminance sums
// to 1.03; .30 is meant.
vec3 sharpened_shadow(float lit, vec2 power) {
  vec2 sharp = lit > 0.0 ? exp2(power * log2(max(lit, 1e-30))) : vec2(0.0);
  vec3 both = mix(vec3(sharp.y), vec3(sharp.x), diffusion * vec3(1.0, 0.5, 0.5));
  return clamp(mix(both, vec3(dot(both, vec3(0.30, 0.59, 0.11))), 0.75), 0.0, 1.0);
}
// One blended shadow for all layers.
vec3 blended_shadow(float lit, vec2 power) { return sharpened_shadow(lit, vec2(1.0, 2.0)); }

vec3 layers(SkinPoint point, vec3 to_light, float lit, vec3 share) {
  vec3 wrapped = max(dot(point.normal, to_light) + layer_wraps, 0.0) * layer_weights * share;
  return point.albedo * wrapped.x * SHADOWS(lit, vec2(16.0, 16.0)) +
         with_melanin(texture(skin_epidermal, point.uv).rgb) * wrapped.y * SHADOWS(lit, vec2(4.0, 8.0)) +
         with_melanin(texture(skin_subdermal, point.uv).rgb) * wrapped.z * SHADOWS(lit, vec2(1.0, 2.0));
}
// As printed: the weights sum to 1, the wraps do not.
vec3 clement_layers_printed(SkinPoint point, vec3 to_light, float lit) {
  return layers(point, to_light, lit, 1.0 / (1.0 + layer_wraps));
}
// Each wrapped layer with Lambert's energy.
vec3 clement_layers(SkinPoint point, vec3 to_light, float lit) {
  return layers(point, to_light, lit, 1.0 / ((1.0 + layer_wraps) * (1.0 + layer_wraps)));
}

// Highlights take the diffuse layer's shadow, or light bleeds into shadows.
float sharp_highlight(float lit) { return lit > 0.0 ? exp2(16.0 * log2(max(lit, 1e-30))) : 0.0; }
