// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace lamina {

// Wall time since it was made.
class Stopwatch {
 public:
  double elapsed_s() const { return elapsed<std::ratio<1>>(); }
  double elapsed_ms() const { return elapsed<std::milli>(); }

 private:
  template <class Unit>
  double elapsed() const {
    return std::chrono::duration<double, Unit>(std::chrono::steady_clock::now() - start_).count();
  }
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace lamina
