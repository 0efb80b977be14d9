// SPDX-License-Identifier: Apache-2.0
// Geometry of glTF models: nodes, primitives, indices, normals, tangents.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "harness/scene/gltf/gltf.h"
#include "harness/scene/model_look.h"
#include "tests/scene/made_files.h"

namespace lamina {
namespace {

LoadedModel load(const Folder& folder, const GltfMaker& maker, bool binary = true) {
  return load_gltf(folder.write(binary ? "model.glb" : "model.gltf", binary ? maker.glb() : maker.json(true)));
}

glm::vec3 world_position(const Object& object, size_t corner) {
  return glm::vec3(object.world_from_object * glm::vec4(object.mesh.vertices[object.mesh.indices[corner]].position, 1));
}
// Area times direction of the triangle that starts at `corner`, in world space.
glm::vec3 world_area(const Object& object, size_t corner) {
  const glm::vec3 a = world_position(object, corner), b = world_position(object, corner + 1),
                  c = world_position(object, corner + 2);
  return 0.5f * glm::cross(b - a, c - a);
}
void expect_near(glm::vec3 a, glm::vec3 b) { EXPECT_LT(glm::distance(a, b), 1e-5f) << a.x << " " << a.y << " " << a.z; }

TEST(LoadGltf, ReadsAQuadFromGlbAndFromJsonAlike) {
  const Folder folder;
  GltfMaker maker;
  maker.add_mesh("square", {maker.quad()});
  maker.add_node(R"({"mesh":0,"name":"wall"})");
  for (const bool binary : {true, false}) {
    const LoadedModel model = load(folder, maker, binary);
    ASSERT_EQ(model.objects.size(), 1u);
    const Object& wall = model.objects[0];
    EXPECT_EQ(wall.name, "wall");
    EXPECT_EQ(wall.mesh.vertices.size(), 4u);
    EXPECT_EQ(wall.mesh.indices.size(), 6u);
    expect_near(world_area(wall, 0) + world_area(wall, 3), {0, 0, 1});
    for (const Vertex& vertex : wall.mesh.vertices) {
      // u runs with x, v against y (the picture hangs upright), so dP/dv = -y = -1 * cross(z, x).
      EXPECT_EQ(vertex.tangent, glm::vec4(1, 0, 0, -1));
      EXPECT_EQ(vertex.uv, glm::vec2(vertex.position.x, 1 - vertex.position.y));
    }
    EXPECT_TRUE(model.warnings.empty()) << model.warnings[0];
    ASSERT_TRUE(wall.look);
  }
}

TEST(LoadGltf, FindsBuffersAndPicturesBesideTheFile) {
  const Folder folder;
  GltfMaker maker;
  maker.add_mesh("square", {maker.quad(R"(,"material":0)")});
  maker.more = R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],"textures":[{"source":0}],)"
               R"("images":[{"uri":"red%20one.png"}])";
  write_png(folder / "red one.png", 2, 2, 3, {255, 0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0});
  folder.write("all.bin", maker.binary);
  std::string json = maker.json(false);
  const std::string before = R"("buffers":[{)";
  json.insert(json.find(before) + before.size(), R"("uri":"all.bin",)");
  const LoadedModel model = load_gltf(folder.write("model.gltf", json));
  const Texels& texels = model.objects.at(0).look->base_colour;
  EXPECT_EQ(glm::vec3(texels.rgba.at(0)), glm::vec3(1, 0, 0));
}

// A node 2 to the right, whose child is turned a quarter about z (x to y) and scaled by 3: (1, 0, 0) goes to (2, 3, 0).
TEST(LoadGltf, NodesPlaceTheirChildren) {
  const Folder folder;
  GltfMaker maker;
  maker.add_mesh("square", {maker.quad()});
  maker.add_node(R"({"children":[1],"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,2,0,0,1]})");
  maker.add_node(R"({"mesh":0,"rotation":[0,0,0.70710678,0.70710678],"scale":[3,3,3]})");
  const LoadedModel model = load(folder, maker);
  ASSERT_EQ(model.objects.size(), 1u);
  EXPECT_EQ(model.objects[0].name, "square") << "a node without a name takes its mesh's";
  expect_near(world_position(model.objects[0], 0), {2, 0, 0});
  expect_near(world_position(model.objects[0], 1), {2, 3, 0});
  expect_near(world_position(model.objects[0], 2), {-1, 3, 0});
}

TEST(LoadGltf, ShowsOnlyItsScene) {
  const Folder folder;
  GltfMaker maker;
  maker.add_mesh("square", {maker.quad()});
  maker.add_node(R"({"mesh":0,"name":"shown"})");
  maker.add_node(R"({"mesh":0,"name":"hidden"})");
  maker.more = R"(,"scene":1,"scenes":[{"nodes":[1]},{"nodes":[0]}])";
  const LoadedModel model = load(folder, maker);
  ASSERT_EQ(model.objects.size(), 1u);
  EXPECT_EQ(model.objects[0].name, "shown");
}

TEST(LoadGltf, EveryPrimitiveIsAnObjectOfItsOwnName) {
  const Folder folder;
  GltfMaker maker;
  maker.add_mesh("pair", {maker.quad(), maker.quad()});
  maker.add_mesh("one", {maker.quad()});
  maker.add_node(R"({"mesh":0,"name":"a"})");
  maker.add_node(R"({"mesh":1,"name":"a_0"})");
  maker.add_node(R"({"mesh":1})");
  maker.add_node(R"({"mesh":1})");
  const LoadedModel model = load(folder, maker);
  std::set<std::string> names;
  for (const Object& object : model.objects) names.insert(object.name);
  EXPECT_EQ(names, (std::set<std::string>{"a_0", "a_1", "a_0_2", "one", "one_2"}));
}

// A box corner's three faces would do; one quad and a mirror say the same: it must still face where the mirrored outside is.
TEST(LoadGltf, MirroredNodesKeepTheirWindingOutwardAndTheirFrames) {
  const Folder folder;
  GltfMaker maker;
  maker.add_mesh("square", {maker.quad()});
  maker.add_node(R"({"mesh":0,"scale":[-2,1,1]})");
  maker.add_node(R"({"mesh":0,"scale":[1,1,-1]})");
  maker.add_node(R"({"mesh":0,"scale":[-1,-1,-1]})");
  const LoadedModel model = load(folder, maker);
  ASSERT_EQ(model.objects.size(), 3u);
  const std::array<glm::vec3, 3> scale = {{{-2, 1, 1}, {1, 1, -1}, {-1, -1, -1}}};
  for (size_t i = 0; i < 3; ++i) {
    const Object& object = model.objects[i];
    const glm::mat3 world(object.world_from_object);
    EXPECT_GT(glm::determinant(world), 0.0f) << "no matrix of a scene mirrors";
    const glm::vec3 outside = glm::normalize(glm::vec3(0, 0, 1) / scale[i]);
    EXPECT_GT(glm::dot(world_area(object, 0), outside), 0.0f) << "object " << i;
    for (const Vertex& vertex : object.mesh.vertices) {
      const glm::vec3 normal = glm::normalize(glm::transpose(glm::inverse(world)) * vertex.normal);
      expect_near(normal, outside);
      const glm::vec3 tangent = glm::normalize(world * glm::vec3(vertex.tangent));
      expect_near(tangent, glm::normalize(scale[i] * glm::vec3(1, 0, 0)));
      expect_near(vertex.tangent.w * glm::cross(normal, tangent), glm::normalize(scale[i] * glm::vec3(0, -1, 0)));
    }
  }
}

// Strips and fans over the corners 0 1 2 3 of a square, in the orders glTF 2.0 (3.7.2.1) prescribes: every triangle faces +z.
TEST(LoadGltf, StripsAndFansCoverTheSquareFacingOneWay) {
  const Folder folder;
  for (const auto& [mode, order] : {std::pair{5, std::vector<uint8_t>{0, 1, 3, 2}}, {6, std::vector<uint8_t>{0, 1, 2, 3}}}) {
    GltfMaker maker;
    const int positions = maker.add_floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, 3);
    const int uvs = maker.add_floats({0, 1, 1, 1, 1, 0, 0, 0}, 2);
    const int indices = maker.add_accessor(order, 1, 5121);
    maker.add_mesh("square", {fmt::format(R"({{"attributes":{{"POSITION":{},"TEXCOORD_0":{}}},"indices":{},"mode":{}}})",
                                          positions, uvs, indices, mode)});
    maker.add_node(R"({"mesh":0})");
    const LoadedModel model = load(folder, maker);
    const Object& object = model.objects.at(0);
    ASSERT_EQ(object.mesh.indices.size(), 6u) << "mode " << mode;
    expect_near(world_area(object, 0), {0, 0, 0.5f});
    expect_near(world_area(object, 3), {0, 0, 0.5f});
  }
}

TEST(LoadGltf, ReadsIndicesOfEveryTypeAndNone) {
  const Folder folder;
  for (const int type : {5121, 5123, 5125, 0}) {
    GltfMaker maker;
    const int positions = maker.add_floats({0, 0, 0, 1, 0, 0, 1, 1, 0}, 3);
    const int uvs = maker.add_floats({0, 0, 1, 0, 1, 1}, 2);
    std::string indices;
    if (type == 5121) indices = fmt::format(R"(,"indices":{})", maker.add_accessor(std::vector<uint8_t>{0, 1, 2}, 1, type));
    if (type == 5123) indices = fmt::format(R"(,"indices":{})", maker.add_accessor(std::vector<uint16_t>{0, 1, 2}, 1, type));
    if (type == 5125) indices = fmt::format(R"(,"indices":{})", maker.add_accessor(std::vector<uint32_t>{0, 1, 2}, 1, type));
    maker.add_mesh("t", {fmt::format(R"({{"attributes":{{"POSITION":{},"TEXCOORD_0":{}}}{}}})", positions, uvs, indices)});
    const LoadedModel model = load(folder, maker);  // and without nodes: meshes alone are shown
    expect_near(world_area(model.objects.at(0), 0), {0, 0, 0.5f});
  }
}

// KHR_mesh_quantization and core glTF: normalized bytes, and a stride longer than the element.
TEST(LoadGltf, ReadsNormalizedTextureCoordinatesAndSparseAccessors) {
  const Folder folder;
  GltfMaker maker;
  const int positions = maker.add_floats({0, 0, 0, 1, 0, 0, 1, 1, 0}, 3);
  const int uvs = maker.add_accessor(std::vector<uint16_t>{0, 0, 65535, 0, 65535, 13107}, 2, 5123, R"(,"normalized":true)");
  // Vertex 2 moves to (0, 5, 0).
  const int places = maker.add_view(std::string("\2", 1));
  const float moved[] = {0, 5, 0};
  const int values = maker.add_view(std::string(reinterpret_cast<const char*>(moved), sizeof moved));
  maker.accessors[size_t(positions)].pop_back();
  maker.accessors[size_t(positions)] += fmt::format(
      R"(,"sparse":{{"count":1,"indices":{{"bufferView":{},"componentType":5121}},"values":{{"bufferView":{}}}}}}})", places,
      values);
  maker.add_mesh("t", {fmt::format(R"({{"attributes":{{"POSITION":{},"TEXCOORD_0":{}}}}})", positions, uvs)});
  const LoadedModel model = load(folder, maker);
  const Mesh& mesh = model.objects.at(0).mesh;
  EXPECT_LT(glm::distance(mesh.vertices[2].uv, glm::vec2(1, 0.2f)), 1e-6f);
  expect_near(mesh.vertices[2].position, {0, 5, 0});
}

// Without normals: flat where triangles share no vertex, and where they do, their mean by area: two triangles at a right angle
// along an edge, the second of twice the area, lean 2 to 1.
TEST(LoadGltf, MakesMissingNormals) {
  const Folder folder;
  GltfMaker maker;
  const int positions = maker.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, -2}, 3);
  const int uvs = maker.add_floats({0, 0, 1, 0, 0, 1, 1, 1}, 2);
  const int indices = maker.add_accessor(std::vector<uint16_t>{0, 1, 2, 1, 0, 3}, 1, 5123);
  maker.add_mesh("bent",
                 {fmt::format(R"({{"attributes":{{"POSITION":{},"TEXCOORD_0":{}}},"indices":{}}})", positions, uvs, indices)});
  const LoadedModel model = load(folder, maker);
  const Mesh& mesh = model.objects.at(0).mesh;
  // Triangle 1: area 1/2 facing +z. Triangle 2: corners (1,0,0) (0,0,0) (1,0,-2): area 1 facing -y.
  expect_near(mesh.vertices[0].normal, glm::normalize(glm::vec3(0, -2, 1)));
  expect_near(mesh.vertices[2].normal, {0, 0, 1});
  expect_near(mesh.vertices[3].normal, {0, -1, 0});
}

// glTF's bitangent points up the picture, ours down it: a file's tangent (1, 0, 0) with w = +1 on a quad whose picture hangs
// upright is the same frame as the one made from texture coordinates, w = -1.
TEST(LoadGltf, TangentsOfTheFileAreTurnedToOurFrame) {
  const Folder folder;
  GltfMaker maker;
  std::string quad = maker.quad();
  const int tangents = maker.add_floats({1, 0, 0.5f, 1, 1, 0, 0, 1, 2, 0, 0, 1, 0, 0, 1, 1}, 4);
  const std::string before = R"("attributes":{)";
  quad.insert(quad.find(before) + before.size(), fmt::format(R"("TANGENT":{},)", tangents));
  maker.add_mesh("square", {quad});
  const LoadedModel model = load(folder, maker);
  const Mesh& mesh = model.objects.at(0).mesh;
  for (size_t i = 0; i < 3; ++i)
    EXPECT_EQ(mesh.vertices[i].tangent, glm::vec4(1, 0, 0, -1)) << "orthogonal to the normal, unit";
  EXPECT_NEAR(mesh.vertices[3].tangent.z, 0.0f, 1e-6f) << "a tangent along the normal becomes any orthogonal one";
  EXPECT_NEAR(glm::length(glm::vec3(mesh.vertices[3].tangent)), 1.0f, 1e-6f);
}

TEST(LoadGltf, LeavesOutWhatHasNoAreaWithAWarning) {
  const Folder folder;
  GltfMaker maker;
  const int positions = maker.add_floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0, 9, 9, 9}, 3);
  const int uvs = maker.add_floats({0, 0, 1, 0, 1, 1, 0, 0, 7, 7}, 2);
  const int indices = maker.add_accessor(std::vector<uint16_t>{0, 1, 2, 0, 1, 1, 0, 1, 3}, 1, 5123);
  const auto primitive = [&](int mode) {
    return fmt::format(R"({{"attributes":{{"POSITION":{},"TEXCOORD_0":{}}},"indices":{},"mode":{}}})", positions, uvs, indices,
                       mode);
  };
  maker.add_mesh("mixed", {primitive(4), primitive(0), primitive(1)});
  const LoadedModel model = load(folder, maker);
  ASSERT_EQ(model.objects.size(), 1u);
  EXPECT_EQ(model.objects[0].mesh.indices.size(), 3u);
  EXPECT_EQ(model.objects[0].mesh.vertices.size(), 3u) << "vertices that nothing uses are gone";
  ASSERT_EQ(model.warnings.size(), 3u);
  EXPECT_NE(model.warnings[0].find("2 triangles without area"), std::string::npos) << model.warnings[0];
  EXPECT_NE(model.warnings[1].find("points or lines"), std::string::npos) << model.warnings[1];
}

TEST(LoadGltf, NodesScaledToNothingAreLeftOut) {
  const Folder folder;
  GltfMaker maker;
  maker.add_mesh("square", {maker.quad()});
  maker.add_node(R"({"mesh":0,"name":"gone","scale":[0,0,0]})");
  maker.add_node(R"({"mesh":0,"name":"there"})");
  const LoadedModel model = load(folder, maker);
  ASSERT_EQ(model.objects.size(), 1u);
  EXPECT_EQ(model.objects[0].name, "there");
  EXPECT_EQ(model.warnings.size(), 1u);
}

}  // namespace
}  // namespace lamina
