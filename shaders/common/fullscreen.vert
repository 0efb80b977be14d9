// SPDX-License-Identifier: Apache-2.0
// One triangle over the whole target, from the vertex number alone.

void main() {
  vec2 corner = vec2(LAMINA_VERTEX_INDEX == 1 ? 3.0 : -1.0, LAMINA_VERTEX_INDEX == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
}
