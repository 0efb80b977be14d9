// SPDX-License-Identifier: Apache-2.0
#include "harness/cost/nonnegative_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "harness/core/error.h"

namespace lamina {
namespace {

using Matrix = std::vector<std::vector<double>>;

constexpr double tolerance = 1e-11;  // of columns of length 1

// The solution of matrix x = right over the columns in `free`, by Cholesky's factors; a column that the ones before it give,
// but for rounding, gets 0.
std::vector<double> solve(const Matrix& matrix, const std::vector<double>& right, const std::vector<size_t>& free) {
  const size_t n = free.size();
  Matrix lower(n, std::vector<double>(n, 0));
  std::vector<bool> is_given(n, false);
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j <= i; ++j) {
      double sum = matrix[free[i]][free[j]];
      for (size_t k = 0; k < j; ++k) sum -= lower[i][k] * lower[j][k];
      if (i == j) {
        is_given[i] = sum < tolerance;
        lower[i][i] = is_given[i] ? 1 : std::sqrt(sum);
      } else {
        lower[i][j] = is_given[j] ? 0 : sum / lower[j][j];
      }
      if (i == j && is_given[i])
        for (size_t k = 0; k < j; ++k) lower[i][k] = 0;
    }
  std::vector<double> x(n, 0);
  for (size_t i = 0; i < n; ++i) {
    double sum = is_given[i] ? 0 : right[free[i]];
    for (size_t k = 0; k < i; ++k) sum -= lower[i][k] * x[k];
    x[i] = sum / lower[i][i];
  }
  for (size_t i = n; i-- > 0;) {
    for (size_t k = i + 1; k < n; ++k) x[i] -= lower[k][i] * x[k];
    x[i] /= lower[i][i];
    if (is_given[i]) x[i] = 0;
  }
  return x;
}

// The active set of the weights that are 0, and the others free.
class ActiveSet {
 public:
  ActiveSet(const Matrix& matrix, const std::vector<double>& right)
      : matrix_(matrix), right_(right), x_(right.size(), 0), is_free_(right.size(), false) {}

  std::vector<double> solution() {
    std::vector<bool> refused(x_.size(), false);
    for (size_t turn = 0; turn < 10 * x_.size(); ++turn) {
      const std::optional<size_t> next = steepest(refused);
      if (!next) break;
      is_free_[*next] = true;
      settle();
      // One that falls back to 0 at once only has a slope by rounding: another has to move first.
      if (is_free_[*next])
        refused.assign(x_.size(), false);
      else
        refused[*next] = true;
    }
    return x_;
  }

 private:
  std::optional<size_t> steepest(const std::vector<bool>& refused) const {
    std::optional<size_t> best;
    double slope = tolerance;
    for (size_t j = 0; j < x_.size(); ++j) {
      if (is_free_[j] || refused[j]) continue;
      double down = right_[j];
      for (size_t k = 0; k < x_.size(); ++k) down -= matrix_[j][k] * x_[k];
      if (down > slope) best = j, slope = down;
    }
    return best;
  }

  // Goes to the best values of the free ones, and binds those that would fall below 0 on the way.
  void settle() {
    for (size_t turn = 0; turn <= x_.size(); ++turn) {
      std::vector<size_t> free;
      for (size_t j = 0; j < x_.size(); ++j)
        if (is_free_[j]) free.push_back(j);
      const std::vector<double> goal = solve(matrix_, right_, free);
      double step = 1;
      for (size_t k = 0; k < free.size(); ++k)
        if (goal[k] <= 0) step = std::min(step, x_[free[k]] / std::max(x_[free[k]] - goal[k], 1e-300));
      bool is_bound = false;
      for (size_t k = 0; k < free.size(); ++k) {
        double& value = x_[free[k]];
        value += step * (goal[k] - value);
        if (goal[k] <= 0 && value <= tolerance) value = 0, is_free_[free[k]] = false, is_bound = true;
      }
      if (!is_bound) return;
    }
  }

  const Matrix& matrix_;
  const std::vector<double>& right_;
  std::vector<double> x_;
  std::vector<bool> is_free_;
};

void check_rows(std::span<const std::vector<double>> rows, std::span<const double> targets) {
  if (rows.empty() || rows.size() != targets.size())
    throw Error(ErrorKind::failed, "cost model", "fit", "there is nothing to fit to");
  const auto finite = [](double value) { return std::isfinite(value); };
  for (const std::vector<double>& row : rows)
    if (row.size() != rows.front().size() || !std::ranges::all_of(row, finite))
      throw Error(ErrorKind::failed, "cost model", "fit", "a row has another length, or holds what is not a finite number");
  if (!std::ranges::all_of(targets, finite))
    throw Error(ErrorKind::failed, "cost model", "fit", "a target is not a finite number");
}

// `weights`: of the squares, beside the rows. Columns are scaled to one length, so that one tolerance fits all.
std::vector<double> fit_weighted(std::span<const std::vector<double>> rows, std::span<const double> targets,
                                 std::span<const double> weights, double ridge) {
  const size_t columns = rows.front().size();
  std::vector<double> scale(columns, 0), right(columns, 0);
  for (size_t i = 0; i < rows.size(); ++i)
    for (size_t j = 0; j < columns; ++j) scale[j] += weights[i] * rows[i][j] * rows[i][j];
  for (double& length : scale) length = std::sqrt(length);
  Matrix matrix(columns, std::vector<double>(columns, 0));
  for (size_t i = 0; i < rows.size(); ++i)
    for (size_t j = 0; j < columns; ++j) {
      if (rows[i][j] == 0 || scale[j] == 0) continue;
      const double scaled = weights[i] * rows[i][j] / scale[j];
      right[j] += scaled * targets[i];
      for (size_t k = 0; k < columns; ++k)
        if (scale[k] > 0) matrix[j][k] += scaled * rows[i][k] / scale[k];
    }
  for (size_t j = 0; j < columns; ++j) matrix[j][j] += scale[j] > 0 ? ridge : 0;
  std::vector<double> x = ActiveSet(matrix, right).solution();
  for (size_t j = 0; j < columns; ++j) x[j] = scale[j] > 0 ? x[j] / scale[j] : 0;
  return x;
}

}  // namespace

std::vector<double> fit_nonnegative(std::span<const std::vector<double>> rows, std::span<const double> targets) {
  check_rows(rows, targets);
  return fit_weighted(rows, targets, std::vector<double>(rows.size(), 1), 0);
}

std::vector<double> fit_least_absolute(std::span<const std::vector<double>> rows, std::span<const double> targets, double small,
                                       double ridge) {
  check_rows(rows, targets);
  constexpr int max_turns = 100;
  constexpr double settled = 1e-6;  // relative
  std::vector<double> weights(rows.size(), 1), x;
  for (int turn = 0; turn < max_turns; ++turn) {
    const std::vector<double> before = std::exchange(x, fit_weighted(rows, targets, weights, ridge));
    const auto is_settled = [](double a, double b) { return std::abs(a - b) <= settled * std::abs(a); };
    if (std::ranges::equal(x, before, is_settled)) break;
    for (size_t i = 0; i < rows.size(); ++i) {
      double error = -targets[i];
      for (size_t j = 0; j < x.size(); ++j) error += rows[i][j] * x[j];
      weights[i] = 1 / std::max(std::abs(error), small);
    }
  }
  return x;
}

}  // namespace lamina
