// SPDX-License-Identifier: Apache-2.0
// An oracle from one formula in 200 bits: values are rounded once, and condition numbers come from its differences.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <functional>
#include <random>

#include "harness/stress/oracle.h"

namespace lamina {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<200, boost::multiprecision::digit_base_2>,
                                           boost::multiprecision::et_off>;

class SetRandom {
 public:
  explicit SetRandom(uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53); }
  double logarithmic(double low, double high);  // evenly in the logarithm; 0 < low

 private:
  std::mt19937_64 engine_;
};

struct RealFormula {
  std::vector<std::string> inputs;
  std::string refusal;                   // in words, for what `accepts` does not
  bool (*accepts)(Oracle::Point point);  // of finite numbers
  Real (*value)(const std::vector<Real>& point);
  double scale = 1;
  struct Set {
    std::string name;
    std::vector<double> (*point)(SetRandom& random);  // accepted, also when rounded to binary32
  };
  std::vector<Set> sets;
};

class RealOracle : public Oracle {
 public:
  explicit RealOracle(RealFormula formula) : formula_(std::move(formula)) {}
  std::vector<std::string> inputs() const override { return formula_.inputs; }
  std::string refusal(Point point) const override;
  double value(Point point) const override;
  double condition(Point point, double value) const override;
  double scale(Point) const override { return formula_.scale; }
  std::vector<std::string> sets() const override;
  Points points(const std::string& set, size_t count, uint64_t seed) const override;

 private:
  RealFormula formula_;
};

// The families of functions that light through objects is made of: shaders/refraction, wrap_lighting, back_light,
// thickness_ramp and depth_bias have what their inputs mean.
const Oracle& refraction_oracle();
const Oracle& wrap_oracle();
const Oracle& back_light_oracle();
const Oracle& ramp_oracle();
const Oracle& depth_bias_oracle();

}  // namespace lamina
