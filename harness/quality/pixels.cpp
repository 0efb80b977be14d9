// SPDX-License-Identifier: Apache-2.0
#include "harness/quality/pixels.h"

#include <algorithm>
#include <cmath>

#include "harness/core/error.h"

namespace lamina {
namespace {

[[noreturn]] void refuse(std::string_view subject, std::string message) {
  throw Error(ErrorKind::failed, "quality", std::string(subject), std::move(message));
}

void check_storage(std::string_view subject, int width, int height, size_t values, size_t channels) {
  if (width <= 0 || height <= 0)
    refuse(subject, fmt::format("a picture of {} x {} pixels is empty; give one with at least one pixel", width, height));
  const size_t expected = static_cast<size_t>(width) * static_cast<size_t>(height) * channels;
  if (values != expected)
    refuse(subject, fmt::format("a picture of {} x {} pixels holds {} values where {} belong; it was filled wrongly", width,
                                height, values, expected));
}

template <class Picture>
void check_two(std::string_view subject, const Picture& test, const Picture& reference) {
  check_picture(subject, test);
  check_picture(subject, reference);
  if (test.width != reference.width || test.height != reference.height)
    refuse(subject, fmt::format("test is {} x {} pixels, reference {} x {}; render both at one size", test.width, test.height,
                                reference.width, reference.height));
}

}  // namespace

void check_picture(std::string_view subject, const DisplayImage& picture) {
  check_storage(subject, picture.width, picture.height, picture.rgb.size(), 3);
}

void check_picture(std::string_view subject, const Image& picture) {
  check_storage(subject, picture.width, picture.height, picture.rgba.size(), 4);
}

void check_pair(std::string_view subject, const DisplayImage& test, const DisplayImage& reference) {
  check_two(subject, test, reference);
}

void check_pair(std::string_view subject, const Image& test, const Image& reference) { check_two(subject, test, reference); }

void check_mask(std::string_view subject, const Mask* mask, int width, int height) {
  if (mask && (mask->width != width || mask->height != height))
    refuse(subject, fmt::format("the mask is {} x {} pixels, the picture {} x {}; make both at one size", mask->width,
                                mask->height, width, height));
}

size_t counted_pixels(std::string_view subject, const Mask* mask, size_t pixels) {
  if (mask && mask->on.size() != pixels)
    refuse(subject, fmt::format("the mask holds {} pixels, the picture {}; make both at one size", mask->on.size(), pixels));
  const size_t counted = mask ? pixels - static_cast<size_t>(std::ranges::count(mask->on, uint8_t{0})) : pixels;
  if (counted == 0) refuse(subject, "no pixel is counted; the effect covers nothing in this view, or the picture is empty");
  return counted;
}

bool is_finite_pixel(const Image& image, size_t pixel) {
  return std::ranges::all_of(&image.rgba[4 * pixel], &image.rgba[4 * pixel] + 4,
                             [](float value) { return std::isfinite(value); });
}

void check_finite(std::string_view subject, const Image& image, std::string_view name) {
  const size_t bad = nonfinite_pixels(image);
  if (bad == 0) return;
  size_t first = 0;
  while (is_finite_pixel(image, first)) ++first;
  const size_t width = static_cast<size_t>(image.width);
  refuse(subject,
         fmt::format("{} of {} pixels of the {} picture are not finite, the first at x {}, y {} (rgba {}, {}, {}, {}); "
                     "look for a division by zero, a root or an overflow in the shader",
                     bad, image.rgba.size() / 4, name, first % width, first / width, image.rgba[4 * first],
                     image.rgba[4 * first + 1], image.rgba[4 * first + 2], image.rgba[4 * first + 3]));
}

cv::Mat as_mat(const DisplayImage& picture) {
  return cv::Mat(picture.height, picture.width, CV_8UC3, const_cast<uint8_t*>(picture.rgb.data()));  // OpenCV has no const view
}

}  // namespace lamina
