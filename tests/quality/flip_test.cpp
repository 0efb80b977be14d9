// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/quality/pictures.h"

namespace lamina {
namespace {

struct AuthorsValue {
  std::string name;
  DisplayImage test, reference;
  double mean, max;
};
void PrintTo(const AuthorsValue& value, std::ostream* out) { *out << value.name; }

// Mean and greatest error of the authors' own tool on pictures that a formula gives.
std::vector<AuthorsValue> authors_values() {
  const auto checker = [](int shift) {
    return painted(128, 128, [=](int x, int y) { return grey(255 * (((x + shift) / 8 + y / 8) % 2)); });
  };
  const auto step = [](int at) { return painted(96, 80, [=](int x, int) { return grey(x < at ? 60 : 180); }); };
  return {
      {"Reddish", flat(64, 64, {148, 128, 128}), flat(64, 64, grey(128)), 0.208514, 0.208524},
      {"BlackWhite", flat(64, 64, grey(255)), flat(64, 64, grey(0)), 0.967345, 0.967388},
      {"GreenBlue", flat(64, 64, {0, 0, 255}), flat(64, 64, {0, 255, 0}), 1.0, 1.0},
      {"ShiftedChecker", checker(1), checker(0), 0.320955, 0.993284},
      {"PatternedRamp",
       painted(128, 96,
               [](int x, int y) {
                 return Colour8{2 * x, std::min(255, 2 * y + x * y % 7), 128};
               }),
       painted(128, 96,
               [](int x, int y) {
                 return Colour8{2 * x, 2 * y, 128};
               }),
       0.069872, 0.135018},
      {"WhiteDot", painted(101, 101, [](int x, int y) { return grey(x == 50 && y == 50 ? 255 : 64); }),
       flat(101, 101, grey(64)), 0.000774, 0.603224},
      {"MovedStep", step(50), step(48), 0.033376, 0.728363},
  };
}

class FlipOfAuthorsPictures : public testing::TestWithParam<AuthorsValue> {};
TEST_P(FlipOfAuthorsPictures, HasTheirMeanAndMaximum) {
  const std::vector<float> map = flip_map(GetParam().test, GetParam().reference);
  EXPECT_NEAR(flip_mean(map), GetParam().mean, 0.00005);
  EXPECT_NEAR(std::ranges::max(map), GetParam().max, 0.0001);
}
INSTANTIATE_TEST_SUITE_P(Tool, FlipOfAuthorsPictures, testing::ValuesIn(authors_values()),
                         [](const auto& value) { return value.param.name; });

TEST(Flip, TakesItsDefaultDistanceFromTheStatedDisplay) {
  EXPECT_NEAR(default_pixels_per_degree, 0.7 * (3840 / 0.7) * std::numbers::pi / 180, 1e-12);
}

TEST(Flip, IsZeroForEqualPictures) {
  for (const float error : flip_map(noise(40, 30, 1), noise(40, 30, 1))) ASSERT_EQ(error, 0);
}

TEST(Flip, IsSymmetric) {
  EXPECT_EQ(flip_map(noise(40, 30, 1), noise(40, 30, 2)), flip_map(noise(40, 30, 2), noise(40, 30, 1)));
}

TEST(Flip, StaysWithinZeroAndOne) {
  const auto dots = [](int odd) { return painted(64, 64, [=](int x, int y) { return grey((x + y) % 2 == odd ? 255 : 0); }); };
  for (const double pixels_per_degree : {1.0, 20.0, default_pixels_per_degree, 300.0})
    for (const auto& [test, reference] : {std::pair{noise(64, 64, 1), noise(64, 64, 2)},
                                          {dots(0), dots(1)},
                                          {dots(0), flat(64, 64, grey(0))},
                                          {flat(64, 64, {0, 0, 255}), flat(64, 64, {0, 255, 0})}})
      for (const float error : flip_map(test, reference, pixels_per_degree)) ASSERT_TRUE(error >= 0 && error <= 1) << error;
}

TEST(Flip, TurnsWithThePicture) {
  // Mirroring x, and swapping x with y, of both pictures does the same to the map: no axis is preferred.
  const auto colour = [](int seed) {
    return [=](int x, int y) { return Colour8{(x * x + seed * y) % 256, (7 * x * y) % 256, (seed * x) % 256}; };
  };
  const int w = 37, h = 29;
  const auto swapped = [&](int seed) { return painted(h, w, [=](int x, int y) { return colour(seed)(y, x); }); };
  const auto mirrored = [&](int seed) { return painted(w, h, [=](int x, int y) { return colour(seed)(w - 1 - x, y); }); };
  const std::vector<float> map = flip_map(painted(w, h, colour(3)), painted(w, h, colour(5)));
  const std::vector<float> swapped_map = flip_map(swapped(3), swapped(5)), mirrored_map = flip_map(mirrored(3), mirrored(5));
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      ASSERT_NEAR(map[y * w + x], swapped_map[x * h + y], 1e-4);
      ASSERT_NEAR(map[y * w + x], mirrored_map[y * w + w - 1 - x], 1e-4);
    }
}

TEST(Flip, FadesWithDistance) {
  // From further away the eye averages a fine checker into grey.
  const DisplayImage checker = painted(64, 64, [](int x, int y) { return grey((x + y) % 2 ? 150 : 100); });
  const DisplayImage grey_one = flat(64, 64, grey(127));
  EXPECT_GT(flip_mean(flip_map(checker, grey_one, 20)), flip_mean(flip_map(checker, grey_one, 120)));
}

TEST(Flip, MeasuresPicturesSmallerThanItsKernels) {
  // Flat pictures know no border: the errors of the 64x64 pictures, whatever the size.
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 40}, {40, 1}, {2, 3}, {9, 8}})
    for (const float error : flip_map(flat(width, height, grey(255)), flat(width, height, grey(0))))
      ASSERT_NEAR(error, 0.967388, 0.0001) << width << " x " << height;
  const DisplayImage column = noise(1, 40, 1), other = noise(1, 40, 2);
  EXPECT_GT(flip_mean(flip_map(column, other)), 0);
}

TEST(Flip, IsTheSameBitForBitFromRunToRun) {
  const DisplayImage a = noise(301, 203, 1), b = noise(301, 203, 2);
  const std::vector<float> first = flip_map(a, b);
  for (int run = 0; run < 4; ++run) ASSERT_EQ(flip_map(a, b), first);
}

TEST(FlipMean, CountsOnlyTheMask) {
  const std::vector<float> map = {0, 0.25f, 0.5f, 1};
  const Mask all = whole(2, 2), two{2, 2, {0, 1, 1, 0}}, none{2, 2, {0, 0, 0, 0}}, other = whole(3, 2);
  EXPECT_EQ(flip_mean(map), 0.4375);
  EXPECT_EQ(flip_mean(map, &all), 0.4375);
  EXPECT_EQ(flip_mean(map, &two), 0.375);
  EXPECT_NE(refusal([&] { flip_mean(map, &none); }).find("no pixel is counted"), std::string::npos);
  EXPECT_NE(refusal([&] { flip_mean(map, &other); }).find("the mask holds 6"), std::string::npos);
  EXPECT_NE(refusal([&] { flip_mean({}); }).find("no pixel is counted"), std::string::npos);
  EXPECT_NE(refusal([&] { flip_mean({0, std::nanf("")}); }).find("not finite"), std::string::npos);
}

TEST(Flip, RefusesWhatHasNoFigure) {
  const DisplayImage a = flat(4, 3, grey(1));
  EXPECT_NE(refusal([&] { flip_map(a, flat(3, 4, grey(1))); }).find("test is 4 x 3 pixels, reference 3 x 4"),
            std::string::npos);
  EXPECT_NE(refusal([&] { flip_map({}, {}); }).find("empty"), std::string::npos);
  for (const double pixels_per_degree : {0.0, -67.0, 0.99, 1001.0, std::nan("")})
    EXPECT_NE(refusal([&] { flip_map(a, a, pixels_per_degree); }).find("outside 1 to 1000"), std::string::npos);
}

}  // namespace
}  // namespace lamina
