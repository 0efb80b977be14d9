// SPDX-License-Identifier: Apache-2.0
// The families of functions that scattering is made of: shaders/henyey_greenstein, cornette_shanks, rayleigh, transmittance,
// mean_transmittance, slab_in_scatter, fresnel and refraction have what their inputs mean. Errors are relative to the value, of
// refraction to 1.
#pragma once

#include <cmath>

#include "harness/stress/formula_oracle.h"

namespace lamina {

// Random inputs as binary32, in which sets compute with them.
class SingleRandom {
 public:
  explicit SingleRandom(SetRandom& random) : random_(random) {}
  float uniform(double low, double high) { return static_cast<float>(random_.uniform(low, high)); }
  float logarithmic(double low, double high) { return static_cast<float>(random_.logarithmic(low, high)); }
  float sign() { return static_cast<float>(random_.sign()); }

 private:
  SetRandom& random_;
};

// The point of a set that computes in binary32.
template <auto point>
std::vector<double> single(SetRandom& random) {
  SingleRandom singles(random);
  return point(singles);
}

Formula henyey_greenstein_formula();
Formula cornette_shanks_formula();
Formula rayleigh_formula();
Formula transmittance_formula();
Formula mean_transmittance_formula();
Formula slab_in_scatter_formula();
Formula fresnel_formula();
Formula refraction_formula();

// Inputs of functions of a smooth boundary: c, the cosine on the side that the light comes from, and n, the index of refraction
// that it goes into over the one that it comes from.
bool accepts_boundary(Oracle::Point p);
std::vector<Formula::Set> boundary_sets();

}  // namespace lamina
