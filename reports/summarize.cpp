// SPDX-License-Identifier: Apache-2.0
// A record's cells to one row for each variant and backend.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "reports/reports.h"
#include "reports/words.h"

namespace lamina {
namespace {

// What identifies a picture apart from who made it, so that a variant's cell finds the baseline's.
using Shot = std::tuple<std::string, int, int, std::string, std::string>;
using Samples = std::map<Shot, std::vector<double>>;  // the frame's time of each round, ms

Shot shot_of(const CellRow& cell) {
  return {cell.scene, cell.width, cell.height, nlohmann::json(cell.params).dump(), cell.view};
}

struct Group {
  SummaryRow row;
  size_t first_cell = 0;             // order of appearance
  std::vector<const CellRow*> good;  // cells that did not fail
  Samples samples;                   // of the good cells that were timed
};

// Of each round that every shot has: the sum of the shots' times.
std::vector<double> sum_ms(const Samples& samples, const std::vector<Shot>& shots) {
  size_t rounds = shots.empty() ? 0 : std::numeric_limits<size_t>::max();
  for (const Shot& shot : shots) rounds = std::min(rounds, samples.at(shot).size());
  std::vector<double> sums(rounds, 0.0);
  for (const Shot& shot : shots)
    for (size_t round = 0; round < rounds; ++round) sums[round] += samples.at(shot)[round];
  return sums;
}

std::vector<double> mean_frame_ms(const Samples& samples) {
  std::vector<Shot> shots;
  for (const auto& [shot, unused] : samples) shots.push_back(shot);
  std::vector<double> means = sum_ms(samples, shots);
  for (double& mean : means) mean /= static_cast<double>(shots.size());
  return means;
}

std::optional<Interval> ratio_of(const Samples& variant, const Samples& baseline) {
  std::vector<Shot> shots;
  for (const auto& [shot, unused] : variant)
    if (baseline.contains(shot)) shots.push_back(shot);
  std::vector<double> a = sum_ms(variant, shots), b = sum_ms(baseline, shots);
  const size_t rounds = std::min(a.size(), b.size());
  a.resize(rounds), b.resize(rounds);
  if (rounds == 0 || std::any_of(b.begin(), b.end(), [](double ms) { return ms <= 0; })) return std::nullopt;
  if (rounds >= min_rounds_for_95) return ratio_interval(a, b);
  for (size_t round = 0; round < rounds; ++round) a[round] /= b[round];
  return interval_or_range(std::move(a));
}

std::optional<double> fetches_per_pixel(const std::vector<const CellRow*>& cells) {
  double fetches = 0, pixels = 0;
  for (const CellRow* cell : cells) {
    if (!cell->fetches || !cell->covered_pixels) return std::nullopt;
    fetches += static_cast<double>(*cell->fetches);
    pixels += static_cast<double>(*cell->covered_pixels);
  }
  if (pixels == 0) return std::nullopt;
  return fetches / pixels;
}

struct Errors {
  std::optional<ErrorFigures> mean, worst;
  std::string worst_view;
};

Errors errors_of(const std::vector<const CellRow*>& cells, std::optional<ErrorFigures> CellRow::*against) {
  size_t count = 0;
  ErrorFigures sum;  // psnr_db holds the sum of squared errors, relative to the peak's square
  ErrorFigures worst{.psnr_db = std::numeric_limits<double>::infinity(), .ssim = 1};
  double worst_flip = -1;  // below every figure, so that the first view is taken
  Errors errors;
  for (const CellRow* cell : cells) {
    const std::optional<ErrorFigures>& figures = cell->*against;
    if (!figures) continue;
    ++count;
    sum.psnr_db += std::pow(10.0, -figures->psnr_db / 10);  // 0 for identical pictures
    sum.ssim += figures->ssim;
    sum.flip += figures->flip;
    sum.rmse_linear += figures->rmse_linear;
    sum.max_linear += figures->max_linear;
    worst.psnr_db = std::min(worst.psnr_db, figures->psnr_db);
    worst.ssim = std::min(worst.ssim, figures->ssim);
    worst.rmse_linear = std::max(worst.rmse_linear, figures->rmse_linear);
    worst.max_linear = std::max(worst.max_linear, figures->max_linear);
    if (figures->flip > worst_flip) {
      worst.flip = worst_flip = figures->flip;
      errors.worst_view = cell->view;
    }
  }
  if (count == 0) return errors;
  const double n = static_cast<double>(count);
  errors.mean = ErrorFigures{.psnr_db = -10 * std::log10(sum.psnr_db / n),
                             .ssim = sum.ssim / n,
                             .flip = sum.flip / n,
                             .rmse_linear = sum.rmse_linear / n,
                             .max_linear = sum.max_linear / n};
  errors.worst = worst;
  return errors;
}

std::vector<Group> group_cells(const Record& record) {
  std::vector<Group> groups;
  for (size_t i = 0; i < record.cells.size(); ++i) {
    const CellRow& cell = record.cells[i];
    auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& known) {
      return known.row.effect == cell.effect && known.row.variant == cell.variant && known.row.backend == cell.backend;
    });
    if (group == groups.end()) {
      group = groups.insert(groups.end(), Group{});
      group->first_cell = i;
      group->row.effect = cell.effect;
      group->row.variant = cell.variant;
      group->row.backend = cell.backend;
      group->row.baseline = cell.baseline;
    }
    ++group->row.views;
    if (cell.failed) {
      if (++group->row.failed_views == 1) group->row.reason = cell.reason;
      continue;
    }
    group->good.push_back(&cell);
    group->row.max_alpha = std::max(group->row.max_alpha, cell.max_alpha.value_or(0));
    group->row.nonfinite_pixels += cell.nonfinite_pixels.value_or(0);
    if (std::vector<double> samples = shown_samples_ms(record, cell); !samples.empty())
      group->samples[shot_of(cell)] = std::move(samples);
  }
  return groups;
}

// Where the effect, then the effect's backend, first appears; then the baseline, then the variants.
void sort_groups(std::vector<Group>& groups) {
  std::map<std::string, size_t> effect_at;
  std::map<std::pair<std::string, std::string>, size_t> backend_at;
  for (const Group& group : groups) {
    effect_at.try_emplace(group.row.effect, group.first_cell);
    backend_at.try_emplace({group.row.effect, group.row.backend}, group.first_cell);
  }
  const auto place = [&](const Group& group) {
    return std::tuple(effect_at.at(group.row.effect), backend_at.at({group.row.effect, group.row.backend}), !group.row.baseline,
                      group.first_cell);
  };
  std::sort(groups.begin(), groups.end(), [&](const Group& a, const Group& b) { return place(a) < place(b); });
}

}  // namespace

std::vector<SummaryRow> summarize(const Record& record) {
  std::vector<Group> groups = group_cells(record);
  sort_groups(groups);
  std::vector<SummaryRow> rows;
  for (Group& group : groups) {
    SummaryRow& row = group.row;
    row.rounds_ms = mean_frame_ms(group.samples);
    if (!row.rounds_ms.empty()) row.frame_ms = interval_or_range(row.rounds_ms);
    row.fetches_per_pixel = fetches_per_pixel(group.good);
    const Errors to_baseline = errors_of(group.good, &CellRow::error_covered),
                 to_truth = errors_of(group.good, &CellRow::error_truth);
    row.mean = to_baseline.mean, row.worst = to_baseline.worst, row.worst_view = to_baseline.worst_view;
    row.mean_to_truth = to_truth.mean, row.worst_to_truth = to_truth.worst;
    if (row.mean) row.beyond_limit = beyond_limit(record, *row.mean);
    if (!row.baseline) {
      const auto baseline = std::find_if(groups.begin(), groups.end(), [&](const Group& other) {
        return other.row.baseline && other.row.effect == row.effect && other.row.backend == row.backend;
      });
      if (baseline != groups.end()) row.ratio = ratio_of(group.samples, baseline->samples);
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace lamina
