// SPDX-License-Identifier: Apache-2.0
// Bakes on disk: read back where nothing has changed, made again where anything has, or where the file is damaged.
#include <gtest/gtest.h>

#include <fstream>

#include "harness/core/text.h"
#include "tests/effects/made_scenes.h"
#include "tests/folder.h"

namespace lamina {
namespace {

class BakeCache : public InFolder<> {
 protected:
  struct Result {
    std::vector<Aperture> apertures;
    bool from_cache;
    std::vector<std::string> warnings;
  };
  Result bake(const Scene& scene) {
    Bakes bakes(scene, effect_code(), DiskCache(folder_));
    Result result{vertex_apertures(bakes, 0), bakes.stats().at(0).from_cache, bakes.cache().take_warnings()};
    return result;
  }
  std::filesystem::path file() const { return std::filesystem::directory_iterator(folder_)->path(); }
  size_t files() const { return own_.files(); }

  Scene scene_ = scene_of({receiver(), ring("lid", 1, 1, 50, 1)});
};

TEST_F(BakeCache, SecondTimeIsReadAndTheSame) {
  const Result first = bake(scene_), second = bake(scene_);
  EXPECT_FALSE(first.from_cache);
  EXPECT_TRUE(second.from_cache);
  EXPECT_EQ(first.apertures, second.apertures);
  EXPECT_EQ(files(), 1u) << "and nothing beside it is left over";
}

TEST_F(BakeCache, EverythingThatMattersIsInTheKey) {
  bake(scene_);
  std::vector<Scene> others(6, scene_);
  apertures_of(others[0].objects[0]).numbers["rays"] = 512;
  apertures_of(others[1].objects[0]).numbers["seed"] = 2;
  apertures_of(others[2].objects[0]).numbers["bias"] = 0.01;
  others[3].objects[1].mesh.vertices[0].position.y += 0.1f;
  others[4].objects[1].world_from_object[3].x = 0.5f;
  others[5].objects[0].mesh.vertices[0].normal = {1, 0, 0};
  for (size_t i = 0; i < others.size(); ++i) EXPECT_FALSE(bake(others[i]).from_cache) << i;
  Scene same = scene_;
  same.name = "other", same.lights.emplace_back(), same.objects[1].effects["surface"];
  EXPECT_TRUE(bake(same).from_cache) << "light and colour do not matter";
}

TEST_F(BakeCache, DamagedFileIsMadeAgainWithAWarning) {
  const Result good = bake(scene_);
  const std::string text = read_file(file(), "test");
  const std::vector<std::string> damaged = {"",
                                            text.substr(0, 10),
                                            text.substr(0, text.size() - 1),
                                            text + "x",
                                            text.substr(0, text.size() - 3) + "abc",
                                            "lamina cache 2" + text.substr(14)};
  for (size_t i = 0; i < damaged.size(); ++i) {
    std::ofstream(file(), std::ios::binary) << damaged[i];
    const Result again = bake(scene_);
    EXPECT_FALSE(again.from_cache) << i;
    ASSERT_EQ(again.warnings.size(), 1u) << i;
    EXPECT_NE(again.warnings[0].find(file().string()), std::string::npos);
    EXPECT_EQ(again.apertures, good.apertures);
    EXPECT_EQ(read_file(file(), "test"), text) << "and is whole again";
  }
}

TEST_F(BakeCache, FolderThatCannotBeMadeIsAWarning) {
  std::filesystem::remove(folder_);
  std::ofstream(folder_) << "a file stands here";
  const Result result = bake(scene_);
  EXPECT_EQ(result.apertures.size(), 3u);
  ASSERT_EQ(result.warnings.size(), 1u);
}

TEST_F(BakeCache, ProgressRisesFromNothing) {
  std::vector<double> seen;
  Bakes bakes(scene_, effect_code(), DiskCache(""), [&](double fraction, const std::string& what) {
    EXPECT_EQ(what, "apertures of receiver");
    seen.push_back(fraction);
  });
  vertex_apertures(bakes, 0);
  ASSERT_FALSE(seen.empty());
  EXPECT_EQ(seen.front(), 0);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
}

}  // namespace
}  // namespace lamina
