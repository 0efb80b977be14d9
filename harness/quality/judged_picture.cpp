// SPDX-License-Identifier: Apache-2.0
#include "harness/quality/judged_picture.h"

#include <algorithm>
#include <cmath>

#include "harness/core/error.h"
#include "harness/quality/pixels.h"

namespace lamina {
namespace {

constexpr float half_float_step = 1.0f / 1024;  // frames are kept in half floats, the background is given in float

bool shows(const Image& picture, size_t pixel, glm::vec3 colour) {
  for (int channel = 0; channel < 3; ++channel) {
    const float value = picture.rgba[4 * pixel + static_cast<size_t>(channel)];
    if (std::abs(value - colour[channel]) > half_float_step * std::max(1.0f, std::abs(colour[channel]))) return false;
  }
  return true;
}

bool all_show(const Image& picture, const Mask& mask, glm::vec3 colour) {
  for (size_t pixel = 0; pixel < mask.on.size(); ++pixel)
    if (mask.on[pixel] != 0 && !shows(picture, pixel, colour)) return false;
  return true;
}

bool differs_as_displayed(const DisplayImage& a, const DisplayImage& b, size_t pixel) {
  for (size_t channel = 3 * pixel; channel < 3 * pixel + 3; ++channel)
    if (std::abs(a.rgb[channel] - b.rgb[channel]) > outside_steps) return true;
  return false;
}

size_t drawn_outside(const JudgedFrame& frame, const JudgedFrame& baseline) {
  const DisplayImage shown = to_display(frame.picture), expected = to_display(baseline.picture);
  size_t outside = 0;
  for (size_t pixel = 0; pixel < frame.covered.on.size(); ++pixel)
    if (frame.covered.on[pixel] != 0 && baseline.covered.on[pixel] == 0 && differs_as_displayed(shown, expected, pixel))
      ++outside;
  return outside;
}

}  // namespace

std::string why_not_finite(const Image& picture) {
  const size_t count = nonfinite_pixels(picture);
  if (count == 0) return "";
  size_t first = 0;
  while (is_finite_pixel(picture, first)) ++first;
  const auto width = static_cast<size_t>(picture.width);
  return fmt::format("{} of {} pixels {}, the first at ({}, {})", count, picture.rgba.size() / 4,
                     count == 1 ? "is not a finite number" : "are not finite numbers", first % width, first / width);
}

std::string why_no_picture(const JudgedFrame& frame, const JudgedFrame& baseline, glm::vec3 background) {
  check_pair("judged picture", frame.picture, baseline.picture);
  check_mask("judged picture", &frame.covered, frame.picture.width, frame.picture.height);
  check_mask("judged picture", &baseline.covered, frame.picture.width, frame.picture.height);
  const auto expected = static_cast<size_t>(std::ranges::count_if(baseline.covered.on, [](uint8_t on) { return on != 0; }));
  if (expected < min_judged_pixels) return "";
  if (range_linear(baseline.picture, &baseline.covered) > min_baseline_range) {
    if (all_show(frame.picture, baseline.covered, background))
      return fmt::format("nothing is drawn where the baseline covers {} pixels", expected);
    if (range_linear(frame.picture, &baseline.covered) == 0)
      return fmt::format("it is one colour all over the {} pixels that the baseline covers", expected);
  }
  const size_t outside = drawn_outside(frame, baseline);
  if (outside >= min_judged_pixels && static_cast<double>(outside) > max_outside_share * static_cast<double>(expected))
    return fmt::format("it draws {} pixels where the baseline, which covers {}, covers nothing", outside, expected);
  return "";
}

}  // namespace lamina
