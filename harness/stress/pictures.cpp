// SPDX-License-Identifier: Apache-2.0
#include "harness/stress/pictures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "harness/quality/quality.h"

namespace lamina {
namespace {

constexpr int size = 256;

std::array<uint8_t, 3> colour_of(double value, double truth, double scale, double full_error) {
  if (std::isnan(truth)) return {128, 128, 128};
  const double error = (value - truth) / scale;
  if (!std::isfinite(error)) return {0, 0, 0};
  const double strength = std::clamp(error / full_error, -1.0, 1.0);
  const auto fading = static_cast<uint8_t>(std::lround(255 * (1 - std::abs(strength))));
  return strength > 0 ? std::array<uint8_t, 3>{255, fading, fading} : std::array<uint8_t, 3>{fading, fading, 255};
}

Slice make_slice(const Family& family, const FamilySlice& from) {
  const FamilyInput &right = family.inputs[from.right], &up = family.inputs[from.up];
  PointSet set{"", "", Points(family.inputs.size())};
  Slice slice{.full_error = from.full_error, .points = set.points};
  slice.axes = fmt::format("{} from {} to {} to the right, {} from {} to {} upwards", right.name, right.from_words,
                           right.to_words, up.name, up.from_words, up.to_words);
  std::vector<std::string> fixed;
  for (size_t i = 0; i < from.at.size(); ++i) {
    if (i == from.right || i == from.up) continue;
    fixed.push_back(fmt::format("{} = {}", family.inputs[i].name, from.at[i]));
    slice.file += fmt::format("-{}-{}", family.inputs[i].name, from.at[i]);
  }
  slice.name = fmt::format("{}", fmt::join(fixed, ", "));
  slice.file += ".png";
  const auto centre = [](const FamilyInput& input, int pixel) {
    return static_cast<float>(input.from + (input.to - input.from) * (pixel + 0.5) / size);
  };
  std::vector<float> point = from.at;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      point[from.right] = centre(right, x);
      point[from.up] = centre(up, size - 1 - y);
      set.points.add(point);
    }
  slice.truth = truth_of(*family.oracle, set);
  slice.points = std::move(set.points);
  return slice;
}

}  // namespace

std::vector<Slice> make_slices(const Family& family) {
  std::vector<Slice> slices;
  for (const FamilySlice& slice : family.slices) slices.push_back(make_slice(family, slice));
  return slices;
}

std::vector<std::string> write_pictures(FunctionRunner& runner, const std::vector<Slice>& slices,
                                        const std::filesystem::path& folder, const std::string& name) {
  std::vector<std::string> files;
  for (const Slice& slice : slices) {
    const std::vector<float> values = runner.values(slice.points);
    DisplayImage picture{size, size, {}};
    for (size_t i = 0; i < values.size(); ++i) {
      const auto colour = colour_of(values[i], slice.truth.values[i], slice.truth.scales[i], slice.full_error);
      picture.rgb.insert(picture.rgb.end(), colour.begin(), colour.end());
    }
    files.push_back(name + slice.file);
    write_png((folder / files.back()).string(), picture);
  }
  return files;
}

}  // namespace lamina
