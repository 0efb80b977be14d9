// SPDX-License-Identifier: Apache-2.0
#include "harness/stress/cap_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "harness/caps/cap_area.h"
#include "harness/quality/quality.h"

namespace lamina {
namespace {

constexpr int size = 256;

std::array<uint8_t, 3> colour_of(double error) {
  if (!std::isfinite(error)) return {0, 0, 0};
  const double strength = std::clamp(error / full_error, -1.0, 1.0);
  const auto fading = static_cast<uint8_t>(std::lround(255 * (1 - std::abs(strength))));
  return strength > 0 ? std::array<uint8_t, 3>{255, fading, fading} : std::array<uint8_t, 3>{fading, fading, 255};
}

}  // namespace

std::vector<CapSlice> make_cap_slices() {
  const auto centre = [](int pixel) { return static_cast<float>(std::numbers::pi * (pixel + 0.5) / size); };
  std::vector<CapSlice> slices;
  for (const float r1 : {0.1f, 0.5f, 1.0f, 1.5f}) {
    CapSlice& slice = slices.emplace_back();
    slice.r1 = r1;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const auto& [r0, unused, d] = slice.inputs.emplace_back(CapInput{centre(x), r1, centre(size - 1 - y)});
        slice.truth.push_back(cap_intersection_area(r0, r1, d));
      }
  }
  return slices;
}

std::vector<std::string> write_cap_pictures(CapRunner& runner, std::span<const CapSlice> slices,
                                            const std::filesystem::path& folder, const std::string& name) {
  std::vector<std::string> files;
  for (const CapSlice& slice : slices) {
    const std::vector<float> areas = runner.areas(slice.inputs);
    DisplayImage picture{size, size, {}};
    for (size_t i = 0; i < areas.size(); ++i) {
      const auto colour = colour_of((areas[i] - slice.truth[i]) / smaller_cap_area(slice.inputs[i].r0, slice.r1));
      picture.rgb.insert(picture.rgb.end(), colour.begin(), colour.end());
    }
    files.push_back(fmt::format("{}-r1-{}.png", name, slice.r1));
    write_png((folder / files.back()).string(), picture);
  }
  return files;
}

}  // namespace lamina
