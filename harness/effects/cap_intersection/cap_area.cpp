// SPDX-License-Identifier: Apache-2.0
// The double form of shaders/cap_intersection/exact_cap.glsl, which says where it comes from.
#include "harness/effects/cap_intersection/cap_area.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

namespace lamina {
namespace {

using std::numbers::pi;
constexpr double pi_low = 1.2246467991473532e-16;  // pi less the double next to it

double versine(double r) { return 2 * std::sin(r / 2) * std::sin(r / 2); }

// Cosine, accurate near a right angle too, where cos() of a rounded argument is.
struct Circle {
  double sine, cosine, versine, folded_versine;
  explicit Circle(double r)
      : sine(std::sin(r)),
        cosine(std::cos(r)),
        versine(lamina::versine(r)),
        folded_versine(lamina::versine(std::min(r, (pi - r) + pi_low))) {}
};

struct Corner {
  double angle, supplement, cosine, sine;
};

Corner corner(double numerator, double denominator) {
  const double half_sine = std::sqrt(numerator), half_cosine = std::sqrt(denominator), sum = numerator + denominator;
  return {2 * std::atan2(half_sine, half_cosine), 2 * std::atan2(half_cosine, half_sine), (denominator - numerator) / sum,
          2 * half_sine * half_cosine / sum};
}

Corner outside(const Corner& corner) { return {corner.supplement, corner.angle, -corner.cosine, corner.sine}; }

// The triangle: twice (s - side) for each side, 2 (pi - s), and the angles at the centres.
struct Triangle {
  double over0, over1, over_d, gap;
  Corner a{}, b{};

  Triangle(double r0, double r1, double d) {
    const double longest = std::max({r0, r1, d}), shortest = std::min({r0, r1, d});
    const double middle = std::max(std::min(r0, r1), std::min(std::max(r0, r1), d));
    const auto over = [&](double side) {
      if (side == longest) return shortest - (longest - middle);
      return side == middle ? shortest + (longest - middle) : longest + (middle - shortest);
    };
    over0 = over(r0), over1 = over(r1), over_d = over(d);
    gap = (((2 * pi - longest) - middle) - shortest) + 2 * pi_low;
    if (std::min({over0, over1, over_d, gap}) <= 0) return;  // no triangle
    const auto half_sine = [&](double excess, double side) { return std::sin(excess <= pi ? excess / 2 : gap / 2 + side); };
    const double sin_s = std::sin(gap <= pi ? gap / 2 : (r0 + r1 + d) / 2);
    const double sin_0 = half_sine(over0, r0), sin_1 = half_sine(over1, r1), sin_d = half_sine(over_d, d);
    a = corner(sin_0 * sin_d, sin_s * sin_1);
    b = corner(sin_1 * sin_d, sin_s * sin_0);
  }
};

double segment(const Corner& corner, const Circle& circle) {
  const double c = std::abs(circle.cosine), s = circle.sine;
  double area;
  if (corner.angle < 0.75)
    area =
        c * s * s *
        boost::math::quadrature::gauss<double, 15>::integrate(
            [&](double t) { return std::sin(t) * std::sin(t) / (1 - s * s * std::sin(t) * std::sin(t)); }, 0.0, corner.angle);
  else if (c >= 0.5)
    area = corner.angle * circle.folded_versine - std::atan2(circle.folded_versine * corner.sine * corner.cosine,
                                                             corner.cosine * corner.cosine + c * corner.sine * corner.sine);
  else
    area = std::atan2(c * corner.sine, corner.cosine) - c * corner.angle;
  return std::copysign(1.0, circle.cosine) * area;
}

bool is_flat(const Corner& corner, const Circle& circle) {
  return std::abs(circle.cosine) < 0.1 && corner.angle > 0.75 && corner.supplement > 0.75;
}

bool apart(double r0, double r1, double d) { return std::max({r0, r1, d}) == d; }

}  // namespace

bool are_caps(double r0, double r1, double d) {
  constexpr double most = std::numbers::pi_v<float>;
  return r0 > 0 && r0 <= most && r1 > 0 && r1 <= most && d >= 0 && d <= most;
}

double smaller_cap_area(double r0, double r1) { return 2 * pi * versine(std::min(r0, r1)); }

double cap_intersection_area(double r0, double r1, double d) {
  const Triangle triangle(r0, r1, d);
  if (std::min({triangle.over0, triangle.over1, triangle.over_d}) <= 0) return apart(r0, r1, d) ? 0 : smaller_cap_area(r0, r1);
  const Circle circle0(r0), circle1(r1);
  // -(cos r0 + cos r1), which cancels where the radii add up to pi.
  const double larger = std::max(r0, r1), smaller = std::min(r0, r1);
  const double beyond = ((larger - pi) + smaller) - pi_low, to_opposite = ((pi - larger) + pi_low) + smaller;
  const double all_around = 4 * pi * std::sin(beyond / 2) * std::sin(to_opposite / 2);
  if (triangle.gap <= 0) return std::max(all_around, 0.0);
  const Corner &a = triangle.a, &b = triangle.b;
  if (is_flat(a, circle0) || is_flat(b, circle1)) {
    const double excess = 4 * std::atan(std::sqrt(std::tan(triangle.over0 / 4) * std::tan(triangle.over1 / 4) *
                                                  std::tan(triangle.over_d / 4) / std::tan(triangle.gap / 4)));
    return std::max(2 * (a.angle * circle0.versine + b.angle * circle1.versine - excess), 0.0);
  }
  if (circle0.cosine < 0 && circle1.cosine < 0)
    return all_around - 2 * (segment(outside(a), circle0) + segment(outside(b), circle1));
  return std::max(2 * (segment(a, circle0) + segment(b, circle1)), 0.0);
}

double cap_intersection_condition(double r0, double r1, double d, double area) {
  const Triangle triangle(r0, r1, d);
  if (std::min({triangle.over0, triangle.over1, triangle.over_d}) <= 0) {
    if (apart(r0, r1, d)) return 0;
    const double r = std::min(r0, r1);
    return 2 * pi * std::sin(r) * r / area;
  }
  if (triangle.gap <= 0) return area > 0 ? 2 * pi * (std::sin(r0) * r0 + std::sin(r1) * r1) / area : 0;
  const double s0 = std::sin(r0), s1 = std::sin(r1);
  return (2 * triangle.a.angle * s0 * r0 + 2 * triangle.b.angle * s1 * r1 + 2 * s0 * triangle.a.sine * d) / area;
}

}  // namespace lamina
