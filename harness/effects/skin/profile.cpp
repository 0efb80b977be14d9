// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/skin/profile.h"

#include <cmath>
#include <numbers>

#include "harness/core/error.h"
#include "harness/core/text.h"

namespace lamina {
namespace {

using std::numbers::pi;

// The mean of max(0, N.L) over a circle around a point: its cosine to the light, and the circle's angular radius.
double mean_on_circle(double cosine, double angle) {
  const double along = cosine * std::cos(angle), beside = std::sqrt(std::max(1 - cosine * cosine, 0.0)) * std::sin(angle);
  if (std::abs(along) >= beside) return std::max(along, 0.0);
  const double half = std::acos(-along / beside);
  return (along * half + beside * std::sin(half)) / pi;
}

}  // namespace

glm::dvec3 DiffusionProfile::value(double r) const {
  glm::dvec3 sum(0);
  for (size_t i = 0; i < 6; ++i) sum += weight[i] * (std::exp(-r * r / (2 * variance[i])) / (2 * pi * variance[i]));
  return sum;
}

glm::dvec3 DiffusionProfile::inside_disc(double r) const {
  glm::dvec3 sum(0);
  for (size_t i = 0; i < 6; ++i) sum += weight[i] * -std::expm1(-r * r / (2 * variance[i]));
  return sum;
}

glm::dvec3 DiffusionProfile::line_of_light(double x) const {
  glm::dvec3 sum(0);
  for (size_t i = 0; i < 6; ++i) sum += weight[i] * (std::exp(-x * x / (2 * variance[i])) / std::sqrt(2 * pi * variance[i]));
  return sum;
}

glm::dvec3 DiffusionProfile::edge_of_light(double x) const {
  glm::dvec3 sum(0);
  for (size_t i = 0; i < 6; ++i) sum += weight[i] * (0.5 * std::erfc(x / std::sqrt(2 * variance[i])));
  return sum;
}

glm::dvec3 DiffusionProfile::sphere(double cosine, double radius_mm) const {
  glm::dvec3 sum(0);
  for (size_t i = 0; i < 6; ++i) {
    // Evenly over the lobe's mass: 1 - cos of the angle is -ln(1 - u (1 - e^(-2 s))) / s.
    const double sharpness = radius_mm * radius_mm / variance[i], mass = -std::expm1(-2 * sharpness);
    constexpr int steps = 2000;
    double lit = 0;
    for (int k = 0; k < steps; ++k) {
      const double lowered = -std::log1p(-(k + 0.5) / steps * mass) / sharpness;
      lit += mean_on_circle(cosine, 2 * std::asin(std::sqrt(std::min(lowered / 2, 1.0))));
    }
    sum += weight[i] * (mass * lit / steps);
  }
  return sum;
}

glm::dvec3 DiffusionProfile::transmitted(double d) const {
  glm::dvec3 sum(0);
  for (size_t i = 0; i < 6; ++i) sum += weight[i] * std::exp(-d * d / (2 * variance[i]));
  return sum;
}

DiffusionProfile profile_of(const EffectValues& values) {
  DiffusionProfile profile{};
  const auto number = [&](const char* name, size_t i) {
    return values.numbers.find(fmt::format("{}_{}", name, i + 1))->second;
  };
  for (size_t i = 0; i < 6; ++i) {
    const double sigma = number("sigma", i);
    profile.variance[i] = sigma * sigma;
    profile.weight[i] = {number("red", i), number("green", i), number("blue", i)};
  }
  return profile;
}

std::string profile_problem(const DiffusionProfile& profile) {
  glm::dvec3 sum(0);
  for (size_t i = 0; i < 6; ++i) {
    if (profile.variance[i] <= 0)
      return fmt::format(
          "Gaussian {} of the profile has a width of 0: give skin.sigma_{} in mm, above 0, and a weight of 0 to "
          "leave it out",
          i + 1, i + 1);
    if (i > 0 && profile.variance[i] < profile.variance[i - 1])
      return fmt::format("Gaussian {} of the profile is narrower than the one before it: give them from narrow to wide", i + 1);
    sum += profile.weight[i];
  }
  constexpr const char* channels[] = {"red", "green", "blue"};
  for (int c = 0; c < 3; ++c)
    if (std::abs(sum[c] - 1) > 0.005)
      return fmt::format("the {} weights of the profile sum to {:.4g}: make skin.{}_1 to skin.{}_6 sum to 1", channels[c],
                         sum[c], channels[c], channels[c]);
  return "";
}

}  // namespace lamina
