// SPDX-License-Identifier: Apache-2.0
// Cache keys of what follows from a scene: they alone decide whether a sweep may be resumed, what a point must redo, and what
// a cache may give back. Everything that effects declare is in them.
#pragma once

#include <string>

#include "harness/manifest/library.h"
#include "harness/scene/scene.h"

namespace lamina {

// Of all that a picture of the scene follows from: meshes, textures, numbers and words of objects and scene, lights and views.
std::string scene_digest(const Scene& scene);

// Of what is on a device for all frames, and must be made anew where it changes: textures, the sizes of meshes, and what is
// baked. Other numbers are written into uniform blocks.
std::string device_digest(const Scene& scene, const Library& library);

// Of all vertices and indices.
std::string meshes_digest(const Scene& scene);

// Of a texture's texels; found once for each texture.
std::string texture_digest(const Texture& texture);

}  // namespace lamina
