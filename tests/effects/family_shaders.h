// SPDX-License-Identifier: Apache-2.0
// Shaders of function families on each backend: what they give, and what they err by against the family's oracle.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "harness/stress/function_runner.h"
#include "harness/stress/judge.h"
#include "harness/stress/point_sets.h"
#include "tests/effects/caps.h"
#include "tests/graph/each_backend.h"
#include "tests/open_backend.h"

namespace lamina {

inline Family family_in(const std::string& folder) {
  return load_family(shaders_folder() / folder / "family.toml", effect_code());
}

class FamilyShaders : public ::testing::TestWithParam<std::string_view> {
 protected:
  explicit FamilyShaders(size_t inputs_of_a_set) : inputs_(inputs_of_a_set) {}

  void SetUp() override {
    std::string missing;
    backend_ = open_or_say(GetParam(), missing);
    if (!backend_) GTEST_SKIP() << missing;
  }

  FunctionErrors errors(const Family& family, const std::string& function, const std::string& set) {
    FunctionRunner runner(*backend_, shaders_folder(), family, function);
    const PointSet points{set, "", family.oracle->points(set, inputs_, 5)};
    return judge(points.points, runner.values(points.points), truth_of(*family.oracle, points));
  }
  std::vector<float> values(const Family& family, const std::string& function, const std::vector<std::vector<float>>& points) {
    Points asked(points.at(0).size());
    for (const std::vector<float>& point : points) asked.add(point);
    return FunctionRunner(*backend_, shaders_folder(), family, function).values(asked);
  }

  // A claim that was judged.
  struct Judged {
    std::string function;
    bool baseline;
    FunctionErrors errors;
  };
  // Expects that every function keeps the bounds that it claims on each set, and is finite there; and that baselines claim
  // every set but "beyond", which binary32 cannot hold.
  std::vector<Judged> judge_claims(std::span<const char* const> folders) {
    std::vector<Judged> judged;
    for (const char* folder : folders) {
      const Family family = family_in(folder);
      for (const FamilyFunction& function : family.functions)
        for (const FamilySet& set : family.sets) {
          SCOPED_TRACE(std::string(folder) + " " + function.name + " " + set.name);
          const FamilyClaim* bounds = function.claim(set.name);
          EXPECT_TRUE(bounds || !function.baseline || set.name == "beyond");
          if (!bounds) continue;
          const FunctionErrors& found =
              judged.emplace_back(Judged{function.name, function.baseline, errors(family, function.name, set.name)}).errors;
          EXPECT_LE(found.max_over, bounds->over);
          EXPECT_GE(found.max_under, bounds->under);
          EXPECT_LE(found.max_eps_kappa, bounds->eps_kappa.value_or(std::numeric_limits<double>::infinity()));
          EXPECT_EQ(found.nonfinite, 0u);
          EXPECT_FALSE(function.baseline && found.first_fault) << "below 0, or not 0 where that is right";
        }
    }
    return judged;
  }

  size_t inputs_;  // of a set
  std::unique_ptr<Backend> backend_;
};

}  // namespace lamina
