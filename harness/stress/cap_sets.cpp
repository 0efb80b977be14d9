// SPDX-License-Identifier: Apache-2.0
#include "harness/stress/cap_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <random>
#include <sstream>
#include <tuple>
#include <utility>

#include "harness/caps/cap_area.h"
#include "harness/core/error.h"

namespace lamina {
namespace {

constexpr double pi = std::numbers::pi;
constexpr float below_pi = 3.14159250f;  // the largest binary32 below pi

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

// A regular grid: radii, and the share of the way from contained to apart.
CapSet overlaps(size_t count) {
  const size_t steps = static_cast<size_t>(std::cbrt(static_cast<double>(count)));
  CapSet set{"overlaps", "a grid of radii up to pi/2 and of distances from contained to apart", {}, {}};
  const auto radius = [&](size_t i) { return pi / 2 * static_cast<double>(i + 1) / static_cast<double>(steps); };
  for (size_t i = 0; i < steps; ++i)
    for (size_t j = 0; j <= i; ++j)
      for (size_t k = 0; k < steps; ++k) {
        const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(steps);
        set.inputs.push_back(input(radius(i), radius(j), radius(i) - radius(j) + share * 2 * radius(j)));
      }
  return set;
}

double number(const std::string& text, const std::string& where) {
  size_t used = 0;
  double value = 0;
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used == 0 || text.find_first_not_of(" \t\r", used) != std::string::npos || !std::isfinite(value))
    throw Error(ErrorKind::bad_input, "stress", where, fmt::format("'{}' is not a finite number", text));
  return value;
}

}  // namespace

std::vector<CapSet> make_cap_sets(size_t count, uint64_t seed) {
  const auto box = [](double largest) {
    return [largest](Random& r) {
      return input(largest - r.uniform(0, largest), largest - r.uniform(0, largest), r.uniform(0, pi));
    };
  };
  const std::vector<std::tuple<const char*, const char*, std::function<CapInput(Random&)>>> makers = {
      {"box", "radii up to pi/2, any distance", box(pi / 2)},
      {"large", "radii up to pi, any distance", box(pi)},
      {"tiny", "radii of 1e-6 to 1e-3, overlapping", tiny},
      {"tangent_outside", "just not apart", tangent_outside},
      {"tangent_inside", "just not one in the other", tangent_inside},
      {"equal", "radii equal to a few units in the last place", equal},
      {"hemispheres", "both radii within 1e-2 of pi/2", hemispheres},
      {"nearly_whole", "all but a tiny cap, and a small one across its edge", nearly_whole},
      {"covering", "just not covering the sphere", covering}};
  std::vector<CapSet> sets = {overlaps(count)};
  for (const auto& [name, what, make] : makers) {
    Random random(seed + sets.size());
    CapSet& set = sets.emplace_back(CapSet{name, what, {}, {}});
    for (size_t i = 0; i < count; ++i) set.inputs.push_back(make(random));
  }
  return sets;
}

CapSet make_cap_grid(size_t steps) {
  CapSet set{"grid", fmt::format("{0} x {0} x {0} radii in (0, pi) and distances in [0, pi]", steps), {}, {}};
  const auto radius = [&](size_t i) { return pi * static_cast<double>(i + 1) / static_cast<double>(steps + 1); };
  for (size_t i = 0; i < steps; ++i)
    for (size_t j = 0; j < steps; ++j)
      for (size_t k = 0; k < steps; ++k)
        set.inputs.push_back(input(radius(i), radius(j), pi * static_cast<double>(k) / static_cast<double>(steps - 1)));
  return set;
}

CapSet read_cap_points(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw Error(ErrorKind::bad_input, "stress", file.string(), "cannot be read; check that the file exists");
  CapSet set{"points", file.filename().string(), {}, {}};
  std::string line;
  size_t line_number = 0;
  bool first = true;
  while (std::getline(in, line)) {
    ++line_number;
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.starts_with('#')) continue;
    const std::string where = fmt::format("{}:{}", file.string(), line_number);
    if (std::exchange(first, false) && line.starts_with("r0")) continue;
    std::vector<std::string> fields;
    std::stringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) fields.push_back(cell);
    if (fields.size() < 3)
      throw Error(ErrorKind::bad_input, "stress", where, "needs r0,r1,d and may have area, separated by commas");
    const double r0 = number(fields[0], where), r1 = number(fields[1], where), d = number(fields[2], where);
    if (!are_caps(r0, r1, d))
      throw Error(ErrorKind::bad_input, "stress", where,
                  "radii must lie above 0 and up to pi, the distance from 0 to pi (radians)");
    set.inputs.push_back({static_cast<float>(r0), static_cast<float>(r1), static_cast<float>(d)});
    // A given area holds for the numbers as written; where they are no binary32 numbers the rounded ones have another.
    const bool exact = set.inputs.back().r0 == r0 && set.inputs.back().r1 == r1 && set.inputs.back().d == d;
    set.areas.push_back(fields.size() > 3 && exact ? number(fields[3], where) : std::nan(""));
  }
  if (set.inputs.empty()) throw Error(ErrorKind::bad_input, "stress", file.string(), "holds no points; give lines of r0,r1,d");
  return set;
}

}  // namespace lamina
