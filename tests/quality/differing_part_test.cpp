// SPDX-License-Identifier: Apache-2.0
// Maps are made only where pictures differ. They must be those of the whole pictures.
#include <cmath>

#include "harness/quality/pixels.h"
#include "tests/quality/pictures.h"

namespace lamina {
namespace {

constexpr int across_px = 120, down_px = 90, flip_radius = 10, ssim_radius = 5;

DisplayImage with_noise_in(const DisplayImage& picture, const cv::Rect& box, uint32_t seed) {
  DisplayImage changed = picture;
  const DisplayImage other = noise(picture.width, picture.height, seed);
  as_mat(other)(box).copyTo(as_mat(changed)(box));
  return changed;
}

int distance_to(const cv::Rect& box, int x, int y) {
  return std::max({box.x - x, x - (box.br().x - 1), box.y - y, y - (box.br().y - 1), 0});
}

const std::vector<cv::Rect> boxes = {{60, 40, 1, 1},   {50, 30, 20, 25}, {0, 40, 3, 8},
                                     {117, 30, 3, 30}, {50, 0, 9, 2},    {40, 88, 30, 2}};

TEST(DifferingPart, IsTheBoxOfTheDifferencesAndAllThatItLooksAt) {
  const DisplayImage picture = flat(across_px, down_px, grey(100));
  DisplayImage changed = picture;
  changed.rgb[3 * (20 * across_px + 30) + 2] = 101;  // the last channel of the pixel at 30, 20
  changed.rgb[3 * (25 * across_px + 33)] = 99;       // the first of that at 33, 25
  const DifferingPart part = differing_part(picture, changed, 5);
  EXPECT_EQ(part.changed, cv::Rect(25, 15, 14, 16));
  EXPECT_EQ(part.read, cv::Rect(20, 10, 24, 26));
  changed.rgb[0] = 0;
  EXPECT_EQ(differing_part(picture, changed, 5).changed, cv::Rect(0, 0, 39, 31)) << "cut at the border";
  EXPECT_TRUE(differing_part(picture, picture, 5).changed.empty());
}

// Two more pixels that differ, in opposite corners, make the part the whole picture: there both ways must agree.
TEST(DifferingPart, MapsAreThoseOfTheWholePictures) {
  const DisplayImage reference = noise(across_px, down_px, 1);
  for (const cv::Rect& box : boxes) {
    const DisplayImage test = with_noise_in(reference, box, 2);
    const DisplayImage whole_test = with_noise_in(with_noise_in(test, {0, 0, 1, 1}, 3), {across_px - 1, down_px - 1, 1, 1}, 3);
    ASSERT_EQ(differing_part(whole_test, reference, 1).changed, cv::Rect(0, 0, across_px, down_px));
    const std::vector<float> flip = flip_map(test, reference), whole_flip = flip_map(whole_test, reference);
    const cv::Mat3d similarity = ssim_map(test, reference), whole_similarity = ssim_map(whole_test, reference);
    size_t compared = 0, unequal = 0;
    for (int y = 0; y < down_px; ++y)
      for (int x = 0; x < across_px; ++x) {
        if (std::min(distance_to({0, 0, 1, 1}, x, y), distance_to({across_px - 1, down_px - 1, 1, 1}, x, y)) <= flip_radius)
          continue;
        const size_t pixel = static_cast<size_t>(y * across_px + x);
        ASSERT_NEAR(flip[pixel], whole_flip[pixel], 1e-5) << box << " " << x << " " << y;
        for (int channel = 0; channel < 3; ++channel)
          ASSERT_NEAR(similarity(y, x)[channel], whole_similarity(y, x)[channel], 1e-12) << box << " " << x << " " << y;
        if (distance_to(box, x, y) > flip_radius) {
          ASSERT_EQ(whole_flip[pixel], 0) << box << " " << x << " " << y;
        }
        if (distance_to(box, x, y) > ssim_radius) {
          ASSERT_EQ(whole_similarity(y, x), cv::Vec3d::all(1)) << box << " " << x << " " << y;
        }
        ++compared;
        unequal += flip[pixel] > 0 && similarity(y, x) != cv::Vec3d::all(1);
      }
    EXPECT_GT(compared, 9000u);
    EXPECT_GT(unequal, 30u) << box;
  }
}

}  // namespace
}  // namespace lamina
