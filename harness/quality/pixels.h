// SPDX-License-Identifier: Apache-2.0
// What the metrics share, inside this folder only: the checks that come before any figure, which pixels count, and OpenCV's
// view of a picture.
#pragma once

#include <opencv2/core.hpp>
#include <string_view>

#include "harness/quality/quality.h"

namespace lamina {

// Each throws Error(failed, "quality", subject, ...); `subject` is the figure or picture being made.
// A picture with no pixels, or whose storage does not match its size.
void check_picture(std::string_view subject, const DisplayImage& picture);
void check_picture(std::string_view subject, const Image& picture);
// Either picture as above, or two sizes.
void check_pair(std::string_view subject, const DisplayImage& test, const DisplayImage& reference);
void check_pair(std::string_view subject, const Image& test, const Image& reference);
// A mask that is not width x height pixels. A null mask passes.
void check_mask(std::string_view subject, const Mask* mask, int width, int height);

inline bool counts(const Mask* mask, size_t pixel) { return !mask || mask->on[pixel] != 0; }
// Pixels counted out of `pixels`. Throws as above where that is none, or where the mask is not that many pixels.
size_t counted_pixels(std::string_view subject, const Mask* mask, size_t pixels);

// Whether r, g, b and a of the pixel are all finite.
bool is_finite_pixel(const Image& image, size_t pixel);
// Throws as above, with the first place and the count, where a pixel is not finite; `name` is "test" or "reference".
void check_finite(std::string_view subject, const Image& image, std::string_view name);

// The same memory as an OpenCV matrix of three 8-bit channels, r first: read only, and no longer than the picture lives.
cv::Mat as_mat(const DisplayImage& picture);

// A map is that of equal pictures beyond `radius` pixels of where two pictures differ, if each of its pixels looks that far.
struct DifferingPart {
  cv::Rect changed;  // where the map has to be made; empty: the pictures are equal
  cv::Rect read;     // what it is made from: what the pixels of `changed` look at
};
DifferingPart differing_part(const DisplayImage& test, const DisplayImage& reference, int radius);

// SSIM of every pixel and channel (three doubles, r first), and its mean: apart, so that one map serves several masks.
cv::Mat3d ssim_map(const DisplayImage& test, const DisplayImage& reference);
double ssim_mean(const cv::Mat3d& map, const Mask* mask);

}  // namespace lamina
