// SPDX-License-Identifier: Apache-2.0
// Uniform layers one over the other, and what they show by closed forms.
#pragma once

#include <string>
#include <vector>

#include "tests/graph/quad_scene.h"

namespace lamina {

struct UniformLayer {
  float albedo, opacity;
};
inline EffectValues& stack_of(Scene& scene) { return scene.objects[0].effects.at("layered_material"); }

inline Texture layer_texture(const UniformLayer& sheet) {
  return make_texture("sheet",
                      filled(64, [&](uint32_t, uint32_t) { return glm::vec4(glm::vec3(sheet.albedo), 1 - sheet.opacity); }),
                      TexelMeaning::colour);
}

// Uniform sheets under light of 1 from all around, seen straight on.
inline Scene stack_scene(const std::vector<UniformLayer>& sheets, float shadowing) {
  Scene scene = quad_scene({5, 1 - sheets[0].opacity, glm::vec3(sheets[0].albedo)});
  EffectValues& layers = stack_of(scene);
  layers.textures["inner_albedo"] = layer_texture(sheets[1]);
  for (size_t n = 3; n <= 6; ++n) {
    layers.textures["layer_" + std::to_string(n) + "_albedo"] =
        layer_texture(n <= sheets.size() ? sheets[n - 1] : UniformLayer{0, 1});
    layers.numbers["layer_" + std::to_string(n) + "_distance"] = float(n);
  }
  layers.numbers["layer_count"] = float(sheets.size());
  layers.numbers["shadowing"] = shadowing;
  return scene;
}

// What the rule gives: seen through transparencies, lit through them too.
inline double single_bounce(const std::vector<UniformLayer>& sheets, double shadowing) {
  double seen = 0, through = 1, light = 1;
  for (size_t n = 0; n < sheets.size(); ++n) {
    const double opacity = n + 1 == sheets.size() ? 1 : sheets[n].opacity;
    seen += through * opacity * sheets[n].albedo * light;
    through *= 1 - opacity;
    light *= 1 - shadowing * opacity;
  }
  return seen;
}

// All bounces between the sheets, by adding from the bottom up: R + t^2 R' / (1 - R R').
inline double all_bounces(const std::vector<UniformLayer>& sheets) {
  double below = sheets.back().albedo;
  for (size_t n = sheets.size() - 1; n-- > 0;) {
    const double reflected = sheets[n].opacity * sheets[n].albedo, through = 1 - sheets[n].opacity;
    below = reflected + through * through * below / (1 - reflected * below);
  }
  return below;
}

}  // namespace lamina
