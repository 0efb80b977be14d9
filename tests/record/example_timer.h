// SPDX-License-Identifier: Apache-2.0
// A timer's certificate made by hand.
#pragma once

#include <string>

#include "harness/record/timer_row.h"

namespace lamina {

inline TimerRow example_timer(std::string backend, bool ok = true) {
  return {.backend = std::move(backend),
          .ok = ok,
          .linearity = {1, 1.01, 0.99, ok ? 1.0 : 1.4},
          .additivity = 0.98,
          .attribution = 0.015,
          .reason = ok ? "" : "8x work took 1.4 of linear"};
}

}  // namespace lamina
