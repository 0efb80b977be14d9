// SPDX-License-Identifier: Apache-2.0
// What a model's material says, for what effects declare with otherwise = "model. ...".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/scene/effect_values.h"
#include "harness/scene/textures.h"

namespace lamina {

struct ModelLook {
  std::string name;                // "material 'skin'", for messages and labels
  Texels base_colour;              // linear; alpha = opacity, after the cutoff of masks
  bool opaque = true;              // alpha says nothing
  std::optional<Texels> normal;    // n = 2 t - 1, tangent space, y along +v (down)
  std::optional<float> thickness;  // in the mesh's units, > 0

  // Textures made of it, so that objects and effects that ask for the same share one.
  struct Made {
    std::string of;  // what it was asked for
    Texture texture;
  };
  mutable std::vector<Made> made;
};

}  // namespace lamina
