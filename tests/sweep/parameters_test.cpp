// SPDX-License-Identifier: Apache-2.0
#include "harness/sweep/parameters.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "harness/core/error.h"
#include "harness/scene/digest.h"
#include "harness/sweep/swept_scene.h"
#include "tests/folder.h"

namespace lamina {
namespace {

const Library& library() {
  static const Library loaded = load_library(LAMINA_SOURCE_DIR, effect_code());
  return loaded;
}
const Scene& heart() {
  static const Scene scene = load_scene("heart", library());
  return scene;
}
EffectValues& layers_of(Object& object) { return object.effects.at("layered_material"); }

TEST(Parameters, ThePresentValueIsTheScenes) {
  const auto all = parameters_of(heart(), library());
  const Parameter& thickness = parameter_named(all, "objects.heart.thickness");
  EXPECT_EQ(thickness.value, 16);
  EXPECT_EQ(thickness.unit, "texels");
  EXPECT_EQ(parameter_named(all, "scene.time").value, 0);
  EXPECT_EQ(parameter_named(all, "lights.rim.position.x").value, 1.5);
  EXPECT_EQ(parameter_named(all, "views.front.fov_y_degrees").value, 36);
}

// Every parameter takes the ends of a range about its value, and reads back what was set.
TEST(Parameters, WhatIsSetIsWhatIsThereThen) {
  const auto all = parameters_of(heart(), library());
  ASSERT_GT(all.size(), 30u);
  for (const Parameter& parameter : all) {
    if (!parameter.set) continue;
    const double beside = std::clamp(parameter.value.value_or(0.5) + 0.25, parameter.min, parameter.max);
    const double wanted = parameter.words.empty() ? beside : parameter.max;  // of a word: its place
    Scene scene = heart();
    parameter.set(scene, wanted);
    const bool relative = parameter.path.find("rotation") != std::string::npos || parameter.path.ends_with(".scale");
    if (relative) continue;
    const auto now = parameters_of(scene, library());
    ASSERT_TRUE(parameter_named(now, parameter.path).value) << parameter.path;
    EXPECT_NEAR(*parameter_named(now, parameter.path).value, wanted, 3e-3) << parameter.path;  // 1/255 where it is a texel
  }
}

TEST(Parameters, TurningAndScalingKeepTheOrigin) {
  Scene scene = heart();
  scene.objects[0].world_from_object[3] = glm::vec4(1, 2, 3, 1);
  const auto all = parameters_of(scene, library());
  parameter_named(all, "objects.heart.rotation_degrees.y").set(scene, 90);
  parameter_named(all, "objects.heart.scale").set(scene, 2);
  const glm::vec4 origin = scene.objects[0].world_from_object * glm::vec4(0, 0, 0, 1);
  const glm::vec4 right = scene.objects[0].world_from_object * glm::vec4(1, 0, 0, 1);
  EXPECT_NEAR(glm::distance(glm::vec3(origin), glm::vec3(1, 2, 3)), 0, 1e-6);
  EXPECT_NEAR(glm::distance(glm::vec3(right), glm::vec3(1, 2, 1)), 0, 1e-6);  // x turns to -z, twice as far
}

TEST(Parameters, UnknownPathsNameTheNearest) {
  try {
    SweptScene(heart(), library(), {{{"objects.heart.tickness", "", {1}}}, false});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_NE(std::string(error.what()).find("did you mean 'objects.heart.thickness'"), std::string::npos) << error.what();
  }
}

TEST(Parameters, ANumberTakesNoWord) {
  try {
    SweptScene(heart(), library(), {{{"objects.heart.thickness", "", {}, {"thick"}}}, false});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_NE(std::string(error.what()).find("'thick' is no number"), std::string::npos) << error.what();
  }
}

// Who leaves the beginning of a path out is told the whole of it; where several fit as well, they are all named.
TEST(Parameters, PathsWithoutTheirBeginningNameTheNearestToo) {
  const std::pair<const char*, const char*> cases[] = {
      {"thickness", "did you mean 'objects.heart.thickness' or 'objects.*.thickness'"},
      {"heart.scatering", "did you mean 'objects.heart.scattering'"},
      {"intensity", "did you mean 'lights.key.intensity' or 'lights.fill.intensity' or 'lights.rim.intensity'"},
      {"nothing.like.any.of.them", "unknown parameter 'nothing.like.any.of.them'; 'lamina list"}};
  for (const auto& [path, words] : cases) try {
      parameter_named(parameters_of(heart(), library()), path);
      ADD_FAILURE() << path;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

TEST(Parameters, AWildcardSetsEveryObjectThatHasTheNumber) {
  Scene scene = heart();
  scene.objects.push_back(scene.objects[0]);
  scene.objects[1].name = "other";
  scene.objects.push_back(scene.objects[0]);
  scene.objects[2].name = "plain", scene.objects[2].effects.erase("layered_material");
  parameter_named(parameters_of(scene, library()), "objects.*.thickness").set(scene, 5);
  EXPECT_EQ(layers_of(scene.objects[0]).numbers.at("thickness"), 5);
  EXPECT_EQ(layers_of(scene.objects[1]).numbers.at("thickness"), 5);
  Scene one = heart();
  parameter_named(parameters_of(one, library()), "objects.*.thickness").set(one, 6);
  EXPECT_EQ(layers_of(one.objects[0]).numbers.at("thickness"), 6);
}

TEST(Parameters, ValuesOutOfRangeAreRefusedWithTheRange) {
  const auto all = parameters_of(heart(), library());
  try {
    check_value(parameter_named(all, "objects.heart.thickness"), -1);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("it takes 0 to 65536 texels"), std::string::npos) << error.what();
  }
}

TEST(SweptScene, AnotherTimeKeepsTheTexturesAndMovesTheMesh) {
  SweptScene scenes(heart(), library(), {{{"scene.time", "", {0, 0.3}}, {"objects.heart.thickness", "", {7}}}, false});
  Scene first = scenes.at(0), second = scenes.at(1);
  EXPECT_EQ(layers_of(first.objects[0]).textures, layers_of(second.objects[0]).textures);
  EXPECT_EQ(first.objects[0].mesh.vertices.size(), second.objects[0].mesh.vertices.size());
  EXPECT_NE(meshes_digest(first), meshes_digest(second));
  EXPECT_EQ(layers_of(second.objects[0]).numbers.at("thickness"), 7) << "what is set goes before what time brings";
  EXPECT_NE(scene_digest(first), scene_digest(second));
}

// A model that was given no time stands at rest, which need not be where its animation begins.
TEST(SweptScene, TimesOfAModelPlayItFromTheFirstOn) {
  const Folder folder;
  // A triangle that stands at x = 5 and is moved from x = 1 to x = 3 in a second.
  const std::filesystem::path file =
      folder.write("played.gltf", R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0,"name":"t","translation":[5,0,0]}],)"
                                  R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[)"
                                  R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
                                  R"({"bufferView":0,"byteOffset":36,"componentType":5126,"count":2,"type":"SCALAR"},)"
                                  R"({"bufferView":0,"byteOffset":44,"componentType":5126,"count":2,"type":"VEC3"}],)"
                                  R"("bufferViews":[{"buffer":0,"byteLength":68}],"animations":[{"channels":[{"sampler":0,)"
                                  R"("target":{"node":0,"path":"translation"}}],"samplers":[{"input":1,"output":2}]}],)"
                                  R"("buffers":[{"byteLength":68,"uri":"data:;base64,)"
                                  "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAIA/AAAAAAAAAAAAAEBAAAAAAAAAAAA="
                                  R"("}]})");
  const auto x_of = [](const Scene& scene) { return scene.objects.at(0).world_from_object[3].x; };
  SweptScene scenes(load_scene(file.string(), library()), library(), {{{"scene.time", "", {0, 0.5, 1}}}, false});
  EXPECT_EQ(x_of(scenes.scene()), 5);
  for (size_t point = 0; point < 3; ++point) EXPECT_EQ(x_of(scenes.at(point)), 1 + float(point)) << point;
}

TEST(SweptScene, WhatALaterOneWouldUndoIsRefused) {
  const auto swept = [](const char* first, const char* second) {
    SweptScene(heart(), library(), {{{first, "", {1}}, {second, "", {2}}}, false});
  };
  EXPECT_THROW(swept("objects.heart.thickness", "objects.*.thickness"), Error);
  EXPECT_NO_THROW(swept("objects.*.thickness", "objects.heart.thickness")) << "all but one";
  EXPECT_NO_THROW(swept("objects.heart.thickness", "objects.*.scattering"));
  EXPECT_THROW(swept("lights.key.intensity", "lights.key.radiance.red"), Error);
  EXPECT_THROW(swept("lights.key.radiance.red", "lights.key.intensity"), Error);
  EXPECT_NO_THROW(swept("lights.key.radiance.red", "lights.rim.intensity"));
}

// A point is the same whichever points came before it.
TEST(SweptScene, PointsDoNotDependOnTheWayThere) {
  const SweepPoints points{{{"objects.heart.rotation_degrees.x", "", {0, 10, 20}}, {"lights.key.intensity", "", {0, 1}}},
                           false};
  SweptScene walked(heart(), library(), points), jumped(heart(), library(), points);
  for (size_t point = 0; point < points.count(); ++point) walked.at(point);
  EXPECT_EQ(scene_digest(walked.at(4)), scene_digest(jumped.at(4)));
  EXPECT_NE(scene_digest(walked.at(4)), scene_digest(walked.at(5)));
}

}  // namespace
}  // namespace lamina
