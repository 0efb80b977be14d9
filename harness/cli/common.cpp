// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>

#include "harness/cli/commands.h"

namespace lamina {

std::filesystem::path home_folder() {
  const char* home = std::getenv("LAMINA_HOME");
  return home && *home ? home : LAMINA_SOURCE_DIR;
}

Library load_library_for(const SceneOptions& options) { return load_library(home_folder(), options.variants_dirs); }

Scene load_scene_for(const SceneOptions& options) {
  Scene scene = load_scene(options.scene, options.time_s);
  if (scene.objects.empty()) throw Error(ErrorKind::bad_input, "scene", scene.source, "has no objects");
  if (scene.views.empty()) throw Error(ErrorKind::bad_input, "scene", scene.source, "has no views");
  return scene;
}

}  // namespace lamina
