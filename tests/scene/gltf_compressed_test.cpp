// SPDX-License-Identifier: Apache-2.0
// Compressed models: encoded here by the libraries that wrote the formats, decoded by the loader, and equal to what went in.
// What is broken, contradicts its accessors or claims too much is refused by name.
#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <cmath>

#include "harness/scene/gltf/gltf.h"
#include "tests/scene/made_files.h"

namespace lamina {
namespace {

constexpr size_t cloth_side = 9, cloth_vertices = cloth_side * cloth_side,
                 cloth_triangles = 2 * (cloth_side - 1) * (cloth_side - 1);

// A wavy cloth over x and y in 0 to 1.
struct Cloth {
  std::vector<float> positions, uvs;
  std::vector<uint32_t> indices;
  Cloth() {
    for (size_t y = 0; y < cloth_side; ++y)
      for (size_t x = 0; x < cloth_side; ++x) {
        const float u = float(x) / (cloth_side - 1), v = float(y) / (cloth_side - 1);
        positions.insert(positions.end(), {u, v, 0.1f * std::sin(5 * u) * std::cos(3 * v)});
        uvs.insert(uvs.end(), {u, 1 - v});
        if (x + 1 == cloth_side || y + 1 == cloth_side) continue;
        const auto a = static_cast<uint32_t>(y * cloth_side + x), above = a + uint32_t{cloth_side};
        indices.insert(indices.end(), {a, a + 1, above + 1, a, above + 1, above});
      }
  }
};

// The same triangles, whatever the order of them, of their corners and of their vertices: each triangle's centre and its two
// texture coordinates' sum, sorted.
std::vector<std::array<float, 5>> triangles_of(const Mesh& mesh) {
  std::vector<std::array<float, 5>> all;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    std::array<float, 5> sums{};
    for (size_t c = 0; c < 3; ++c) {
      const Vertex& v = mesh.vertices.at(mesh.indices[i + c]);
      for (int axis = 0; axis < 3; ++axis) sums[size_t(axis)] += v.position[axis];
      sums[3] += v.uv.x, sums[4] += v.uv.y;
    }
    all.push_back(sums);
  }
  const auto key = [](const std::array<float, 5>& t) { return std::pair(std::lround(t[1] * 100), std::lround(t[0] * 100)); };
  std::ranges::sort(all, {}, key);
  return all;
}

void expect_cloth(const LoadedModel& model, float tolerance) {
  const Cloth cloth;
  Mesh plain;
  for (size_t i = 0; i < cloth_vertices; ++i) {
    Vertex v{};
    v.position = {cloth.positions[3 * i], cloth.positions[3 * i + 1], cloth.positions[3 * i + 2]};
    v.uv = {cloth.uvs[2 * i], cloth.uvs[2 * i + 1]};
    plain.vertices.push_back(v);
  }
  plain.indices = cloth.indices;
  const auto should = triangles_of(plain), is = triangles_of(model.objects.at(0).mesh);
  ASSERT_EQ(is.size(), cloth_triangles);
  for (size_t i = 0; i < cloth_triangles; ++i)
    for (size_t k = 0; k < 5; ++k) EXPECT_NEAR(is[i][k], should[i][k], tolerance) << i << " " << k;
  for (const Vertex& v : model.objects.at(0).mesh.vertices) EXPECT_GT(v.normal.z, 0.5f) << "triangles keep their side";
}

// --- Draco

std::string draco_stream(int method, bool with_metadata = false) {
  const Cloth cloth;
  draco::Mesh mesh;
  mesh.set_num_points(cloth_vertices);
  mesh.SetNumFaces(cloth_triangles);
  for (uint32_t f = 0; f < cloth_triangles; ++f) {
    draco::Mesh::Face face;
    for (size_t c = 0; c < 3; ++c) face[c] = draco::PointIndex(cloth.indices[3 * f + c]);
    mesh.SetFace(draco::FaceIndex(f), face);
  }
  const auto add = [&](draco::GeometryAttribute::Type type, int8_t components, const std::vector<float>& values) {
    draco::GeometryAttribute attribute;
    attribute.Init(type, nullptr, uint8_t(components), draco::DT_FLOAT32, false, sizeof(float) * size_t(components), 0);
    const int id = mesh.AddAttribute(attribute, true, cloth_vertices);
    for (uint32_t i = 0; i < cloth_vertices; ++i)
      mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), &values[i * size_t(components)]);
  };
  add(draco::GeometryAttribute::POSITION, 3, cloth.positions);
  add(draco::GeometryAttribute::TEX_COORD, 2, cloth.uvs);
  if (with_metadata) {
    auto metadata = std::make_unique<draco::GeometryMetadata>();
    metadata->AddEntryString("made by", "a test");
    mesh.AddMetadata(std::move(metadata));
  }
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::TEX_COORD, 12);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());
  return {buffer.data(), buffer.size()};
}

struct DracoModel {
  std::string stream = draco_stream(draco::MESH_EDGEBREAKER_ENCODING);
  size_t points = cloth_vertices, indices = 3 * cloth_triangles;
  std::string position_type = "VEC3", attributes = R"("POSITION":0,"TEXCOORD_0":1)";

  LoadedModel load(const Folder& folder) const {
    GltfMaker maker;
    const int view = maker.add_view(stream);
    maker.accessors = {fmt::format(R"({{"componentType":5126,"count":{},"type":"{}"}})", points, position_type),
                       fmt::format(R"({{"componentType":5126,"count":{},"type":"VEC2"}})", points),
                       fmt::format(R"({{"componentType":5123,"count":{},"type":"SCALAR"}})", indices)};
    maker.add_mesh("cloth", {fmt::format(R"({{"attributes":{{"POSITION":0,"TEXCOORD_0":1}},"indices":2,"extensions":{{)"
                                         R"("KHR_draco_mesh_compression":{{"bufferView":{},"attributes":{{{}}}}}}}}})",
                                         view, attributes)});
    maker.more = R"(,"extensionsUsed":["KHR_draco_mesh_compression"],"extensionsRequired":["KHR_draco_mesh_compression"])";
    return load_gltf(folder.write("cloth.glb", maker.glb()));
  }
};

TEST(GltfCompressed, DracoGivesWhatWasEncoded) {
  const Folder folder;
  DracoModel model;
  for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING})
    for (const bool with_metadata : {false, true}) {
      model.stream = draco_stream(method, with_metadata);
      const LoadedModel loaded = model.load(folder);
      EXPECT_TRUE(loaded.warnings.empty()) << loaded.warnings.at(0);
      expect_cloth(loaded, 1e-3f);
    }
}

TEST(GltfCompressed, ADracoStreamThatContradictsItsAccessorsIsRefused) {
  const Folder folder;
  const auto refused = [&](auto change, const std::vector<std::string>& parts) {
    DracoModel model;
    change(model);
    expect_refused([&] { model.load(folder); }, parts);
  };
  refused([](DracoModel& m) { m.points = cloth_vertices + 1; },
          {"mesh 'cloth'", "KHR_draco_mesh_compression", "81 vertices", "82"});
  refused([](DracoModel& m) { m.indices = 3; }, {"128 triangles", "3 indices"});
  refused([](DracoModel& m) { m.position_type = "VEC4"; }, {"POSITION", "3 numbers a vertex"});
  refused([](DracoModel& m) { m.attributes = R"("POSITION":7)"; }, {"no attribute 7"});
  refused([](DracoModel& m) { m.attributes = R"("POSITION":0,"NORMAL":1)"; }, {"NORMAL", "which the primitive has not"});
}

TEST(GltfCompressed, ABrokenDracoStreamIsRefused) {
  const Folder folder;
  const DracoModel whole;
  // Cut anywhere, or with a byte turned over: refused, or drawn where the byte is only a value.
  for (size_t bytes = 1; bytes < whole.stream.size(); bytes += 7) {
    DracoModel cut = whole;
    cut.stream.resize(bytes);
    expect_refused([&] { cut.load(folder); }, {"mesh 'cloth'"});
  }
  for (size_t at = 0; at < whole.stream.size(); at += 5) {
    DracoModel turned = whole;
    turned.stream[at] = static_cast<char>(~turned.stream[at]);
    try {
      turned.load(folder);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input) << at;
    }
  }
  DracoModel other = whole;
  other.stream[6] = 1;  // the minor version
  expect_refused([&] { other.load(folder); }, {"bitstream 2.2"});
}

TEST(GltfCompressed, ADracoStreamThatClaimsTooMuchIsRefusedBeforeItIsDecoded) {
  const Folder folder;
  // Header, sequential, no flags; then 2^30 triangles of 2^31 points, in 7 bits a byte.
  const std::string billion("\x80\x80\x80\x80\x04", 5), two_billion("\x80\x80\x80\x80\x08", 5);
  DracoModel model;
  model.stream = std::string("DRACO\x02\x02\x01\x00\x00\x00", 11) + billion + two_billion + std::string(200, '\0');
  model.indices = 3u << 30;
  model.points = size_t{1} << 31;
  expect_refused([&] { model.load(folder); }, {"claims 1073741824 triangles", "cannot hold more"});
}

// --- meshoptimizer

std::string encoded_attributes(const void* data, size_t count, size_t stride) {
  std::string bytes(meshopt_encodeVertexBufferBound(count, stride), '\0');
  bytes.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), data, count, stride));
  return bytes;
}
std::string encoded_triangles(const std::vector<uint32_t>& indices) {
  std::string bytes(meshopt_encodeIndexBufferBound(indices.size(), cloth_vertices), '\0');
  bytes.resize(
      meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), indices.data(), indices.size()));
  return bytes;
}
std::string encoded_sequence(const std::vector<uint32_t>& indices) {
  std::string bytes(meshopt_encodeIndexSequenceBound(indices.size(), cloth_vertices), '\0');
  bytes.resize(meshopt_encodeIndexSequence(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), indices.data(),
                                           indices.size()));
  return bytes;
}

// A .glb whose views of buffer 1, which holds nothing, lie compressed in its binary chunk.
struct MeshoptModel {
  GltfMaker maker;
  std::vector<std::string> views;
  MeshoptModel() { meshopt_encodeIndexVersion(1); }

  int add(const std::string& bytes, size_t count, size_t stride, const std::string& mode, int component, const char* type,
          const std::string& filter = "", const std::string& members = "", size_t claimed = 0) {
    const size_t at = maker.binary.size();
    maker.binary += bytes;
    maker.binary.resize((maker.binary.size() + 3) / 4 * 4);
    const size_t says = claimed ? claimed : count;
    views.push_back(fmt::format(R"({{"buffer":1,"byteLength":{},"extensions":{{"EXT_meshopt_compression":{{"buffer":0,)"
                                R"("byteOffset":{},"byteLength":{},"byteStride":{},"count":{},"mode":"{}"{}}}}}}})",
                                says * stride, at, bytes.size(), stride, says, mode,
                                filter.empty() ? "" : fmt::format(R"(,"filter":"{}")", filter)));
    maker.accessors.push_back(fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"{}"{}}})",
                                          views.size() - 1, component, count, type, members));
    return static_cast<int>(maker.accessors.size()) - 1;
  }
  LoadedModel load(const Folder& folder, const std::string& attributes, int indices) const {
    const std::string extension = R"("EXT_meshopt_compression")";
    const std::string json = fmt::format(
        R"({{"asset":{{"version":"2.0"}},"extensionsUsed":[{0}],"extensionsRequired":[{0}],"accessors":[{1}],"bufferViews":[{2}],)"
        R"("buffers":[{{"byteLength":{3}}},{{"byteLength":99999,"extensions":{{{0}:{{"fallback":true}}}}}}],)"
        R"("meshes":[{{"name":"cloth","primitives":[{{"attributes":{{{4}}},"indices":{5}}}]}}],"nodes":[{{"mesh":0}}]}})",
        extension, fmt::join(maker.accessors, ","), fmt::join(views, ","), maker.binary.size(), attributes, indices);
    return load_gltf(folder.write("cloth.glb", glb_of(json, maker.binary)));
  }
};

LoadedModel load_meshopt_cloth(const Folder& folder, bool as_sequence, const std::function<void(MeshoptModel&)>& change = {}) {
  const Cloth cloth;
  MeshoptModel model;
  model.add(encoded_attributes(cloth.positions.data(), cloth_vertices, 12), cloth_vertices, 12, "ATTRIBUTES", 5126, "VEC3");
  std::vector<float> exponential(2 * cloth_vertices);
  meshopt_encodeFilterExp(exponential.data(), cloth_vertices, 8, 20, cloth.uvs.data());
  model.add(encoded_attributes(exponential.data(), cloth_vertices, 8), cloth_vertices, 8, "ATTRIBUTES", 5126, "VEC2",
            "EXPONENTIAL");
  std::vector<int8_t> normals(4 * cloth_vertices);
  std::vector<float> up;
  for (size_t i = 0; i < cloth_vertices; ++i) up.insert(up.end(), {0.6f, 0, 0.8f, 0});
  meshopt_encodeFilterOct(normals.data(), cloth_vertices, 4, 8, up.data());
  model.add(encoded_attributes(normals.data(), cloth_vertices, 4), cloth_vertices, 4, "ATTRIBUTES", 5120, "VEC3", "OCTAHEDRAL",
            R"(,"normalized":true)");
  if (as_sequence)
    model.add(encoded_sequence(cloth.indices), cloth.indices.size(), 4, "INDICES", 5125, "SCALAR");
  else
    model.add(encoded_triangles(cloth.indices), cloth.indices.size(), 2, "TRIANGLES", 5123, "SCALAR");
  if (change) change(model);
  return model.load(folder, R"("POSITION":0,"TEXCOORD_0":1,"NORMAL":2)", 3);
}

TEST(GltfCompressed, MeshoptGivesWhatWasEncoded) {
  const Folder folder;
  for (const bool as_sequence : {false, true}) {
    const LoadedModel model = load_meshopt_cloth(folder, as_sequence);
    EXPECT_TRUE(model.warnings.empty()) << model.warnings.at(0);
    expect_cloth(model, 1e-4f);
    for (const Vertex& v : model.objects.at(0).mesh.vertices)
      EXPECT_LT(glm::distance(v.normal, glm::vec3(0.6f, 0, 0.8f)), 0.02f) << "its octahedral filter is applied";
  }
}

TEST(GltfCompressed, ABrokenMeshoptStreamIsRefused) {
  const Folder folder;
  const auto refused = [&](const std::string& from, const std::string& to, const std::vector<std::string>& parts) {
    expect_refused(
        [&] {
          load_meshopt_cloth(folder, false, [&](MeshoptModel& model) {
            bool found = false;
            for (std::string& view : model.views)
              if (const size_t at = view.find(from); at != std::string::npos && !found)
                view.replace(at, from.size(), to), found = true;
            EXPECT_TRUE(found) << from;
          });
        },
        parts);
  };
  refused(R"("byteStride":12)", R"("byteStride":13)", {"buffer view 0, EXT_meshopt_compression", "elements of 13 bytes"});
  refused(R"("count":81)", R"("count":80)", {"has 80 elements of 12 bytes", "972 bytes"});
  refused(R"("mode":"TRIANGLES")", R"("mode":"TRIANGLE")", {"'mode' is none of ATTRIBUTES, TRIANGLES, INDICES"});
  refused(R"("filter":"EXPONENTIAL")", R"("filter":"LOG")", {"'filter' is none of"});
  refused(R"("mode":"TRIANGLES")", R"("mode":"INDICES")", {"buffer view 3, EXT_meshopt_compression"});
  refused(R"("buffer":0)", R"("buffer":9)", {"refers to buffer 9; the file has 2"});
  refused(R"("byteOffset":0,)", R"("byteOffset":99999,)", {"leave buffer 0"});
  // Its first byte is its kind and version.
  expect_refused([&] { load_meshopt_cloth(folder, false, [](MeshoptModel& model) { model.maker.binary[0] = 0x55; }); },
                 {"buffer view 0", "damaged"});
}

TEST(GltfCompressed, AMeshoptViewThatClaimsTooMuchIsRefusedBeforeItIsDecoded) {
  const Folder folder;
  MeshoptModel model;
  const size_t billion = size_t{1} << 30;
  model.add(std::string(100, '\xa0'), 3, 12, "ATTRIBUTES", 5126, "VEC3", "", "", billion);
  expect_refused([&] { model.load(folder, R"("POSITION":0)", 0); },
                 {"claims 1073741824 elements", "cannot hold more than 533"});
  MeshoptModel indices;
  indices.add(std::string(100, '\xe1'), 3, 4, "TRIANGLES", 5125, "SCALAR", "", "", 3 * billion);
  expect_refused([&] { indices.load(folder, R"("POSITION":0)", 0); }, {"cannot hold more than 300"});
}

TEST(GltfCompressed, TheBestCompressedViewIsNoLieOfItsSize) {
  const Folder folder;
  // Vertices all at one place compress to what the format needs at least; still they are read.
  const size_t count = 65536;
  const std::vector<float> same(3 * count, 0.5f);
  const Cloth cloth;
  MeshoptModel model;
  model.add(encoded_attributes(same.data(), count, 12), count, 12, "ATTRIBUTES", 5126, "VEC3");
  std::vector<uint32_t> one(3 * count, 0);
  model.add(encoded_triangles(one), one.size(), 4, "TRIANGLES", 5125, "SCALAR");
  expect_refused([&] { model.load(folder, R"("POSITION":0)", 1); }, {"has no triangles to draw"});
}

}  // namespace
}  // namespace lamina
