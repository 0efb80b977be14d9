// SPDX-License-Identifier: Apache-2.0
// What each assumption of a cell costs, in words and figures.
#include <fmt/format.h>

#include <algorithm>

#include "reports/words.h"

namespace lamina {

std::string costliest_assumption(const CellRow& cell) {
  std::vector<std::pair<double, std::string>> costs;
  for (const AssumptionRow& assumption : cell.assumptions) costs.emplace_back(assumption.error.rmse_linear, assumption.title);
  std::ranges::stable_sort(costs, [](const auto& a, const auto& b) { return a.first > b.first; });
  if (costs.empty() || costs[0].first == 0) return "No assumption changes this picture.";
  std::string words = fmt::format("What costs the most: {}, RMSE {:.3g}", costs[0].second, costs[0].first);
  for (size_t i = 1; i < costs.size(); ++i) words += fmt::format("; then {}, {:.3g}", costs[i].second, costs[i].first);
  return words + ".";
}

}  // namespace lamina
