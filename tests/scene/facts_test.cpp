// SPDX-License-Identifier: Apache-2.0
// Facts of textures that are known texel by texel.
#include "harness/scene/facts.h"

#include <gtest/gtest.h>

#include "harness/scene/textures.h"

namespace lamina {
namespace {

// An object with an effect that asks for the largest texel of a texture.
struct Asked {
  EffectManifest effect;
  Object object;
  explicit Asked(const std::vector<glm::vec4>& texels, const std::string& function = "largest") {
    effect.name = "e";
    effect.facts = {{"most", function, "map"}};
    object.effects["e"].textures["map"] =
        make_texture("map", {static_cast<uint32_t>(texels.size()), 1, texels}, TexelMeaning::data);
    settle_facts(object, effect);
  }
  double most() const { return object.effects.at("e").facts.at("most"); }
};

TEST(Facts, LargestIsTheGreatestRedOfAnyTexel) {
  EXPECT_EQ(Asked({{0, 1, 1, 1}, {0, 0, 0, 0}}).most(), 0) << "green, blue and alpha do not count";
  EXPECT_NEAR(Asked({{0.2f, 0, 0, 0}, {0.6f, 0, 0, 0}, {0.4f, 0, 0, 0}}).most(), 0.6, 0.5 / 255);
  EXPECT_EQ(Asked({{1, 0, 0, 0}, {0, 0, 0, 0}}).most(), 1);
}

TEST(Facts, LargestChannelIsTheGreatestOfAllThree) {
  EXPECT_EQ(Asked({{0, 0, 0, 1}}, "largest_channel").most(), 0) << "alpha does not count";
  for (int c = 0; c < 3; ++c) {
    glm::vec4 texel(0.2f);
    texel[c] = 0.6f;
    EXPECT_NEAR(Asked({glm::vec4(0), texel}, "largest_channel").most(), 0.6, 0.5 / 255);
  }
}

TEST(Facts, LargestBendIsHowFarNormalsLieFromFlat) {
  EXPECT_EQ(Asked({{0.5f, 0.5f, 1, 1}, {127.0f / 255, 128.0f / 255, 1, 1}}, "largest_bend").most(), 0) << "both codes are flat";
  EXPECT_NEAR(Asked({{0.5f, 0.5f, 1, 1}, {0.5f, 0.1f, 0.9f, 1}}, "largest_bend").most(), 0.8, 1.0 / 255);
}

TEST(Facts, LeastAlphaIsTheLeastOfAnyTexel) {
  EXPECT_EQ(Asked({{0, 0, 0, 1}, {0, 0, 0, 1}}, "least_alpha").most(), 1) << "colours do not count";
  EXPECT_NEAR(Asked({{1, 1, 1, 0.8f}, {1, 1, 1, 0.2f}, {1, 1, 1, 1}}, "least_alpha").most(), 0.2, 0.5 / 255);
}

TEST(Facts, AFactComesBeforeANumberAndWhatIsNotKnownIsZero) {
  EffectValues values;
  values.numbers = {{"both", 2}, {"number", 3}};
  values.facts = {{"both", 0.5}};
  EXPECT_EQ(fact_or_number(values, "both"), 0.5);
  EXPECT_EQ(fact_or_number(values, "number"), 3);
  EXPECT_EQ(fact_or_number(values, "neither"), 0);
}

}  // namespace
}  // namespace lamina
