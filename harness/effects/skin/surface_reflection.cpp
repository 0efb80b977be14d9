// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/skin/surface_reflection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lamina {

double beckmann(double cosine, double slope) {
  if (cosine <= 1e-3) return 0;
  const double x = std::min(cosine, 1.0), squared = x * x, rough = slope * slope;
  return std::exp(-(1 - x) * (1 + x) / (squared * rough)) / (rough * squared * squared);
}

double schlick_reflectance(double cosine, double reflectance) {
  return reflectance + (1 - reflectance) * std::pow(1 - cosine, 5);
}

double kelemen_reflection(glm::dvec3 normal, glm::dvec3 to_light, glm::dvec3 to_eye, double slope, double reflectance) {
  const glm::dvec3 sum = to_light + to_eye;
  const double squared = glm::dot(sum, sum), cosine = glm::dot(normal, to_light);
  if (squared < 1e-6 || cosine <= 0) return 0;
  const glm::dvec3 half = sum / std::sqrt(squared);
  return cosine * beckmann(glm::dot(normal, half), slope) *
         schlick_reflectance(std::clamp(glm::dot(half, to_eye), 0.0, 1.0), reflectance) / squared;
}

// By the slopes that Beckmann's distribution has: tan^2 of the facet's angle is -m^2 ln(1 - u).
double reflected_share(double cosine, double slope, double reflectance, int steps) {
  const double c = std::max(cosine, 1e-3);
  const glm::dvec3 to_eye(std::sqrt(1 - c * c), 0, c);
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double tangent = -slope * slope * std::log1p(-(i + 0.5) / steps), nh = 1 / std::sqrt(1 + tangent),
                 sh = std::sqrt(tangent) * nh;
    for (int k = 0; k < steps; ++k) {
      const double turn = std::numbers::pi * (k + 0.5) / steps;  // both halves are alike
      const glm::dvec3 half(sh * std::cos(turn), sh * std::sin(turn), nh);
      const double hv = glm::dot(half, to_eye), nl = 2 * hv * half.z - c;
      if (hv > 0 && nl > 0) sum += schlick_reflectance(hv, reflectance) * nl / (hv * nh);
    }
  }
  return sum / (double(steps) * steps);
}

SurfaceReflection::SurfaceReflection(double reflectance) {
  for (size_t row = 0; row < steps_; ++row)
    for (size_t column = 0; column < steps_; ++column)
      table_.push_back(std::min(
          1.0, reflected_share(double(column) / (steps_ - 1), std::max(double(row) / (steps_ - 1), 0.02), reflectance, 48)));
}

double SurfaceReflection::share(double cosine, double slope) const {
  const double x = std::clamp(cosine, 0.0, 1.0) * (steps_ - 1), y = std::clamp(slope, 0.0, 1.0) * (steps_ - 1);
  const auto column = std::min(static_cast<size_t>(x), steps_ - 2), row = std::min(static_cast<size_t>(y), steps_ - 2);
  const auto at = [&](size_t r, size_t c) { return table_[r * steps_ + c]; };
  const double u = x - double(column), v = y - double(row);
  return (1 - v) * ((1 - u) * at(row, column) + u * at(row, column + 1)) +
         v * ((1 - u) * at(row + 1, column) + u * at(row + 1, column + 1));
}

}  // namespace lamina
