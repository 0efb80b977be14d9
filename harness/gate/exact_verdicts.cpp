// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/exact_verdicts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "harness/core/error.h"
#include "harness/gate/count_verdicts.h"

namespace lamina {
namespace {

constexpr double blank_range = 1e-4;  // below any difference that a display shows

struct Figure {
  const char* name;
  double ErrorFigures::*value;
  bool more_is_better;
  double ErrorTolerance::*tolerance;
  std::optional<double> ErrorLimits::*bound;
};
constexpr Figure figures[] = {
    {"psnr_db", &ErrorFigures::psnr_db, true, &ErrorTolerance::psnr_db, &ErrorLimits::min_psnr_db},
    {"ssim", &ErrorFigures::ssim, true, &ErrorTolerance::ssim, &ErrorLimits::min_ssim},
    {"flip", &ErrorFigures::flip, false, &ErrorTolerance::flip, &ErrorLimits::max_flip},
    {"rmse_linear", &ErrorFigures::rmse_linear, false, &ErrorTolerance::rmse_linear, &ErrorLimits::max_rmse_linear},
    {"max_linear", &ErrorFigures::max_linear, false, &ErrorTolerance::max_linear, &ErrorLimits::max_max_linear}};

// What errors are measured against.
struct Reference {
  const char* name;
  std::optional<ErrorFigures> CellRow::*error;
};
constexpr Reference to_baseline = {"baseline", &CellRow::error_covered}, to_truth = {"truth", &CellRow::error_truth};

// What the errors of a view came to.
struct ErrorsFound {
  bool better = false, worse = false;  // some of them
};

// `before` may be null, here and below: then only what holds for every picture is judged.
void judge_errors(const VerdictSubject& subject, const CellRow* before, const CellRow& after, const Reference& against,
                  const ErrorLimits& bounds, std::set<std::string>& changed, ErrorsFound& found) {
  const std::optional<ErrorFigures> old_error = before ? before->*against.error : std::nullopt;
  const std::optional<ErrorFigures>& new_error = after.*against.error;
  const std::string& view = after.view;
  if (!new_error) {
    if (!old_error) return;
    changed.insert("errors");
    subject.add(fmt::format("error to {}", against.name), Verdict::failed, Cause::error_lost, view, {against.name});
    return;
  }
  for (const Figure& figure : figures) {
    const std::string what = std::string(figure.name) + (against.error == to_truth.error ? " to truth" : "");
    const double now = (*new_error).*figure.value, sign = figure.more_is_better ? 1 : -1;
    const auto report = [&](Verdict verdict, Cause cause, std::optional<double> old_value, std::optional<double> limit) {
      changed.insert("errors");
      (verdict == Verdict::better ? found.better : found.worse) = true;
      VerdictRow& row = subject.add(what, verdict, cause, view);
      row.before = old_value, row.after = now, row.limit = limit;
    };
    if (const std::optional<double>& bound = bounds.*figure.bound; bound && sign * now < sign * *bound) {
      report(Verdict::failed, Cause::beyond_bound, old_error ? std::optional((*old_error).*figure.value) : std::nullopt, bound);
      continue;
    }
    if (!old_error) continue;
    const double was = (*old_error).*figure.value, tolerance = subject.limits.tolerance.*figure.tolerance;
    if (now == was || std::abs(now - was) <= tolerance) continue;
    const bool worse = sign * now < sign * was;
    report(worse ? Verdict::worse : Verdict::better, Cause::figures, was, was - sign * tolerance);
  }
}

bool shows_something(const CellRow& cell) { return cell.range_linear >= blank_range; }

// Whether the picture shows something, and something finite.
void judge_content(const VerdictSubject& subject, const CellRow* before, const CellRow& after, std::set<std::string>& changed) {
  const std::string& view = after.view;
  const uint64_t nonfinite = after.nonfinite_pixels.value_or(0), covered = after.covered_pixels.value_or(0);
  if (nonfinite > subject.limits.max_nonfinite_pixels) {
    changed.insert("nonfinite");
    VerdictRow& row = subject.add("nonfinite", Verdict::failed, Cause::not_finite, view);
    row.after = static_cast<double>(nonfinite), row.limit = static_cast<double>(subject.limits.max_nonfinite_pixels);
  }
  if (!before) return;
  const uint64_t covered_before = before->covered_pixels.value_or(0);
  if (covered == 0 && covered_before > 0) {
    changed.insert("blank");
    subject.add("blank", Verdict::failed, Cause::covers_nothing, view, {std::to_string(covered_before)});
  } else if (shows_something(*before) && !shows_something(after) && nonfinite == 0) {
    changed.insert("blank");
    subject.add("blank", Verdict::failed, Cause::one_colour, view);
  }
}

// Whether it is the picture that was there before.
void judge_change(const VerdictSubject& subject, const CellRow& before, const CellRow& after,
                  const std::optional<double>& change, bool hashes_tell, const ErrorsFound& errors,
                  std::set<std::string>& changed) {
  const std::string& view = after.view;
  const bool same_hash = before.image_hash == after.image_hash;
  if (subject.limits.same_image && !same_hash) {
    changed.insert("image_hash");
    subject.add("image_hash", Verdict::failed, Cause::another_hash, view);
  }
  const double most = subject.limits.max_picture_change;
  if (same_hash || after.nonfinite_pixels.value_or(0) > 0 || (change ? *change <= most : !hashes_tell)) return;
  if (errors.better && !errors.worse) return;
  changed.insert("picture");
  VerdictRow& row =
      subject.add("picture", Verdict::worse, after.baseline ? Cause::baseline_changed : Cause::changed_for_nothing, view);
  row.after = change;
  if (change) row.limit = most;
}

// A variant that was not there before.
void judge_presence(const VerdictSubject& subject, const CellPair& pair) {
  subject.add("cell", Verdict::not_compared, Cause::new_variant);
  const auto drawn = [](const std::optional<CellRow>& cell) { return cell && !cell->failed; };
  const auto covers = [&](const std::optional<CellRow>& cell) { return drawn(cell) && cell->covered_pixels.value_or(0) > 0; };
  if (std::ranges::any_of(pair.after, drawn) && std::ranges::none_of(pair.after, covers))
    subject.add("blank", Verdict::failed, Cause::covers_nothing_anywhere);
}

// Views that gave different pictures and now give one: a frame that is not drawn again.
void judge_staleness(const VerdictSubject& subject, const CellPair& pair, std::set<std::string>& changed) {
  for (size_t i = 0; i < pair.after.size(); ++i)
    for (size_t j = i + 1; j < pair.after.size(); ++j) {
      const std::optional<CellRow>&a = pair.after[i], &b = pair.after[j];
      if (!a || !b || !pair.before[i] || !pair.before[j]) continue;
      if (a->image_hash != b->image_hash || a->image_hash.empty()) continue;
      if (pair.before[i]->image_hash == pair.before[j]->image_hash) continue;
      changed.insert("blank");
      subject.add("stale", Verdict::failed, Cause::one_picture, "", {a->view, b->view});
    }
}

}  // namespace

double max_change(const Image& picture, const Image& before, bool alpha) {
  if (before.width != picture.width || before.height != picture.height)
    throw Error(ErrorKind::failed, "gate", "picture", "the pictures before and after are of different sizes");
  double most = 0;
  for (size_t i = 0; i < picture.rgba.size(); ++i)
    if (alpha || i % 4 != 3) most = std::max(most, std::abs(double{picture.rgba[i]} - double{before.rgba[i]}));
  return most;
}

std::vector<VerdictRow> judge_cells(const CellPair& pair, const Limits& limits) {
  std::vector<VerdictRow> rows;
  const auto present = [](const std::vector<std::optional<CellRow>>& cells) {
    return std::ranges::find_if(cells, [](const std::optional<CellRow>& cell) { return cell.has_value(); });
  };
  const bool all_new = present(pair.before) == pair.before.end();
  const CellRow& example = **(all_new ? present(pair.after) : present(pair.before));
  VerdictSubject subject{limits, {}, rows};
  subject.blank.backend = example.backend, subject.blank.effect = example.effect, subject.blank.variant = example.variant;
  std::set<std::string> changed;
  size_t compared = 0;
  for (size_t i = 0; i < pair.after.size(); ++i) {
    const std::optional<CellRow>&before = pair.before[i], &after = pair.after[i];
    if (!after) {
      subject.add("cell", Verdict::failed, Cause::gone, before->view);
    } else if (after->failed) {
      subject.add("cell", Verdict::failed, Cause::cannot_be_measured, after->view, {after->reason});
    } else {
      const CellRow* was = before && !before->failed ? &*before : nullptr;
      if (was) {
        ++compared;
        judge_counts(subject, *was, *after, changed);
      } else if (!all_new) {
        subject.add("cell", Verdict::not_compared, before ? Cause::failed_before : Cause::new_view, after->view);
      }
      ErrorsFound errors;
      judge_errors(subject, was, *after, to_baseline, limits.baseline, changed, errors);
      judge_errors(subject, was, *after, to_truth, limits.truth, changed, errors);
      judge_content(subject, was, *after, changed);
      judge_work_bounds(subject, *after);
      const std::optional<double> change = i < pair.changes.size() ? pair.changes[i] : std::nullopt;
      if (was) judge_change(subject, *was, *after, change, pair.hashes_tell, errors, changed);
    }
  }
  if (all_new) judge_presence(subject, pair);
  judge_staleness(subject, pair, changed);
  std::vector<const char*> kinds = {"fetches", "errors", "nonfinite", "blank"};
  if (std::ranges::any_of(pair.after, [](const std::optional<CellRow>& cell) { return cell && counts_operations(*cell); }))
    kinds.push_back("operations");
  if (compared > 0)
    for (const char* what : kinds)
      if (!changed.contains(what)) subject.add(what, Verdict::same, Cause::as_before, "", {std::to_string(compared)});
  return rows;
}

}  // namespace lamina
