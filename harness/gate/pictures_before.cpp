// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/pictures_before.h"

#include <cstring>

namespace lamina {
namespace {

// To the bit: no number is equal to itself where it is not a number.
bool same_bits(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height && a.rgba.size() == b.rgba.size() &&
         std::memcmp(a.rgba.data(), b.rgba.data(), a.rgba.size() * sizeof(float)) == 0;
}

}  // namespace

void PicturesBefore::add(const std::string& variant, size_t view, Image picture, Mask covered) {
  drawn_[{variant, view}] = {std::move(picture), std::move(covered)};
}

const PicturesBefore::Drawn* PicturesBefore::of(const std::string& variant, size_t view) const {
  const auto was = drawn_.find({variant, view});
  return was == drawn_.end() ? nullptr : &was->second;
}

bool PicturesBefore::same_errors(const std::string& variant, bool baseline, size_t view, const Image& picture,
                                 const Mask& covered) {
  const auto was = drawn_.find({variant, view});
  const bool same = was != drawn_.end() && same_bits(was->second.picture, picture) && was->second.covered.on == covered.on;
  if (baseline) same_baseline_[view] = same;
  return same && same_baseline_[view];
}

}  // namespace lamina
