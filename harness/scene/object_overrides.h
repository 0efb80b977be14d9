// SPDX-License-Identifier: Apache-2.0
// What a scene file's [objects.NAME] says about an object, put into effect.
//
//   aperture                a table, even an empty one: apertures instead of layers; see aperture_keys.h
//   apertures = false       no apertures
//   layers = false          no layered material: the object shows its albedo
//   albedo                  FILE or [r, g, b]: what it shows then; colours are linear, 0 to 1
//   thickness, scattering   as LayeredMaterial: texels of the inner layer; radius of the blur per texel of thickness
//   position (metres), rotation_degrees, scale
//                           on top of the object's own place: scaled, turned about x, then y, then z, then moved
//   outer.albedo            FILE or [r, g, b]
//   outer.normal            FILE: tangent space, green up the image, as glTF's
//   outer.transparency      FILE, its red channel, or a number from 0 to 1
//   inner.albedo            FILE or [r, g, b]
//
// Files are relative to the scene file. A new outer albedo keeps the transparency that was there. A new inner albedo keeps the
// thickness as a share of its width; one colour is spread over the old one's size.
#pragma once

#include "harness/core/toml_table.h"
#include "harness/scene/scene.h"

namespace lamina {

// Objects that no entry names stay as they are; "*" holds for all, before the entries that name one. What "*" says about layers
// goes to the objects that have them; an entry that names an object without layers must give outer.albedo and so makes them.
// Layers and apertures exclude each other: an entry that speaks of both is refused, and one that gives an object layers takes
// its apertures away. Throws Error(bad_input) with file and line.
void override_objects(std::vector<Object>& objects, const TomlTable& root, const std::filesystem::path& folder);

}  // namespace lamina
