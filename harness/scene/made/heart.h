// SPDX-License-Identifier: Apache-2.0
// The built-in scene `heart`: an organ-like mesh with a unique unwrap and muscle, membrane and vein textures, all made by code,
// beating over time so that the thickness between the layers changes. After Oat, "Rendering Gooney Materials with Multiple
// Layers", SIGGRAPH 2006 course, chapter 4, figures 1, 2 and 11.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

struct HeartOptions {
  float time_s = 0;
  uint32_t texture_size = 1024;  // texels on a side of every layer's base level, a power of two from 64 to 4096
};
// Any finite time, negative ones too; the beat repeats. Throws Error(bad_input) for a time that is not finite or another size.
Scene make_heart(const HeartOptions& options);

}  // namespace lamina
