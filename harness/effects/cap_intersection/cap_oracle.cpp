// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/cap_intersection/cap_oracle.h"

#include <fmt/format.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "harness/core/error.h"
#include "harness/effects/cap_intersection/cap_area.h"

namespace lamina {
namespace {

namespace mp = boost::multiprecision;
using Real = mp::number<mp::cpp_bin_float<400, mp::digit_base_2>, mp::et_off>;

void check(double r0, double r1, double d) {
  if (are_caps(r0, r1, d)) return;
  throw Error(ErrorKind::bad_input, "stress", fmt::format("r0 {}, r1 {}, d {}", r0, r1, d),
              "radii must lie above 0 and up to pi, the distance from 0 to pi (radians)");
}

}  // namespace

double cap_intersection_oracle(double r0_given, double r1_given, double d_given) {
  check(r0_given, r1_given, d_given);
  const Real r0 = r0_given, r1 = r1_given, d = d_given, pi = boost::math::constants::pi<Real>();
  if (d >= r0 + r1) return 0;
  if (d <= abs(r0 - r1)) {
    const Real half_sine = sin((r0 < r1 ? r0 : r1) / 2);
    return static_cast<double>(4 * pi * half_sine * half_sine);
  }
  const Real c0 = cos(r0), c1 = cos(r1), cd = cos(d), s0 = sin(r0), s1 = sin(r1), sd = sin(d);
  if (r0 + r1 + d >= 2 * pi) return static_cast<double>(-2 * pi * (c0 + c1));
  const Real a = acos((c1 - cd * c0) / (sd * s0)), b = acos((c0 - cd * c1) / (sd * s1)), c = acos((cd - c0 * c1) / (s0 * s1));
  return static_cast<double>(2 * pi - 2 * a * c0 - 2 * b * c1 - 2 * c);
}

}  // namespace lamina
