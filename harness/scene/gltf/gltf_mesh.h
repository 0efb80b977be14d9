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

// `name` is the mesh's, for messages. With `mirrored`, x is negated in space, so that a node whose matrix mirrors can be drawn
// by a matrix that does not, with triangles still counter-clockwise from outside. Nothing where the primitive has no triangles
// (points, lines, degenerate triangles alone): a warning says so. Throws Error(bad_input) naming the mesh, attribute and
// vertex.
std::optional<Mesh> mesh_from_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                        const std::string& name, bool mirrored, std::vector<std::string>& warnings);

}  // namespace lamina
