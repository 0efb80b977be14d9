// SPDX-License-Identifier: Apache-2.0
// No diffusion.
vec3 lambert(SkinPoint point, vec3 to_light, float lit) { return point.albedo * (lit * max(dot(point.normal, to_light), 0.0)); }
