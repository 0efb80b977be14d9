// SPDX-License-Identifier: Apache-2.0
// A glTF 2.0 file before it is parsed: its JSON (Khronos Group, "glTF 2.0 Specification", 2021), and of that what a scene uses.
// What is not used must not be able to refuse a model: animations that are not played, cameras and extensions that change no
// picture are dropped here, and data URIs are brought into the one form that every parser reads.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/scene/gltf/gltf_animation.h"
#include "harness/scene/gltf/gltf_meshopt.h"

namespace lamina {

// A skin as the file has it; `inverse_bind` is an accessor, or -1: all matrices are the identity (section 3.7.3.1).
struct GltfSkin {
  std::vector<int> joints;
  int inverse_bind = -1;
};

struct GltfSource {
  std::string text;  // with only what is used: JSON, or where there is a binary chunk a whole .glb
  std::vector<GltfSkin> skins;
  std::vector<int> node_skins;  // by node; -1: none
  std::vector<CompressedView> compressed_views;
  std::optional<GltfAnimation> animation;  // the first, where it is played
};

// Throws Error(bad_input) naming the file and what is wrong with the model. `bytes`: the file's. `folder`: beside it lie its
// buffers and pictures. `plays`: its first animation is read.
GltfSource prepared_gltf(const std::string& bytes, const std::string& subject, const std::filesystem::path& folder, bool plays,
                         std::vector<std::string>& warnings);

// Throws Error(bad_input, "gltf", ...) about a part of a model.
[[noreturn]] void refuse_gltf(const std::string& subject, const std::string& message);

}  // namespace lamina
