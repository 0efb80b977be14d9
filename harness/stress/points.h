// SPDX-License-Identifier: Apache-2.0
// Inputs of a function, call after call.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace lamina {

inline constexpr size_t max_inputs = 8;

// Each point has the same number of inputs, 1 to max_inputs; binary32, as the shaders take them.
class Points {
 public:
  explicit Points(size_t inputs, std::initializer_list<std::initializer_list<float>> points = {}) : inputs_(inputs) {
    for (const auto& point : points) add(point);
  }
  size_t inputs() const { return inputs_; }
  size_t size() const { return numbers_.size() / inputs_; }
  std::span<const float> operator[](size_t i) const { return {numbers_.data() + i * inputs_, inputs_}; }
  std::span<float> operator[](size_t i) { return {numbers_.data() + i * inputs_, inputs_}; }
  // Point after point.
  std::span<const float> numbers() const { return numbers_; }
  void add(std::span<const float> point) { numbers_.insert(numbers_.end(), point.begin(), point.end()); }
  void add(std::initializer_list<float> point) { add(std::span(point.begin(), point.size())); }

 private:
  size_t inputs_;
  std::vector<float> numbers_;
};

struct PointSet {
  std::string name, what;  // what is in it, in words
  Points points;
  std::vector<double> given{};  // right values that a file brings, beside the points and NaN where it brings none; else empty
};

}  // namespace lamina
