// SPDX-License-Identifier: Apache-2.0
// Radiance of plane layers by adding and doubling, azimuth averaged: what random walks are held against. After van de Hulst,
// "Multiple Light Scattering", 1980, chapter 4. Directions are cosines to the normal; operators act on radiances at quadrature
// points, their weights within.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

namespace lamina {

// Points in (0, 1) whose weights sum to 1, by Gauss; then further cosines that count for nothing in sums, where radiance is
// asked for.
struct Cosines {
  std::vector<double> at, weight;
  size_t size() const { return at.size(); }
};
inline Cosines gauss_cosines(size_t count, const std::vector<double>& asked) {
  Cosines made;
  for (size_t i = 0; i < count; ++i) {
    double x = std::cos(std::numbers::pi * (double(i) + 0.75) / (double(count) + 0.5)), slope = 1;
    for (int step = 0; step < 60; ++step) {
      double before = 1, now = x;
      for (size_t l = 2; l <= count; ++l) {
        const double next = ((2 * double(l) - 1) * x * now - (double(l) - 1) * before) / double(l);
        before = now, now = next;
      }
      slope = double(count) * (x * now - before) / (x * x - 1);
      x -= now / slope;
    }
    made.at.push_back((1 + x) / 2), made.weight.push_back(1 / ((1 - x * x) * slope * slope));
  }
  for (const double cosine : asked) made.at.push_back(cosine), made.weight.push_back(0);
  return made;
}

struct SquareMatrix {
  explicit SquareMatrix(size_t side) : n(side), v(side * side, 0) {}
  double& operator()(size_t i, size_t j) { return v[i * n + j]; }
  double operator()(size_t i, size_t j) const { return v[i * n + j]; }
  size_t n;
  std::vector<double> v;
};
inline SquareMatrix operator*(const SquareMatrix& a, const SquareMatrix& b) {
  SquareMatrix product(a.n);
  for (size_t i = 0; i < a.n; ++i)
    for (size_t k = 0; k < a.n; ++k)
      for (size_t j = 0; j < a.n; ++j) product(i, j) += a(i, k) * b(k, j);
  return product;
}
inline SquareMatrix operator+(SquareMatrix a, const SquareMatrix& b) {
  for (size_t i = 0; i < a.v.size(); ++i) a.v[i] += b.v[i];
  return a;
}
// x of (1 - a) x = b, by elimination with the largest pivots.
inline SquareMatrix solved(const SquareMatrix& a, SquareMatrix b) {
  SquareMatrix m(a.n);
  for (size_t i = 0; i < a.n; ++i)
    for (size_t j = 0; j < a.n; ++j) m(i, j) = (i == j ? 1 : 0) - a(i, j);
  for (size_t c = 0; c < a.n; ++c) {
    size_t pivot = c;
    for (size_t i = c; i < a.n; ++i)
      if (std::abs(m(i, c)) > std::abs(m(pivot, c))) pivot = i;
    for (size_t j = 0; j < a.n; ++j) std::swap(m(c, j), m(pivot, j)), std::swap(b(c, j), b(pivot, j));
    for (size_t i = 0; i < a.n; ++i) {
      const double factor = m(i, c) / m(c, c);
      if (i == c || factor == 0) continue;
      for (size_t j = c; j < a.n; ++j) m(i, j) -= factor * m(c, j);
      for (size_t j = 0; j < a.n; ++j) b(i, j) -= factor * b(c, j);
    }
  }
  for (size_t i = 0; i < a.n; ++i)
    for (size_t j = 0; j < a.n; ++j) b(i, j) /= m(i, i);
  return b;
}

// How a layer, the same seen from both sides, turns radiance that falls on it into what leaves on the same side and on the
// other.
struct PlaneLayer {
  SquareMatrix back, through;
};

// A sheet that lets a share pass and scatters the rest as Lambert says.
inline PlaneLayer sheet_layer(const Cosines& c, double albedo, double transparency) {
  PlaneLayer made{SquareMatrix(c.size()), SquareMatrix(c.size())};
  for (size_t i = 0; i < c.size(); ++i) {
    made.through(i, i) = transparency;
    for (size_t j = 0; j < c.size(); ++j) made.back(i, j) = (1 - transparency) * albedo * 2 * c.at[j] * c.weight[j];
  }
  return made;
}

// The first over the second. Only sums of equal layers are equal from both sides; `back` is that of light from above.
inline PlaneLayer over(const PlaneLayer& above, const PlaneLayer& below) {
  const SquareMatrix falling = solved(above.back * below.back, above.through);
  return {above.back + above.through * (below.back * falling), below.through * falling};
}

// A medium of an optical depth that scatters by Henyey and Greenstein's law.
inline PlaneLayer medium_layer(const Cosines& c, double albedo, double depth, double g) {
  const size_t n = c.size(), orders = 2 * n;
  std::vector<std::vector<double>> legendre(n, std::vector<double>(orders, 1));
  for (size_t i = 0; i < n; ++i) {
    legendre[i][1] = c.at[i];
    for (size_t l = 2; l < orders; ++l)
      legendre[i][l] = ((2 * double(l) - 1) * c.at[i] * legendre[i][l - 1] - (double(l) - 1) * legendre[i][l - 2]) / double(l);
  }
  int doublings = 0;
  double thin = depth;
  while (thin > 1e-7) thin /= 2, ++doublings;
  PlaneLayer made{SquareMatrix(n), SquareMatrix(n)};
  for (size_t i = 0; i < n; ++i) {
    made.through(i, i) = 1 - thin / c.at[i];
    for (size_t j = 0; j < n; ++j) {
      double ahead = 0, back = 0, power = 1;
      for (size_t l = 0; l < orders; ++l, power *= g) {
        const double term = (2 * double(l) + 1) * power * legendre[i][l] * legendre[j][l];
        ahead += term, back += l % 2 ? -term : term;
      }
      const double share = albedo * thin / (4 * c.at[i] * c.at[j]) * 2 * c.at[j] * c.weight[j];
      made.back(i, j) += share * back, made.through(i, j) += share * ahead;
    }
  }
  for (int i = 0; i < doublings; ++i) made = over(made, made);
  return made;
}

// Radiance that leaves at cosine i under radiance of 1 from everywhere above. For a cosine that is asked for it is the share of
// light from there that comes back, or passes, as well: paths run both ways.
inline double sum_of_row(const SquareMatrix& m, size_t i) {
  double sum = 0;
  for (size_t j = 0; j < m.n; ++j) sum += m(i, j);
  return sum;
}
// Of radiance 1 from everywhere the share that comes back, or passes.
inline double diffuse_share(const Cosines& c, const SquareMatrix& m) {
  double sum = 0;
  for (size_t i = 0; i < m.n; ++i) sum += 2 * c.at[i] * c.weight[i] * sum_of_row(m, i);
  return sum;
}

}  // namespace lamina
