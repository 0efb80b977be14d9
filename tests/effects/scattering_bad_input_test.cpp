// SPDX-License-Identifier: Apache-2.0
// What users may say wrongly of fog and of light through objects: one message with file and line.
#include <gtest/gtest.h>

#include "harness/scene/scene.h"
#include "tests/builtin_library.h"
#include "tests/scene/made_files.h"

namespace lamina {
namespace {

// A tetrahedron, as it should be, without its last face, or with that face turned.
std::string tetrahedron_model(const std::vector<uint16_t>& last_face) {
  GltfMaker maker;
  std::vector<uint16_t> indices = {0, 2, 1, 0, 1, 3, 0, 3, 2};
  indices.insert(indices.end(), last_face.begin(), last_face.end());
  const int positions = maker.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 3);
  const int normals = maker.add_floats({-0.57735f, -0.57735f, -0.57735f, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 3);
  const int uvs = maker.add_floats({0, 0, 1, 0, 0, 1, 1, 1}, 2);
  const int faces = maker.add_accessor(indices, 1, 5123);
  maker.add_mesh("hull", {fmt::format(R"({{"attributes":{{"POSITION":{},"NORMAL":{},"TEXCOORD_0":{}}},"indices":{}}})",
                                      positions, normals, uvs, faces)});
  maker.add_node(R"({"mesh":0,"name":"hull"})");
  return maker.glb();
}

class ScatteringInput : public testing::Test {
 protected:
  // A scene file whose third line is the first of `says`.
  std::string write(const std::string& says, const std::vector<uint16_t>& last_face = {1, 2, 3}) {
    folder_.write("hull.glb", tetrahedron_model(last_face));
    return folder_.write("a.toml", "[scene]\nmodel = \"hull.glb\"\n" + says).string();
  }
  void expect_refused_at(int line, const std::string& says, const std::string& why,
                         const std::vector<uint16_t>& last_face = {1, 2, 3}) {
    SCOPED_TRACE(says);
    const std::string file = write(says, last_face);
    expect_refused([&] { load_scene(file, builtin_library()); }, {fmt::format("a.toml:{}:", line), why});
  }

  Folder folder_;
};

TEST_F(ScatteringInput, FogNeedsAHullARampAndADensity) {
  EXPECT_EQ(load_scene(write("[objects.hull]\nfog = true\n"), builtin_library()).objects.size(), 1u);
  expect_refused_at(3, "[objects.hull]\nfog = true\n", "volume_fog needs a closed hull, and its mesh is open: the edge from (",
                    {});
  expect_refused_at(3, "[objects.hull]\nfog = true\n", "volume_fog needs a closed hull, and its mesh", {1, 3, 2});
  const std::string fog = "[objects.hull]\nfog = true\n[effects.volume_fog]\n";
  expect_refused_at(6, fog + "density = -1\n", "'density' must be a number from 0 to 10000");
  expect_refused_at(6, fog + "density = inf\n", "'density' must be a number from 0 to 10000");
  expect_refused_at(4, "[objects.hull.fog]\nshare = 1.5\n", "'share' must be a number from 0 to 1");
  // Near and far planes are fitted, so that none lies before the other.
  expect_refused_at(5, "[views.close]\nnear = 5\nfar = 1\neye = [0, 0, 9]\ntarget = [0, 0, 0]\n",
                    "unknown key 'far' (known: eye, target, up, fov_y_degrees)");
}

// One texel is one colour for any thickness. A file of one texel, one that is only high, and a colour alone are such.
TEST_F(ScatteringInput, ARampOfOneTexelIsRefused) {
  write_png(folder_ / "one.png", 1, 1, 3, {9, 9, 9});
  write_png(folder_ / "high.png", 1, 2, 3, {9, 9, 9, 8, 8, 8});
  write_png(folder_ / "two.png", 2, 1, 3, {9, 9, 9, 8, 8, 8});
  const std::string fog = "[objects.hull]\nfog = true\n[effects.volume_fog]\nramp_length = 2\n";
  for (const std::string ramp : {"\"one.png\"", "\"high.png\"", "[1, 0, 0]"})
    expect_refused_at(7, fog + "ramp = " + ramp + "\n", "'ramp' is 1 texel wide and must be 2 at least");
  expect_refused_at(7, fog + "ramp_opacity = \"one.png\"\n", "'ramp_opacity' is 1 texel wide and must be 2 at least");
  for (const std::string ramp : {"ramp = \"two.png\"", "ramp = [1, 0, 0]\nramp_opacity = \"two.png\""})
    EXPECT_EQ(load_scene(write(fog + ramp + "\n"), builtin_library()).effects.at("volume_fog").textures.at("ramp")->width, 2u);
  expect_refused_at(4, "[objects.hull.translucency]\nramp = \"one.png\"\n", "'translucency.ramp' is 1 texel wide");
}

TEST_F(ScatteringInput, AMediumHasAnExtinctionThatIsANumber) {
  const std::string medium = "[objects.hull.translucency]\n";
  EXPECT_EQ(load_scene(write(medium), builtin_library()).objects.size(), 1u);
  for (const char* value : {"-1", "inf", "-inf", "nan", "2e9"})
    expect_refused_at(4, medium + "extinction_red = " + value + "\n", "'extinction_red' must be a number from 0 to");
  expect_refused_at(4, medium + "refraction_index = 0.9\n", "'refraction_index' must be a number from 1 to 3");
}

}  // namespace
}  // namespace lamina
