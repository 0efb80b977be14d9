// SPDX-License-Identifier: Apache-2.0
// Random small scenes, as scene files with a model beside them: what effects declare says what may be written, so an effect
// that is added is in them. A scene that fails a test is shrunk: what it fails without is left away, piece by piece.
#pragma once

#include <functional>
#include <random>

#include "harness/manifest/library.h"
#include "harness/scene/scene.h"

namespace lamina {

struct RandomScene {
  enum class Kind { object, light, view, effect };
  struct Piece {
    Kind kind = Kind::object;
    std::string head;                // "[objects.a]"
    std::vector<std::string> lines;  // "thickness = 3"
    std::string name, mesh;          // of an object
  };
  uint64_t seed = 0;
  std::vector<std::string> head;  // of [scene], without the model
  std::vector<Piece> pieces;

  // The scene file; `model`: the path of its model.
  std::string text(const std::string& model) const;
};

RandomScene random_scene(uint64_t seed, const Library& library);

// Writes scene.toml, model.gltf and model.bin into the folder and loads the scene.
Scene load_random(const RandomScene& scene, const std::filesystem::path& folder, const Library& library);

// The smallest scene found for which `fails` says true, as it does for this one: pieces are left away, then lines, while it
// does. `fails` is never asked for a scene without objects.
RandomScene shrunk(RandomScene scene, const std::function<bool(const RandomScene&)>& fails);

}  // namespace lamina
