// SPDX-License-Identifier: Apache-2.0
// An oracle from a formula: the formula is evaluated with 128 bits, and so is its condition number, by differences.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "harness/stress/oracle.h"

namespace lamina {

using WideReal = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<128, boost::multiprecision::digit_base_2>,
                                               boost::multiprecision::et_off>;

// Random inputs of a set, the same for the same seed.
class InputRandom {
 public:
  explicit InputRandom(uint64_t seed) : engine_(seed) {}
  float uniform(double low, double high) { return static_cast<float>(low + (high - low) * unit()); }
  // Even in the logarithm; both ends above 0.
  float logarithmic(double low, double high) { return static_cast<float>(low * std::exp(unit() * std::log(high / low))); }
  float sign() { return (engine_() & 1) != 0 ? 1.0f : -1.0f; }

 private:
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  std::mt19937_64 engine_;
};

struct ExactFunction {
  struct Set {
    std::string name;
    std::vector<float> (*point)(InputRandom& random);
  };
  std::vector<std::string> inputs;
  std::string (*refusal)(Oracle::Point point);  // of finite inputs
  WideReal (*value)(std::span<const WideReal> point);
  std::vector<Set> sets;
};

// Errors are relative to the value, or to 1e-36 where that is smaller: binary32 ends there.
class ExactOracle : public Oracle {
 public:
  explicit ExactOracle(ExactFunction function) : function_(std::move(function)) {}
  std::vector<std::string> inputs() const override { return function_.inputs; }
  std::string refusal(Point point) const override;
  double value(Point point) const override;
  double condition(Point point, double value) const override;
  double scale(Point point) const override { return std::max(std::abs(value(point)), 1e-36); }
  std::vector<std::string> sets() const override;
  Points points(const std::string& set, size_t count, uint64_t seed) const override;

 private:
  ExactFunction function_;
};

// The families.
ExactFunction henyey_greenstein_function();
ExactFunction cornette_shanks_function();
ExactFunction rayleigh_function();
ExactFunction transmittance_function();
ExactFunction mean_transmittance_function();
ExactFunction slab_in_scatter_function();
ExactFunction fresnel_function();

}  // namespace lamina
