// SPDX-License-Identifier: Apache-2.0
// Rows of a grid or texture on two threads, which halves the time that the heart takes to make.
#pragma once

#include <cstdint>
#include <thread>

namespace lamina {

// Calls row(y) once for each y in [0, rows), the lower half on a second thread. Rows must not depend on each other, so that the
// result does not depend on threads; `row` must not throw.
template <class Row>
void each_row(uint32_t rows, Row&& row) {
  std::thread other([&] {
    for (uint32_t y = rows / 2; y < rows; ++y) row(y);
  });
  for (uint32_t y = 0; y < rows / 2; ++y) row(y);
  other.join();
}

}  // namespace lamina
