// SPDX-License-Identifier: Apache-2.0
// The C++ of encoded depths: the oracle of their family of functions.
#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/manifest/effect_code.h"
#include "harness/stress/oracle.h"

namespace lamina {
namespace {

// 113 bits: sums of a hundred binary32 numbers are exact.
using Sum = boost::multiprecision::cpp_bin_float_quad;

constexpr double max_pairs = 64;

// The depth of a face of pair k, rounded as the definition says: the product, then the sum, to binary32.
double depth_of_pair(double depth, double step, int k) {
  const float moved = static_cast<float>(step) * static_cast<float>(k);
  const float sum = static_cast<float>(depth) + moved;
  return std::clamp(double(sum), 0.0, 1.0);
}

struct DepthSet {
  const char* name;
  int min_pairs, max_pairs;
};
constexpr DepthSet depth_sets[] = {{"one", 1, 1},  {"few", 1, 2},      {"thin", 1, 2},     {"far", 1, 2},
                                   {"deep", 3, 8}, {"crowded", 9, 17}, {"beyond", 18, 40}, {"fullest", 1, 17}};

class DepthSumOracle : public Oracle {
 public:
  std::vector<std::string> inputs() const override { return {"front", "back", "step", "pairs"}; }
  std::string refusal(Point p) const override {
    const bool depths = p[0] >= 0 && p[0] <= p[1] && p[1] <= 1 && p[2] >= 0 && p[2] <= 1;
    const bool pairs = p[3] >= 1 && p[3] <= max_pairs && p[3] == std::floor(p[3]);
    return depths && pairs ? "" : "depths must be 0 <= front <= back <= 1, step 0 to 1, pairs a whole number from 1 to 64";
  }
  double value(Point p) const override {
    Sum sum = 0;
    for (int k = 0; k < int(p[3]); ++k) sum += Sum(depth_of_pair(p[1], p[2], k)) - Sum(depth_of_pair(p[0], p[2], k));
    return static_cast<double>(sum);
  }
  double condition(Point p, double value) const override {
    double sum = 0;
    for (int k = 0; k < int(p[3]); ++k) sum += depth_of_pair(p[1], p[2], k) + depth_of_pair(p[0], p[2], k);
    return value == 0 ? 0 : sum / std::abs(value);
  }
  double scale(Point) const override { return 1; }

  std::vector<std::string> sets() const override {
    std::vector<std::string> names;
    for (const DepthSet& set : depth_sets) names.emplace_back(set.name);
    return names;
  }
  Points points(const std::string& set, size_t count, uint64_t seed) const override {
    const auto found = std::ranges::find(depth_sets, set, &DepthSet::name);
    if (found == std::end(depth_sets)) throw Error(ErrorKind::bad_input, "stress", set, unknown_name("set", set, sets()));
    std::mt19937_64 engine(seed + static_cast<uint64_t>(found - std::begin(depth_sets)) * 1000003);
    const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
    Points points(4);
    for (size_t i = 0; i < count; ++i) {
      const auto pairs = static_cast<float>(found->min_pairs + int(uniform() * (found->max_pairs - found->min_pairs + 1)));
      const auto step = static_cast<float>(uniform() * 0.01);
      const float first = static_cast<float>(uniform()), second = static_cast<float>(uniform());
      float front = std::min(first, second), back = std::max(first, second);
      if (set == "thin") back = std::min(front + static_cast<float>(1e-6 * std::pow(1000.0, uniform())), 1.0f);
      if (set == "far") front = 1 - 1e-3f * back, back = 1 - 1e-3f * std::min(first, second);
      if (set == "fullest") front = 0, back = 1;
      points.add({front, std::max(front, back), set == "fullest" ? 0 : step, pairs});
    }
    return points;
  }
};

}  // namespace

void add_depth_encoding(EffectCode& code);

void add_depth_encoding(EffectCode& code) {
  static const DepthSumOracle oracle;
  code.oracles["depth_sum"] = &oracle;
}

}  // namespace lamina
