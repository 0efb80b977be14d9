// SPDX-License-Identifier: Apache-2.0
// Penner's table over N.L and curvature ("Pre-Integrated Skin Shading", SIGGRAPH 2011 course), with blended normals: red sees
// the vertex normal most.
#ifdef PREINTEGRATED
layout(binding = 9) uniform sampler2D preintegrated_table;
vec3 preintegrated(SkinPoint point, vec3 to_light, float lit) {
  float coarse = dot(point.smooth_normal, to_light), fine = dot(point.normal, to_light);
  vec3 c = mix(vec3(fine), vec3(coarse), vec3(0.7, 0.2, 0.1));
  float row = clamp(in_curvature * 4.0, 0.0, 1.0);  // the table ends at R = 4 mm
  vec2 size = vec2(textureSize(preintegrated_table, 0));
  vec3 sum;
  for (int i = 0; i < 3; ++i) sum[i] = texture(preintegrated_table, (vec2(c[i] * 0.5 + 0.5, row) * (size - 1.0) + 0.5) / size)[i];
  return point.albedo * lit * sum;
}
#endif
