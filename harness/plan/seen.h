// SPDX-License-Identifier: Apache-2.0
// Whether a view can see an object at all: boxes against frusta, as U. Assarsson and T. Möller, "Optimized View Frustum Culling
// Algorithms for Bounding Boxes", Journal of Graphics Tools 5(1), 2000, section 3, has it in its plainest form.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// False only where the box around the object's mesh lies wholly outside one of the frustum's six planes. `aspect`: width over
// height of the frame. An object without vertices is seen by no view.
bool may_be_seen(const Object& object, const View& view, double aspect);

}  // namespace lamina
