// SPDX-License-Identifier: Apache-2.0
// When errors to a baseline cannot differ: a change of the picture, of the covered pixels or of the baseline, each alone, is
// enough that they may.
#include "harness/gate/pictures_before.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lamina {
namespace {

struct Drawn {
  Image picture{2, 1, {0, 0.25f, 0.5f, 1, 1, 0.75f, 0.5f, 1}};
  Mask covered{2, 1, {0, 1}};
};

class PicturesBeforeTest : public testing::Test {
 protected:
  PicturesBeforeTest() {
    for (const size_t view : {0u, 1u}) {
      before_.add("baseline", view, Drawn().picture, Drawn().covered);
      before_.add("cheap", view, cheap_.picture, cheap_.covered);
    }
  }
  static Drawn darker(Drawn drawn) {
    for (float& value : drawn.picture.rgba) value *= 0.5f;
    return drawn;
  }
  bool same(const Drawn& baseline, const Drawn& cheap, size_t view = 0) {
    before_.same_errors("baseline", true, view, baseline.picture, baseline.covered);
    return before_.same_errors("cheap", false, view, cheap.picture, cheap.covered);
  }
  Drawn cheap_ = darker({});
  PicturesBefore before_;
};

TEST_F(PicturesBeforeTest, TheSamePicturesHaveTheSameErrors) {
  EXPECT_TRUE(same({}, cheap_));
  EXPECT_EQ(before_.of("cheap", 1)->picture.rgba, cheap_.picture.rgba);
  EXPECT_EQ(before_.of("cheap", 1)->covered.on, cheap_.covered.on);
  EXPECT_EQ(before_.of("cheap", 2), nullptr);
}

TEST_F(PicturesBeforeTest, OneBitOfThePictureIsEnough) {
  Drawn changed = cheap_;
  changed.picture.rgba[5] = std::nextafter(changed.picture.rgba[5], 1.0f);
  EXPECT_FALSE(same({}, changed));
  changed.picture.rgba[5] = cheap_.picture.rgba[5];
  EXPECT_TRUE(same({}, changed));
  changed.picture.rgba[0] = -0.0f;
  EXPECT_FALSE(same({}, changed)) << "equal, but not the same";
}

TEST_F(PicturesBeforeTest, WhatIsNotANumberIsTheSameToTheBit) {
  Drawn broken = cheap_;
  broken.picture.rgba[5] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(same({}, broken));
  before_.add("cheap", 0, broken.picture, broken.covered);
  EXPECT_TRUE(same({}, broken));
}

TEST_F(PicturesBeforeTest, SoAreTheCoveredPixels) {
  Drawn changed = cheap_;
  changed.covered.on = {1, 1};
  EXPECT_FALSE(same({}, changed));
}

TEST_F(PicturesBeforeTest, AndTheBaselineOfTheView) {
  EXPECT_FALSE(same(darker({}), cheap_));
  EXPECT_TRUE(same({}, cheap_, 1)) << "in another view it is as it was";
  Drawn covers_more;
  covers_more.covered.on = {1, 1};
  EXPECT_FALSE(same(covers_more, cheap_));
}

TEST_F(PicturesBeforeTest, WithoutABaselineOrAPictureNothingIsKnown) {
  EXPECT_FALSE(before_.same_errors("cheap", false, 0, cheap_.picture, cheap_.covered)) << "the baseline was not drawn";
  EXPECT_TRUE(same({}, cheap_));
  EXPECT_FALSE(before_.same_errors("new", false, 0, cheap_.picture, cheap_.covered));
  EXPECT_FALSE(before_.same_errors("cheap", false, 2, cheap_.picture, cheap_.covered)) << "a view that was not there";
}

}  // namespace
}  // namespace lamina
