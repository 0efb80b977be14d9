// SPDX-License-Identifier: Apache-2.0
// Whether what a variant left in the frame is a picture at all. Errors tell how far apart two pictures are; a frame of NaN, of
// background or of one grey is no picture, and no speed makes it worth having.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <string_view>

#include "harness/core/image.h"

namespace lamina {

// What the reason of such a cell's failure begins with, so that tables can say so in place of "failed".
inline constexpr std::string_view no_picture = "not a picture: ";

// A frame as drawn, and the pixels in which the effect's final pass shaded.
struct JudgedFrame {
  const Image& picture;
  const Mask& covered;
};

// Fewer pixels than this are too few to say "all over" of.
inline constexpr size_t min_judged_pixels = 64;
// A baseline whose linear colours span less over the same pixels is nearly of one colour itself.
inline constexpr double min_baseline_range = 0.02;
// Drawing outside is more than this share of what the baseline covers (and at least min_judged_pixels), each by more than
// outside_steps of 255 in some channel as displayed.
inline constexpr double max_outside_share = 0.01;
inline constexpr int outside_steps = 8;

// "", or why the picture is none: "617 of 262144 pixels are not finite numbers, the first at (256, 0)".
std::string why_not_finite(const Image& picture);
// "", or why a finite picture is none beside its baseline's finite picture of the same size: all that either covers is the
// background, or is one colour where the baseline's is not, or it draws where the baseline covers nothing. `background`:
// linear.
std::string why_no_picture(const JudgedFrame& frame, const JudgedFrame& baseline, glm::vec3 background);

}  // namespace lamina
