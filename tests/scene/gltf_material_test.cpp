// SPDX-License-Identifier: Apache-2.0
// Materials of glTF models, and what a bare model gets of them.
#include <gtest/gtest.h>

#include <cmath>

#include "harness/scene/gltf/gltf.h"
#include "harness/scene/mesh/texel_density.h"
#include "harness/scene/model_look.h"
#include "tests/scene/declared.h"
#include "tests/scene/made_files.h"

namespace lamina {
namespace {

// A quad of one metre with one material, `material` its JSON; pictures beside the model are textures in the order given.
LoadedModel load(const Folder& folder, const std::string& material, const std::vector<std::string>& pictures = {}) {
  GltfMaker maker;
  maker.add_mesh("square", {maker.quad(R"(,"material":0)")});
  maker.add_node(R"({"mesh":0,"name":"wall"})");
  std::vector<std::string> textures, images;
  for (size_t i = 0; i < pictures.size(); ++i) {
    textures.push_back(fmt::format(R"({{"source":{}}})", i));
    images.push_back(
        fmt::format(R"({{"bufferView":{},"mimeType":"image/png"}})", maker.add_view(bytes_of(folder / pictures[i]))));
  }
  maker.more = fmt::format(R"(,"materials":[{}],"textures":[{}],"images":[{}])", material, fmt::join(textures, ","),
                           fmt::join(images, ","));
  LoadedModel model = load_gltf(folder.write("model.glb", maker.glb()));
  declare_objects(model.objects, builtin_library());
  return model;
}

const TextureImage& texture(const LoadedModel& model, const std::string& name) { return layer(model.objects.at(0), name); }
double thickness(const LoadedModel& model) { return thickness_of(model.objects.at(0)); }
glm::vec4 first_texel(const TextureImage& texture) { return base_texels(texture).rgba.at(0); }

TEST(GltfMaterial, AModelThatSaysNothingGetsSensibleLayers) {
  const Folder folder;
  const LoadedModel model = load(folder, R"({"name":"plain"})");
  EXPECT_EQ(glm::vec3(first_texel(texture(model, "outer_albedo"))), glm::vec3(1));
  EXPECT_NEAR(first_texel(texture(model, "outer_albedo")).a, 0.55f, 0.5f / 255);
  EXPECT_LT(glm::distance(glm::vec3(first_texel(texture(model, "outer_normal"))) * 2.0f - 1.0f, glm::vec3(0, 0, 1)), 0.01f);
  EXPECT_EQ(texture(model, "inner_albedo").width, 512u);
  EXPECT_EQ(thickness(model), 5.12) << "a hundredth of the inner layer's width";
  EXPECT_EQ(layers_of(model.objects[0]).numbers.at("scattering"), 1);
  EXPECT_EQ(albedo_of(model.objects[0]), layers_of(model.objects[0]).textures.at("outer_albedo")) << "made once";
}

// Of the albedo's size, but no side below 512 or above 1024.
TEST(GltfMaterial, TheInnerLayerThatAModelLacksHasABoundedSize) {
  const Folder folder;
  write_png(folder / "wide.png", 2048, 8, 3, std::vector<uint8_t>(2048 * 8 * 3, 255));
  write_png(folder / "tall.png", 8, 768, 3, std::vector<uint8_t>(8 * 768 * 3, 255));
  const std::string material = R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
  const LoadedModel wide = load(folder, material, {"wide.png"}), tall = load(folder, material, {"tall.png"});
  EXPECT_EQ(texture(wide, "inner_albedo").width, 1024u);
  EXPECT_EQ(texture(wide, "inner_albedo").height, 512u);
  EXPECT_EQ(texture(tall, "inner_albedo").width, 512u);
  EXPECT_EQ(texture(tall, "inner_albedo").height, 768u);
}

TEST(GltfMaterial, FactorAndTextureMultiplyInLinearLight) {
  const Folder folder;
  write_png(folder / "a.png", 1, 1, 3, {188, 255, 0});
  const LoadedModel model =
      load(folder, R"({"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,1],"baseColorTexture":{"index":0}}})", {"a.png"});
  // 188 is linear 0.503; half of it is linear 0.251, code 137.
  const glm::vec4 texel = first_texel(texture(model, "outer_albedo"));
  EXPECT_NEAR(texel.r, 0.2514f, 0.002f);
  EXPECT_NEAR(texel.g, 0.25f, 0.002f);
  EXPECT_EQ(texel.b, 0.0f);
}

TEST(GltfMaterial, AlphaIsOpacityWhereItCounts) {
  const Folder folder;
  write_png(folder / "a.png", 2, 1, 4, {255, 255, 255, 51, 255, 255, 255, 204});
  const auto alphas = [&](const std::string& mode) {
    const LoadedModel model =
        load(folder,
             R"({"alphaMode":")" + mode +
                 R"(","alphaCutoff":0.6,)"
                 R"("pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.9],"baseColorTexture":{"index":0}}})",
             {"a.png"});
    const Texels texels = base_texels(texture(model, "outer_albedo"));
    return glm::vec2(texels.rgba.at(0).a, texels.rgba.at(1).a);
  };
  const float code = 0.51f / 255;
  EXPECT_LT(glm::distance(alphas("BLEND"), glm::vec2(1 - 0.9f * 0.2f, 1 - 0.9f * 0.8f)), 1.5f * code);
  EXPECT_EQ(alphas("MASK"), glm::vec2(1, 0)) << "0.18 lies below the cutoff, 0.72 above";
  EXPECT_LT(glm::distance(alphas("OPAQUE"), glm::vec2(0.55f)), 1.5f * code);
}

// glTF: green is up the picture; scene.h: down. (0.6, 0.48, 0.64) points right and up.
TEST(GltfMaterial, NormalMapsAreTurnedGreenDownAndScaled) {
  const Folder folder;
  const auto code = [](double v) { return uint8_t(std::lround((v * 0.5 + 0.5) * 255)); };
  write_png(folder / "n.png", 1, 1, 3, {code(0.6), code(0.48), code(0.64)});
  const auto normal = [&](const std::string& scale) {
    const LoadedModel model = load(folder, R"({"normalTexture":{"index":0)" + scale + "}}", {"n.png"});
    return glm::vec3(first_texel(texture(model, "outer_normal"))) * 2.0f - 1.0f;
  };
  EXPECT_LT(glm::distance(normal(""), glm::vec3(0.6f, -0.48f, 0.64f)), 0.01f);
  EXPECT_LT(glm::distance(normal(R"(,"scale":3)"), glm::normalize(glm::vec3(1.8f, -1.44f, 0.64f))), 0.01f);
  EXPECT_LT(glm::distance(normal(R"(,"scale":0)"), glm::vec3(0, 0, 1)), 0.01f);
}

// One square metre covers the whole texture of 512 x 512: 0.01 m are 5.12 texels.
TEST(GltfMaterial, VolumeThicknessBecomesTexels) {
  const Folder folder;
  const LoadedModel thick = load(folder, R"({"extensions":{"KHR_materials_volume":{"thicknessFactor":0.01}}})");
  EXPECT_NEAR(thickness(thick), 5.12, 1e-4);
  const LoadedModel whole = load(folder, R"({"extensions":{"KHR_materials_volume":{"thicknessFactor":2}}})");
  EXPECT_NEAR(thickness(whole), 1024, 1e-2);
  const LoadedModel thin = load(folder, R"({"extensions":{"KHR_materials_volume":{}}})");
  EXPECT_EQ(thickness(thin), 5.12) << "says nothing: the default";
  expect_refused([&] { load(folder, R"({"extensions":{"KHR_materials_volume":{"thicknessFactor":-1}}})"); },
                 {"thicknessFactor"});
}

// Metres are counted in texels, which such a mesh has none of.
TEST(GltfMaterial, AThicknessWithoutTextureCoordinatesIsLeftOutAloud) {
  const Folder folder;
  const auto load_without = [&](const std::string& attributes, const std::string& extensions) {
    GltfMaker maker;
    const int positions = maker.add_floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, 3);
    maker.add_floats(std::vector<float>(8, 0.25f), 2);  // accessor 1: all in one point
    const int indices = maker.add_accessor(std::vector<uint16_t>{0, 1, 2, 0, 2, 3}, 1, 5123);
    maker.add_mesh("square", {fmt::format(R"({{"attributes":{{"POSITION":{}{}}},"indices":{},"material":0}})", positions,
                                          attributes, indices)});
    maker.add_node(R"({"mesh":0,"name":"wall"})");
    maker.more = fmt::format(R"(,"materials":[{{{}}}])", extensions);
    LoadedModel model = load_gltf(folder.write("model.glb", maker.glb()));
    declare_objects(model.objects, builtin_library());
    return model;
  };
  const std::string volume = R"("extensions":{"KHR_materials_volume":{"thicknessFactor":0.5}})";
  for (const char* uv : {"", R"(,"TEXCOORD_0":1)"}) {
    const LoadedModel model = load_without(uv, volume);
    EXPECT_EQ(thickness(model), 5.12) << "that of a model that gives none";
    const std::string said = fmt::format("{}", fmt::join(model.warnings, "|"));
    const std::string words = "The thickness of 'wall' in metres is left out";
    ASSERT_NE(said.find(words), std::string::npos) << said;
    EXPECT_EQ(said.find(words, said.find(words) + 1), std::string::npos) << "once";
    EXPECT_EQ(fmt::format("{}", fmt::join(load_without(uv, "").warnings, "|")).find("thickness"), std::string::npos);
  }
}

// Density is the mesh's mean: a quad stretched to 2 m x 8 m over the same texture has sqrt(1 / 16) of the density.
TEST(LengthInTexels, IsTheMeanDensityOfTheMesh) {
  Mesh mesh;
  for (const glm::vec2 p : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}})
    mesh.vertices.push_back({glm::vec3(2 * p.x, 0, 8 * p.y), {0, 1, 0}, {1, 0, 0, 1}, p});
  mesh.indices = {0, 1, 2, 0, 2, 3};
  TextureImage texture;
  texture.width = 64, texture.height = 256;
  EXPECT_NEAR(length_in_texels(0.5f, mesh, texture, "quad"), 0.5f * 128 / 4, 1e-4f);
  for (Vertex& vertex : mesh.vertices) vertex.uv.x = 0;
  expect_refused([&] { length_in_texels(0.5f, mesh, texture, "quad"); }, {"quad", "no area"});
}

// The mesh has one set of texture coordinates, which the base colour takes; the normal map would need another.
TEST(GltfMaterial, WarnsOfWhatItLeavesOut) {
  const Folder folder;
  write_png(folder / "a.png", 1, 1, 3, {9, 9, 9});
  const LoadedModel model = load(folder,
                                 R"({"name":"m","pbrMetallicRoughness":{"baseColorTexture":{"index":0}},)"
                                 R"("normalTexture":{"index":0,"texCoord":1}})",
                                 {"a.png"});
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].find("material 'm''s normal map has other texture coordinates"), std::string::npos);
}

TEST(GltfMaterial, WebpAloneOrBesideAnother) {
  const Folder folder;
  write_png(folder / "green.png", 1, 1, 3, {0, 255, 0});
  const auto colour = [&](const std::string& texture) {
    GltfMaker maker;
    maker.add_mesh("square", {maker.quad(R"(,"material":0)")});
    maker.add_node(R"({"mesh":0,"name":"wall"})");
    const int webp = maker.add_view(webp_bytes()), png = maker.add_view(bytes_of(folder / "green.png"));
    maker.more =
        fmt::format(R"(,"materials":[{{"pbrMetallicRoughness":{{"baseColorTexture":{{"index":0}}}}}}],"textures":[{}],)"
                    R"("images":[{{"bufferView":{},"mimeType":"image/webp"}},{{"bufferView":{},"mimeType":"image/png"}}],)"
                    R"("extensionsUsed":["EXT_texture_webp"],"extensionsRequired":["EXT_texture_webp"])",
                    texture, webp, png);
    const LoadedModel model = load_gltf(folder.write("model.glb", maker.glb()));
    EXPECT_TRUE(model.warnings.empty()) << model.warnings.at(0);
    return glm::vec3(model.objects.at(0).look->base_colour.rgba.at(0));
  };
  const std::string extension = R"("extensions":{"EXT_texture_webp":{"source":0}})";
  EXPECT_EQ(colour("{" + extension + "}"), glm::vec3(1, 0, 0)) << "the picture in WebP is all there is";
  EXPECT_EQ(colour(R"({"source":1,)" + extension + "}"), glm::vec3(0, 1, 0)) << "of two the plain one is taken";
}

TEST(GltfMaterial, RefusesPicturesThatCannotBeHad) {
  const Folder folder;
  folder.write("broken.png", "no picture at all");
  const std::string material = R"({"name":"skin","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
  expect_refused([&] { load(folder, material, {"broken.png"}); }, {"material 'skin'", "base colour texture"});
  expect_refused([&] { load(folder, material); }, {"material 'skin'", "texture 0"});
  expect_refused([&] { load(folder, R"({"name":"skin","alphaMode":"FOG"})"); }, {"material 'skin'", "FOG", "BLEND"});
  expect_refused([&] { load(folder, R"({"pbrMetallicRoughness":{"baseColorFactor":[1,1]}})"); }, {"baseColorFactor"});
}

// Pictures that nothing shows are not decoded: a model with a damaged emissive texture loads.
TEST(GltfMaterial, DecodesOnlyWhatLayersUse) {
  const Folder folder;
  folder.write("broken.png", "no picture at all");
  EXPECT_NO_THROW(load(folder, R"({"emissiveTexture":{"index":0},"occlusionTexture":{"index":0}})", {"broken.png"}));
}

}  // namespace
}  // namespace lamina
