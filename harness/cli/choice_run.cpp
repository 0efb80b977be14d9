// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/choice_run.h"

#include <algorithm>
#include <limits>

#include "harness/quality/judged_picture.h"

namespace lamina {
namespace {

// Views in which nothing is covered show no error, and none is asked of them.
constexpr ErrorFigures no_error = {
    .psnr_db = std::numeric_limits<double>::infinity(), .ssim = 1, .flip = 0, .rmse_linear = 0, .max_linear = 0};

[[noreturn]] void refuse_picture(const View& view, const std::string& why) {
  throw Error(ErrorKind::failed, "choose", "view " + view.name, std::string(no_picture) + why);
}

std::vector<ChoiceRun::Times> timed(const std::vector<Frame*>& frames, size_t views, const RoundOptions& rounds) {
  std::vector<Arm> arms;
  for (size_t i = 0; i < frames.size(); ++i)
    for (size_t view = 0; view < views; ++view)
      arms.push_back(
          {[frame = frames[i], view] { return frame->run(view, Timing::bracketed); }, i == 0 ? std::optional<size_t>() : view});
  const RoundsResult result = run_rounds(arms, rounds);
  std::vector<ChoiceRun::Times> times(frames.size());
  for (size_t i = 0; i < arms.size(); ++i) {
    if (!result.arms[i].failure.empty()) throw Error(ErrorKind::failed, "choose", "timing", result.arms[i].failure);
    times[i / views].push_back(result.arms[i].frame_ms);
  }
  return times;
}

const VariantManifest& variant_of(const Configuration& configuration, const EffectManifest& effect) {
  return **std::ranges::find(configuration, effect.name, [](const VariantManifest* variant) { return variant->effect; });
}

}  // namespace

ChoiceRun::ChoiceRun(const SceneOnDevice& there, const std::vector<const EffectManifest*>& effects, ShaderCache& shaders,
                     const CellOptions& options, bool to_truth, const Tell& tell)
    : there_(there), shaders_(shaders), options_(options), tell_(tell), first_(*effects.front()) {
  if (to_truth) truth_ = std::make_unique<TruthRun>(*there.resources, *there.plan, first_, shaders, *there.bakes, options_);
  ReadyFrame& frame = ready(baselines());
  Frame counting(*there.resources, frame.graph, Build::counting);
  counting.run_once(Timing::off);
  for (size_t view = 0; view < there.scene->views.size(); ++view) {
    counting.run(view, Timing::off);
    Mask covered = counting.coverage(first_.name);
    for (const EffectManifest* effect : effects) covered = either(covered, counting.coverage(effect->name));
    frame.frame.run(view, Timing::off);
    baselines_.push_back({frame.frame.picture(), std::move(covered)});
    if (const std::string why = why_not_finite(baselines_.back().picture); !why.empty())
      refuse_picture(there.scene->views[view], why);
  }
}

ChoiceRun::~ChoiceRun() = default;

// The baselines' frame is kept: it stands in every batch.
ReadyFrame& ChoiceRun::ready(const Configuration& configuration) {
  if (!ready_.contains(configuration) && ready_.size() >= max_ready)
    std::erase_if(ready_, [&](const auto& entry) { return entry.first != baselines(); });
  std::unique_ptr<ReadyFrame>& frame = ready_[configuration];
  if (!frame) frame = std::make_unique<ReadyFrame>(*there_.resources, *there_.plan, configuration, shaders_);
  return *frame;
}

Outcome ChoiceRun::errors_of(const Configuration& configuration) {
  Outcome outcome;
  ReadyFrame& frame = ready(configuration);
  for (size_t view = 0; view < baselines_.size(); ++view) {
    const View& seen = there_.scene->views[view];
    const Drawn& baseline = baselines_[view];
    frame.frame.run(view, Timing::off);
    const Image picture = frame.frame.picture();
    if (const std::string why = why_not_finite(picture); !why.empty()) refuse_picture(seen, why);
    ErrorFigures& error = outcome.emplace_back().error;
    error = no_error;
    if (count_on(baseline.covered) == 0) continue;
    if (const std::string why =
            why_no_picture({picture, baseline.covered}, {baseline.picture, baseline.covered}, there_.scene->background);
        !why.empty())
      refuse_picture(seen, why);
    if (!truth_) {
      error = measure_error(picture, baseline.picture, baseline.covered).covered;
      continue;
    }
    CellRow row;
    truth_->score(variant_of(configuration, first_), view, picture, row, {},
                  [&](double fraction) { tell_(fraction, "casting rays for the truth of view " + seen.name); });
    if (row.error_truth) error = *row.error_truth;
  }
  return outcome;
}

std::vector<std::vector<PassRow>> ChoiceRun::counts_of(const Configuration& configuration) {
  Frame counting(*there_.resources, ready(configuration).graph, Build::counting);
  counting.run_once(Timing::off);
  const std::vector<PassCounts> once = counting.once_counts();
  std::vector<std::vector<PassRow>> passes;
  for (size_t view = 0; view < baselines_.size(); ++view) {
    CellRow row;
    count_cell(row, counting, once, variant_of(configuration, first_), view);
    passes.push_back(std::move(row.passes));
  }
  return passes;
}

std::vector<ChoiceRun::Times> ChoiceRun::times_of(const std::vector<Configuration>& configurations,
                                                  const RoundOptions& rounds) {
  std::erase_if(ready_, [&](const auto& entry) {
    return entry.first != baselines() && std::ranges::find(configurations, entry.first) == configurations.end();
  });
  std::vector<Frame*> frames;
  for (const Configuration& configuration : configurations) frames.push_back(&ready(configuration).frame);
  return timed(frames, baselines_.size(), rounds);
}

std::vector<ChoiceRun::Times> ChoiceRun::times_without(const EffectManifest& effect, const RoundOptions& rounds) {
  Plan without = *there_.plan;
  for (EffectPlan& entry : without.effects)
    if (entry.effect == &effect) entry.called_for = false;
  ReadyFrame left(*there_.resources, without, configuration_of(without, {}), shaders_);
  return timed({&ready(baselines()).frame, &left.frame}, baselines_.size(), rounds);
}

}  // namespace lamina
