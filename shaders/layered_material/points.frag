// SPDX-License-Identifier: Apache-2.0
// For the truth: where each pixel's surface is, its tangent frame, its footprint in texture coordinates, and the outer
// layer as it is filtered here.
#define OBJECT_MEMBERS ivec4 object_place;
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"

layout(binding = 5) uniform sampler2D outer_normal;
layout(binding = 6) uniform sampler2D outer_albedo;
layout(location = 0) out vec4 out_point;   // world; alpha: the object's place + 1
layout(location = 1) out vec4 out_along;   // world, dP/du of the tangent frame; alpha: handedness
layout(location = 2) out vec4 out_normal;  // world
layout(location = 3) out vec4 out_uv;
layout(location = 4) out vec4 out_steps;   // of the texture coordinates, to the pixel on the right and to the one below
layout(location = 5) out vec4 out_outer;   // colour and transparency, as they are filtered
layout(location = 6) out vec4 out_mapped;  // tangent space, as it is filtered

void main() {
  SurfacePoint point = surface_point();
  out_point = vec4(point.position, float(object_place.x + 1));
  out_along = vec4(point.world_from_tangent[0], in_tangent.w < 0.0 ? -1.0 : 1.0);
  out_normal = vec4(point.normal, 0.0);
  out_uv = vec4(point.uv, 0.0, 0.0);
  out_steps = vec4(dFdx(point.uv), dFdy(point.uv));
  out_outer = texture(outer_albedo, point.uv);
  out_mapped = vec4(decode_normal(texture(outer_normal, point.uv).xyz), 0.0);
}
