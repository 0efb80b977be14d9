// SPDX-License-Identifier: Apache-2.0
// What scenes take long to make is made once for each build of a program.
#include "harness/scene/made/kept.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "harness/core/disk_cache.h"
#include "harness/core/text.h"
#include "harness/scene/textures.h"
#include "tests/folder.h"

namespace lamina {
namespace {

class Kept : public InFolder<> {
 protected:
  void SetUp() override {
    if (const char* set = std::getenv("LAMINA_CACHE")) before_ = set;
    ::setenv("LAMINA_CACHE", folder_.c_str(), 1);
  }
  void TearDown() override { before_ ? ::setenv("LAMINA_CACHE", before_->c_str(), 1) : ::unsetenv("LAMINA_CACHE"); }
  // How often two calls make it.
  size_t makings(const std::function<void()>& between = [] {}) {
    size_t count = 0;
    const auto make = [&] { return ++count, Parts{"one", "", std::string("\0two", 4)}; };
    const Parts first = kept("thing", make);
    between();
    EXPECT_EQ(kept("thing", make), first);
    EXPECT_EQ(first, (Parts{"one", "", std::string("\0two", 4)}));
    return count;
  }
  std::filesystem::path entry() const { return std::filesystem::directory_iterator(folder_)->path(); }

  std::optional<std::string> before_;
};

TEST_F(Kept, IsMadeOnce) { EXPECT_EQ(makings(), 1u); }

TEST_F(Kept, AnotherBuildMakesItAgainInTheSamePlace) {
  const size_t count = makings([&] {
    DiskCache cache(folder_);
    std::string bytes = cache.find(entry().stem().string()).value();
    bytes.back() ^= 1;  // the build id comes last
    cache.keep(entry().stem().string(), bytes);
  });
  EXPECT_EQ(count, 2u);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(Kept, WhatIsDamagedIsMadeAgain) {
  EXPECT_EQ(makings([&] { std::filesystem::resize_file(entry(), std::filesystem::file_size(entry()) - 1); }), 2u);
}

TEST_F(Kept, WithoutACacheItIsMadeEachTime) {
  ::setenv("LAMINA_CACHE", "", 1);
  EXPECT_EQ(makings(), 2u);
}

TEST_F(Kept, TexturesAndMeshesComeBackToTheBit) {
  const auto texture =
      make_texture("spots", {4, 2, std::vector<glm::vec4>(8, glm::vec4(0.1f, 0.7f, 0.3f, 0.9f))}, TexelMeaning::colour);
  const Mesh mesh{{{{1, 2, 3}, {0, 1, 0}, {1, 0, 0, -1}, {0.5f, 0.25f}}}, {0, 0, 0}};
  for (int call = 0; call < 2; ++call) {
    const auto same = kept_textures("textures", [&] { return std::vector{texture, texture}; });
    ASSERT_EQ(same.size(), 2u);
    EXPECT_EQ(same[1]->name, texture->name);
    EXPECT_EQ(same[1]->format, texture->format);
    EXPECT_EQ(std::tuple(same[1]->width, same[1]->height, same[1]->depth), std::tuple(4u, 2u, 1u));
    EXPECT_EQ(same[1]->levels, texture->levels);
    const Mesh again = kept_mesh("mesh", [&] { return mesh; });
    EXPECT_EQ(bytes_of(again.vertices), bytes_of(mesh.vertices));
    EXPECT_EQ(again.indices, mesh.indices);
  }
}

}  // namespace
}  // namespace lamina
