// SPDX-License-Identifier: Apache-2.0
// Models that once were drawn wrong or refused, from ../shared/cases where it is there: what each must give.
#include <gtest/gtest.h>

#include "harness/scene/gltf/gltf.h"
#include "harness/scene/mesh/unwrap_check.h"
#include "harness/scene/model_look.h"
#include "tests/scene/made_files.h"

namespace lamina {
namespace {

class GltfCases : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder_)) GTEST_SKIP() << folder_ << " is not here";
  }
  LoadedModel load_case(const std::string& name) const { return load_gltf(folder_ / name); }
  static bool says(const LoadedModel& model, const std::string& words) {
    return fmt::format("{}", fmt::join(model.warnings, "\n")).find(words) != std::string::npos;
  }
  const std::filesystem::path folder_ = std::filesystem::path(LAMINA_SOURCE_DIR) / "../shared/cases";
};

TEST_F(GltfCases, WhatIsValidIsDrawn) {
  for (const char* name :
       {"vertex_colours.gltf", "texture_transform.gltf", "second_uv_set.gltf", "skin_without_matrices.gltf",
        "animation_without_node.gltf", "no_texture_coordinates.gltf", "quantized.gltf", "double_sided_from_behind.gltf",
        "models/c01_unknown_chunk_no_bin.glb", "models/c07_empty_bin_chunk.glb", "models/d14_anim_pointer.gltf",
        "models/m06_only_uv1.glb", "models/p15_one_without_pos.gltf", "models/x03_xmp.gltf", "models/u20_data_none.gltf",
        "models/u20_data_octet_charset.gltf", "models/u22_img_jpg.gltf"})
    EXPECT_NO_THROW(EXPECT_FALSE(load_case(name).objects.empty())) << name;
}

TEST_F(GltfCases, WhatIsNotIsRefusedInWordsAboutTheModel) {
  expect_refused([&] { load_case("models/x04_req_str.gltf"); }, {"'extensionsRequired' is not a list of names"});
  expect_refused([&] { load_case("models/c12_version_3_0.gltf"); }, {"glTF version '3.0'"});
  expect_refused([&] { load_case("models/u14_dir.gltf"); },
                 {"buffer 0", "'sub'"});  // a folder, where there is one of that name
}

TEST_F(GltfCases, APaletteHasNoUnwrap) {
  EXPECT_EQ(share_without_texels(load_case("palette_cube.gltf").objects.at(0).mesh), 1);
  const Mesh half = load_case("half_palette_cube.gltf").objects.at(0).mesh;
  EXPECT_NEAR(share_without_texels(half), 0.5, 1e-6);
  EXPECT_NE(unwrap_problem(half).find("no area on 50% of its surface"), std::string::npos) << unwrap_problem(half);
  EXPECT_EQ(load_case("palette_cube.gltf").objects.at(0).look->base_colour.width, 1024u) << "its texels are repeated";
}

TEST_F(GltfCases, WhatIsLeftOutIsSaid) {
  EXPECT_TRUE(says(load_case("models/p15_one_without_pos.gltf"), "without POSITION"));
  EXPECT_TRUE(says(load_case("models/x03_xmp.gltf"), "changes no picture"));
  EXPECT_TRUE(says(load_case("no_texture_coordinates.gltf"), "no texture coordinates"));
  for (const char* name : {"vertex_colours.gltf", "texture_transform.gltf", "second_uv_set.gltf", "quantized.gltf"})
    EXPECT_TRUE(load_case(name).warnings.empty()) << name;
}

TEST_F(GltfCases, AQuantizedSquareHasASideOfTwo) {
  const LoadedModel model = load_case("quantized.gltf");
  for (const Vertex& vertex : model.objects.at(0).mesh.vertices) EXPECT_NEAR(std::abs(vertex.position.x), 1, 1e-6);
}

}  // namespace
}  // namespace lamina
