// SPDX-License-Identifier: Apache-2.0
// What may lie under water: how far it is along the view's axis, which share of its light comes from the sun, the first light of the
// scene, and its light in the air, as plain diffuse surfaces have it. Sun and sky lose their light over different ways in water, and
// waves gather the sun's alone. What stands over the water is left out: it hides nothing from a ray that is refracted. HIDDEN: the
// nearest surface some way behind what that picture shows, by this much at least, which a ray that bends may see past it.
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "../common/anisotropic.glsl"

layout(location = 0) out vec4 out_below;
#ifndef FRAME_BELOW
layout(binding = 4) uniform sampler2D albedo;
layout(location = 1) out vec4 out_color;
#endif
#ifdef HIDDEN
layout(binding = 7) uniform sampler2D below;
#endif

layout(std140, binding = 3) uniform Effect { float height, wave_1_amplitude, wave_2_amplitude, wave_3_amplitude, wave_4_amplitude; };

void main() {
#ifndef FRAME_BELOW
  // Texels beside the water's edge are looked up too: a little more than the highest crest is kept.
  float highest = wave_1_amplitude + wave_2_amplitude + wave_3_amplitude + wave_4_amplitude;
  // Seen from under the water it is what lies over it.
  float beyond = eye_world.y < height ? height - in_position.y : in_position.y - height;
  if (beyond > 0.03 + highest) discard;
#endif
#ifdef HIDDEN
  float shown = texelFetch(below, ivec2(gl_FragCoord.xy), 0).r;
  if (shown <= 0.0 || 1.0 / gl_FragCoord.w <= shown + float(HIDDEN) * (0.01 * shown + 0.03)) discard;
#endif
  vec3 normal = normalize(in_normal), all = diffuse_light(normal, in_position);
  vec3 sun = light_count.x > 0 ? light_radiance[0].rgb * max(dot(normal, light_position[0].xyz), 0.0) : vec3(0.0);
  sun *= light_position[0].w > 0.0 || light_position[0].y <= 0.0 ? 0.0 : 1.0;
  out_below = vec4(1.0 / gl_FragCoord.w, clamp(sun / max(all, 1e-6), 0.0, 1.0));
#ifndef FRAME_BELOW
  out_color = vec4(anisotropic_texture(albedo, in_uv).rgb * all, 1.0);
#endif
}
