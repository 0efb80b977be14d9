// SPDX-License-Identifier: Apache-2.0
// What of a model is applied: vertex colours, texture transforms and sets, samplers, both sides, skins and morph targets at
// rest. Every model is made here; the answers follow from the specification.
#include <gtest/gtest.h>

#include <cmath>

#include "harness/scene/default_views.h"
#include "harness/scene/gltf/gltf.h"
#include "harness/scene/mesh/unwrap_check.h"
#include "harness/scene/model_look.h"
#include "tests/scene/declared.h"
#include "tests/scene/made_files.h"

namespace lamina {
namespace {

LoadedModel load_made(const Folder& folder, const GltfMaker& maker) {
  return load_gltf(folder.write("model.glb", maker.glb()));
}

// A quad of x and y in 0 to 1 with these vertex colours, corners counter-clockwise from the lower left.
struct QuadModel {
  GltfMaker maker;
  std::string attributes, members;

  QuadModel() {
    const int positions = maker.add_floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, 3);
    attributes = fmt::format(R"("POSITION":{})", positions);
    indices = maker.add_accessor(std::vector<uint16_t>{0, 1, 2, 0, 2, 3}, 1, 5123);
  }
  QuadModel& uv(int set, const std::vector<float>& values) {
    return add(fmt::format("TEXCOORD_{}", set), maker.add_floats(values, 2));
  }
  QuadModel& add(const std::string& name, int accessor) {
    attributes += fmt::format(R"(,"{}":{})", name, accessor);
    return *this;
  }
  // With one picture of 2 x 2 texels: red, green over blue, white.
  void picture(const Folder& folder, const std::string& reference, const std::string& sampler = "{}",
               const std::string& material = "") {
    write_png(folder / "four.png", 2, 2, 3, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255});
    maker.more =
        fmt::format(R"(,"materials":[{{"pbrMetallicRoughness":{{"baseColorTexture":{{"index":0{}}}}}{}}}],"samplers":[{}],)"
                    R"("textures":[{{"source":0,"sampler":0}}],"images":[{{"uri":"four.png"}}])",
                    reference, material, sampler);
    members = R"(,"material":0)";
  }
  LoadedModel load(const Folder& folder, const std::string& node = R"({"mesh":0,"name":"thing"})") {
    GltfMaker whole = maker;
    whole.add_mesh("quad", {fmt::format(R"({{"attributes":{{{}}},"indices":{}{}}})", attributes, indices, members)});
    whole.add_node(node);
    return load_made(folder, whole);
  }
  int indices = 0;
};

const std::vector<float> plain_uv = {0, 1, 1, 1, 1, 0, 0, 0};

// The base colour that the surface has at a vertex.
glm::vec3 colour_at(const Object& object, size_t vertex) {
  const Texels& texels = object.look->base_colour;
  const glm::vec2 uv = object.mesh.vertices.at(vertex).uv;
  const auto texel = [](float at, uint32_t size) {
    return std::min(static_cast<uint32_t>(std::clamp(at, 0.0f, 1.0f) * float(size)), size - 1);
  };
  return glm::vec3(texels.rgba[size_t{texel(uv.y, texels.height)} * texels.width + texel(uv.x, texels.width)]);
}
void expect_colour(glm::vec3 is, glm::vec3 should, const char* where) {
  EXPECT_LT(glm::distance(is, should), 0.02f) << where << ": " << is.x << " " << is.y << " " << is.z;
}
std::string all_of(const std::vector<std::string>& warnings) { return fmt::format("{}", fmt::join(warnings, "\n")); }

TEST(GltfApplied, VertexColoursMultiplyTheBaseColour) {
  const Folder folder;
  QuadModel quad;
  quad.uv(0, plain_uv).add("COLOR_0", quad.maker.add_floats({1, 0, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 1, 0, 0, 1}, 4));
  const LoadedModel model = quad.load(folder);
  EXPECT_TRUE(model.warnings.empty()) << all_of(model.warnings);
  const Object& object = model.objects.at(0);
  ASSERT_EQ(object.mesh.vertices.size(), 4u) << "its texture coordinates are its own";
  expect_colour(colour_at(object, 0), {1, 0, 0}, "left");
  expect_colour(colour_at(object, 1), {0, 1, 0}, "right");
  const Texels& texels = object.look->base_colour;
  expect_colour(glm::vec3(texels.rgba[size_t{texels.height / 2} * texels.width + texels.width / 4]), {0.75f, 0.25f, 0},
                "linear between them");
}

TEST(GltfApplied, VertexColoursNeedNoTextureCoordinates) {
  const Folder folder;
  QuadModel quad;  // bytes, three components
  quad.add("COLOR_0", quad.maker.add_accessor(std::vector<uint8_t>{255, 0, 0, 0, 255, 0, 0, 255, 0, 255, 0, 0}, 3, 5121,
                                              R"(,"normalized":true)"));
  const LoadedModel model = quad.load(folder);
  const Object& object = model.objects.at(0);
  ASSERT_EQ(object.mesh.vertices.size(), 6u) << "each triangle has a patch of its own";
  expect_colour(colour_at(object, 0), {1, 0, 0}, "left");
  expect_colour(colour_at(object, 1), {0, 1, 0}, "right");
  expect_colour(colour_at(object, 5), {1, 0, 0}, "left, in the other triangle");
  EXPECT_EQ(unwrap_problem(object.mesh), "");
}

TEST(GltfApplied, VertexColoursOverARepeatedPictureAreLeftOutAloud) {
  const Folder folder;
  QuadModel quad;
  quad.uv(0, {0, 4, 4, 4, 4, 0, 0, 0}).add("COLOR_0", quad.maker.add_floats({1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0}, 3));
  quad.picture(folder, "");
  const LoadedModel model = quad.load(folder);
  EXPECT_NE(all_of(model.warnings).find("colours of the vertices of 'thing' are not applied"), std::string::npos);
  quad.maker.more = "";
  quad.members = "";
  EXPECT_EQ(all_of(quad.load(folder).warnings), "") << "without a picture they get patches";
}

TEST(GltfApplied, TextureTransformsByTheirDefinition) {
  const Folder folder;
  QuadModel quad;
  quad.uv(0, plain_uv);
  const auto uv_of = [&](const std::string& transform) {
    quad.picture(folder, fmt::format(R"(,"extensions":{{"KHR_texture_transform":{{{}}}}})", transform));
    const LoadedModel model = quad.load(folder);
    EXPECT_TRUE(model.warnings.empty()) << all_of(model.warnings);
    return model.objects.at(0).mesh.vertices.at(1).uv;  // (1, 1) before
  };
  const auto near = [](glm::vec2 a, glm::vec2 b) { return glm::distance(a, b) < 1e-6f; };
  EXPECT_TRUE(near(uv_of(R"("offset":[0.5,0])"), {1.5f, 1}));
  EXPECT_TRUE(near(uv_of(R"("scale":[0.25,0.5])"), {0.25f, 0.5f}));
  // The extension's own matrix for a quarter turn: u = cos u + sin v, v = -sin u + cos v.
  EXPECT_TRUE(near(uv_of(R"("rotation":1.5707963267948966)"), {1, -1}));
  EXPECT_TRUE(near(uv_of(R"("offset":[1,2],"rotation":1.5707963267948966,"scale":[0.5,0.25])"), {1.25f, 1.5f}));
}

TEST(GltfApplied, ASecondSetOfTextureCoordinates) {
  const Folder folder;
  QuadModel quad;
  quad.uv(0, plain_uv).uv(1, {1, 1, 0, 1, 0, 0, 1, 0});
  quad.picture(folder, R"(,"texCoord":1)");
  EXPECT_EQ(quad.load(folder).objects.at(0).mesh.vertices.at(0).uv, glm::vec2(1, 1));
  QuadModel only_second;
  only_second.uv(1, plain_uv);
  only_second.picture(folder, "");
  const LoadedModel model = only_second.load(folder);
  EXPECT_EQ(model.objects.at(0).mesh.vertices.at(1).uv, glm::vec2(1, 1));
  EXPECT_NE(all_of(model.warnings).find("set 1 is used"), std::string::npos) << all_of(model.warnings);
}

TEST(GltfApplied, SamplersOfTheNearestTexel) {
  const Folder folder;
  QuadModel quad;
  quad.uv(0, plain_uv);
  quad.picture(folder, "", R"({"magFilter":9728,"minFilter":9728})");
  const Texels texels = quad.load(folder).objects.at(0).look->base_colour;
  ASSERT_EQ(texels.width, 1024u) << "each texel is repeated";
  expect_colour(glm::vec3(texels.rgba[511]), {1, 0, 0}, "the last of the first");
  expect_colour(glm::vec3(texels.rgba[512]), {0, 1, 0}, "the first of the second");
  quad.picture(folder, "", R"({"magFilter":9729})");
  EXPECT_EQ(quad.load(folder).objects.at(0).look->base_colour.width, 2u);
}

TEST(GltfApplied, BordersAreHeldOrMirroredAsTheSamplerSays) {
  const Folder folder;
  QuadModel quad;
  quad.uv(0, {1, 2, 2, 2, 2, 1, 1, 1});  // the tile beside and below the first
  const auto load_it = [&](const std::string& sampler) {
    quad.picture(folder, "", sampler);
    const LoadedModel model = quad.load(folder);
    EXPECT_EQ(all_of(model.warnings), "") << sampler;
    return load_scene((folder / "model.glb").string(), builtin_library());
  };
  const auto wraps_of = [](const Scene& scene) {
    return scene.objects.at(0).effects.at("layered_material").textures.at("outer_albedo")->wraps;
  };
  const auto uv_of = [](const Scene& scene) { return scene.objects.at(0).mesh.vertices.at(0).uv; };
  for (const char* plain : {"{}", R"({"wrapS":10497,"wrapT":10497})"}) {
    const Scene repeated = load_it(plain);
    EXPECT_FALSE(wraps_of(repeated)) << plain;
    EXPECT_EQ(uv_of(repeated), glm::vec2(0, 1)) << "every tile is the same, so the first is taken";
  }
  const Scene mixed = load_it(R"({"wrapS":33648,"wrapT":33071})");
  ASSERT_TRUE(wraps_of(mixed));
  EXPECT_EQ(wraps_of(mixed)->u, Wrap::mirror);
  EXPECT_EQ(wraps_of(mixed)->v, Wrap::clamp);
  EXPECT_EQ(uv_of(mixed), glm::vec2(1, 2)) << "another tile shows another picture";
  const Scene nearest = load_it(R"({"wrapS":33071,"wrapT":33071,"magFilter":9728})");
  ASSERT_TRUE(wraps_of(nearest)) << "whose texels are repeated";
  expect_refused([&] { load_it(R"({"wrapS":7})"); }, {"base colour texture", "wraps by 7"});
}

TEST(GltfApplied, BothSidesOfAnOpenSurface) {
  const Folder folder;
  QuadModel quad;
  quad.uv(0, plain_uv);
  quad.picture(folder, "", "{}", R"(,"doubleSided":true)");
  const Mesh mesh = quad.load(folder).objects.at(0).mesh;
  ASSERT_EQ(mesh.indices.size(), 12u);
  glm::vec3 sum(0);
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]],
                 &c = mesh.vertices[mesh.indices[i + 2]];
    const glm::vec3 area = glm::cross(b.position - a.position, c.position - a.position);
    EXPECT_GT(glm::dot(area, a.normal), 0) << "normals are turned with the triangles";
    // dP/dv must stay: v runs down.
    EXPECT_LT(glm::distance(a.tangent.w * glm::cross(a.normal, glm::vec3(a.tangent)), glm::vec3(0, -1, 0)), 1e-5f);
    sum += area;
  }
  EXPECT_LT(glm::length(sum), 1e-6f) << "as much faces back as front";
  quad.picture(folder, "");
  EXPECT_EQ(quad.load(folder).objects.at(0).mesh.indices.size(), 6u);
}

TEST(GltfApplied, AClosedSurfaceHasNoBackToSee) {
  const Folder folder;
  GltfMaker maker;
  const int positions = maker.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 3);
  const int indices = maker.add_accessor(std::vector<uint8_t>{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, 1, 5121);
  maker.add_mesh("t", {fmt::format(R"({{"attributes":{{"POSITION":{}}},"indices":{},"material":0}})", positions, indices)});
  maker.more = R"(,"materials":[{"doubleSided":true}])";
  EXPECT_EQ(load_made(folder, maker).objects.at(0).mesh.indices.size(), 12u);
}

TEST(GltfApplied, ViewsLookAtTheSideThatIsDrawn) {
  const Folder folder;
  QuadModel quad;  // faces +z
  const auto sees = [](const LoadedModel& model) {
    const View front = default_views(model.objects).at(0);
    return glm::normalize(front.eye - front.target);
  };
  EXPECT_LT(glm::distance(sees(quad.load(folder)), glm::vec3(0, 0, 1)), 1e-5f);
  const LoadedModel away = quad.load(folder, R"({"mesh":0,"rotation":[0,1,0,0]})");
  EXPECT_LT(glm::distance(sees(away), glm::vec3(0, 0, -1)), 1e-5f);
  const LoadedModel down = quad.load(folder, R"({"mesh":0,"rotation":[0.70710678,0,0,0.70710678]})");
  EXPECT_LT(glm::distance(sees(down), glm::vec3(0, -1, 0)), 1e-5f);
}

TEST(GltfApplied, ASkinPosesItsMeshAtRest) {
  const Folder folder;
  // The left edge hangs on the joint at x = 10, the right one half on that and half on the joint at y = 4.
  QuadModel quad;
  quad.add("JOINTS_0", quad.maker.add_accessor(std::vector<uint8_t>{0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0}, 4, 5121));
  quad.add("WEIGHTS_0", quad.maker.add_floats({1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 0.5f, 0.5f, 0, 0, 1, 0, 0, 0}, 4));
  quad.maker.add_node(R"({"translation":[10,0,0]})");
  quad.maker.add_node(R"({"translation":[0,4,0]})");
  quad.maker.more = R"(,"skins":[{"joints":[0,1]}])";
  const LoadedModel model = quad.load(folder, R"({"mesh":0,"skin":0,"translation":[100,100,100]})");
  const Object& object = model.objects.at(0);
  EXPECT_EQ(object.world_from_object, glm::mat4(1)) << "its node's own place does not count";
  EXPECT_EQ(object.mesh.vertices.at(0).position, glm::vec3(10, 0, 0));
  EXPECT_EQ(object.mesh.vertices.at(2).position, glm::vec3(1 + 5, 1 + 2, 0));
  EXPECT_NE(all_of(model.warnings).find("skin at rest"), std::string::npos);
  // Bound where the joints are, it stays where it is.
  std::vector<float> matrices(32, 0);
  for (const size_t m : {0u, 16u}) matrices[m] = matrices[m + 5] = matrices[m + 10] = matrices[m + 15] = 1;
  matrices[12] = -10, matrices[16 + 13] = -4;
  const int inverse_bind = quad.maker.add_accessor(matrices, 4, 5126);
  std::string& accessor = quad.maker.accessors.back();
  accessor.replace(accessor.find(R"("count":8,"type":"VEC4")"), 23, R"("count":2,"type":"MAT4")");
  quad.maker.more = fmt::format(R"(,"skins":[{{"joints":[0,1],"inverseBindMatrices":{}}}])", inverse_bind);
  EXPECT_EQ(quad.load(folder, R"({"mesh":0,"skin":0})").objects.at(0).mesh.vertices.at(2).position, glm::vec3(1, 1, 0));
}

TEST(GltfApplied, MorphTargetsInTheirWeights) {
  const Folder folder;
  QuadModel quad;
  const int moved = quad.maker.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 2, 0, 0, 2}, 3);
  quad.members = fmt::format(R"(,"targets":[{{"POSITION":{}}}])", moved);
  EXPECT_EQ(quad.load(folder).objects.at(0).mesh.vertices.at(2).position, glm::vec3(1, 1, 0));
  const LoadedModel half = quad.load(folder, R"({"mesh":0,"weights":[0.5]})");
  EXPECT_EQ(half.objects.at(0).mesh.vertices.at(2).position, glm::vec3(1, 1, 1));
}

TEST(GltfApplied, WhatIsNotUsedRefusesNoModel) {
  const Folder folder;
  QuadModel quad;
  quad.maker.more = R"(,"animations":[{"channels":[{"sampler":9,"target":{"path":"pointer"}}]}],"cameras":[7],)"
                    R"("extensionsUsed":["KHR_xmp"],"extensionsRequired":["KHR_xmp"],"extensions":{"KHR_xmp":3})";
  const LoadedModel model = quad.load(folder);
  EXPECT_NE(all_of(model.warnings).find("its animations are not played"), std::string::npos);
  EXPECT_NE(all_of(model.warnings).find("requires KHR_xmp, which changes no picture"), std::string::npos);
}

TEST(GltfApplied, ChunksThatAreNotKnownAreIgnored) {
  const Folder folder;
  QuadModel quad;
  quad.maker.add_mesh("quad", {fmt::format(R"({{"attributes":{{{}}},"indices":{}}})", quad.attributes, quad.indices)});
  std::string glb = quad.maker.glb();
  glb += std::string("\4\0\0\0XYZ ", 8) + "what";
  const auto size = static_cast<uint32_t>(glb.size());
  std::memcpy(&glb[8], &size, 4);
  EXPECT_EQ(load_gltf(folder.write("more.glb", glb)).objects.size(), 1u);
}

TEST(GltfApplied, APrimitiveWithoutPositionsIsLeftOut) {
  const Folder folder;
  GltfMaker maker;
  const std::string whole = maker.quad();
  maker.add_mesh("two", {whole, R"({"attributes":{"NORMAL":1}})"});
  const LoadedModel model = load_made(folder, maker);
  EXPECT_EQ(model.objects.size(), 1u);
  EXPECT_NE(all_of(model.warnings).find("without POSITION"), std::string::npos);
}

}  // namespace
}  // namespace lamina
