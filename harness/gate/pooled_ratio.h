// SPDX-License-Identifier: Apache-2.0
// One ratio of times from several processes. Repeats in one process are not independent: each has its own layout of code and
// memory, which moves its ratio by a percent or two, and on a busy machine bursts of other work do. So what counts is how the
// processes scatter, of which five tell little; but the comparisons of one gate ran in the same processes, and tell it
// together.
#pragma once

#include <span>

#include "harness/measure/ratio_estimate.h"

namespace lamina {

struct PooledRatio {
  double log_ratio = 0;  // the mean of the processes', weighted
  size_t strips = 0;
  double within = 0;  // variance of log_ratio by the processes' own errors
  double within_freedom = 1;
  double disagreement = 1;          // its variance by how the processes scatter, over `within`: 1 where their errors explain it
  double disagreement_freedom = 0;  // degrees of freedom of that; 0: one process says nothing of it
};

// Weighted by the processes' errors, but none more than the middle one: an error that was taken from a few strips may be small
// by luck, and must not decide alone. The scatter is that of the weighted mean with residuals in place of the errors (H. White,
// "A heteroskedasticity-consistent covariance matrix estimator and a direct test for heteroskedasticity", Econometrica 48,
// 1980, with the correction for few residuals). Throws Error(failed) for no process, or an estimate that is not finite.
PooledRatio pool(std::span<const RatioEstimate> processes);

// What comparisons that share their processes say of each other: how much processes typically disagree, and how many degrees of
// freedom that is worth to one of them. 0: nothing.
struct SharedDisagreement {
  double typical = 1;
  double freedom = 0;
};

// The fewer degrees of freedom the more the comparisons differ in it beyond what chance does: a scaled F distribution fitted by
// moments of the logarithms (G. K. Smyth, "Linear models and empirical Bayes methods for assessing differential expression in
// microarray experiments", Statistical Applications in Genetics and Molecular Biology 3, 2004, section 6.2). Their spread
// enters as its upper quartile, since a few comparisons may be alike by luck. Never more than the other comparisons have.
SharedDisagreement shared_disagreement(std::span<const PooledRatio> comparisons);

// The ratio with its error: `within`, times the disagreement where that is above 1, which is this comparison's own moderated by
// what the others say (Smyth, section 3). Its degrees of freedom are the disagreement's even where that is below 1: processes
// that agree by luck must not be believed the more for it. Those of one process alone are its own.
RatioEstimate settle(const PooledRatio& pooled, const SharedDisagreement& others = {});

}  // namespace lamina
