// SPDX-License-Identifier: Apache-2.0
// See fog_heart.h.
#include "harness/scene/made/fog_heart.h"

#include "harness/scene/made/fog_hull.h"
#include "harness/scene/made/heart.h"

namespace lamina {

Scene make_fog_heart(float time_s) {
  Scene scene = make_heart({.time_s = time_s});
  const float turned = 360 * time_s / 20;
  scene.objects.push_back(fog_ball("outer", {0, 0.35f, 0}, {1.35f, 1.2f, 1.25f}, 0.25f));
  scene.objects.push_back(fog_ball("inner", {-0.1f, 0.1f, 0.1f}, {0.95f, 0.75f, 0.95f}, 0.4f));
  scene.objects.push_back(fog_ball("left", {0, -0.72f, 0}, {1.7f, 0.32f, 0.55f}, 1, 35 + turned));
  scene.objects.push_back(fog_ball("right", {0, -0.68f, 0}, {1.7f, 0.30f, 0.55f}, 1, -35 + turned));
  set_fog(scene, 0.9f, {0.30f, 0.36f, 0.42f});
  return scene;
}

}  // namespace lamina
