// SPDX-License-Identifier: Apache-2.0
// The random walk through slabs without reflecting surfaces, against shares of light that adding and doubling has converged to.
// The rows are not part of the product: where they are absent the test is skipped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "harness/effects/translucency/random_walk.h"
#include "tests/effects/translucent_scenes.h"

namespace lamina {
namespace {

// Henyey and Greenstein's scattering of mean cosine `forward`; shares of light that comes along the normal, and of a Lambertian
// source's, that leave on the side they came from and on the other.
struct SlabRow {
  double albedo, depth, forward, back, through, diffuse_back, diffuse_through;
};

std::vector<SlabRow> slab_rows(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::vector<SlabRow> rows;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 'a') continue;
    std::ranges::replace(line, ',', ' ');
    std::istringstream numbers(line);
    SlabRow row{};
    numbers >> row.albedo >> row.depth >> row.forward >> row.back >> row.through >> row.diffuse_back >> row.diffuse_through;
    EXPECT_TRUE(numbers) << line;
    rows.push_back(row);
  }
  return rows;
}

struct Share {
  double sum = 0, squares = 0;
  int count = 0;
  void add(double weight) { sum += weight, squares += weight * weight, ++count; }
  double mean() const { return sum / count; }
  double deviation() const { return std::sqrt(std::max(squares / count - mean() * mean(), 1e-6) / count); }  // of the mean
};

TEST(SlabRows, ARandomWalkComesToTheirShares) {
  const std::filesystem::path file = std::filesystem::path(LAMINA_DATA_DIR) / "slab_reflectance.csv";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent: reference values are not part of the product";
  const std::vector<SlabRow> rows = slab_rows(file);
  EXPECT_GE(rows.size(), 9u);
  for (const SlabRow& row : rows) {
    SCOPED_TRACE(testing::Message() << "albedo " << row.albedo << ", depth " << row.depth << ", forward " << row.forward);
    // 1 m thick, and as wide as light goes.
    const float half_m = row.depth > 100 ? 20 : 200;
    const Scene scene = lit_alone(
        translucent(block_mesh({{{-half_m, -1, -half_m}, {half_m, 0, half_m}}}, half_m), {glm::vec3(float(row.depth))}),
        {0, -1, 0}, {0, 3, 0}, 40);
    const Solids solids(scene);
    WalkRandom random(3);
    for (const bool diffuse : {false, true}) {
      Share back, through;
      for (int walk = 0; walk < 12000; ++walk) {
        const double cosine = diffuse ? std::sqrt(random.uniform()) : 1;
        const WalkEnd end = random_walk(
            solids, 0, glm::dvec3(row.albedo), {0, -1e-6, 0}, {std::sqrt(1 - cosine * cosine), -cosine, 0}, random,
            [](glm::dvec3, glm::dvec3, int) {}, row.forward);
        back.add(end.left && end.position.y > -0.5 ? end.weight.g : 0);
        through.add(end.left && end.position.y <= -0.5 ? end.weight.g : 0);
      }
      EXPECT_NEAR(back.mean(), diffuse ? row.diffuse_back : row.back, 4 * back.deviation() + 1e-5) << diffuse;
      EXPECT_NEAR(through.mean(), diffuse ? row.diffuse_through : row.through, 4 * through.deviation() + 1e-5) << diffuse;
      EXPECT_LT(std::max(back.deviation(), through.deviation()), 0.005) << "what there is to tell";
    }
  }
}

}  // namespace
}  // namespace lamina
