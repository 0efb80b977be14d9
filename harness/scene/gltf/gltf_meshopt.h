// SPDX-License-Identifier: Apache-2.0
// EXT_meshopt_compression (Arseny Kapoulkine, Khronos Group's registry of glTF extensions, 2021): buffer views whose bytes lie
// compressed in another buffer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace lamina {

// A buffer view as the extension describes it.
struct CompressedView {
  enum class Mode : uint8_t { attributes, triangles, indices } mode = Mode::attributes;
  enum class Filter : uint8_t { none, octahedral, quaternion, exponential } filter = Filter::none;
  size_t view = 0;                           // the buffer view that it stands in for
  size_t buffer = 0, offset = 0, bytes = 0;  // where its compressed bytes lie
  size_t count = 0, stride = 0;              // elements, and bytes of each
};

// What the file says of such views, checked against what each kind may hold, and taken out of its JSON. Buffers that only stand
// in for them and hold nothing are replaced by ones of a byte, as they have no file. Throws Error(bad_input) about `subject`.
std::vector<CompressedView> take_compressed_views(nlohmann::json& root, const std::string& subject, bool has_binary);

// Puts each view's bytes into a buffer of its own, to which the view then refers. Throws Error(bad_input) naming the buffer
// view where its stream is broken, or is too short for what the view claims to hold: no more memory is asked for than its bytes
// can fill.
void decompress_views(tinygltf::Model& model, const std::vector<CompressedView>& views, const std::string& subject);

}  // namespace lamina
