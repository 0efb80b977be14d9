// SPDX-License-Identifier: Apache-2.0
// Finds the coefficients of the *fit_cap functions in shaders/cap_intersection, and prints them.
//
// The share of the smaller cap that two caps have in common is t + t (1 - t) P: t is how far they overlap (cap_overlap in
// cap.glsl), and P a sum of terms f(t) ratio^j s^k, with ratio the smaller radius over the larger, s the smaller one's square,
// and f one of 1, t, t^2, t^3, w, t w, where w = sqrt(t (1 - t)). It is 0 where the caps are apart and 1 where one holds the
// other, whatever P is.
//
// It starts with all terms up to given powers and drops, one by one, the term whose loss costs least. Then it exchanges terms
// for dropped ones while that helps. Coefficients have the least maximum error: repeated least squares, where each point's
// weight is multiplied by its error (Lawson, "Contributions to the Theory of Linear Least Maximum Approximations", 1961).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <opencv2/core.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "harness/effects/cap_intersection/cap_area.h"

namespace {

constexpr double pi = std::numbers::pi;

struct Point {
  double t, ratio, s;
  double share;  // of the smaller cap
};

// Radii up to pi / 2, closer to each other near the ends of t and of the ratio.
std::vector<Point> make_points(int steps) {
  const auto towards_ends = [](int i, int count) { return 0.5 - 0.5 * std::cos(pi * i / count); };
  std::vector<Point> points;
  for (int i = 1; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      for (int k = 1; k < 2 * steps; ++k) {
        const double larger = pi / 2 * i / steps, ratio = std::max(1e-3, towards_ends(j, steps)),
                     t = towards_ends(k, 2 * steps);
        const double smaller = ratio * larger, d = larger + smaller - 2 * smaller * t;
        points.push_back({t, ratio, smaller * smaller,
                          lamina::cap_intersection_area(larger, smaller, d) / lamina::smaller_cap_area(larger, smaller)});
      }
  return points;
}

struct Fit {
  std::vector<double> coefficients;
  double error = INFINITY;  // the greatest
};

// The coefficients whose weighted sum of columns has the least maximum distance from `target`.
Fit fit(const std::vector<const std::vector<double>*>& columns, const std::vector<double>& target, int passes) {
  const int terms = static_cast<int>(columns.size());
  std::vector<double> weights(target.size(), 1), errors(target.size());
  Fit best;
  for (int pass = 0; pass < passes; ++pass) {
    cv::Mat_<double> normal(terms, terms), right(terms, 1), solution;
    std::vector<double> weighted(target.size());
    for (int i = 0; i < terms; ++i) {
      for (size_t p = 0; p < target.size(); ++p) weighted[p] = weights[p] * (*columns[i])[p];
      const auto product = [&](const std::vector<double>& other) {
        double sum = 0;
        for (size_t p = 0; p < target.size(); ++p) sum += weighted[p] * other[p];
        return sum;
      };
      for (int j = 0; j <= i; ++j) normal(i, j) = normal(j, i) = product(*columns[j]);
      right(i) = product(target);
    }
    cv::solve(normal, right, solution, cv::DECOMP_SVD);
    errors = target;
    for (int i = 0; i < terms; ++i)
      for (size_t p = 0; p < target.size(); ++p) errors[p] -= solution(i) * (*columns[i])[p];
    double greatest = 0, sum = 0;
    for (double& error : errors) greatest = std::max(greatest, error = std::abs(error));
    if (greatest < best.error) best = {{solution.begin(), solution.end()}, greatest};
    for (size_t p = 0; p < target.size(); ++p) sum += weights[p] *= errors[p] / greatest + 1e-3;
    for (double& weight : weights) weight *= static_cast<double>(target.size()) / sum;
  }
  return best;
}

struct Profile {
  std::string_view name;
  std::function<double(double t)> value;
};
const Profile one = {"", [](double) { return 1.0; }};
const Profile t1 = {"t", [](double t) { return t; }};
const Profile t2 = {"t^2", [](double t) { return t * t; }};
const Profile t3 = {"t^3", [](double t) { return t * t * t; }};
const Profile w = {"w", [](double t) { return std::sqrt(t * (1 - t)); }};
const Profile tw = {"t w", [](double t) { return t * std::sqrt(t * (1 - t)); }};

struct Term {
  Profile profile;
  int ratio_power, s_power;
  double value(const Point& p) const {
    return p.t * (1 - p.t) * profile.value(p.t) * std::pow(p.ratio, ratio_power) * std::pow(p.s, s_power);
  }
};

// A set of terms over points, and fits to their shares by some of them, given as indices.
class Fitter {
 public:
  Fitter(const std::vector<Term>& terms, int steps) : terms_(terms), points_(make_points(steps)), columns_(terms.size()) {
    for (const Point& point : points_) {
      target_.push_back(point.share - point.t);
      for (size_t i = 0; i < terms.size(); ++i) columns_[i].push_back(terms[i].value(point));
    }
  }
  Fit by(const std::vector<size_t>& chosen, int passes) const {
    std::vector<const std::vector<double>*> columns;
    for (const size_t i : chosen) columns.push_back(&columns_[i]);
    return fit(columns, target_, passes);
  }

 private:
  std::vector<Term> terms_;
  std::vector<Point> points_;
  std::vector<double> target_;
  std::vector<std::vector<double>> columns_;
};

std::vector<size_t> choose_terms(const Fitter& fitter, size_t terms, size_t kept) {
  std::vector<size_t> chosen;
  for (size_t i = 0; i < terms; ++i) chosen.push_back(i);
  while (chosen.size() > kept) {
    std::vector<size_t> best;
    double least = INFINITY;
    for (const size_t dropped : chosen) {
      std::vector<size_t> without;
      for (const size_t i : chosen)
        if (i != dropped) without.push_back(i);
      const double error = fitter.by(without, chosen.size() > 20 ? 6 : 20).error;
      if (error < least) least = error, best = without;
    }
    chosen = best;
  }
  for (double least = fitter.by(chosen, 30).error;;) {
    std::vector<size_t> best;
    for (size_t place = 0; place < kept; ++place)
      for (size_t other = 0; other < terms; ++other) {
        if (std::find(chosen.begin(), chosen.end(), other) != chosen.end()) continue;
        std::vector<size_t> exchanged = chosen;
        exchanged[place] = other;
        const double error = fitter.by(exchanged, 30).error;
        if (error < 0.995 * least) least = error, best = exchanged;
      }
    if (best.empty()) return chosen;
    chosen = best;
  }
}

// The terms up to these powers, `kept` of them.
void print_fit(std::string_view name, const std::vector<Profile>& profiles, int ratio_power, int s_power, size_t kept) {
  std::vector<Term> terms;
  for (const Profile& profile : profiles)
    for (int j = 0; j <= ratio_power; ++j)
      for (int k = 0; k <= s_power; ++k) terms.push_back({profile, j, k});
  std::vector<size_t> chosen = choose_terms(Fitter(terms, 10), terms.size(), kept);
  std::sort(chosen.begin(), chosen.end());
  const Fit best = Fitter(terms, 20).by(chosen, 400);
  fmt::print("\n{}: within {:.5f} of the smaller cap. P is the sum of\n", name, best.error);
  for (size_t i = 0; i < chosen.size(); ++i) {
    const Term& term = terms[chosen[i]];
    fmt::print("  {:>10.5f} {:<4} ratio^{} s^{}\n", best.coefficients[i], term.profile.name, term.ratio_power, term.s_power);
  }
}

// A cap's area over s = r^2, for r up to pi, in powers of s.
void print_area(int terms) {
  std::vector<std::vector<double>> powers(static_cast<size_t>(terms));
  constexpr int steps = 400;
  for (int i = 1; i <= steps; ++i) {
    const double r = pi / 2 * (1 - std::cos(pi * i / steps)), quotient = lamina::smaller_cap_area(r, r) / (r * r);
    for (int k = 0; k < terms; ++k) powers[static_cast<size_t>(k)].push_back(std::pow(r, 2 * k) / quotient);
  }
  std::vector<const std::vector<double>*> columns;
  for (const auto& power : powers) columns.push_back(&power);
  const Fit best = fit(columns, std::vector<double>(powers[0].size(), 1), 400);
  fmt::print("area of a cap over s, within {:.2g} of it:", best.error);
  for (int k = 0; k < terms; ++k) fmt::print(" {:.8g} s^{}", best.coefficients[static_cast<size_t>(k)], k);
  fmt::print("\n");
}

}  // namespace

int main() {
  print_area(5);
  print_fit("quick_fit_cap", {one, t1}, 2, 1, 4);
  print_fit("fitted_cap", {one, t1, t2, t3}, 3, 2, 10);
  print_fit("close_fit_cap", {one, t1, w, tw}, 3, 2, 16);
}
