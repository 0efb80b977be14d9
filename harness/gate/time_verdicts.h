// SPDX-License-Identifier: Apache-2.0
// Verdicts on times, for all comparisons of a gate at once. A ratio is slower where its interval lies wholly above the margin,
// faster where wholly below, the same where wholly inside, else ambiguous. Intervals are those of the median by order
// statistics (see measure/statistics.h), which is a sign test turned round; their confidence is raised so that over all
// comparisons together a wrong verdict has at most the stated chance (Holm, "A simple sequentially rejective multiple test
// procedure", Scandinavian Journal of Statistics 6, 1979). Rounds of one process share its memory layout and are not
// independent of each other, so the median of every process must agree with the verdict too.
#pragma once

#include <span>
#include <vector>

#include "harness/gate/verdict.h"

namespace lamina {

struct TimeComparison {
  std::vector<std::vector<double>> ratios;  // [process][round], after over before; positive
  double margin = 0;                        // as a share, above 0
};

struct TimeVerdict {
  Verdict verdict = Verdict::ambiguous;  // same, faster, slower or ambiguous
  Interval ratio;                        // over the rounds of all processes
};

// `family_error`, between 0 and 1: the chance of any wrong verdict, over all of them. Throws Error(failed) for a ratio that is
// not positive and finite, or a comparison without rounds.
std::vector<TimeVerdict> judge_times(std::span<const TimeComparison> comparisons, double family_error);

// Greatest half width of the intervals, over their margins: at most 1/2 means that more rounds would decide little that these
// do not, whatever the verdicts are.
double worst_precision(std::span<const TimeComparison> comparisons, std::span<const TimeVerdict> verdicts);

}  // namespace lamina
