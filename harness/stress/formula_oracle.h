// SPDX-License-Identifier: Apache-2.0
// An oracle from one formula in 200 bits: values are rounded once, and condition numbers come from its differences.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <random>

#include "harness/stress/oracle.h"

namespace lamina {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<200, boost::multiprecision::digit_base_2>,
                                           boost::multiprecision::et_off>;

// Random inputs of a set, the same for the same seed.
class SetRandom {
 public:
  explicit SetRandom(uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53); }
  double logarithmic(double low, double high);  // evenly in the logarithm; 0 < low
  double sign() { return (engine_() & 1) != 0 ? 1 : -1; }

 private:
  std::mt19937_64 engine_;
};

struct Formula {
  std::vector<std::string> inputs;
  std::string refusal;                   // in words, for what `accepts` does not
  bool (*accepts)(Oracle::Point point);  // of finite numbers
  Real (*value)(std::span<const Real> point);
  double (*scale)(double value);  // what an error is divided by
  struct Set {
    std::string name;
    std::vector<double> (*point)(SetRandom& random);  // accepted, also when rounded to binary32
  };
  std::vector<Set> sets;
};

// Errors of the value itself.
double of_one(double value);
// Errors relative to the value, or to 1e-36 where that is smaller: binary32 ends there.
double of_value(double value);

class FormulaOracle : public Oracle {
 public:
  explicit FormulaOracle(Formula formula) : formula_(std::move(formula)) {}
  std::vector<std::string> inputs() const override { return formula_.inputs; }
  std::string refusal(Point point) const override;
  double value(Point point) const override;
  double condition(Point point, double value) const override;
  double scale(Point point) const override { return formula_.scale(value(point)); }
  std::vector<std::string> sets() const override;
  Points points(const std::string& set, size_t count, uint64_t seed) const override;

 private:
  Formula formula_;
};

}  // namespace lamina
