// SPDX-License-Identifier: Apache-2.0
// Families of a test's own: files in a folder that goes with the test, and oracles without a place in the product.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>

#include "harness/stress/family.h"
#include "tests/folder.h"

namespace lamina {

class FamilyFolder : public InFolder<> {
 protected:
  static std::filesystem::path shaders() { return std::filesystem::path(LAMINA_SOURCE_DIR) / "shaders"; }
};

// Of x0, x1, ...: 1 x0 + 2 x1 + 3 x2 + ... Refuses any input above 3.
class WeightedSum : public Oracle {
 public:
  explicit WeightedSum(size_t count) : count_(count) {}
  std::vector<std::string> inputs() const override {
    std::vector<std::string> names;
    for (size_t i = 0; i < count_; ++i) names.push_back("x" + std::to_string(i));
    return names;
  }
  std::string refusal(Point point) const override {
    for (const double x : point)
      if (!(x <= 3)) return "no input may be above 3";
    return "";
  }
  double value(Point point) const override {
    double sum = 0;
    for (size_t i = 0; i < count_; ++i) sum += static_cast<double>(i + 1) * point[i];
    return sum;
  }
  double condition(Point, double) const override { return 1; }
  double scale(Point) const override { return 2; }
  std::vector<std::string> sets() const override { return {"steps", "rest"}; }
  // x0 counts from the seed on in "steps", x1 is half of it, x2 a third ...; "rest" is the same from half of it on.
  Points points(const std::string& set, size_t count, uint64_t seed) const override {
    Points points(count_);
    std::vector<float> point(count_);
    for (size_t n = 0; n < count; ++n) {
      const float first = static_cast<float>(n + seed) * 0x1p-10f + (set == "rest" ? 0.5f : 0.0f);
      for (size_t i = 0; i < count_; ++i) point[i] = first / static_cast<float>(i + 1);
      points.add(point);
    }
    return points;
  }

 private:
  size_t count_;
};

}  // namespace lamina
