// SPDX-License-Identifier: Apache-2.0
// Families that the product does not know, run on every backend: one that is data beside this file with an oracle of the test's
// own, and some made here.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstring>
#include <map>

#include "harness/backend/backend.h"
#include "harness/core/image.h"
#include "harness/scene/textures.h"
#include "harness/stress/pictures.h"
#include "harness/stress/point_sets.h"
#include "tests/open_backend.h"
#include "tests/stress/family_folder.h"

namespace lamina {
namespace {

namespace mp = boost::multiprecision;

class Hypotenuse : public Oracle {
 public:
  std::vector<std::string> inputs() const override { return {"a", "b"}; }
  std::string refusal(Point p) const override {
    return p[0] > 0 && p[0] < 1e31 && p[1] >= 0 && p[1] < 1e31 ? "" : "legs must be lengths";
  }
  double value(Point p) const override {
    using Real = mp::number<mp::cpp_bin_float<100, mp::digit_base_2>, mp::et_off>;
    return static_cast<double>(sqrt(Real(p[0]) * p[0] + Real(p[1]) * p[1]));
  }
  double condition(Point, double) const override { return 1; }  // (a^2 + b^2) / (a^2 + b^2)
  double scale(Point p) const override { return std::max(p[0], p[1]); }
  std::vector<std::string> sets() const override { return {"huge", "everyday"}; }
  Points points(const std::string& set, size_t count, uint64_t seed) const override {
    Points points(2);
    for (size_t i = 0; i < count; ++i) {
      const double place = std::fmod(static_cast<double>(i + seed) * 0.618033988749895, 1);
      const double a = set == "huge" ? std::pow(10, 20 + 10 * place) : 8 * (1 - place);
      points.add({static_cast<float>(a), static_cast<float>(a * static_cast<double>(i) / static_cast<double>(count))});
    }
    return points;
  }
};

class FunctionsOn : public FamilyFolder, public ::testing::WithParamInterface<std::string_view> {
 protected:
  void SetUp() override {
    std::string missing;
    backend_ = open_or_say(GetParam(), missing);
    if (!backend_) GTEST_SKIP() << missing;
  }
  void TearDown() override {
    if (backend_) {
      EXPECT_TRUE(backend_->take_messages().empty());
    }
  }
  Family family_of_sums(size_t inputs, const std::string& glsl, const std::vector<std::string>& tables = {}) {
    Family family{.file = "family.toml", .shader = write("family.comp", glsl + "\n#include \"stress/function.glsl\"\n")};
    family.name = "sums", family.function = "sum", family.definition = "SUM";
    for (const std::string& name : WeightedSum(inputs).inputs()) family.inputs.push_back({.name = name});
    for (const std::string& name : tables)
      family.tables.push_back({name, name == "first" ? TextureMaker(first) : TextureMaker(second)});
    return family;
  }
  using TextureMaker = TextureImage (*)();
  static TextureImage texels(const char* name, std::vector<uint8_t> red) {
    TextureImage image{.name = name, .format = Format::r8_unorm, .width = static_cast<uint32_t>(red.size()), .height = 1};
    std::memcpy(image.levels.emplace_back(red.size()).data(), red.data(), red.size());
    return image;
  }
  static TextureImage first() { return texels("first", {255, 255}); }
  static TextureImage second() { return texels("second", {0, 51}); }  // 51 / 255 is 0.2
  std::unique_ptr<Backend> backend_;
};

TEST_P(FunctionsOn, AFamilyIsDataAndAnOracle) {
  const Hypotenuse oracle;
  EffectCode code;
  code.oracles["hypotenuse"] = &oracle;
  const Family family = load_family(std::filesystem::path(LAMINA_SOURCE_DIR) / "tests/stress/hypotenuse/family.toml", code);
  std::map<std::string, FunctionErrors> all;
  size_t kept = 0;
  for (const PointSet& set : make_sets(family, 5000, 1))
    for (const FamilyFunction& function : family.functions) {
      SCOPED_TRACE(function.name + " " + set.name);
      FunctionRunner runner(*backend_, shaders(), family, function.name);
      const FunctionErrors errors = judge(set.points, runner.values(set.points), truth_of(oracle, set));
      all[function.name + " " + set.name] = errors;
      const FamilyClaim* claim = function.claim(set.name);
      if (!claim) continue;
      ++kept;
      EXPECT_LE(errors.max_over, claim->over);
      EXPECT_GE(errors.max_under, claim->under);
      EXPECT_LE(errors.max_eps_kappa, claim->eps_kappa.value_or(1e30));
      EXPECT_FALSE(errors.first_fault);
    }
  EXPECT_EQ(kept, 5u);
  EXPECT_EQ(all.at("naive_hypotenuse huge").nonfinite, 5000u) << "squares beyond binary32";
  EXPECT_LT(all.at("longer_leg everyday").max_under, -0.4) << "two legs alike: 1 - sqrt(2)";

  const std::vector<Slice> slices = make_slices(family);
  FunctionRunner runner(*backend_, shaders(), family, "longer_leg");
  EXPECT_EQ(write_pictures(runner, slices, folder_, "leg"), std::vector<std::string>{"leg.png"});
  // A leg is shorter than the hypotenuse: blue, and nowhere red.
  const Texels shown = load_texels(folder_ / "leg.png", /*srgb_colour=*/true);
  ASSERT_EQ(shown.rgba.size(), slices[0].points.size());
  size_t blue = 0;
  for (const glm::vec4& texel : shown.rgba) {
    EXPECT_LE(texel.r, texel.b);
    blue += texel.r < texel.b;
  }
  EXPECT_GT(blue, shown.rgba.size() / 2);
}

TEST_P(FunctionsOn, InputsOfAnyNumberReachTheFunctionInTheirOrder) {
  for (size_t inputs = 1; inputs <= max_inputs; ++inputs) {
    std::string parameters, sum;
    for (size_t i = 0; i < inputs; ++i) {
      parameters += (i > 0 ? ", float x" : "float x") + std::to_string(i);
      sum += (i > 0 ? " + " : "") + std::to_string(i + 1) + ".0 * x" + std::to_string(i);
    }
    const Family family = family_of_sums(inputs, "float sum(" + parameters + ") { return SUM * (" + sum + "); }");
    const WeightedSum oracle(inputs);
    Points points(inputs);
    for (size_t n = 0; n < 200; ++n) {
      std::vector<float> point(inputs);
      for (size_t i = 0; i < inputs; ++i) point[i] = static_cast<float>((n * 7 + i * 3) % 16) / 8;
      points.add(point);
    }
    FunctionRunner runner(*backend_, shaders(), family, "1.0");
    const std::vector<float> values = runner.values(points);
    EXPECT_EQ(runner.points(), 200u);
    for (size_t n = 0; n < 200; ++n)
      ASSERT_EQ(values[n], oracle.value(std::vector<double>(points[n].begin(), points[n].end()))) << inputs << " " << n;
    EXPECT_GT(runner.time_ms(1024), 0) << inputs;
  }
}

TEST_P(FunctionsOn, TheDefinitionSelectsTheFunction) {
  const Family family = family_of_sums(1,
                                       "float plain(float x) { return x; } float twice(float x) { return 2.0 * x; }\n"
                                       "float sum(float x) { return SUM(x); }");
  const Points points(1, {{1.5f}});
  EXPECT_EQ(FunctionRunner(*backend_, shaders(), family, "plain").values(points)[0], 1.5f);
  EXPECT_EQ(FunctionRunner(*backend_, shaders(), family, "twice").values(points)[0], 3);
}

TEST_P(FunctionsOn, TablesAreReadByNameFilteredAndClamped) {
  const Family family = family_of_sums(1,
                                       "layout(binding = SECOND_BINDING) uniform sampler2D second;\n"
                                       "layout(binding = FIRST_BINDING) uniform sampler2D first;\n"
                                       "float sum(float x) { return textureLod(SUM, vec2(x, 0.5), 0.0).r; }",
                                       {"first", "second"});
  const Points points(1, {{0.25f}, {0.5f}, {0.75f}, {-5}, {5}});
  FunctionRunner runner(*backend_, shaders(), family, "second");
  const std::vector<float> values = runner.values(points), right = {0, 0.1f, 0.2f, 0, 0.2f};
  for (size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], right[i], 4e-3) << i;  // of 8 bits
  EXPECT_EQ(FunctionRunner(*backend_, shaders(), family, "first").values(points)[0], 1);
}

TEST_P(FunctionsOn, WhatTheFamilyDoesNotBringIsRefused) {
  const auto refused = [&](const std::string& glsl, const std::string& words) {
    const Family family = family_of_sums(1, glsl, {"first"});
    try {
      FunctionRunner(*backend_, shaders(), family, "1.0");
      ADD_FAILURE() << "accepted: " << glsl;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_NE(error.message().find(words), std::string::npos) << error.what();
    }
  };
  refused("layout(binding = 7) uniform sampler2D fist; float sum(float x) { return textureLod(fist, vec2(x), 0.0).r; }",
          "reads 'fist', which is no texture that family.toml has in 'tables'");
  refused("layout(std140, binding = 7) uniform first { float y; }; float sum(float x) { return y; }",
          "reads 'first', which is no texture");
  refused("float sum(float x, float y) { return x + y; }", "sum");
  refused("float product(float x) { return x; }", "sum");
}

INSTANTIATE_TEST_SUITE_P(Backends, FunctionsOn, ::testing::ValuesIn(backend_names().begin(), backend_names().end()),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace lamina
