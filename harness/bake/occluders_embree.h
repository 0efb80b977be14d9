// SPDX-License-Identifier: Apache-2.0
// Embree's side of Occluders, for those who call Embree themselves (its benchmark).
#pragma once

#include "harness/bake/embree_scene.h"
#include "harness/bake/occluders.h"

namespace lamina {

struct Occluders::Handles : EmbreeScene {
  using EmbreeScene::EmbreeScene;
};

}  // namespace lamina
