// SPDX-License-Identifier: Apache-2.0
// SSIM without the border, as tools report that leave the window where it does not fit.
#pragma once

#include <optional>

#include "harness/quality/quality.h"

namespace lamina {

inline constexpr int ssim_border_px = 5;  // half of the 11x11 window, rounded down

// As ssim() over every pixel (OpenCV's whole map, whose window mirrors the picture at its border), but only over pixels whose
// window lies inside the picture: Wang et al.'s own program and scikit-image's do so. Nothing for pictures of 10 pixels or
// fewer on a side. Throws Error(failed) as ssim() does.
std::optional<double> ssim_interior(const DisplayImage& test, const DisplayImage& reference);

}  // namespace lamina
