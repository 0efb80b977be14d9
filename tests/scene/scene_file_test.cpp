// SPDX-License-Identifier: Apache-2.0
// Scene files: what they change, and what they refuse with file and line.
#include "harness/scene/scene_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/scene/declared.h"
#include "tests/scene/made_files.h"

namespace lamina {
namespace {

// Two squares, "wall" and "floor", with a one-texel material each, beside the scene files of a test.
class SceneFile : public testing::Test {
 protected:
  SceneFile() {
    GltfMaker maker;
    maker.add_mesh("square", {maker.quad()});
    maker.add_node(R"({"mesh":0,"name":"wall","translation":[1,0,0]})");
    maker.add_node(R"({"mesh":0,"name":"floor"})");
    folder_.write("model.glb", maker.glb());
    write_png(folder_ / "ramp.png", 4, 2, 3,
              {0, 0, 0, 85, 9, 9, 170, 9, 9, 255, 9, 9, 0, 0, 0, 85, 9, 9, 170, 9, 9, 255, 9, 9});
  }
  // A scene file that starts with the model in lines 1 and 2; `rest` starts in line 3.
  std::string write(const std::string& rest) {
    return folder_.write("a.toml", "[scene]\nmodel = \"model.glb\"\n" + rest).string();
  }
  Scene load(const std::string& rest) { return load_scene(write(rest), builtin_library()); }
  // Refused at a.toml's `line` in words that hold all of `parts`.
  void expect_refused_at(int line, const std::string& rest, std::vector<std::string> parts) {
    const std::string file = write(rest);
    parts.push_back(fmt::format("a.toml:{}:", line));
    expect_refused([&] { load_scene(file, builtin_library()); }, parts);
  }
  static const Object& named(const Scene& scene, const std::string& name) {
    for (const Object& object : scene.objects)
      if (object.name == name) return object;
    throw std::runtime_error("no object " + name);
  }
  static glm::vec4 texel(const TextureImage& texture, size_t i = 0) { return base_texels(texture).rgba.at(i); }

  Folder folder_;
};

TEST_F(SceneFile, AloneIsTheModelWithDefaults) {
  const Scene scene = load("");
  EXPECT_EQ(scene.name, "a");
  EXPECT_EQ(scene.source, (folder_ / "a.toml").string());
  EXPECT_EQ(scene.objects.size(), 2u);
  EXPECT_EQ(scene.views.size(), 3u);
  EXPECT_EQ(scene.lights.size(), 3u);
  EXPECT_EQ(scene.background, glm::vec3(0.05f));
  EXPECT_EQ(scene.time_s, 0.0f);
  EXPECT_NEAR(transparency_of(scene.objects[0]), 0.55, 0.5 / 255);
}

TEST_F(SceneFile, SceneKeys) {
  const std::string keys = "name = \"b\"\ntime = 1.5\nbackground = [0, 0.5, 1]\nambient = [0.1, 0.2, 0.3]\n";
  const Scene scene = load(keys);
  EXPECT_EQ(scene.name, "b");
  EXPECT_EQ(scene.time_s, 1.5f);
  EXPECT_EQ(scene.background, glm::vec3(0, 0.5f, 1));
  EXPECT_EQ(scene.ambient, glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(load_scene(write(keys), builtin_library(), 9.0f).time_s, 9.0f) << "the caller's time goes first";
}

TEST_F(SceneFile, ThicknessAndScatteringOfOneAndOfAll) {
  const Scene scene = load("[objects.wall]\nthickness = 3\n[objects.\"*\"]\nthickness = 24.5\nscattering = 0.5\n");
  EXPECT_EQ(thickness_of(named(scene, "wall")), 3) << "the entry that names it comes last";
  EXPECT_EQ(thickness_of(named(scene, "floor")), 24.5);
  EXPECT_EQ(layers_of(named(scene, "wall")).numbers.at("scattering"), 0.5);
}

TEST_F(SceneFile, LayersCanBeTakenAway) {
  const Scene scene = load("[objects.wall]\nlayers = false\nalbedo = [1, 0, 0]\n");
  EXPECT_FALSE(has_layers(named(scene, "wall")));
  EXPECT_EQ(glm::vec3(texel(*albedo_of(named(scene, "wall")))), glm::vec3(1, 0, 0));
  EXPECT_TRUE(has_layers(named(scene, "floor")));
  // Taken from all, given back to one.
  const Scene back = load("[objects.\"*\"]\nlayers = false\n[objects.floor.outer]\nalbedo = [0, 1, 0]\n");
  EXPECT_FALSE(has_layers(named(back, "wall")));
  EXPECT_NEAR(transparency_of(named(back, "floor")), 0.55, 0.5 / 255);
  // The model's own come back.
  const Scene own = load("[objects.\"*\"]\nlayers = false\n[objects.floor]\nlayers = true\nthickness = 2\n");
  EXPECT_FALSE(has_layers(named(own, "wall")));
  EXPECT_EQ(thickness_of(named(own, "floor")), 2);
  EXPECT_EQ(glm::vec3(texel(layer(named(own, "floor"), "outer_albedo"))), glm::vec3(1));
}

TEST_F(SceneFile, LayersWithoutAnOuterAlbedoAreRefused) {
  const std::string file =
      folder_.write("b.toml", "[scene]\nbuiltin = \"open_plane\"\n[objects.plane]\nthickness = 2\n").string();
  expect_refused([&] { load_scene(file, builtin_library()); }, {"b.toml:3:", "'plane'", "outer.albedo"});
}

TEST_F(SceneFile, OuterAlbedoAndTransparencyCombineAtTheLargerSize) {
  const Scene scene = load(
      "[objects.wall.outer]\nalbedo = [0, 1, 0]\ntransparency = \"ramp.png\"\n"
      "[objects.floor.outer]\nalbedo = \"ramp.png\"\n");
  const TextureImage& wall = layer(named(scene, "wall"), "outer_albedo");
  ASSERT_EQ(wall.width, 4u);
  ASSERT_EQ(wall.height, 2u);
  for (size_t x = 0; x < 4; ++x) {
    EXPECT_NEAR(texel(wall, x).a, float(x) / 3, 1e-6f) << "red, as it is in the file";
    EXPECT_EQ(glm::vec3(texel(wall, x)), glm::vec3(0, 1, 0));
  }
  const TextureImage& floor = layer(named(scene, "floor"), "outer_albedo");
  EXPECT_NEAR(texel(floor, 1).r, 0.0908417f, 1e-5f) << "code 85 in linear light";
  EXPECT_NEAR(texel(floor, 1).a, 0.55f, 0.5f / 255) << "the transparency that was there";
}

TEST_F(SceneFile, TransparencyZeroCallsForNothing) {
  const Scene scene = load("[objects.\"*\".outer]\ntransparency = 0\n");
  for (const Object& object : scene.objects) EXPECT_EQ(transparency_of(object), 0);
}

TEST_F(SceneFile, InnerAlbedoKeepsTheThicknessAsAShareOfItsWidth) {
  const Scene scene = load("[objects.wall.inner]\nalbedo = [0.5, 0, 0]\n[objects.floor.inner]\nalbedo = \"ramp.png\"\n");
  const Object& wall = named(scene, "wall");
  EXPECT_EQ(layer(wall, "inner_albedo").width, 512u) << "one colour is spread over the size that was there";
  EXPECT_EQ(thickness_of(wall), 5.12);
  const Object& floor = named(scene, "floor");
  EXPECT_EQ(layer(floor, "inner_albedo").width, 4u);
  EXPECT_EQ(thickness_of(floor), 0.04);
}

TEST_F(SceneFile, NormalMapsAreGreenUpInTheFile) {
  const auto code = [](double v) { return uint8_t(std::lround((v * 0.5 + 0.5) * 255)); };
  write_png(folder_ / "n.png", 1, 1, 3, {code(0.6), code(0.48), code(0.64)});
  const Scene scene = load("[objects.wall.outer]\nnormal = \"n.png\"\n");
  const glm::vec3 n = glm::vec3(texel(layer(named(scene, "wall"), "outer_normal"))) * 2.0f - 1.0f;
  EXPECT_LT(glm::distance(n, glm::vec3(0.6f, -0.48f, 0.64f)), 0.01f);
}

// Scaled by 2, then a quarter turn about x (y to z), then about z (x to y), then moved; on top of wall's own move by 1 in x.
// Its corner (1, 1, 0) stands at (2, 1, 0): (4, 2, 0), (4, 0, 2), (0, 4, 2), (0, 4, 12).
TEST_F(SceneFile, PlacesObjectsInTheOrderScaleTurnMove) {
  const Scene scene = load(
      "[objects.wall]\nposition = [0, 0, 10]\nrotation_degrees = [90, 0, 90]\nscale = 2\n"
      "[objects.floor]\nscale = [1, 2, 3]\n");
  const Object& wall = named(scene, "wall");
  const glm::vec3 corner(wall.world_from_object * glm::vec4(wall.mesh.vertices[2].position, 1));
  EXPECT_LT(glm::distance(corner, glm::vec3(0, 4, 12)), 1e-5f);
  const glm::mat4 floor = named(scene, "floor").world_from_object;
  EXPECT_EQ(glm::vec3(floor[0][0], floor[1][1], floor[2][2]), glm::vec3(1, 2, 3));
}

TEST_F(SceneFile, LightsReplaceTheDefaultOnesInTheFilesOrder) {
  const Scene scene = load(
      "[lights.sun]\nkind = \"directional\"\ndirection = [0, -2, 0]\ncolor = [1, 0.5, 0]\nintensity = 4\n"
      "[lights.bulb]\nkind = \"point\"\nposition = [1, 2, 3]\n");
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.lights[0].name, "sun");
  EXPECT_EQ(scene.lights[0].direction, glm::vec3(0, -1, 0)) << "unit length";
  EXPECT_EQ(scene.lights[0].radiance, glm::vec3(4, 2, 0));
  EXPECT_EQ(scene.lights[1].kind, Light::Kind::point);
  EXPECT_EQ(scene.lights[1].position, glm::vec3(1, 2, 3));
  EXPECT_EQ(scene.lights[1].radiance, glm::vec3(1));
  EXPECT_EQ(scene.views.size(), 3u) << "the default views stay";
}

TEST_F(SceneFile, ViewsReplaceTheDefaultOnesAndFitTheirDepth) {
  const Scene scene = load("[views.far]\neye = [0, 0, 100]\ntarget = [0, 0, 0]\nup = [1, 0, 0]\nfov_y_degrees = 10\n");
  ASSERT_EQ(scene.views.size(), 1u);
  EXPECT_EQ(scene.views[0].name, "far");
  EXPECT_EQ(scene.views[0].eye, glm::vec3(0, 0, 100));
  EXPECT_EQ(scene.views[0].up, glm::vec3(1, 0, 0));
  EXPECT_EQ(scene.views[0].fov_y_degrees, 10.0f);
  EXPECT_GT(scene.views[0].near_m, 50.0f);
  EXPECT_LT(scene.views[0].near_m, 99.0f);
  EXPECT_GT(scene.views[0].far_m, 100.0f);
}

TEST_F(SceneFile, UnknownKeysAreNamedWithTheNearestKnownOne) {
  expect_refused_at(3, "tiem = 1\n", {"unknown key 'tiem'", "'time'"});
  expect_refused_at(3, "[object.wall]\n", {"unknown key 'object'", "'objects'"});
  expect_refused_at(4, "[objects.wall]\ntickness = 1\n", {"unknown key 'tickness'", "'thickness'"});
  expect_refused_at(4, "[objects.wall.outer]\nalpha = 1\n", {"unknown key 'alpha'"});
  expect_refused_at(4, "[objects.wall.inner]\nalbdo = [1,1,1]\n", {"unknown key 'albdo'", "'albedo'"});
  expect_refused_at(5, "[lights.a]\nkind = \"point\"\ndirection = [0,0,1]\n", {"unknown key 'direction'"});
  expect_refused_at(5, "[views.a]\neye = [0,0,1]\ntraget = [0,0,0]\n", {"unknown key 'traget'", "'target'"});
  expect_refused_at(3, "[objects.wal]\nthickness = 1\n", {"unknown object 'wal'", "'wall'"});
  expect_refused_at(4, "[lights.a]\nkind = \"pint\"\n", {"unknown kind of light 'pint'", "'point'"});
}

TEST_F(SceneFile, WrongTypesAndValuesAreRefusedWhereTheyStand) {
  expect_refused_at(3, "time = \"noon\"\n", {"'time'"});
  expect_refused_at(3, "background = [0, 0]\n", {"'background'", "three"});
  expect_refused_at(3, "ambient = [0, -1, 0]\n", {"'ambient'", "from 0"});
  expect_refused_at(4, "[objects.wall]\nthickness = -1\n", {"'thickness'", "from 0"});
  expect_refused_at(4, "[objects.wall]\nthickness = nan\n", {"'thickness'", "number"});
  expect_refused_at(4, "[objects.wall]\nscattering = inf\n", {"'scattering'", "number"});
  expect_refused_at(4, "[objects.wall]\nlayers = 0\n", {"'layers'", "true or false"});
  expect_refused_at(4, "[objects.wall]\nscale = 0\n", {"'scale'"});
  expect_refused_at(4, "[objects.wall]\nscale = [1, -1, 1]\n", {"'scale'", "from 0 to"});
  expect_refused_at(4, "[objects.wall]\nposition = [0, nan, 0]\n", {"'position'", "finite"});
  expect_refused_at(4, "[objects.wall]\nalbedo = [0, 2, 0]\n", {"'albedo'", "from 0 to 1"});
  expect_refused_at(4, "[objects.wall]\nalbedo = 1\n", {"'albedo'", "file"});
  expect_refused_at(4, "[objects.wall.outer]\nalbedo = \"none.png\"\n", {"none.png", "no file"});
  expect_refused_at(4, "[objects.wall.outer]\ntransparency = 1.5\n", {"'transparency'", "from 0 to 1"});
  expect_refused_at(4, "[objects.wall]\nlayers = false\nthickness = 2\n", {"layers = false"});
  expect_refused_at(3, "[lights]\n", {"no light"});
  expect_refused_at(3, "[lights.a]\ndirection = [0, 0, 1]\n", {"'kind'"});
  expect_refused_at(5, "[lights.a]\nkind = \"directional\"\ndirection = [0, 0, 0]\n", {"'direction'", "no length"});
  expect_refused_at(3, "[lights.a]\nkind = \"directional\"\n", {"'direction'", "missing"});
  expect_refused_at(6, "[lights.a]\nkind = \"point\"\nposition = [0, 0, 1]\nintensity = -1\n", {"'intensity'"});
  expect_refused_at(3, "[views]\n", {"no view"});
  expect_refused_at(3, "[views.a]\neye = [0, 0, 1]\n", {"'target'", "missing"});
  expect_refused_at(5, "[views.a]\neye = [0, 0, 1]\ntarget = [0, 0, 1]\n", {"same point"});
  expect_refused_at(6, "[views.a]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nup = [0, 0, 2]\n", {"'up'"});
  expect_refused_at(6, "[views.a]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nup = [0, 0, 0]\n", {"'up'"});
  for (const char* fov : {"0", "180", "-20", "400", "nan"})
    expect_refused_at(6, fmt::format("[views.a]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nfov_y_degrees = {}\n", fov),
                      {"'fov_y_degrees'"});
}

TEST_F(SceneFile, LightsHaveASize) {
  const Scene scene = load(
      "[lights.sun]\nkind = \"directional\"\ndirection = [0, -1, 0]\nangular_radius_degrees = 90\n"
      "[lights.bulb]\nkind = \"point\"\nposition = [1, 2, 3]\nradius = 0.25\n"
      "[lights.spark]\nkind = \"point\"\nposition = [1, 2, 3]\n");
  EXPECT_FLOAT_EQ(scene.lights.at(0).angular_radius, float(M_PI / 2));
  EXPECT_EQ(scene.lights.at(0).radius_m, 0.0f);
  EXPECT_EQ(scene.lights.at(1).radius_m, 0.25f);
  EXPECT_EQ(scene.lights.at(2).radius_m, 0.0f);
}

TEST_F(SceneFile, AnApertureTableTakesTheLayersPlace) {
  const Scene scene = load(
      "[objects.wall.aperture]\n"
      "[objects.floor.aperture]\nbaker = \"spherical_harmonics\"\nmap_texels = 8\nrays = 65536\nseed = 7\nbias = 0.01\n");
  const EffectValues& wall = apertures_of(named(scene, "wall"));
  EXPECT_FALSE(has_layers(named(scene, "wall")));
  EXPECT_EQ(wall.words.at("baker"), "rays");
  EXPECT_EQ(wall.numbers.at("map_texels"), 0);
  EXPECT_EQ(wall.numbers.at("rays"), 1024);
  EXPECT_EQ(wall.numbers.at("seed"), 1);
  EXPECT_FALSE(wall.numbers.contains("bias"));
  const EffectValues& floor = apertures_of(named(scene, "floor"));
  EXPECT_EQ(floor.words.at("baker"), "spherical_harmonics");
  EXPECT_EQ(floor.numbers.at("map_texels"), 8);
  EXPECT_EQ(floor.numbers.at("rays"), 65536);
  EXPECT_EQ(floor.numbers.at("seed"), 7);
  EXPECT_EQ(floor.numbers.at("bias"), 0.01);
}

TEST_F(SceneFile, AperturesOfAllAndOfOne) {
  const Scene scene = load(
      "[objects.wall.aperture]\nrays = 64\n[objects.\"*\".aperture]\nrays = 32\nseed = 5\n"
      "[objects.floor]\napertures = false\nalbedo = [1, 0, 0]\n");
  EXPECT_EQ(apertures_of(named(scene, "wall")).numbers.at("rays"), 64) << "the entry that names it comes last";
  EXPECT_EQ(apertures_of(named(scene, "wall")).numbers.at("seed"), 5) << "and keeps what it does not change";
  EXPECT_FALSE(has_apertures(named(scene, "floor")));
  EXPECT_FALSE(has_layers(named(scene, "floor")));
  // Layers given back to one take its apertures away.
  const Scene back = load("[objects.\"*\".aperture]\n[objects.floor.outer]\nalbedo = [0, 1, 0]\n");
  EXPECT_TRUE(has_apertures(named(back, "wall")));
  EXPECT_FALSE(has_apertures(named(back, "floor")));
  EXPECT_TRUE(has_layers(named(back, "floor")));
}

TEST_F(SceneFile, AperturesAndLayersExcludeEachOther) {
  expect_refused_at(3, "[objects.wall]\nthickness = 2\n[objects.wall.aperture]\n",
                    {"layered_material or aperture_lighting", "leave out thickness, or aperture"});
  expect_refused_at(3, "[objects.\"*\".aperture]\n[objects.\"*\".outer]\nalbedo = [0, 1, 0]\n",
                    {"layered_material or aperture_lighting", "leave out outer, or aperture"});
  expect_refused_at(4, "[objects.wall]\napertures = false\n[objects.wall.aperture]\n", {"apertures = false"});
}

TEST_F(SceneFile, ApertureAndLightSizeValuesAreRefusedWhereTheyStand) {
  const auto aperture = [&](const char* line, const std::vector<std::string>& parts) {
    expect_refused_at(4, fmt::format("[objects.wall.aperture]\n{}\n", line), parts);
  };
  aperture("baker = \"ray\"", {"unknown baker 'ray'", "'rays'"});
  aperture("baker = 1", {"'baker'", "string"});
  aperture("map_texels = 7", {"'map_texels'", "8 to 4096"});
  aperture("map_texels = 4097", {"'map_texels'", "from 0 to 4096"});
  aperture("map_texels = 64.5", {"'map_texels'", "whole number"});
  aperture("rays = 15", {"'rays'", "from 16 to 65536"});
  aperture("rays = 65537", {"'rays'", "from 16 to 65536"});
  aperture("rays = nan", {"'rays'", "number"});
  aperture("seed = -1", {"'seed'", "from 0"});
  aperture("bias = 0", {"'bias'", "from 1e-09"});
  aperture("bias = -0.1", {"'bias'", "from 1e-09"});
  aperture("bais = 1", {"unknown key 'bais'", "'bias'"});
  expect_refused_at(4, "[objects.wall]\naperture = true\n", {"'aperture'", "table"});
  expect_refused_at(4, "[objects.wall]\napertures = 0\n", {"'apertures'", "true or false"});
  for (const char* value : {"-1", "90.5", "nan"})
    expect_refused_at(
        6, fmt::format("[lights.a]\nkind = \"directional\"\ndirection = [0, 0, 1]\nangular_radius_degrees = {}\n", value),
        {"'angular_radius_degrees'", "from 0 to 90"});
  for (const char* value : {"-0.5", "inf"})
    expect_refused_at(6, fmt::format("[lights.a]\nkind = \"point\"\nposition = [0, 0, 1]\nradius = {}\n", value),
                      {"'radius'", "from 0"});
  expect_refused_at(6, "[lights.a]\nkind = \"point\"\nposition = [0, 0, 1]\nangular_radius_degrees = 1\n",
                    {"unknown key 'angular_radius_degrees'"});
}

TEST_F(SceneFile, NoMoreLightsThanAreDrawn) {
  std::string lights;
  for (size_t i = 0; i < max_lights; ++i)
    lights += fmt::format("[lights.l{}]\nkind = \"point\"\nposition = [0, 1, {}]\n", i, i);
  EXPECT_EQ(load(lights).lights.size(), max_lights);
  lights += "[lights.more]\nkind = \"point\"\nposition = [0, 2, 0]\n";
  expect_refused_at(3, lights, {"9 lights", "at most 8"});
}

TEST_F(SceneFile, NeedsOneModelThatExists) {
  const auto refused = [&](const std::string& text, const std::vector<std::string>& parts) {
    const std::string file = folder_.write("b.toml", text).string();
    expect_refused([&] { load_scene(file, builtin_library()); }, parts);
  };
  refused("", {"b.toml", "[scene] is missing"});
  refused("[scene]\n", {"b.toml:1:", "model", "builtin"});
  refused("[scene]\nmodel = \"model.glb\"\nbuiltin = \"heart\"\n", {"b.toml:1:", "either"});
  refused("[scene]\nmodel = \"none.glb\"\n", {"b.toml:2:", "none.glb"});
  refused("[scene]\nbuiltin = \"hart\"\n", {"b.toml:2:", "'hart'", "'heart'"});
  refused("[scene]\nmodel = model.glb\n", {"b.toml:2"});
  expect_refused([&] { load_scene((folder_ / "none.toml").string(), builtin_library()); }, {"none.toml", "cannot be read"});
}

}  // namespace
}  // namespace lamina
