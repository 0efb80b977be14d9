// SPDX-License-Identifier: Apache-2.0
#include "harness/choose/choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "harness/core/error.h"
#include "harness/quality/error_metrics.h"

namespace lamina {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double squared_of_db(double psnr_db) { return std::isinf(psnr_db) ? 0 : std::pow(10, -psnr_db / 10); }
double db_of_squared(double squared) { return squared > 0 ? -10 * std::log10(squared) : infinity; }

const ErrorMetric& metric_of(const std::string& name) {
  if (const ErrorMetric* metric = error_metric(name)) return *metric;
  throw Error(ErrorKind::bad_input, "choose", name, "is no metric of an error: ssim, psnr_db, flip, max_linear or rmse_linear");
}

// Smaller is better; finite but for unequal infinities.
double badness(const Outcome& outcome, const std::string& metric) {
  const double error = worst_error(outcome, metric);
  return greater_is_better(metric) ? -error : error;
}

}  // namespace

uint64_t ChoiceSpace::choices() const {
  return std::accumulate(effects.begin(), effects.end(), uint64_t{1},
                         [](uint64_t product, const ChoiceEffect& effect) { return product * effect.options.size(); });
}

Outcome predicted(const ChoiceSpace& space, const Choice& choice) {
  Outcome sum = space.baseline;
  for (size_t view = 0; view < sum.size(); ++view) {
    const ViewOutcome& base = space.baseline[view];
    double squared = squared_of_db(base.error.psnr_db), linear = base.error.rmse_linear * base.error.rmse_linear;
    const double base_squared = squared, base_linear = linear;
    for (size_t effect = 0; effect < choice.size(); ++effect) {
      if (choice[effect] == 0) continue;
      const ViewOutcome& single = space.effects[effect].options[choice[effect]].single[view];
      sum[view].ms += single.ms - base.ms;
      squared += squared_of_db(single.error.psnr_db) - base_squared;
      linear += single.error.rmse_linear * single.error.rmse_linear - base_linear;
      sum[view].error.ssim += single.error.ssim - base.error.ssim;
      sum[view].error.flip += single.error.flip - base.error.flip;
      sum[view].error.max_linear = std::max(sum[view].error.max_linear, single.error.max_linear);
    }
    sum[view].ms = std::max(sum[view].ms, 0.0);
    sum[view].error.psnr_db = db_of_squared(squared);
    sum[view].error.rmse_linear = std::sqrt(std::max(linear, 0.0));
    sum[view].error.flip = std::clamp(sum[view].error.flip, 0.0, 1.0);
  }
  return sum;
}

bool greater_is_better(const std::string& metric) { return metric_of(metric).more_is_closer; }

double worst_ms(const Outcome& outcome) {
  double worst = 0;
  for (const ViewOutcome& view : outcome) worst = std::max(worst, view.ms);
  return worst;
}

double worst_error(const Outcome& outcome, const std::string& metric) {
  double worst = greater_is_better(metric) ? infinity : 0;
  for (const ViewOutcome& view : outcome) {
    const double value = view.error.*metric_of(metric).figure;
    worst = greater_is_better(metric) ? std::min(worst, value) : std::max(worst, value);
  }
  return worst;
}

double miss(const Outcome& outcome, const ChoiceGoal& goal) {
  double sum = 0;
  if (goal.budget_ms) sum += std::max(0.0, worst_ms(outcome) / *goal.budget_ms - 1);
  for (const ErrorLimit& limit : goal.limits) {
    const double value = worst_error(outcome, limit.metric);
    const double beyond = greater_is_better(limit.metric) ? limit.value - value : value - limit.value;
    const double bound = limit.metric == "ssim" ? 1 - limit.value : limit.value;
    if (beyond > 0) sum += beyond / std::max(bound, 1e-6);
  }
  return sum;
}

bool is_better(const Outcome& a, const Outcome& b, const ChoiceGoal& goal) {
  if (const double miss_a = miss(a, goal), miss_b = miss(b, goal); miss_a != miss_b) return miss_a < miss_b;
  const double error_a = badness(a, goal.metric), error_b = badness(b, goal.metric), ms_a = worst_ms(a), ms_b = worst_ms(b);
  if (goal.budget_ms) return error_a != error_b ? error_a < error_b : ms_a < ms_b;
  return ms_a != ms_b ? ms_a < ms_b : error_a < error_b;
}

std::vector<size_t> frontier_of(std::span<const Outcome> outcomes, const std::string& metric) {
  std::vector<size_t> order(outcomes.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::ranges::sort(order, [&](size_t a, size_t b) {
    const double ms_a = worst_ms(outcomes[a]), ms_b = worst_ms(outcomes[b]);
    return ms_a != ms_b ? ms_a < ms_b : badness(outcomes[a], metric) < badness(outcomes[b], metric);
  });
  std::vector<size_t> frontier;
  double least = infinity;
  for (const size_t i : order) {
    if (const double error = badness(outcomes[i], metric); error < least) {
      least = error;
      frontier.push_back(i);
    }
  }
  return frontier;
}

}  // namespace lamina
