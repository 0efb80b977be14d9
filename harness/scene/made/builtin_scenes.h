// SPDX-License-Identifier: Apache-2.0
// The scenes that are made by code, by name; builtin_scenes() of scene.h lists them.
#pragma once

#include <string>

#include "harness/scene/scene.h"

namespace lamina {

// A built-in scene as it comes. Throws Error(bad_input) for an unknown name or a time that is not finite.
Scene read_builtin(const std::string& name, float time_s);

}  // namespace lamina
