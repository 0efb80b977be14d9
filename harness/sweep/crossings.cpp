// SPDX-License-Identifier: Apache-2.0
#include "harness/sweep/crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace lamina {
namespace {

class ErrorCurve {
 public:
  ErrorCurve(std::span<const double> x, std::span<const double> y, double limit) : x_(x), y_(y), limit_(limit) {}

  bool crosses_after(size_t i) const { return !std::isnan(y_[i]) && !std::isnan(y_[i + 1]) && above(i) != above(i + 1); }

  // Between samples i and i + 1.
  Crossing crossing(size_t i) const {
    Crossing found;
    found.rising = above(i + 1);
    const double low = x_[i], high = x_[i + 1];
    if (!std::isfinite(y_[i]) || !std::isfinite(y_[i + 1])) {
      found.at = low + (high - low) / 2;
      found.tolerance = (high - low) / 2;
      return found;
    }
    found.at = low + (limit_ - y_[i]) / slope(i);
    found.tolerance = std::max(found.at - low, high - found.at);
    if (const auto bound = bound_crossing(i, found.at)) found.tolerance = std::abs(*bound - found.at);
    return found;
  }

 private:
  bool above(size_t i) const { return y_[i] >= limit_; }
  double slope(size_t i) const { return (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]); }
  bool known(size_t i) const { return i < y_.size() && std::isfinite(y_[i]); }

  // Where the bound that the neighbours' secants make between samples i and i + 1 crosses the limit; nothing where there is no
  // such bound, or it does not get there. A convex curve is above both secants (a concave one below), and the bound meets the
  // curve in the sample that lies on the bound's side of the limit; so it crosses between that sample and the chord's crossing.
  std::optional<double> bound_crossing(size_t i, double chord) const {
    const bool left = i > 0 && known(i - 1), right = known(i + 2);
    const double here = slope(i), before = left ? slope(i - 1) : here, after = right ? slope(i + 1) : here;
    const bool convex = before <= here && here <= after, concave = before >= here && here >= after;
    if ((!left && !right) || (!convex && !concave)) return std::nullopt;
    constexpr double none = std::numeric_limits<double>::infinity();
    const auto is_above = [&](double at) {
      const double by_left = left ? y_[i] + before * (at - x_[i]) : convex ? -none : none;
      const double by_right = right ? y_[i + 1] + after * (at - x_[i + 1]) : convex ? -none : none;
      return (convex ? std::max(by_left, by_right) : std::min(by_left, by_right)) >= limit_;
    };
    double near = chord, far = convex == (y_[i] > y_[i + 1]) ? x_[i] : x_[i + 1];
    const bool far_side = is_above(far);
    if (is_above(near) == far_side) return left && right ? std::optional(chord) : std::nullopt;  // a straight line, or no bound
    constexpr int bisections = 60;  // to the last bit of a double, nearly
    for (int step = 0; step < bisections; ++step) {
      const double middle = near + (far - near) / 2;
      (is_above(middle) == far_side ? far : near) = middle;
    }
    return far;
  }

  std::span<const double> x_, y_;
  double limit_;
};

}  // namespace

std::vector<Crossing> crossings(std::span<const double> x, std::span<const double> y, double limit) {
  std::vector<Crossing> found;
  const ErrorCurve curve(x, y, limit);
  for (size_t i = 0; i + 1 < x.size(); ++i)
    if (curve.crosses_after(i)) found.push_back(curve.crossing(i));
  return found;
}

}  // namespace lamina
