// SPDX-License-Identifier: Apache-2.0
// Diffuse light of many normals by their mean alone. `mean` is a mean of unit normals, not made unit again: what it lacks in length
// is how much they scatter, 1 - |mean|^2 in all, half of it along each axis across the mean (Michael Toksvig, "Mipmapping Normal
// Maps", NVIDIA 2004). N.L of the normals then has the mean m = mean.L and the variance s^2 = (1 - |mean|^2) / 2 (1 - cos^2), cos of
// the angle between the mean's direction and L; and for a normal distribution the mean of max(N.L, 0) is m P(m/s) + s p(m/s), p
// its density and P its integral.

// Normals in 8 bits are up to 0.007 off unit length: what little scatter that would feign is taken as none.
const float least_scatter = 0.007, sure_scatter = 0.02;

float clamped_mean(float mean, float deviation) {
  float z = mean / max(deviation, 1e-4);
  if (abs(z) > 6.0) return max(mean, 0.0);
  float integral = 1.0 / (1.0 + exp(-z * (1.5957691 + 0.0713548 * z * z)));  // within 2e-4
  return mean * integral + deviation * 0.39894228 * exp(-0.5 * z * z);
}

// As diffuse_light() of surface.glsl. mean_world: world space, at most 1 long.
vec3 mean_diffuse_light(vec3 mean_world, vec3 position) {
  float squared_mean = dot(mean_world, mean_world);
  float scatter = max(1.0 - squared_mean, 0.0);
  scatter *= smoothstep(least_scatter, sure_scatter, scatter);
  vec3 sum = ambient.rgb;
  for (int i = 0; i < light_count.x; ++i) {
    vec3 to_light = light_position[i].xyz - position * light_position[i].w;
    float squared = max(dot(to_light, to_light), 1e-8);
    float falloff = light_position[i].w > 0.0 ? 1.0 / squared : 1.0;
    float cosine = dot(mean_world, to_light) * inversesqrt(squared);
    float across = max(1.0 - cosine * cosine / max(squared_mean, 1e-6), 0.0);
    sum += light_radiance[i].rgb * (clamped_mean(cosine, sqrt(0.5 * scatter * across)) * falloff);
  }
  return sum;
}
