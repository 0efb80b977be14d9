// SPDX-License-Identifier: Apache-2.0
// Hair of a glTF model's mesh, whose base colour has alpha.
#include <gtest/gtest.h>

#include "tests/graph/each_backend.h"
#include "tests/scene/made_files.h"

namespace lamina {
namespace {

class HairModels : public EachBackend {};

TEST_P(HairModels, AMeshWithAlphaIsHair) {
  const Folder folder;
  GltfMaker maker;
  maker.add_mesh("cards", {maker.quad(R"(,"material":0)")});
  maker.add_node(R"({"mesh":0,"name":"fringe"})");
  maker.more = R"(,"materials":[{"alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],)"
               R"("textures":[{"source":0}],"images":[{"uri":"strands.png"}])";
  // Eight columns: the left half covers half, the right one nothing.
  std::vector<uint8_t> codes;
  for (int i = 0; i < 64; ++i) codes.insert(codes.end(), {255, 255, 255, uint8_t(i % 8 < 4 ? 128 : 0)});
  write_png(folder / "strands.png", 8, 8, 4, codes);
  folder.write("cards.glb", maker.glb());
  const Scene scene = load_scene(folder
                                     .write("hair.toml", R"(
[scene]
model = "cards.glb"
background = [0, 0, 0]
ambient = [1, 1, 1]
[objects.fringe.hair]
strength = 0
gloss_strength = 0
[lights.off]
kind = "directional"
direction = [0, 0, -1]
intensity = 0
[views.head_on]
eye = [0.5, 0.5, 10]
target = [0.5, 0.5, 0]
fov_y_degrees = 5.7248
)")
                                     .string(),
                                 builtin_library());
  EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
  for (const char* name : {"samples", "sorted", "gradient_golden_blur_strand"}) {
    const Image image = picture(scene, name, 32);
    double left = 0, right = 0;
    for (int y = 0; y < 32; ++y) {
      for (int x = 2; x < 12; ++x) left += double(pixel(image, x, y).r) / 320;
      for (int x = 20; x < 30; ++x) right += double(pixel(image, x, y).r) / 320;
    }
    EXPECT_NEAR(left, 128.0 / 255, 0.05) << name;
    EXPECT_EQ(right, 0) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, HairModels, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
