// SPDX-License-Identifier: Apache-2.0
// One glTF primitive as a mesh: triangles from lists, strips and fans, indices of any type or none, checked attributes, normals
// and tangents made where there are none, mirrored where the node mirrors it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/scene/gltf/gltf_file.h"
#include "harness/scene/scene.h"

namespace lamina {

// How a primitive is used where it stands.
struct PrimitiveUse {
  std::string name;  // the mesh's, for messages
  bool mirrored = false;
  int uv_set = 0;                     // TEXCOORD_n of its textures; where the primitive has no such set, the first that it has
  glm::dmat3 texture_from_uv{1};      // KHR_texture_transform
  bool double_sided = false;          // an open surface gets a second one for its back
  std::vector<double> morph_weights;  // of its targets; fewer: the rest is 0
  std::vector<glm::dmat4> world_from_bind;  // of each joint; empty: it has no skin
};

struct GltfMesh {
  Mesh mesh;
  std::vector<glm::vec4> colours;  // COLOR_0 of each vertex, linear; empty: it has none
  bool has_uv = true;
};

// With `mirrored`, x is negated in space, so that a node whose matrix mirrors can be drawn by a matrix that does not, with
// triangles still counter-clockwise from outside. Nothing where the primitive has no triangles (points, lines, degenerate
// triangles alone, no POSITION): a warning says so. Throws Error(bad_input) naming the mesh, attribute and vertex.
std::optional<GltfMesh> mesh_from_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                            const PrimitiveUse& use, std::vector<std::string>& warnings);

}  // namespace lamina
