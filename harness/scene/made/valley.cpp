// SPDX-License-Identifier: Apache-2.0
// See valley.h.
#include "harness/scene/made/valley.h"

#include "harness/scene/made/fog_valley.h"

namespace lamina {

Scene make_valley(float time_s) {
  Scene scene = make_fog_valley(time_s);
  scene.background = glm::vec3(0);  // space: the air before it is the sky
  Keys& air = scene.said["atmosphere"];
  // Above the air the sun is as bright as day.h's; on the ground day.h's own light stays, so that the valley looks as it does
  // in its other scenes.
  for (const char* channel : {"sun.red", "sun.green", "sun.blue"}) air.values[channel] = {1.6};
  air.values["mie.amount"] = {6.0};
  scene.views = {{"valley", {200, 620, 2250}, {-170, 390, -300}, {0, 1, 0}, 45},
                 {"into_the_sun", {-1790, 620, -300}, {-900, 560, 0}, {0, 1, 0}, 50},
                 {"above", {-300, 2900, 2700}, {0, 200, 150}, {0, 1, 0}, 42}};
  for (View& view : scene.views) view.near_m = 20, view.far_m = 12000;
  return scene;
}

}  // namespace lamina
