// SPDX-License-Identifier: Apache-2.0
// The mirror's picture from a pyramid of it, by five look-ups along the way in which it is stretched. Each stands for a fifth of
// the facets by their lean, at that fifth's mean in a Gaussian (0, 0.532 and 1.400 standard deviations), and is as blurred as
// facets spread across. What fifths leave between them is 0.32 deviations; a look-up is as blurred at least.
#include "spread.glsl"
#include "picture_pyramid/levels.glsl"

layout(location = 0) out vec4 out_color;

void main() {
  SurfacePoint at = surface_point();
  vec3 to_eye = normalize(eye_world.xyz - at.position);
  SeenFacets seen = seen_facets(at, to_eye);
  Spread spread = spread_of(at, to_eye, seen);
#ifdef ROUGH
  float own_depth = view_depth_of(at.position), start = max(depth_at(own_place()), own_depth);
  float along = max(spread.axes_px.x, 1e-6), px = clamp(spread.axes_px.y, 0.32 * along, max(spread.px, 0.32 * along));
  float reach = sqrt(max(1.0 - px * px / (along * along), 0.0) / 0.897) * seen.along;
  vec3 sum = vec3(0.0);
  for (int i = -2; i <= 2; ++i) {
    float fifth = float(sign(i)) * (abs(i) == 2 ? 1.4 : 0.532);
    vec2 uv = landing(reflected_by(at, to_eye, vec2(seen.lean + reach * fifth, 0.0)), start);
    uv = mix(spread.uv, uv, step(own_depth, depth_at(uv)));
    sum += from_levels(Spread(uv, spread.axes_px, px), own_depth);
  }
  vec3 reflected = sum / 5.0;
#else
  vec3 reflected = textureLod(pyramid, spread.uv, 0.0).rgb;
#endif
  out_color = vec4(light_of_surface(at, to_eye, reflected * middle_share(at, to_eye, seen)), 1.0);
}
