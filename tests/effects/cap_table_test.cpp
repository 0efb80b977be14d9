// SPDX-License-Identifier: Apache-2.0
// The table of shares, and the shader that reads it on every backend.
#include "harness/effects/cap_intersection/cap_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <numbers>

#include "harness/core/error.h"
#include "harness/effects/cap_intersection/cap_area.h"
#include "harness/effects/cap_intersection/cap_oracle.h"
#include "tests/effects/family_shaders.h"

namespace lamina {
namespace {

using std::numbers::pi;

class Table {
 public:
  explicit Table(uint32_t size) : size_(size), image_(make_cap_table(size)), halves_(size_t{size} * size * size) {
    if (image_.levels.at(0).size() != halves_.size() * 2) throw std::logic_error("the table's bytes are not its texels'");
    std::memcpy(halves_.data(), image_.levels[0].data(), image_.levels[0].size());
  }
  const TextureImage& image() const { return image_; }
  double at(uint32_t overlap, uint32_t ratio, uint32_t larger) const {
    return glm::unpackHalf1x16(halves_.at((size_t{larger} * size_ + ratio) * size_ + overlap));
  }

 private:
  uint32_t size_;
  TextureImage image_;
  std::vector<uint16_t> halves_;
};

TEST(CapTable, IsOneLevelOfHalves) {
  const TextureImage table = make_cap_table();
  EXPECT_EQ(table.format, Format::r16_float);
  EXPECT_EQ(table.width, cap_table_size);
  EXPECT_EQ(table.height, cap_table_size);
  EXPECT_EQ(table.depth, cap_table_size);
  ASSERT_EQ(table.levels.size(), 1u);
  EXPECT_EQ(table.levels[0].size(), size_t{2} * cap_table_size * cap_table_size * cap_table_size);
}

// Half precision: 11 bits, so a value is rounded by 2^-11 of it at most, and by 2^-25 where it is denormal.
TEST(CapTable, NodesHoldTheExactShareToHalfPrecision) {
  constexpr uint32_t size = 9;
  const Table table(size);
  for (uint32_t k = 1; k < size; ++k)
    for (uint32_t j = 1; j < size; ++j)
      for (uint32_t i = 0; i < size; ++i) {
        const double larger = pi / 2 * k / 8.0, smaller = larger * j / 8.0, d = larger + smaller - 2 * smaller * i / 8.0;
        const double share = cap_intersection_oracle(larger, smaller, std::min(d, pi)) / smaller_cap_area(larger, smaller);
        EXPECT_NEAR(table.at(i, j, k), share, 0x1p-11 * share + 0x1p-25) << larger << " " << smaller << " " << d;
      }
}

TEST(CapTable, MeetsApartAndInsideExactly) {
  const Table table(cap_table_size);
  for (uint32_t k = 0; k < cap_table_size; ++k)
    for (uint32_t j = 0; j < cap_table_size; ++j) {
      ASSERT_EQ(table.at(0, j, k), 0) << j << " " << k;
      ASSERT_EQ(table.at(cap_table_size - 1, j, k), 1) << j << " " << k;
    }
}

// Where radius and ratio are 0 the sphere is flat and the larger cap's edge straight: the share is that of a disc's segment.
TEST(CapTable, EndsInThePlanesLimits) {
  constexpr uint32_t size = 17;
  const Table table(size);
  for (uint32_t i = 0; i < size; ++i) {
    const double u = 1 - 2 * i / 16.0, segment = (std::acos(u) - u * std::sqrt(1 - u * u)) / pi;
    EXPECT_NEAR(table.at(i, 0, 0), segment, 0x1p-12) << i;
    // Two discs of one radius, their centres 2 v radii apart.
    const double v = 1 - i / 16.0, lens = 2 / pi * (std::acos(v) - v * std::sqrt(1 - v * v));
    EXPECT_NEAR(table.at(i, size - 1, 0), lens, 0x1p-12) << i;
    // Two hemispheres share a lune.
    EXPECT_NEAR(table.at(i, size - 1, size - 1), i / 16.0, 0x1p-12) << i;
  }
}

TEST(CapTable, RefusesToBeOneTexel) {
  EXPECT_THROW(make_cap_table(1), Error);
  EXPECT_THROW(make_cap_table(0), Error);
}

class LutCap : public FamilyShaders {
 protected:
  LutCap() : FamilyShaders(0) {}  // its tests choose their points

  void SetUp() override {
    FamilyShaders::SetUp();
    if (backend_) runner_ = std::make_unique<FunctionRunner>(*backend_, shaders_folder(), caps(), "lut_cap");
  }
  std::unique_ptr<FunctionRunner> runner_;
};

TEST_P(LutCap, ErrsByNoMoreThanItsBoundForAllRadii) {
  for (const PointSet& set : make_sets(caps(), 100000, 9)) {
    SCOPED_TRACE(set.name);
    const FunctionErrors errors = judge(set.points, runner_->values(set.points), truth_of_caps(set));
    EXPECT_LE(errors.max_over, cap_table_error);
    EXPECT_GE(errors.max_under, -cap_table_error);
    EXPECT_EQ(errors.negative + errors.nonfinite, 0u);
    if (set.name == "box") {
      EXPECT_GT(errors.max_over, 0.5 * cap_table_error) << "the bound says less than it could";
    }
  }
}

// Apart, inside and covering are no matter of the table's nodes.
TEST_P(LutCap, BordersAreExact) {
  constexpr float below_pi = 3.14159250f;
  const Points apart(3, {{0.5f, 0.25f, 0.75f}, {0.5f, 0.25f, 2}, {1.5f, 1.5f, 3.1f}, {2, 0.5f, 3}, {1e-3f, 1e-5f, 1}});
  EXPECT_EQ(runner_->values(apart), std::vector<float>(5, 0.0f));
  const Points inside(3, {{1, 0.5f, 0.25f}, {1, 1, 0}, {2, 0.5f, 0.25f}, {3, 1, 2}, {2, 2, 0}, {below_pi, 1, 3}});
  const Points covering(3, {{2, 2.5f, 3}, {1.75f, 3, 3}, {3, 1.75f, 2.5f}, {3.1f, 3.1f, 0.5f}});
  for (const auto& inputs : {inside, covering}) {
    const std::vector<float> areas = runner_->values(inputs);
    for (size_t i = 0; i < inputs.size(); ++i) {
      const double r0 = inputs[i][0], r1 = inputs[i][1], d = inputs[i][2];
      EXPECT_NEAR(areas[i], cap_intersection_area(r0, r1, d), 3e-6) << r0 << " " << r1 << " " << d;
    }
  }
}

TEST_P(LutCap, WhatIsNoCapOrTheWholeSphereHasAnArea) {
  constexpr float pi_above = 3.14159274f;
  const Points inputs(3, {{0, 1, 0.5f},
                          {-1, 1, 0.5f},
                          {std::nanf(""), 1, 0},
                          {pi_above, 1, 2},
                          {4, 1, 2},
                          {pi_above, pi_above, 1},
                          {1e-30f, 1, 0}});
  const double cap = smaller_cap_area(1, 1);
  const std::vector<double> expected = {0, 0, 0, cap, cap, 4 * pi, 0};
  const std::vector<float> areas = runner_->values(inputs);
  for (size_t i = 0; i < inputs.size(); ++i) EXPECT_NEAR(areas[i], expected[i], 3e-6) << i;
}

TEST_P(LutCap, DoesNotDependOnTheOrderOfTheCaps) {
  Points there(3), back(3);
  for (const PointSet& set : make_sets(caps(), 300, 4))
    for (size_t i = 0; i < set.points.size(); ++i) {
      there.add(set.points[i]);
      back.add({set.points[i][1], set.points[i][0], set.points[i][2]});
    }
  const std::vector<float> one = runner_->values(there), other = runner_->values(back);
  for (size_t i = 0; i < there.size(); ++i)
    ASSERT_NEAR(one[i], other[i], 16 * 0x1p-23 * smaller_cap_area(there[i][0], there[i][1]))
        << there[i][0] << " " << there[i][1] << " " << there[i][2];
}

INSTANTIATE_TEST_SUITE_P(Backends, LutCap, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
