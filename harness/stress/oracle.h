// SPDX-License-Identifier: Apache-2.0
// An oracle gives the exact value of a family's function at each point. Effects bring oracles, and family.toml asks for them by
// name (harness/manifest/effect_code.h).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "harness/stress/points.h"

namespace lamina {

// Without state, so that it may be asked from anywhere.
class Oracle {
 public:
  using Point = std::span<const double>;  // as many as inputs(), in their order

  virtual ~Oracle() = default;
  // Names, in the order of the arguments. family.toml declares the same, with their units and ranges.
  virtual std::vector<std::string> inputs() const = 0;

  // Why a point has no value, in words for who gave it, "" where it has one. Whatever is not finite has none. The others below
  // are asked only for points that have one.
  virtual std::string refusal(Point point) const = 0;
  // To double precision, from a computation of at least 100 bits or one that a test proves against such a one.
  virtual double value(Point point) const = 0;
  // How much relative errors of the inputs are amplified: the sum over inputs of |input * derivative / value|, 0 where the
  // value is 0. `value` is value(point).
  virtual double condition(Point point, double value) const = 0;
  // What an error is divided by, above 0.
  virtual double scale(Point point) const = 0;

  // Names of the sets of inputs that it makes. family.toml declares the same, and says what is in each.
  virtual std::vector<std::string> sets() const = 0;
  // About `count` points of a set, the same for the same seed; all have a value.
  virtual Points points(const std::string& set, size_t count, uint64_t seed) const = 0;
};

}  // namespace lamina
