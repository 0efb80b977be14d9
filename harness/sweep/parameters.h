// SPDX-License-Identifier: Apache-2.0
// Every number of a scene, and every parameter of a variant, by its path: what a sweep may set, within which range, in which
// unit. Numbers of the scene are set on a copy of it as it was loaded.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/manifest/library.h"
#include "harness/scene/scene.h"

namespace lamina {

struct Parameter {
  std::string path;         // "objects.heart.thickness", "scene.time", "VARIANT.PARAMETER"
  std::string unit, title;  // unit "" for a pure number
  double min = 0, max = 0;
  bool or_zero = false;            // 0 is allowed beside the range
  bool whole = false;              // takes whole numbers alone
  std::vector<std::string> words;  // not empty: the value is the place of one of these words
  bool moves = false;              // objects or cameras
  std::optional<double> value;     // in the scene as it is; absent where it is not one number (a map, objects that differ)
  // Sets it in a scene with the same objects, lights and views; empty for scene.time, which load_scene() takes, and for
  // parameters of variants, which their shaders take.
  std::function<void(Scene&, double)> set;
};

inline constexpr const char* time_path = "scene.time";

// In the order of the scene: the scene's own, then objects ("objects.*.NAME" sets all that have it), lights, views; then the
// variants' in the library's order.
std::vector<Parameter> parameters_of(const Scene& scene, const Library& library);

// Throws Error(bad_input, "sweep", ...): for a path that is none, with the nearest; for a value out of its range or not whole.
const Parameter& parameter_named(const std::vector<Parameter>& parameters, const std::string& path);
void check_value(const Parameter& parameter, double value);

}  // namespace lamina
