// SPDX-License-Identifier: Apache-2.0
// Files that the scene tests write for themselves: pictures, and glTF models put together accessor by accessor.
#pragma once

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "harness/core/error.h"
#include "tests/folder.h"

namespace lamina {

// 8-bit codes, `channels` a texel.
inline void write_png(const std::filesystem::path& file, int width, int height, int channels,
                      const std::vector<uint8_t>& codes) {
  auto output = OIIO::ImageOutput::create(file.string());
  OIIO::ImageSpec spec(width, height, channels, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  ASSERT_TRUE(output && output->open(file.string(), spec)) << OIIO::geterror();
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, codes.data()));
  ASSERT_TRUE(output->close());
}

// 2 x 1 texels in WebP, lossless, as libwebp encodes them: red, and blue of an opacity of 51 in 255.
inline std::string webp_bytes() {
  return {
      "\x52\x49\x46\x46\x20\x00\x00\x00\x57\x45\x42\x50\x56\x50\x38\x4c\x13\x00\x00\x00\x2f\x01\x00\x00"
      "\x10\x0f\x10\xfb\x3f\xff\xa7\xf9\x8f\x0a\x15\x88\xe8\x7f\x00\x00",
      40};
}

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::string base64(const std::string& bytes) {
  static const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t three = 0;
    for (size_t j = 0; j < 3; ++j) three = three << 8 | (i + j < bytes.size() ? uint8_t(bytes[i + j]) : 0u);
    for (size_t j = 0; j < 4; ++j) text += i + j <= bytes.size() ? digits[three >> (18 - 6 * j) & 63u] : '=';
  }
  return text;
}

// A .glb of its JSON and its binary chunk, whose length is a multiple of 4.
inline std::string glb_of(std::string json, const std::string& binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto word = [](size_t value) {
    const auto number = static_cast<uint32_t>(value);
    return std::string(reinterpret_cast<const char*>(&number), 4);
  };
  return "glTF" + word(2) + word(28 + json.size() + binary.size()) + word(json.size()) + "JSON" + json + word(binary.size()) +
         std::string("BIN\0", 4) + binary;
}

// A model under construction. Every add_* returns the index of what it added.
class GltfMaker {
 public:
  template <class Number>
  int add_accessor(const std::vector<Number>& values, int components, int component_type, const std::string& members = "") {
    static const char* types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    std::string bytes(values.size() * sizeof(Number), '\0');
    if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    accessors.push_back(fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"{}"{}}})", add_view(bytes),
                                    component_type, values.size() / size_t(components), types[components], members));
    return static_cast<int>(accessors.size()) - 1;
  }
  int add_floats(const std::vector<float>& values, int components) { return add_accessor(values, components, 5126); }
  int add_view(const std::string& bytes) {
    views.push_back(fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}}})", binary.size(), bytes.size()));
    binary += bytes;
    binary.resize((binary.size() + 3) / 4 * 4);
    return static_cast<int>(views.size()) - 1;
  }
  // `primitives`: JSON objects.
  int add_mesh(const std::string& name, const std::vector<std::string>& primitives) {
    meshes.push_back(fmt::format(R"({{"name":"{}","primitives":[{}]}})", name, fmt::join(primitives, ",")));
    return static_cast<int>(meshes.size()) - 1;
  }
  // The unit square in the plane z = 0 facing +z, v down as in a picture, as a primitive; `members` adds to it, with a comma
  // before each.
  std::string quad(const std::string& members = "") {
    const int positions = add_floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, 3);
    const int normals = add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
    const int uvs = add_floats({0, 1, 1, 1, 1, 0, 0, 0}, 2);
    const int indices = add_accessor(std::vector<uint16_t>{0, 1, 2, 0, 2, 3}, 1, 5123);
    return fmt::format(R"({{"attributes":{{"POSITION":{},"NORMAL":{},"TEXCOORD_0":{}}},"indices":{}{}}})", positions, normals,
                       uvs, indices, members);
  }
  void add_node(const std::string& json) { nodes.push_back(json); }

  std::string json(bool embedded) const {
    std::string text = fmt::format(R"({{"asset":{{"version":"2.0"}},"accessors":[{}],"bufferViews":[{}],"meshes":[{}])",
                                   fmt::join(accessors, ","), fmt::join(views, ","), fmt::join(meshes, ","));
    const std::string uri =
        embedded ? fmt::format(R"("uri":"data:application/octet-stream;base64,{}",)", base64(binary)) : std::string();
    if (!binary.empty()) text += fmt::format(R"(,"buffers":[{{{}"byteLength":{}}}])", uri, binary.size());
    if (!nodes.empty()) text += fmt::format(R"(,"nodes":[{}])", fmt::join(nodes, ","));
    return text + more + "}";
  }
  std::string glb() const { return glb_of(json(false), binary); }

  std::vector<std::string> accessors, views, meshes, nodes;
  std::string binary;
  std::string more;  // members of the file itself, each with a comma before it
};

// Expects Error(bad_input) whose text holds all of `parts`.
inline void expect_refused(const std::function<void()>& action, const std::vector<std::string>& parts) {
  try {
    action();
    ADD_FAILURE() << "nothing was refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    for (const std::string& part : parts)
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << "'" << error.what() << "' lacks '" << part << "'";
  }
}

}  // namespace lamina
