// SPDX-License-Identifier: Apache-2.0
// Same, faster, slower or ambiguous: verdicts on ratios of times, with one error rate over all of them. Holm's method (S. Holm,
// "A simple sequentially rejective multiple test procedure", Scandinavian Journal of Statistics 6, 1979) over t tests against
// the margin: slower and faster one side each, same by both (D. J. Schuirmann, "A comparison of the two one-sided tests
// procedure and the power approach for assessing the equivalence of average bioavailability", Journal of Pharmacokinetics and
// Biopharmaceutics 15, 1987).
#pragma once

#include <span>
#include <vector>

#include "harness/gate/pooled_ratio.h"
#include "harness/gate/verdict.h"

namespace lamina {

struct TimeComparison {
  std::vector<RatioEstimate> processes;
  double margin = 0;  // as a share, above 0
};

struct TimeVerdict {
  Verdict verdict = Verdict::ambiguous;  // same, faster, slower or ambiguous
  Interval ratio;                        // pooled; `rounds` counts strips
};

// `shared`: what all comparisons of the gate say of how its processes disagree. `family_error`, between 0 and 1: the chance of
// any wrong verdict, over all of them. Throws as pool() does.
std::vector<TimeVerdict> judge_times(std::span<const TimeComparison> comparisons, const SharedDisagreement& shared,
                                     double family_error);

// The interval of a ratio, by Student's t; `confidence` between 0 and 1.
Interval ratio_interval(const RatioEstimate& ratio, double confidence);

}  // namespace lamina
