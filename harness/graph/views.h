// SPDX-License-Identifier: Apache-2.0
// Matrices of the views that a pass may be drawn from: the eye's, a light's, and the eye's in a mirror. Clip space as backend.h
// says: x right, y down, depth 0 to 1, counter-clockwise triangles front.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "harness/scene/default_views.h"
#include "harness/scene/scene.h"

namespace lamina {

struct ViewMatrices {
  glm::mat4 view_from_world{1};
  glm::mat4 clip_from_view{1};
  glm::vec3 eye{0};  // where it is seen from, in world space

  glm::mat4 clip_from_world() const { return clip_from_view * view_from_world; }
};

// The view's own, at the aspect of a picture of this size.
ViewMatrices eye_view(const View& view, uint32_t width_px, uint32_t height_px);

// The light's view of the sphere around everything that casts (radius > 0): a square map that the sphere touches on four sides,
// at depth 0 and at depth 1. It depends only on the light and the sphere, so a map stays valid while the eye moves. A point
// outside the sphere may fall outside the map: it casts no shadow, and is lit unless something in the map lies before it.
//
// A directional light's view is parallel; its eye is where its ray through the centre enters the sphere. A point light's view
// is a square pyramid around the cone of half angle asin(radius / distance); the closer the light is to the sphere, the less
// even its depth is. The light's own size does not count: it is seen from its centre.
//
// None for a point light in the sphere or on it: casters lie all around it, and no single view shows them.
std::optional<ViewMatrices> light_view(const Light& light, const BoundingSphere& casters);

// The points p with dot(normal, p) = height.
struct MirrorPlane {
  glm::vec3 normal{0, 1, 0};  // unit length
  float height = 0;           // metres
};

// What the eye sees in a mirror: the scene from the eye's reflection, cut off at the mirror so that nothing behind it is drawn.
//
// view_from_world reflects, which would turn all triangles; clip_from_view negates x, which turns them back, so that culling
// and gl_FrontFacing stay as they are. The picture is therefore the eye's turned left to right: a point of the mirror stands at
// (-x, y, w) where the eye's clip space has (x, y, w). A reader projects its world position with the mirror's own
// clip_from_world(), as it does with a light's.
//
// The near plane is the mirror itself (Lengyel, "Oblique View Frustum Depth Projection and Clipping", Journal of Game
// Development 1(2), 2005, for depth from 0 to 1): clip z is 0 on the mirror, negative behind it, and grows along every ray from
// the eye's reflection. All before the mirror that the eye's far plane would leave keeps a depth below 1. Depths are of this
// picture alone; they compare with nothing drawn from another view.
//
// A mirror has two faces. It shows the side on which the eye is, whichever way the normal points; an eye in the plane itself
// counts as on the normal's side, where it sees the mirror edge on.
ViewMatrices mirror_view(const View& view, uint32_t width_px, uint32_t height_px, const MirrorPlane& mirror);

}  // namespace lamina
