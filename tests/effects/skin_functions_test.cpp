// SPDX-License-Identifier: Apache-2.0
// The families of functions that skin is made of, on every backend: against their oracles and known values.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/effects/family_shaders.h"

namespace lamina {
namespace {

const char* const skin_folders[] = {"beckmann",      "kelemen_reflection", "blended_normals",
                                    "shadow_powers", "burley_radius",      "gaussian_sum"};

class SkinFunctions : public FamilyShaders {
 protected:
  SkinFunctions() : FamilyShaders(300) {}
};

TEST_P(SkinFunctions, EveryFunctionKeepsTheBoundsThatItClaims) { EXPECT_GE(judge_claims(skin_folders).size(), 16u); }

TEST_P(SkinFunctions, NaiveFormsFailWhereStableOnesDoNot) {
  const Family kelemen = family_in("kelemen_reflection"), burley = family_in("burley_radius"), beckmann = family_in("beckmann");
  EXPECT_EQ(errors(kelemen, "kelemen_unguarded", "opposite").nonfinite, inputs_);
  EXPECT_EQ(errors(kelemen, "kelemen_by_cosines", "opposite").nonfinite, 0u);
  const FunctionErrors closed = errors(burley, "burley_closed", "small");
  EXPECT_GT(std::max(closed.max_over, -closed.max_under), 0.05);
  // N.H = 1 read half a texel beyond the last centre is most of a table's error.
  EXPECT_GT(-errors(beckmann, "beckmann_table_printed", "peak").max_under,
            3 * -errors(beckmann, "beckmann_table_half", "peak").max_under);
}

// Mended, the dark side of a bump keeps red, and its lit side has no colour; as printed it turns grey.
TEST_P(SkinFunctions, BlendedNormalsOverAllCodes) {
  const Family family = family_in("blended_normals");
  std::vector<std::vector<float>> points;
  for (int vertex = 0; vertex < 256; ++vertex)
    for (int bump = 0; bump < 256; ++bump)
      points.push_back({static_cast<float>(vertex) / 127.5f - 1, static_cast<float>(bump) / 127.5f - 1, 0.6f, 0.4f});
  const std::vector<float> rest = values(family, "blended_mended", points);
  for (size_t i = 0; i < points.size(); ++i) {
    const float v = points[i][0], b = points[i][1], red = b + 0.6f * (v - b);
    ASSERT_GE(rest[i], 0);
    ASSERT_LE(rest[i], std::clamp(red, 0.0f, 1.0f) + 1e-6f) << v << " " << b;
    if (v == b) {
      ASSERT_NEAR(rest[i], std::clamp(v, 0.0f, 1.0f), 1e-6f);
    }
  }
  EXPECT_NEAR(values(family, "blended_mended", {{0.8f, 0.2f, 0.6f, 0.4f}})[0], 0.44f, 1e-6f);
  EXPECT_NEAR(values(family, "blended_mended", {{0.2f, 0.8f, 0.6f, 0.4f}})[0], 0.44f, 1e-6f);
  EXPECT_NEAR(values(family, "blended_printed", {{0.8f, 0.2f, 0.6f, 0.4f}})[0], 0.44f, 1e-6f);
}

TEST_P(SkinFunctions, SharpenedShadowsAreTheTable) {
  const Family family = family_in("shadow_powers");
  const float shadows[] = {0.25f, 0.5f, 0.75f, 0.9f};
  const float plain[] = {.2008f, .4344f, .7008f, .8764f}, printed[] = {.2064f, .4456f, .7177f, .8966f},
              epidermal[] = {.0030f, .0485f, .2667f, .6116f};
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(values(family, "powers_by_logarithm", {{shadows[i], 1, 2, 1}})[0], plain[i], 6e-5f);
    EXPECT_NEAR(values(family, "powers_printed", {{shadows[i], 1, 2, 1}})[0], printed[i], 6e-5f);
    EXPECT_NEAR(values(family, "powers_printed", {{shadows[i], 4, 8, 1}})[0], epidermal[i], 6e-5f);
  }
  EXPECT_EQ(values(family, "powers_by_logarithm", {{0, 16, 16, 1}, {0, 1, 2, 1}}), (std::vector<float>{0, 0}));
  EXPECT_NEAR(values(family, "powers_by_logarithm", {{1, 16, 16, 1}})[0], 1, 1e-6f);
}

// Of the peak, 1 / m^2: 8 bits err by half a step of the stored root and by what a filter in 8 bits cuts off, 0.86 of a step at
// most, ten times over in the tenth power; 16 bits and halves by what lies between two texels.
TEST_P(SkinFunctions, TablesErrAsTheirBitsLet) {
  const Family family = family_in("beckmann");
  for (const float m : {0.2f, 0.3f, 0.5f}) {
    std::vector<std::vector<float>> points;
    for (int i = 0; i <= 500; ++i) points.push_back({0.8f + 0.2f * float(i) / 500, m});
    const std::vector<float> right = values(family, "beckmann_without_angles", points);
    const auto most = [&](const char* function) {
      const std::vector<float> found = values(family, function, points);
      float off = 0;
      for (size_t i = 0; i < found.size(); ++i) off = std::max(off, std::abs(found[i] - right[i]) * m * m);
      return off;
    };
    EXPECT_GT(most("beckmann_table_unorm8"), 0.005f) << m;
    EXPECT_LT(most("beckmann_table_unorm8"), 10 * (0.5f + 0.86f) / 255 / (0.5f * std::pow(m, -0.2f))) << m;
    EXPECT_LT(most("beckmann_table_unorm16"), 0.001f) << m;
    EXPECT_LT(most("beckmann_table_half"), 0.005f) << m;
  }
}

TEST_P(SkinFunctions, BurleysRadiusIsTheTable) {
  const float right[] = {.214462f, 1.552183f, 6.062229f, 12.952642f, 16.564399f};
  EXPECT_EQ(values(family_in("burley_radius"), "burley_series", {{.1f}, {.5f}, {.9f}, {.99f}, {.997f}}).size(), 5u);
  const std::vector<float> found = values(family_in("burley_radius"), "burley_series", {{.1f}, {.5f}, {.9f}, {.99f}, {.997f}});
  for (size_t i = 0; i < 5; ++i) EXPECT_NEAR(found[i], right[i], 1e-4f * right[i]);
}

INSTANTIATE_TEST_SUITE_P(Backends, SkinFunctions, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
