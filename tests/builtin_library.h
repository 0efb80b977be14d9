// SPDX-License-Identifier: Apache-2.0
// The built-in effects with their code, as every command has them.
#pragma once

#include "harness/manifest/library.h"

namespace lamina {

inline const Library& builtin_library() {
  static const Library loaded = load_library(LAMINA_SOURCE_DIR, effect_code());
  return loaded;
}

}  // namespace lamina
