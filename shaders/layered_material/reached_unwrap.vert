// SPDX-License-Identifier: Apache-2.0
// Draws a mesh unwrapped, as common/unwrap.vert, but only what the eye may see: triangles whose every vertex is turned away from it by
// more than a margin are culled, by a depth in front of the near plane. What is just behind the silhouette still has to be lit:
// taps reach across it, and mapped normals bend rays there.
#include "../common/frame.glsl"
#include "../common/mesh_out.glsl"

layout(constant_id = 0) const float margin = 0.3;  // sine of the angle beyond the silhouette, as the vertices' normals say it

void main() {
  write_surface();
  float towards_eye = dot(normalize(out_normal), normalize(eye_world.xyz - out_position));
  gl_Position = vec4(uv * 2.0 - 1.0, clamp(0.5 * (towards_eye + margin), -1.0, 1.0), 1.0);
}
