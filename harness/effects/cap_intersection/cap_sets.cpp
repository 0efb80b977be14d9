// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/cap_intersection/cap_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string_view>

#include "harness/core/error.h"
#include "harness/core/text.h"

namespace lamina {
namespace {

using std::numbers::pi;
constexpr float below_pi = 3.14159250f;  // the largest binary32 below pi

using CapInput = std::array<float, 3>;  // r0, r1, d

class Random {
 public:
  explicit Random(uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53); }
  double logarithmic(double low, double high) { return low * std::exp(uniform(0, 1) * std::log(high / low)); }
  double sign() { return (engine_() & 1) != 0 ? 1 : -1; }

 private:
  std::mt19937_64 engine_;
};

CapInput input(double r0, double r1, double d) {
  const auto radius = [](double r) { return std::clamp(static_cast<float>(r), 1e-30f, below_pi); };
  return {radius(r0), radius(r1), std::clamp(static_cast<float>(d), 0.0f, below_pi)};
}

CapInput box(Random& random, double largest) {
  return input(largest - random.uniform(0, largest), largest - random.uniform(0, largest), random.uniform(0, pi));
}

CapInput tangent_outside(Random& random) {
  const double r0 = random.logarithmic(1e-3, pi / 2), r1 = random.logarithmic(1e-3, pi / 2), sum = std::min(r0 + r1, pi);
  return input(r0, r1, sum * (1 - random.logarithmic(1e-7, 1e-2)));
}

CapInput tangent_inside(Random& random) {
  const double r0 = random.logarithmic(1e-3, pi / 2), r1 = r0 * random.uniform(0.01, 1), smaller = std::min(r0, r1);
  return input(r0, r1, (r0 - r1) + smaller * random.logarithmic(1e-7, 1e-2));
}

CapInput equal(Random& random) {
  const double r = random.logarithmic(1e-4, 3);
  const double apart = r * 0x1p-23 * std::floor(random.uniform(0, 5));
  return input(r, r + apart, std::min(2 * r, pi) * random.logarithmic(1e-7, 1));
}

CapInput hemispheres(Random& random) {
  const auto radius = [&] { return pi / 2 + random.sign() * random.logarithmic(1e-6, 1e-2); };
  return input(radius(), radius(), random.uniform(0, pi));
}

CapInput covering(Random& random) {
  const double r0 = random.uniform(pi / 2, 3.1), r1 = random.uniform(std::max(pi - r0, 0.1), 3.1);
  return input(r0, r1, 2 * pi - r0 - r1 - random.logarithmic(1e-6, 1e-2));
}

// The complement of the first cap is tiny, and crosses the second cap's edge.
CapInput nearly_whole(Random& random) {
  const double left_out = random.logarithmic(1e-5, 1e-1), r1 = random.logarithmic(1e-5, 1e-1);
  return input(pi - left_out, r1, pi - random.uniform(std::abs(left_out - r1), left_out + r1));
}

CapInput tiny(Random& random) {
  const double r0 = random.logarithmic(1e-6, 1e-3), r1 = random.logarithmic(1e-6, 1e-3);
  return input(r0, r1, random.uniform(std::abs(r0 - r1), r0 + r1));
}

CapInput small(Random& random) { return box(random, pi / 2); }
CapInput large(Random& random) { return box(random, pi); }

Points overlaps(size_t count) {
  const size_t steps = static_cast<size_t>(std::cbrt(static_cast<double>(count)));
  Points points(3);
  const auto radius = [&](size_t i) { return pi / 2 * static_cast<double>(i + 1) / static_cast<double>(steps); };
  for (size_t i = 0; i < steps; ++i)
    for (size_t j = 0; j <= i; ++j)
      for (size_t k = 0; k < steps; ++k) {
        const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(steps);
        points.add(input(radius(i), radius(j), radius(i) - radius(j) + share * 2 * radius(j)));
      }
  return points;
}

struct Maker {
  std::string_view name;
  CapInput (*make)(Random&);
};
// Each set has a seed of its own, by its place here. The first is a grid.
constexpr std::array<Maker, 10> makers = {{{"overlaps", nullptr},
                                           {"box", small},
                                           {"large", large},
                                           {"tiny", tiny},
                                           {"tangent_outside", tangent_outside},
                                           {"tangent_inside", tangent_inside},
                                           {"equal", equal},
                                           {"hemispheres", hemispheres},
                                           {"nearly_whole", nearly_whole},
                                           {"covering", covering}}};

}  // namespace

Points make_cap_points(const std::string& set, size_t count, uint64_t seed) {
  if (set == makers.front().name) return overlaps(count);
  const auto maker = std::ranges::find(makers, set, &Maker::name);
  if (maker == makers.end()) throw Error(ErrorKind::bad_input, "stress", "set", unknown_name("set", set, cap_set_names()));
  Random random(seed + static_cast<uint64_t>(maker - makers.begin()));
  Points points(3);
  for (size_t i = 0; i < count; ++i) points.add(maker->make(random));
  return points;
}

std::vector<std::string> cap_set_names() {
  std::vector<std::string> names;
  for (const Maker& maker : makers) names.emplace_back(maker.name);
  return names;
}

}  // namespace lamina
