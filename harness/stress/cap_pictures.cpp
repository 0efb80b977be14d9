// SPDX-License-Identifier: Apache-2.0
#include "harness/stress/cap_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "harness/quality/quality.h"
#include "harness/stress/cap_area.h"

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

void write_cap_pictures(CapRunner& runner, const std::filesystem::path& folder, const std::string& name) {
  const auto centre = [](int pixel) { return static_cast<float>(std::numbers::pi * (pixel + 0.5) / size); };
  for (const float r1 : {0.1f, 0.5f, 1.0f, 1.5f}) {
    std::vector<CapInput> inputs;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) inputs.push_back({centre(x), r1, centre(size - 1 - y)});
    const std::vector<float> areas = runner.areas(inputs);
    DisplayImage picture{size, size, {}};
    for (size_t i = 0; i < inputs.size(); ++i) {
      const auto& [r0, unused, d] = inputs[i];
      const auto colour = colour_of((areas[i] - cap_intersection_area(r0, r1, d)) / smaller_cap_area(r0, r1));
      picture.rgb.insert(picture.rgb.end(), colour.begin(), colour.end());
    }
    write_png((folder / fmt::format("{}-r1-{}.png", name, r1)).string(), picture);
  }
}

}  // namespace lamina
