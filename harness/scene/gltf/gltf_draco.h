// SPDX-License-Identifier: Apache-2.0
// KHR_draco_mesh_compression (Khronos Group's registry of glTF extensions, 2018): primitives whose triangles and attributes lie
// compressed in a buffer view, as a stream of the Draco bitstream 2.2.
#pragma once

#include <tiny_gltf.h>

namespace lamina {

// Decodes every such primitive: its accessors then read buffers of their own. Throws Error(bad_input) naming the mesh where the
// stream is broken or does not hold what the accessors describe. What a stream claims is held against its length and the
// accessors before it is decoded.
void decompress_meshes(tinygltf::Model& model);

}  // namespace lamina
