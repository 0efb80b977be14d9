// SPDX-License-Identifier: Apache-2.0
// By what lines of source are ordered that cost the most.
#pragma once

namespace lamina {

// The sum of a line's shares of its pass's fetches and of its operations, 0 to 2. A pass that has none of a kind gives no
// share.
inline double dearness(double fetches, double operations, double all_fetches, double all_operations) {
  const auto share = [](double part, double all) { return all > 0 ? part / all : 0; };
  return share(fetches, all_fetches) + share(operations, all_operations);
}

}  // namespace lamina
