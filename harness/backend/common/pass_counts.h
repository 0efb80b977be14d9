// SPDX-License-Identifier: Apache-2.0
// What a device has counted of a run's passes, for those passes that asked.
#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include "harness/backend/backend.h"

namespace lamina {

// One number a pass: `read` of its place, 0 where it does not ask. None where no pass asks.
inline std::vector<uint64_t> counts_of(std::span<const Pass> passes, bool (*asks)(const Pass&),
                                       const std::function<uint64_t(size_t)>& read) {
  if (std::none_of(passes.begin(), passes.end(), asks)) return {};
  std::vector<uint64_t> counts(passes.size());
  for (size_t pass = 0; pass < passes.size(); ++pass)
    if (asks(passes[pass])) counts[pass] = read(pass);
  return counts;
}

}  // namespace lamina
