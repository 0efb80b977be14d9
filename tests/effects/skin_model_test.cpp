// SPDX-License-Identifier: Apache-2.0
// Skin of a glTF model that a scene file asks for: it diffuses light as the closed form says; and a model without a unique
// unwrap.
#include <gtest/gtest.h>

#include "tests/effects/skin_scenes.h"
#include "tests/graph/each_backend.h"
#include "tests/scene/made_files.h"

namespace lamina {
namespace {

// The plate that edge_of_light_scene() makes, and what shadows it, as a model. `tiles`: by how many its texture coordinates go.
void write_plate_model(const std::filesystem::path& file, float tiles) {
  GltfMaker maker;
  const int positions = maker.add_floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, 3);
  const int normals = maker.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
  const int uvs = maker.add_floats({0, tiles, tiles, tiles, tiles, 0, 0, 0}, 2);
  const int indices = maker.add_accessor(std::vector<uint16_t>{0, 1, 2, 0, 2, 3}, 1, 5123);
  maker.add_mesh("square",
                 {fmt::format(R"({{"attributes":{{"POSITION":{},"NORMAL":{},"TEXCOORD_0":{}}},"indices":{},"material":0}})",
                              positions, normals, uvs, indices)});
  maker.add_node(R"({"mesh":0,"name":"plate","translation":[-0.03,-0.03,0],"scale":[0.06,0.06,1]})");
  maker.add_node(R"({"mesh":0,"name":"blocker","translation":[-0.06,-0.06,0.01],"scale":[0.0525,0.12,1]})");
  maker.more = R"(,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,1,1,1]}}])";
  std::ofstream(file, std::ios::binary) << maker.glb();
}

constexpr const char* lit_plate = R"(
[scene]
model = "plate.glb"
background = [0, 0, 0]
ambient = [0, 0, 0]
[lights.lamp]
kind = "directional"
direction = [0.6, 0, -0.8]
intensity = 1.25
casts = true
[views.view]
eye = [0.05, 0, 0.2]
target = [0, 0, 0]
fov_y_degrees = 8
[objects.blocker]
layers = false
)";
constexpr const char* of_skin = "[objects.plate.skin]\nspecular = 0\npenumbra = 0\n";

class SkinModels : public EachBackend {
 protected:
  void SetUp() override {
    EachBackend::SetUp();
    if (IsSkipped()) return;
    write_plate_model(folder_ / "plate.glb", 1);
  }
  Scene loaded(const std::string& text) { return load_scene(folder_.write("scene.toml", text).string(), builtin_library()); }

  const Folder folder_;
};

TEST_P(SkinModels, AModelHasSkinWhereTheSceneFileSaysSo) {
  EXPECT_FALSE(make_plan(library(), loaded(lit_plate), 1).of("skin")->called_for);
  const Scene scene = loaded(std::string(lit_plate) + of_skin);
  EXPECT_EQ(make_plan(library(), scene, 1).of("skin")->objects.size(), 1u) << "the blocker has none";
  const DrawnFrame::Choice choice = {.variant = &variant("six_gaussians"),
                                     .width = 128,
                                     .height = 128,
                                     .parameters = {{"six_gaussians.map_texels", 256}, {"six_gaussians.shadow_texels", 2048}},
                                     .aspect = 1};
  const glm::dvec3 error = edge_error(scene, DrawnFrame(*backend_, library(), scene, choice).picture());
  EXPECT_LT(error.r, .003);
  EXPECT_LT(std::max(error.g, error.b), .002);
  EXPECT_GT(edge_error(scene, picture(scene, "plain_lambert", 128)).r, 0.15);
}

// Variants that unwrap the mesh fail and say of which object and why; all others draw.
TEST_P(SkinModels, WithoutAUniqueUnwrapTexturesOfLightFailByName) {
  write_plate_model(folder_ / "plate.glb", 3);
  const Scene scene = loaded(std::string(lit_plate) + of_skin);
  ASSERT_FALSE(scene.objects[0].unwrap_problem.empty());
  size_t failed = 0, drawn = 0;
  for (const VariantManifest& each : library().effect("skin").variants) {
    SCOPED_TRACE(each.name);
    const bool unwraps =
        std::ranges::any_of(each.passes, [](const PassManifest& pass) { return pass.draw == DrawKind::unwrapped; });
    try {
      const Image image =
          DrawnFrame(*backend_, library(), scene, {.variant = &each, .width = 16, .height = 16, .aspect = 1}).picture();
      EXPECT_GT(pixel(image, 15, 8).r, 0.1f);
      ++drawn;
      EXPECT_FALSE(unwraps);
    } catch (const Error& error) {
      EXPECT_TRUE(unwraps) << error.what();
      ++failed;
      for (const char* part : {"object 'plate'", "cannot be drawn unwrapped, as pass '", "texture coordinates"})
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
  EXPECT_GE(failed, 10u);
  EXPECT_GE(drawn, 10u);
}

// Numbers out of range are refused where the file says them; a profile that is none, by object.
TEST_P(SkinModels, AWrongProfileIsRefusedByFileOrObject) {
  const auto with = [&](const std::string& line) { return loaded(std::string(lit_plate) + of_skin + line + "\n"); };
  expect_refused([&] { with("sigma_3 = -1"); }, {"scene.toml:20", "sigma_3", "0 to 1000"});
  expect_refused([&] { with("red_7 = 0.1"); }, {"scene.toml:20", "red_7", "red_"});
  for (const auto& [line, says] :
       {std::pair("red_5 = 0.2", "the red weights of the profile sum to 0.842: make skin.red_1 to skin.red_6 sum to 1"),
        {"sigma_3 = 0", "Gaussian 3 of the profile has a width of 0: give skin.sigma_3 in mm, above 0"},
        {"sigma_3 = 0.1", "Gaussian 3 of the profile is narrower than the one before it"}})
    expect_refused([&] { picture(with(line), "spherical_gaussians", 8); }, {"object 'plate'", says});
}

INSTANTIATE_TEST_SUITE_P(Backends, SkinModels, api_parameters, backend_test_name);

// Levels of a light map that has none: the manifest is refused, by file and line.
TEST(SkinVariants, LevelsOfAMapWithoutMipsAreRefused) {
  const Folder folder;
  std::filesystem::create_directories(folder / "mine");
  std::string text = bytes_of(std::filesystem::path(LAMINA_SOURCE_DIR) / "variants/skin/six_gaussians.toml");
  const auto replace = [&](const std::string& from, const std::string& to) {
    const size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  };
  replace("name = \"six_gaussians\"", "name = \"levels\"\neffect = \"skin\"");
  replace("baseline = true\n", "");
  replace("[[pass]]\nname = \"combine\"",
          "[[pass]]\nname = \"light_mips\"\ndraw = \"mips\"\nwrite = [\"light\"]\n[[pass]]\nname = \"combine\"");
  folder.write("mine/levels.toml", text);
  expect_refused([&] { load_library(LAMINA_SOURCE_DIR, effect_code(), {folder / "mine"}); },
                 {"levels.toml:", "'light' has no mips"});
}

}  // namespace
}  // namespace lamina
