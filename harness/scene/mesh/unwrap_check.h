// SPDX-License-Identifier: Apache-2.0
// Whether a mesh can be drawn into its own texture: its texture coordinates must fill one tile at most, and should use no texel
// twice.
#pragma once

#include <map>
#include <string>

#include "harness/scene/scene.h"

namespace lamina {

// Of a tile: exporters round borders, and a texel of a 1024 texture is as wide.
inline constexpr float tile_tolerance = 1e-3f;
// The overlap_fraction() above which a map over the unwrap is warned of, or not made.
inline constexpr double worrying_overlap = 0.02;

// Moves texture coordinates by whole tiles, the same for all vertices, so that they lie in the unit square where they span no
// more than that.
void move_to_unit_tile(Mesh& mesh);

// Whether the object's pictures are the same in every tile: none of its textures holds or mirrors its borders.
bool pictures_repeat(const Object& object);

// The share of the surface (by area in space) whose texture coordinates have no area: a triangle that gets less than a
// ten-thousandth of the texels that an even unwrap of the same texture would give it. 1 where nothing has any.
double share_without_texels(const Mesh& mesh);
inline constexpr double max_share_without_texels = 0.01;

// Empty, or why the mesh cannot be drawn unwrapped: its texture coordinates leave the unit square by more than a thousandth, or
// leave more than max_share_without_texels of its surface without texels, such as a palette's, where a face is one point.
std::string unwrap_problem(const Mesh& mesh);

// The share of texels covered by more than one triangle, among those covered by any; 0 where none is covered. Counted on 512 x
// 512 texels at their centres, with the top-left rule, so that neighbours in the unwrap share no texel.
double overlap_fraction(const Mesh& mesh);

// The same, counted once for all meshes with the same unwrap: many objects may be of one.
class OverlapFractions {
 public:
  double of(const Mesh& mesh);

 private:
  std::map<std::string, double> known_;  // by a hash of texture coordinates and triangles
};

// What to say of an object whose unwrap is used: of an overlap above worrying_overlap; else "".
std::string overlap_warning(const Object& object, OverlapFractions& overlaps);

}  // namespace lamina
