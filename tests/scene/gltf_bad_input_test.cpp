// SPDX-License-Identifier: Apache-2.0
// Damaged and hostile models: one clear error each, and never a read outside the file's bytes.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "harness/scene/gltf/gltf.h"
#include "tests/scene/made_files.h"

namespace lamina {
namespace {

void load_bytes(const Folder& folder, const std::string& bytes, const std::string& name = "model.glb") {
  load_gltf(folder.write(name, bytes));
}

// A model of one triangle whose parts a test can spoil.
struct Triangle {
  std::vector<float> positions = {0, 0, 0, 1, 0, 0, 1, 1, 0}, uvs = {0, 0, 1, 0, 1, 1}, normals = {0, 0, 1, 0, 0, 1, 0, 0, 1};
  std::vector<uint16_t> indices = {0, 1, 2};
  std::string more_attributes, mode = "4";

  GltfMaker maker() const {
    GltfMaker made;
    const int p = made.add_floats(positions, 3), n = made.add_floats(normals, 3), t = made.add_floats(uvs, 2);
    const int i = made.add_accessor(indices, 1, 5123);
    made.add_mesh("shell",
                  {fmt::format(R"({{"attributes":{{"POSITION":{},"NORMAL":{},"TEXCOORD_0":{}{}}},"indices":{},"mode":{}}})", p,
                               n, t, more_attributes, i, mode)});
    made.add_node(R"({"mesh":0,"name":"body"})");
    return made;
  }
};

void expect_model_refused(const GltfMaker& maker, const std::vector<std::string>& parts) {
  const Folder folder;
  expect_refused([&] { load_bytes(folder, maker.glb()); }, parts);
}

TEST(GltfBadInput, TheUnspoiltTriangleLoads) {
  const Folder folder;
  EXPECT_NO_THROW(load_bytes(folder, Triangle().maker().glb()));
}

TEST(GltfBadInput, NamesMeshAttributeAndVertexOfWhatIsNotFinite) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  Triangle spoilt;
  spoilt.positions[7] = nan;
  expect_model_refused(spoilt.maker(), {"mesh 'shell'", "POSITION", "vertex 2"});
  spoilt = {};
  spoilt.normals[3] = infinity;
  expect_model_refused(spoilt.maker(), {"mesh 'shell'", "NORMAL", "vertex 1"});
  spoilt = {};
  spoilt.uvs[0] = -infinity;
  expect_model_refused(spoilt.maker(), {"mesh 'shell'", "TEXCOORD_0", "vertex 0"});
}

TEST(GltfBadInput, IndexOutOfRange) {
  Triangle spoilt;
  spoilt.indices[2] = 3;
  expect_model_refused(spoilt.maker(), {"mesh 'shell'", "index 3", "3 vertices"});
}

TEST(GltfBadInput, UnequalCountsAndWrongTypes) {
  Triangle spoilt;
  spoilt.uvs = {0, 0, 1, 1};
  expect_model_refused(spoilt.maker(), {"mesh 'shell'", "TEXCOORD_0", "2 vertices", "3"});
  GltfMaker maker = Triangle().maker();
  maker.accessors[2] = maker.accessors[1];  // texture coordinates of three components
  expect_model_refused(maker, {"mesh 'shell'", "TEXCOORD_0", "3 components"});
}

TEST(GltfBadInput, NothingToDraw) {
  Triangle spoilt;
  spoilt.positions = {0, 0, 0, 1, 0, 0, 2, 0, 0};
  expect_model_refused(spoilt.maker(), {"model.glb", "no triangles"});
  spoilt = {};
  spoilt.mode = "1";
  expect_model_refused(spoilt.maker(), {"model.glb", "no triangles"});
  GltfMaker maker = Triangle().maker();
  maker.nodes = {"{}"};
  expect_model_refused(maker, {"model.glb", "no triangles"});
}

TEST(GltfBadInput, AccessorsThatLeaveTheirBuffers) {
  const auto replaced = [](const std::string& from, const std::string& to, std::vector<std::string> GltfMaker::*list,
                           size_t entry) {
    GltfMaker maker = Triangle().maker();
    std::string& text = (maker.*list)[entry];
    text.replace(text.find(from), from.size(), to);
    return maker;
  };
  expect_model_refused(replaced("\"count\":3", "\"count\":4", &GltfMaker::accessors, 0),
                       {"mesh 'shell'", "POSITION", "4 elements"});
  expect_model_refused(replaced("\"count\":3", "\"count\":4000000000", &GltfMaker::accessors, 0), {"POSITION"});
  expect_model_refused(replaced("\"bufferView\":0", "\"bufferView\":99", &GltfMaker::accessors, 0),
                       {"POSITION", "buffer view 99"});
  expect_model_refused(replaced("\"bufferView\":0,", "\"byteOffset\":4000000000,\"bufferView\":0,", &GltfMaker::accessors, 0),
                       {"POSITION"});
  expect_model_refused(replaced("\"buffer\":0", "\"buffer\":7", &GltfMaker::views, 0), {"POSITION", "buffer 7"});
  expect_model_refused(replaced("\"byteLength\":36", "\"byteLength\":4000000000", &GltfMaker::views, 0),
                       {"POSITION", "leaves its buffer"});
  expect_model_refused(replaced("\"byteOffset\":0", "\"byteOffset\":4000000000", &GltfMaker::views, 0),
                       {"POSITION", "leaves its buffer"});
  expect_model_refused(replaced("5126", "5130", &GltfMaker::accessors, 0), {"POSITION", "5130"});
  expect_model_refused(replaced("\"mesh\":0", "\"mesh\":5", &GltfMaker::nodes, 0), {"node 'body'", "mesh 5"});
  expect_model_refused(replaced("\"mesh\":0", "\"children\":[0]", &GltfMaker::nodes, 0), {"model.glb"});
}

TEST(GltfBadInput, NodesThatFormNoTree) {
  GltfMaker maker = Triangle().maker();
  maker.nodes = {R"({"name":"loop","children":[1]})", R"({"children":[0],"mesh":0})"};
  maker.more = R"(,"scene":0,"scenes":[{"nodes":[0]}])";
  expect_model_refused(maker, {"node 'loop'", "twice"});
  maker.nodes = {R"({"children":[8],"mesh":0})"};
  expect_model_refused(maker, {"node 0", "node 8"});
  maker.more = R"(,"scene":3,"scenes":[{"nodes":[0]}])";
  expect_model_refused(maker, {"scene 3"});
  maker.more = "";
  maker.nodes = {R"({"mesh":0,"rotation":[0,0,0,0]})"};
  expect_model_refused(maker, {"node 0", "rotation"});
  maker.nodes = {R"({"mesh":0,"scale":[1e200,1,1]})"};
  expect_model_refused(maker, {"node 0", "not finite"});
}

TEST(GltfBadInput, TruncatedGlb) {
  const Folder folder;
  const std::string whole = Triangle().maker().glb();
  for (const size_t length :
       {size_t{3}, size_t{5}, size_t{15}, size_t{40}, whole.size() / 2, whole.size() - 4, whole.size() - 1})
    expect_refused([&] { load_bytes(folder, whole.substr(0, length)); }, {"model.glb"});
  expect_refused([&] { load_bytes(folder, whole.substr(0, whole.size() - 8)); },
                 {"truncated", std::to_string(whole.size() - 8)});
  // The header agrees with the file's size, but the binary chunk promises 8 bytes more.
  std::string cut = whole.substr(0, whole.size() - 8);
  const auto size = static_cast<uint32_t>(cut.size());
  std::memcpy(&cut[8], &size, 4);
  expect_refused([&] { load_bytes(folder, cut); }, {"model.glb", "chunk 1"});
}

TEST(GltfBadInput, FilesThatAreNoModels) {
  const Folder folder;
  expect_refused([&] { load_bytes(folder, "", "a.gltf"); }, {"a.gltf"});
  expect_refused([&] { load_bytes(folder, "{\"asset\": {", "a.gltf"); },
                 {"a.gltf", "breaks off or is damaged at line 1, column"});
  expect_refused([&] { load_bytes(folder, "[]  ", "a.gltf"); }, {"a.gltf"});
  expect_refused([&] { load_bytes(folder, "{}  ", "a.gltf"); }, {"a.gltf", "asset"});
  expect_refused([&] { load_bytes(folder, R"({"asset":{"version":"2.0"}})", "a.gltf"); }, {"a.gltf", "no triangles"});
  expect_refused([&] { load_gltf(folder / "none.glb"); }, {"none.glb", "cannot be read"});
  expect_refused([&] { load_gltf(folder / ""); }, {"cannot be read"});
  std::string version_1 = Triangle().maker().glb();
  version_1[4] = 1;
  expect_refused([&] { load_bytes(folder, version_1); }, {"version 1"});
}

TEST(GltfBadInput, MissingBuffers) {
  const Folder folder;
  std::string json = Triangle().maker().json(false);
  expect_refused([&] { load_bytes(folder, json, "a.gltf"); }, {"a.gltf", "uri"});
  const std::string before = R"("buffers":[{)";
  json.insert(json.find(before) + before.size(), R"("uri":"gone.bin",)");
  expect_refused([&] { load_bytes(folder, json, "a.gltf"); }, {"a.gltf", "gone.bin"});
  folder.write("gone.bin", "too short");
  expect_refused([&] { load_bytes(folder, json, "a.gltf"); }, {"a.gltf", "gone.bin"});
}

TEST(GltfBadInput, WhatTheFileSaysOfItself) {
  const Folder folder;
  const auto with = [](const std::string& from, const std::string& to) {
    std::string json = Triangle().maker().json(true);
    return json.replace(json.find(from), from.size(), to);
  };
  const std::string version = R"("version":"2.0")";
  for (const auto& [to, words] : {std::pair{R"("version":"3.0")", "version '3.0'"},
                                  {R"("version":2)", "'version' as text"},
                                  {R"("version":"2.1","minVersion":"2.1")", "version '2.1'"}})
    expect_refused([&] { load_bytes(folder, with(version, to), "a.gltf"); }, {"a.gltf", words});
  EXPECT_NO_THROW(load_bytes(folder, with(version, R"("version":"2.7","minVersion":"2.0")"), "a.gltf"));
  expect_refused([&] { load_bytes(folder, with("{", R"({"extensionsRequired":"KHR_x",)"), "a.gltf"); },
                 {"not a list of names"});
  expect_refused([&] { load_bytes(folder, with("application/octet-stream;base64", "text/plain"), "a.gltf"); },
                 {"buffer 0", "not base64"});
  for (const char* written : {"", "application/gltf-buffer;charset=utf-8;", "application/octet-stream;name=a;"})
    EXPECT_NO_THROW(load_bytes(folder, with("application/octet-stream;", written[0] ? written : ";"), "a.gltf")) << written;
}

TEST(GltfBadInput, AFolderInPlaceOfAFile) {
  const Folder folder;
  std::filesystem::create_directories(folder / "inside");
  std::string json = Triangle().maker().json(false);
  const std::string before = R"("buffers":[{)";
  json.insert(json.find(before) + before.size(), R"("uri":"inside",)");
  expect_refused([&] { load_bytes(folder, json, "a.gltf"); }, {"a.gltf", "buffer 0", "'inside' is a folder"});
}

TEST(GltfBadInput, RequiredExtensionsThatChangeTheData) {
  GltfMaker maker = Triangle().maker();
  maker.more = R"(,"extensionsRequired":["EXT_texture_astc"])";
  expect_model_refused(maker, {"EXT_texture_astc", "export"});
}

TEST(GltfBadInput, DeepNestingIsRefusedBeforeItIsParsed) {
  const Folder folder;
  std::string deep = R"({"asset":{"version":"2.0","extras":)";
  deep += std::string(500000, '[') + std::string(500000, ']') + "}}";
  expect_refused([&] { load_bytes(folder, deep, "a.gltf"); }, {"a.gltf", "nested"});
}

// Whatever single byte is damaged, the model either loads or is refused as bad input; the sanitizers watch the rest.
TEST(GltfBadInput, DamagedBytesNeverDoWorse) {
  const Folder folder;
  std::mt19937 random(11);
  const std::string whole = Triangle().maker().glb();
  for (int i = 0; i < 400; ++i) {
    std::string damaged = whole;
    for (int changes = 1 + i % 3; changes > 0; --changes) damaged[random() % damaged.size()] = static_cast<char>(random());
    try {
      load_bytes(folder, damaged);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    }
  }
}

}  // namespace
}  // namespace lamina
