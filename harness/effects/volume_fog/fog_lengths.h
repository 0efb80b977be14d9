// SPDX-License-Identifier: Apache-2.0
// The truth of fog in hulls: every pixel's ray is followed through every hull by itself.
//
// A variant's passes with when = "truth" write targets of four floats, as large as the frame: seen_behind (the frame without
// fog, linear) and seen_depths, in metres of view depth times shares: x as the variant came to it, y as its encoding comes to
// it at the frame's size, z as floats come to it. Steps: colour (ramp), resolution, encoding, and rasterized depths against
// rays.
#pragma once

#include <memory>

#include "harness/effects/volume_fog/hull_rays.h"
#include "harness/truth/truth.h"

namespace lamina {

std::unique_ptr<Truth> fog_lengths_truth(const TruthSetting& setting);

// The truth without a picture.
class FogTracer {
 public:
  explicit FogTracer(const Scene& scene);
  // Metres along the ray of every pixel (row by row, the top one first) inside hulls, times their shares, holes counting
  // against; 0 where holes win. Each ray ends at the nearest solid. `progress`: 0 to 1.
  std::vector<double> lengths_m(
      const View& view, uint32_t width_px, uint32_t height_px,
      const std::function<void(double)>& progress = [](double) {}) const;

 private:
  struct Hull {
    HullRays rays;
    double share;  // negative for a hole
  };
  std::vector<Hull> hulls_;
  HullRays solids_;
};

}  // namespace lamina
