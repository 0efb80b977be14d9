// SPDX-License-Identifier: Apache-2.0
// One channel of three transparent layers over a background of 0, by ways that need no order. Layer i has the opacity a, the
// colour c and the view depth z first + i * step (metres); opacities and colours change from layer to layer as the definition
// of layer_at() says. Sums in 32-bit floats, or as 16-bit targets keep them.
#include "../transparency/moments.glsl"
#include "../transparency/weights.glsl"

const int layer_count = 3;
const float layers_near = 0.1, layers_far = 500.0;

struct MadeLayer {
  float alpha, color, z, window;
};

MadeLayer layer_at(int i, float alpha, float change, float color, float first, float step) {
  float z = first + float(i) * step;
  float window = layers_far / (layers_far - layers_near) * (1.0 - layers_near / z);
  return MadeLayer(clamp(alpha + float(i) * change, 0.0, 1.0), i == 1 ? 1.0 - color : color, z, window);
}

float as_half(float x) { return unpackHalf2x16(packHalf2x16(vec2(x, 0.0))).x; }

// Front to back.
float sorted_layers(float alpha, float change, float color, float first, float step) {
  float sum = 0.0, through = 1.0;
  for (int i = 0; i < layer_count; ++i) {
    MadeLayer layer = layer_at(i, alpha, change, color, first, step);
    sum += through * layer.alpha * layer.color;
    through *= 1.0 - layer.alpha;
  }
  return sum;
}

#define WEIGHTED(NAME, WEIGHT_OF, KEPT)                                                     \
  float NAME(float alpha, float change, float color, float first, float step) {             \
    float sum = 0.0, weights = 0.0, covering = 0.0;                                         \
    for (int i = 0; i < layer_count; ++i) {                                                 \
      MadeLayer layer = layer_at(i, alpha, change, color, first, step);                     \
      float weight = layer.alpha * WEIGHT_OF(layer.alpha, layer.z, layer.window) / 32.0;    \
      sum = KEPT(sum + KEPT(layer.color * weight));                                         \
      weights = KEPT(weights + KEPT(weight));                                               \
      covering = KEPT(layer.alpha + covering * (1.0 - layer.alpha));                        \
    }                                                                                       \
    return weights > 0.0 ? sum / weights * covering : 0.0;                                  \
  }
WEIGHTED(weighted_7, weight_equation_7, float)
WEIGHTED(weighted_8, weight_equation_8, float)
WEIGHTED(weighted_9, weight_equation_9, float)
WEIGHTED(weighted_10, weight_equation_10, float)
WEIGHTED(weighted_saturated, weight_saturated, float)
WEIGHTED(weighted_average, weight_average, float)
WEIGHTED(half_weighted_7, weight_equation_7, as_half)
WEIGHTED(half_weighted_8, weight_equation_8, as_half)
WEIGHTED(half_weighted_9, weight_equation_9, as_half)
WEIGHTED(half_weighted_10, weight_equation_10, as_half)

float four_moments(float alpha, float change, float color, float first, float step) {
  float total = 0.0;
  vec4 moments = vec4(0.0);
  for (int i = 0; i < layer_count; ++i) {
    MadeLayer layer = layer_at(i, alpha, change, color, first, step);
    float depth = moment_depth(layer.z, layers_near, layers_far), absorbance = absorbance_of(layer.alpha), squared = depth * depth;
    total += absorbance;
    moments += absorbance * vec4(depth, squared, squared * depth, squared * squared);
  }
  if (total == 0.0) return 0.0;
  float sum = 0.0, weights = 0.0;
  for (int i = 0; i < layer_count; ++i) {
    MadeLayer layer = layer_at(i, alpha, change, color, first, step);
    float depth = moment_depth(layer.z, layers_near, layers_far);
    float weight = layer.alpha * moment_transmittance(total, moments / total, depth, 5e-5, 0.25);
    sum += layer.color * weight, weights += weight;
  }
  return sum / weights * (1.0 - exp(-total));
}

// The nearest layer alone.
float nearest_layer(float alpha, float change, float color, float first, float step) {
  MadeLayer layer = layer_at(0, alpha, change, color, first, step);
  return layer.alpha * layer.color;
}

// By the function that COMPOSITING names.
#ifdef COMPOSITING
float compositing(float alpha, float change, float color, float first, float step) {
  return COMPOSITING(alpha, change, color, first, step);
}
#endif
