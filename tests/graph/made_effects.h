// SPDX-License-Identifier: Apache-2.0
// Effects that a test writes itself: files in a folder of its own, loaded beside the built-in ones, drawn on every backend.
#pragma once

#include "tests/folder.h"
#include "tests/graph/each_backend.h"
#include "tests/graph/quad_scene.h"

namespace lamina {

class MadeEffects : public InFolder<EachBackend> {
 protected:
  // An effect called NAME that objects call for by the key NAME, with more lines of its effect.toml.
  void write_effect(const std::string& name, const std::string& head, const std::string& rest = "") {
    write(name + "/effect.toml",
          "[effect]\nname = \"" + name + "\"\ntitle = \"t\"\nbecause = \"b\"\nnot_because = \"n\"\n" + head + "\n" + rest);
  }
  void write_variant(const std::string& effect, const std::string& name, const std::string& rest, bool baseline = true) {
    write(effect + "/" + name + ".toml",
          "[variant]\nname = \"" + name + "\"\nbaseline = " + (baseline ? "true" : "false") + "\n" + rest);
  }
  Library made() { return load_library(LAMINA_SOURCE_DIR, effect_code(), {folder_}); }

  // A square that fills the frame, at a depth of its own; it has the effects named.
  static Object square(const std::string& name, float z, const std::vector<std::string>& effects) {
    Object object = quad_scene({}).objects[0];
    object.name = name;
    object.effects.erase("layered_material");
    for (const std::string& effect : effects) object.effects[effect];
    for (Vertex& vertex : object.mesh.vertices) vertex.position.z = z, vertex.position.x *= 2, vertex.position.y *= 2;
    return object;
  }
  static Scene squares(std::vector<Object> objects) {
    Scene scene = quad_scene({});
    scene.objects = std::move(objects);
    return scene;
  }

  // The baselines' frame.
  std::unique_ptr<DrawnFrame> drawn(const Library& library, const Scene& scene, const Parameters& parameters = {},
                                    Build build = Build::timed, uint32_t size = 16, const VariantManifest* told = nullptr) {
    return std::make_unique<DrawnFrame>(
        *backend_, library, scene,
        DrawnFrame::Choice{.width = size, .height = size, .parameters = parameters, .told = told, .build = build});
  }
};

// A pass of a manifest: its lines, quoted.
inline std::string pass_text(const std::string& name, const std::string& rest) {
  return "[[pass]]\nname = \"" + name + "\"\n" + rest;
}
// A pass of objects into the frame.
inline std::string objects_pass(const std::string& fragment, const std::string& rest = "") {
  return pass_text("draw", "draw = \"objects\"\nvertex = \"common/object.vert\"\nfragment = \"" + fragment +
                               "\"\nwrite = [\"frame\"]\n" + rest);
}
inline std::string fullscreen_pass(const std::string& name, const std::string& fragment, const std::string& target,
                                   const std::string& rest = "") {
  return pass_text(name, "draw = \"fullscreen\"\nfragment = \"" + fragment + "\"\nwrite = [\"" + target + "\"]\n" + rest);
}

}  // namespace lamina
