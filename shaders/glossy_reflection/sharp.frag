// SPDX-License-Identifier: Apache-2.0
// The mirror's picture as it is, as if every facet lay in the surface.
#include "facets.glsl"

layout(binding = 5) uniform sampler2D reflection;
layout(location = 0) out vec4 out_color;

void main() {
  SurfacePoint at = surface_point();
  vec3 to_eye = normalize(eye_world.xyz - at.position);
  vec3 reflected = textureLod(reflection, own_place(), 0.0).rgb * reflected_share(dot(at.normal, to_eye));
  out_color = vec4(light_of_surface(at, to_eye, reflected), 1.0);
}
