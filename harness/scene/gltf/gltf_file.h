// SPDX-License-Identifier: Apache-2.0
// A glTF 2.0 file (Khronos Group, "glTF 2.0 Specification", 2021) as tinygltf reads it, and its accessors as numbers, with
// every reference and range checked. Pictures stay encoded: OpenImageIO decodes them, and only those that a scene uses.
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/scene/gltf/gltf_json.h"

namespace lamina {

struct GltfFile {
  tinygltf::Model model;
  AnimatedNodes animated;  // what its animation changes
};

// .glb or .gltf, told apart by their first bytes. With a time, in seconds, its first animation is played to that moment;
// without one its nodes stand as the file places them. What is left out or played is said in `warnings`. Throws
// Error(bad_input) naming the file.
GltfFile read_gltf_file(const std::filesystem::path& file, std::optional<double> time_s, std::vector<std::string>& warnings);

// An accessor's elements one after another, `components` numbers each; normalized integers become 0 to 1 or -1 to 1. Sparse
// accessors are filled in. Throws Error(bad_input) about `subject` where the accessor is missing, has another number of
// components, or leaves its buffer.
std::vector<double> read_accessor(const tinygltf::Model& model, int accessor, int components, const std::string& subject);

// A buffer view's bytes from `offset`. They live as long as the model. Throws Error(bad_input) about `subject`.
std::span<const std::byte> view_bytes(const tinygltf::Model& model, int view, size_t offset, const std::string& subject);

// A picture's encoded bytes. They live as long as the model. Throws Error(bad_input) about `subject`.
std::span<const std::byte> encoded_picture(const tinygltf::Model& model, int image, const std::string& subject);

}  // namespace lamina
