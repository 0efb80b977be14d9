// SPDX-License-Identifier: Apache-2.0
// One ratio of times from several processes. Repeats within one process are not independent: each process has its own layout
// of code and memory, which moves its ratio by a percent or two; on a busy machine, bursts of other work move it too. So the
// variance of a ratio is estimated from the scatter between processes. Five processes estimate a variance badly. The
// comparisons of one gate ran in the same processes, so their variances are pooled: Smyth's moderated t.
#pragma once

#include <span>

#include "harness/measure/ratio_estimate.h"

namespace lamina {

struct PooledRatio {
  double log_ratio = 0;  // the mean of the processes', weighted
  size_t strips = 0;
  double within = 0;  // variance of log_ratio by the processes' own errors
  double within_freedom = 1;
  double disagreement = 1;          // variance between processes over `within`: 1 where the processes' own errors explain it
  double disagreement_freedom = 0;  // degrees of freedom of `disagreement`; 0: one process has no scatter
};

// The weighted mean of the processes' ratios. Weights follow from their errors, but no process weighs more than the middle one:
// an error from few strips may be small by luck and must not decide alone. The scatter is the variance of the weighted mean,
// with residuals in place of the errors (H. White, "A heteroskedasticity-consistent covariance matrix estimator and a direct
// test for heteroskedasticity", Econometrica 48, 1980, with the correction for few residuals). Throws Error(failed) for no
// process, or an estimate that is not finite.
PooledRatio pool(std::span<const RatioEstimate> processes);

// The prior that comparisons with the same processes give each other: how much processes typically disagree, and how many
// degrees of freedom this prior is worth. 0: it is worth nothing.
struct SharedDisagreement {
  double typical = 1;
  double freedom = 0;
};

// Fits a scaled F distribution to the comparisons' disagreements, by moments of the logarithms (G. K. Smyth, "Linear models and
// empirical Bayes methods for assessing differential expression in microarray experiments", Statistical Applications in
// Genetics and Molecular Biology 3, 2004, section 6.2). Where the disagreements differ more than chance explains, the prior has
// fewer degrees of freedom. Their spread enters as its upper quartile, since a few comparisons may be alike by luck. The prior
// never has more degrees of freedom than the other comparisons together.
SharedDisagreement shared_disagreement(std::span<const PooledRatio> comparisons);

// The ratio with its error. The variance is `within`, times the moderated disagreement where that is above 1. The moderated
// disagreement combines this comparison's own with the prior of the others (Smyth, section 3). The degrees of freedom are at
// most the disagreement's, even where it is below 1: processes that agree by luck must not make the result look surer. The part
// of the variance that is not the processes' own scatter has `within` for a factor, which few strips tell badly: its share of
// the relative error is added (F. E. Satterthwaite, "An approximate distribution of estimates of variance components",
// Biometrics Bulletin 2, 1946). With one process they are that process's own.
RatioEstimate settle(const PooledRatio& pooled, const SharedDisagreement& others = {});

}  // namespace lamina
