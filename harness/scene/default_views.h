// SPDX-License-Identifier: Apache-2.0
// Views, lights and depth ranges that fit what a scene holds, for models that bring none.
#pragma once

#include <vector>

#include "harness/scene/scene.h"

namespace lamina {

struct BoundingSphere {
  glm::vec3 centre{0};
  float radius = 0;  // metres
};

// A sphere around all objects in world space: the middle of their box, and the furthest vertex from it. Throws Error(bad_input)
// where it is not finite.
BoundingSphere bounding_sphere(const std::vector<Object>& objects);

// "front" and "three_quarter" see the whole bounding sphere at any aspect of 1 or wider; "grazing" stands close to the surface
// and looks along it: just outside a plane that touches the objects, at the point where it does. All three are turned to the
// side that is drawn where the surfaces all face away from them.
std::vector<View> default_views(const std::vector<Object>& objects);

// A key and a fill light from afar, and a point light behind, as strong at any size of scene.
std::vector<Light> default_lights(const BoundingSphere& bounds);

// Sets near_m and far_m so that nothing in the sphere is cut off, at any aspect up to 2; nearer than a hundredth of the radius
// counts as touching the eye.
void fit_depth(View& view, const BoundingSphere& bounds);

}  // namespace lamina
