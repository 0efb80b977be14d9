// SPDX-License-Identifier: Apache-2.0
// A scene file: a model or a built-in scene, and what differs. TOML; colours are linear.
//
//   [scene]           model = FILE | builtin = NAME; name; time (seconds); background, ambient = [r, g, b]
//   [objects.NAME]    position (metres), rotation_degrees, scale: on top of the object's own place; and the keys that effects
//                     declare for objects: see variants/NAME/effect.toml. "*" holds for all objects, before the entries that
//                     name one.
//   [effects.NAME]    what an effect declares for the whole scene
//   [lights.NAME]     kind = "directional" with direction and angular_radius_degrees (0 to 90, else a point), or "point" with
//                     position and radius (metres, else 0); color = [r, g, b]; intensity; casts = true
//                     for passes with the view of a light
//   [views.NAME]      eye, target, up (metres); fov_y_degrees
//
// Any light replaces all the scene's own, and so does any view.
#pragma once

#include <filesystem>
#include <optional>

#include "harness/manifest/library.h"
#include "harness/scene/scene.h"

namespace lamina {

// What a scene file may hold, with these effects.
TomlFormPtr scene_form(const Library& library);
// The file's scene as far as it says: lights and views are empty where neither it nor its built-in scene has any. `time_s` goes
// before the file's. Throws Error(bad_input), with file and line for what the file itself says.
Scene read_scene_file(const std::filesystem::path& file, const Library& library, std::optional<float> time_s);

// A model's objects, before lights and views: at that time of its first animation, or without one at rest.
Scene read_model(const std::filesystem::path& file, const Library& library, std::optional<float> time_s);

}  // namespace lamina
