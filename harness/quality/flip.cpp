// SPDX-License-Identifier: Apache-2.0
// FLIP: the error that a person sees who flips between two pictures on one display.
// Source: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference Evaluator for Alternating
// Images", Proceedings of the ACM on Computer Graphics and Interactive Techniques 3(2), HPG 2020. Constants are that paper's,
// but for the colour matrix, which is sRGB's primaries and D65 as exact fractions. In: 8-bit sRGB. Out: one error a pixel, in
// [0,1]. Limits: display-referred pictures only; borders repeat the edge pixel.
//
// The contrast filter is defined on YCxCz, where Y = 116 Y/Yn - 16, Cx = 500 (X/Xn - Y/Yn), Cz = 200 (Y/Yn - Z/Zn). Its weights
// sum to 1, so scales and offset cancel on the way back: here the opponent planes are Y/Yn, X/Xn - Y/Yn and Y/Yn - Z/Zn.
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "harness/core/error.h"
#include "harness/core/srgb.h"
#include "harness/quality/pixels.h"

namespace lamina {
namespace {

using std::numbers::pi;
using Plane = cv::Mat1f;
using Kernel = cv::Mat1d;  // one axis of a separable filter, an odd count of weights
struct Opponent {
  Plane luminance, red_green, blue_yellow;  // Y/Yn, X/Xn - Y/Yn, Y/Yn - Z/Zn
};

const cv::Matx33d xyz_from_linear(10135552. / 24577794, 8788810. / 24577794, 4435075. / 24577794,   //
                                  2613072. / 12288897, 8788810. / 12288897, 887015. / 12288897,     //
                                  1425312. / 73733382, 8788810. / 73733382, 70074185. / 73733382);  //
// XYZ in units of the white of linear (1,1,1), so that white is (1,1,1) here too.
const cv::Vec3d white = xyz_from_linear * cv::Vec3d(1, 1, 1);
const cv::Matx33d to_relative = cv::Matx33d::diag({1 / white[0], 1 / white[1], 1 / white[2]}) * xyz_from_linear;
const cv::Matx33f relative_from_linear(to_relative), linear_from_relative(to_relative.inv());

Opponent opponent_from(const cv::Mat3b& picture) {
  std::array<float, 256> linear;
  for (int code = 0; code < 256; ++code) linear[code] = srgb_decode(static_cast<float>(code) / 255);
  Opponent planes{Plane(picture.size()), Plane(picture.size()), Plane(picture.size())};
  tbb::parallel_for(0, picture.rows, [&](int y) {
    for (int x = 0; x < picture.cols; ++x) {
      const cv::Vec3b& rgb = picture(y, x);
      const cv::Vec3f xyz = relative_from_linear * cv::Vec3f(linear[rgb[0]], linear[rgb[1]], linear[rgb[2]]);
      planes.luminance(y, x) = xyz[1];
      planes.red_green(y, x) = xyz[0] - xyz[1];
      planes.blue_yellow(y, x) = xyz[1] - xyz[2];
    }
  });
  return planes;
}

Plane filtered(const Plane& plane, const Kernel& along_x, const Kernel& along_y) {
  Plane out;
  cv::sepFilter2D(plane, out, CV_32F, along_x, along_y, cv::Point(-1, -1), 0, cv::BORDER_REPLICATE);
  return out;
}

// weight(x) for x = -radius .. radius, in pixels.
template <class Weight>
Kernel sampled(int radius, Weight weight) {
  Kernel kernel(1, 2 * radius + 1);
  for (int x = -radius; x <= radius; ++x) kernel(x + radius) = weight(static_cast<double>(x));
  return kernel;
}

// Contrast sensitivity in space: a sqrt(pi/b) exp(-pi^2 x^2 / b), x in degrees; a sum of two for blue-yellow. In two
// dimensions each is the product of its square-rooted amplitudes per axis, so a two-term sum is weighted by the terms' volumes.
class ContrastFilter {
 public:
  explicit ContrastFilter(double pixels_per_degree) : pixels_per_degree_(pixels_per_degree) {}

  Opponent operator()(const Opponent& in) const {
    const Term y{1, 0.0047}, cx{1, 0.0053}, cz_wide{34.1, widest_b}, cz_narrow{13.5, 0.025};
    const double wide = volume(cz_wide), narrow = volume(cz_narrow);
    Opponent out{convolved(in.luminance, y), convolved(in.red_green, cx), {}};
    cv::addWeighted(convolved(in.blue_yellow, cz_wide), wide / (wide + narrow), convolved(in.blue_yellow, cz_narrow),
                    narrow / (wide + narrow), 0, out.blue_yellow);
    return out;
  }
  // Three standard deviations of the widest term, the same for all: b = 2 pi^2 sigma^2.
  int radius() const { return static_cast<int>(std::ceil(3 * pixels_per_degree_ * std::sqrt(widest_b / (2 * pi * pi)))); }

 private:
  static constexpr double widest_b = 0.04;
  struct Term {
    double a, b;
  };

  Kernel gaussian(const Term& term) const {
    return sampled(radius(), [&](double x_px) {
      const double x = x_px / pixels_per_degree_;
      return std::exp(-pi * pi * x * x / term.b);
    });
  }
  double volume(const Term& term) const {
    const double side = cv::sum(gaussian(term))[0];
    return term.a * std::sqrt(pi / term.b) * side * side;
  }
  Plane convolved(const Plane& plane, const Term& term) const {
    Kernel kernel = gaussian(term);
    kernel /= cv::sum(kernel)[0];
    return filtered(plane, kernel, kernel);
  }

  double pixels_per_degree_;
};

// CIELab of a linear colour (CIE 15, white as above), with the Hunt effect: colours fade as they darken.
cv::Vec3f hunt_lab(const cv::Vec3f& linear) {
  const auto f = [](float t) {
    constexpr float delta = 6.f / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.f / 29;
  };
  const cv::Vec3f xyz = relative_from_linear * linear;
  const float fx = f(xyz[0]), fy = f(xyz[1]), fz = f(xyz[2]), lightness = 116 * fy - 16;
  return {lightness, 0.01f * lightness * 500 * (fx - fy), 0.01f * lightness * 200 * (fy - fz)};
}

// HyAB distance, compressed by the paper's exponent.
float colour_distance(const cv::Vec3f& a, const cv::Vec3f& b) {
  return std::pow(std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]), 0.7f);
}

cv::Vec3f seen_colour(const Opponent& planes, int y, int x) {
  const float luminance = planes.luminance(y, x);
  cv::Vec3f linear =
      linear_from_relative * cv::Vec3f(luminance + planes.red_green(y, x), luminance, luminance - planes.blue_yellow(y, x));
  for (float& value : linear.val) value = std::clamp(value, 0.f, 1.f);
  return hunt_lab(linear);
}

// The greatest distance is mapped to 1, and 0.4 of it to 0.95, since beyond that all looks merely different.
float colour_error(const cv::Vec3f& test, const cv::Vec3f& reference) {
  static const float greatest = colour_distance(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1}));
  static const float knee = 0.4f * greatest;
  const float distance = colour_distance(test, reference);
  const float error = distance < knee ? 0.95f * distance / knee : 0.95f + 0.05f * (distance - knee) / (greatest - knee);
  return std::min(error, 1.f);  // rounding only: no two displayable colours are further apart
}

// How strong an edge and a point (a line's middle, a bump) are at each pixel.
struct Features {
  Plane edge, point;
};
// Half a feature's width, which the paper sets to 0.082 degrees.
double feature_sigma(double pixels_per_degree) { return 0.5 * 0.082 * pixels_per_degree; }
int feature_radius(double pixels_per_degree) { return static_cast<int>(std::ceil(3 * feature_sigma(pixels_per_degree))); }
Features features_of(const Plane& luminance, double pixels_per_degree) {
  const double sigma = feature_sigma(pixels_per_degree);
  const int radius = feature_radius(pixels_per_degree);
  const auto g = [&](double x) { return std::exp(-x * x / (2 * sigma * sigma)); };
  Kernel smooth = sampled(radius, g);
  smooth /= cv::sum(smooth)[0];
  // A detector's positive weights sum to 1 and its negative ones to -1, so that its answer to a full step is 1.
  const auto detector = [&](const auto& weight) {
    const Kernel positive = sampled(radius, [&](double x) { return std::max(weight(x), 0.0); });
    const Kernel negative = sampled(radius, [&](double x) { return std::min(weight(x), 0.0); });
    return Kernel(positive / cv::sum(positive)[0] - negative / cv::sum(negative)[0]);
  };
  const auto magnitude = [&](const Kernel& across) {
    Plane out;
    cv::magnitude(filtered(luminance, across, smooth), filtered(luminance, smooth, across), out);
    return out;
  };
  return {magnitude(detector([&](double x) { return -x * g(x); })),
          magnitude(detector([&](double x) { return (x * x / (sigma * sigma) - 1) * g(x); }))};
}

// What FLIP compares of a picture.
struct Seen {
  Opponent colours;
  Features features;
};
Seen seen(const cv::Mat3b& picture, double pixels_per_degree) {
  const Opponent planes = opponent_from(picture);
  return {ContrastFilter(pixels_per_degree)(planes), features_of(planes.luminance, pixels_per_degree)};
}

float pixel_error(const Seen& test, const Seen& reference, int y, int x) {
  const float colour = colour_error(seen_colour(test.colours, y, x), seen_colour(reference.colours, y, x));
  const float edge = std::abs(test.features.edge(y, x) - reference.features.edge(y, x));
  const float point = std::abs(test.features.point(y, x) - reference.features.point(y, x));
  const float feature = std::min(std::sqrt(std::max(edge, point) / std::numbers::sqrt2_v<float>), 1.f);
  return std::pow(colour, 1 - feature);
}

}  // namespace

std::vector<float> flip_map(const DisplayImage& test, const DisplayImage& reference, double pixels_per_degree) {
  check_pair("FLIP", test, reference);
  // Far outside any display: below, the feature filter vanishes between pixels; above, its kernels outgrow every picture.
  if (!(pixels_per_degree >= 1 && pixels_per_degree <= 1000))
    throw Error(ErrorKind::failed, "quality", "FLIP",
                fmt::format("{} pixels per degree is outside 1 to 1000", pixels_per_degree));

  std::vector<float> map(test.rgb.size() / 3);  // 0: of equal surroundings
  const int radius = std::max(ContrastFilter(pixels_per_degree).radius(), feature_radius(pixels_per_degree));
  const DifferingPart part = differing_part(test, reference, radius);
  if (part.changed.empty()) return map;
  Seen test_seen, reference_seen;
  tbb::parallel_invoke([&] { test_seen = seen(as_mat(test)(part.read), pixels_per_degree); },
                       [&] { reference_seen = seen(as_mat(reference)(part.read), pixels_per_degree); });
  tbb::parallel_for(part.changed.y, part.changed.br().y, [&](int y) {
    for (int x = part.changed.x; x < part.changed.br().x; ++x)
      map[static_cast<size_t>(y) * static_cast<size_t>(test.width) + static_cast<size_t>(x)] =
          pixel_error(test_seen, reference_seen, y - part.read.y, x - part.read.x);
  });
  return map;
}

double flip_mean(const std::vector<float>& map, const Mask* mask) {
  const size_t counted = counted_pixels("FLIP", mask, map.size());
  double sum = 0;
  for (size_t pixel = 0; pixel < map.size(); ++pixel)
    if (counts(mask, pixel)) sum += map[pixel];
  if (!std::isfinite(sum)) throw Error(ErrorKind::failed, "quality", "FLIP", "the map holds a value that is not finite");
  return sum / static_cast<double>(counted);
}

}  // namespace lamina
