// SPDX-License-Identifier: Apache-2.0
// Whole scenes by name, as commands take them.
#include <gtest/gtest.h>

#include <cmath>

#include "harness/scene/default_views.h"
#include "harness/scene/scene.h"
#include "tests/scene/declared.h"
#include "tests/scene/made_files.h"

namespace lamina {
namespace {

TEST(LoadScene, RefusesWhatIsNoScene) {
  const Folder folder;
  expect_refused([] { load_scene("hart", builtin_library()); }, {"hart", "did you mean 'heart'?"});
  expect_refused([] { load_scene("", builtin_library()); }, {"built-in scene"});
  expect_refused([&] { load_scene(folder.write("a.obj", "v 0 0 0").string(), builtin_library()); }, {"a.obj", ".glb"});
  expect_refused([&] { load_scene((folder / "none.glb").string(), builtin_library()); }, {"none.glb", "cannot be read"});
}

TEST(LoadScene, AModelByItsNameAloneIsComplete) {
  const Folder folder;
  GltfMaker maker;
  maker.add_mesh("square", {maker.quad()});
  maker.add_node(R"({"mesh":0,"name":"wall"})");
  const std::string file = folder.write("Square.GLB", maker.glb()).string();
  const Scene scene = load_scene(file, builtin_library(), 2.0f);
  EXPECT_EQ(scene.name, "Square");
  EXPECT_EQ(scene.source, file);
  EXPECT_EQ(scene.time_s, 2.0f);
  EXPECT_EQ(scene.views.size(), 3u);
  EXPECT_EQ(scene.lights.size(), 3u);
  EXPECT_FALSE(scene.mesh_moves || scene.lights_move);
  EXPECT_NEAR(transparency_of(scene.objects.at(0)), 0.55, 0.5 / 255);
  EXPECT_TRUE(scene.warnings.empty());
}

// Where nothing is laid out over the unwrap, texels may be used as often as one likes.
TEST(LoadScene, WarnsOfSharedTexelsWhereTheyMatter) {
  const Folder folder;
  GltfMaker maker;
  const int positions = maker.add_floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0, 3, 0, 0, 3, 1, 0}, 3);
  const int normals = maker.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
  const int uvs = maker.add_floats({0, 1, 1, 1, 1, 0, 0, 1, 1, 1, 1, 0}, 2);  // the second triangle over the first
  maker.add_mesh("twice",
                 {fmt::format(R"({{"attributes":{{"POSITION":{},"NORMAL":{},"TEXCOORD_0":{}}}}})", positions, normals, uvs)});
  maker.add_node(R"({"mesh":0,"name":"twice"})");
  folder.write("twice.glb", maker.glb());
  const auto warnings = [&](const std::string& keys) {
    return load_scene(
               folder.write("twice.toml", "[scene]\nmodel = \"twice.glb\"\n[objects.twice]\nlayers = false\n" + keys).string(),
               builtin_library())
        .warnings;
  };
  EXPECT_TRUE(warnings("").empty());
  EXPECT_TRUE(warnings("apertures = true\n").empty());
  ASSERT_EQ(warnings("[objects.twice.aperture]\nmap_texels = 64\n").size(), 1u);
  EXPECT_NE(warnings("[objects.twice.aperture]\nmap_texels = 64\n")[0].find("texture is used twice"), std::string::npos);
}

// Khronos's Damaged Helmet: 46356 indices, texture coordinates a tile below the first, one material with both maps. Parts of it
// share texels, and so become objects of their own.
TEST(LoadScene, DamagedHelmet) {
  const std::string file = LAMINA_DATA_DIR "/models/DamagedHelmet.glb";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "there is no " << file;
  const Scene scene = load_scene(file, builtin_library());
  ASSERT_FALSE(scene.objects.empty());
  EXPECT_EQ(scene.objects[0].name, "node_damagedHelmet_-6514");
  size_t indices = 0, leaning = 0;
  double volume = 0;  // by the divergence theorem: positive where triangles face outward
  for (const Object& part : scene.objects) {
    EXPECT_EQ(part.unwrap_problem, "");
    EXPECT_EQ(layer(part, "outer_albedo").width, 2048u);
    EXPECT_EQ(layer(part, "outer_normal").width, 2048u);
    EXPECT_EQ(layer(part, "inner_albedo").width, 1024u);
    EXPECT_EQ(thickness_of(part), 10.24);
    indices += part.mesh.indices.size();
    for (size_t i = 0; i < part.mesh.indices.size(); i += 3) {
      const auto p = [&](size_t corner) { return glm::dvec3(part.mesh.vertices[part.mesh.indices[i + corner]].position); };
      volume += glm::dot(p(0), glm::cross(p(1), p(2))) / 6;
    }
    for (const Vertex& vertex : part.mesh.vertices) {
      EXPECT_TRUE(glm::all(glm::greaterThanEqual(vertex.uv, glm::vec2(-0.001f)))) << vertex.uv.x << ", " << vertex.uv.y;
      EXPECT_TRUE(glm::all(glm::lessThanEqual(vertex.uv, glm::vec2(1.001f)))) << vertex.uv.x << ", " << vertex.uv.y;
      EXPECT_NEAR(glm::length(vertex.normal), 1.0f, 1e-4f);
      EXPECT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1.0f, 1e-4f);
      leaning += std::abs(glm::dot(vertex.normal, glm::vec3(vertex.tangent))) > 1e-4f;
    }
  }
  EXPECT_LE(indices, 46356u);
  EXPECT_GE(indices, 46000u);
  EXPECT_GT(volume, 0.5);
  EXPECT_EQ(leaning, 0u);
  EXPECT_NEAR(bounding_sphere(scene.objects).radius, 1.2f, 0.3f);
}

TEST(LoadScene, TheHeartWithAndWithoutAnExampleFile) {
  const Scene heart = load_scene("heart", builtin_library());
  EXPECT_EQ(heart.name, "heart");
  EXPECT_EQ(heart.source, "heart");
  EXPECT_FALSE(heart.objects.empty() || heart.views.empty() || heart.lights.empty());

  const Scene thick = load_scene(LAMINA_SOURCE_DIR "/variants/layered_material/scenes/heart_thick.toml", builtin_library());
  ASSERT_EQ(thick.objects.size(), heart.objects.size());
  EXPECT_EQ(thick.views.size(), 2u);
  const BoundingSphere bounds = bounding_sphere(thick.objects);
  for (const View& view : thick.views) EXPECT_GT(glm::distance(view.eye, bounds.centre), 0.5f * bounds.radius);
  bool any = false;
  for (const Object& object : thick.objects) {
    EXPECT_EQ(has_layers(object) ? thickness_of(object) : 24, 24);
    any |= has_layers(object) && transparency_of(object) > 0;
  }
  EXPECT_TRUE(any);

  const Scene opaque = load_scene(LAMINA_SOURCE_DIR "/variants/layered_material/scenes/opaque.toml", builtin_library());
  for (const Object& object : opaque.objects) EXPECT_EQ(has_layers(object) ? transparency_of(object) : 0, 0);

  const Scene still = load_scene(LAMINA_SOURCE_DIR "/variants/layered_material/scenes/heart_still.toml", builtin_library());
  EXPECT_TRUE(heart.moves());
  EXPECT_FALSE(still.moves());
}

}  // namespace
}  // namespace lamina
