// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/choice_run.h"

#include "harness/quality/judged_picture.h"

namespace lamina {
namespace {

constexpr size_t max_ready = 8;  // frames that are kept: each holds its targets

// Views in which nothing is covered show no error, and none is asked of them.
constexpr ErrorFigures no_error = {
    .psnr_db = std::numeric_limits<double>::infinity(), .ssim = 1, .flip = 0, .rmse_linear = 0, .max_linear = 0};

[[noreturn]] void refuse_picture(const View& view, const std::string& why) {
  throw Error(ErrorKind::failed, "choose", "view " + view.name, std::string(no_picture) + why);
}

// [frame][view][round]
std::vector<std::vector<std::vector<double>>> timed(const std::vector<Frame*>& frames, size_t views,
                                                    const RoundOptions& rounds) {
  std::vector<Arm> arms;
  for (Frame* frame : frames)
    for (size_t view = 0; view < views; ++view)
      arms.push_back({[frame, view] { return frame->run(view, Timing::bracketed); },
                      frame == frames.front() ? std::optional<size_t>() : view});
  const RoundsResult result = run_rounds(arms, rounds);
  std::vector<std::vector<std::vector<double>>> times(frames.size());
  for (size_t i = 0; i < arms.size(); ++i) {
    if (!result.arms[i].failure.empty()) throw Error(ErrorKind::failed, "choose", "timing", result.arms[i].failure);
    times[i / views].push_back(result.arms[i].frame_ms);
  }
  return times;
}

}  // namespace

ChoiceRun::ChoiceRun(Backend& backend, const SceneOnDevice& there, const std::vector<ChosenEffect>& effects,
                     ShaderCache& shaders, const CellOptions& options, bool to_truth, const Tell& tell)
    : backend_(backend), there_(there), effects_(effects), shaders_(shaders), options_(options), tell_(tell) {
  if (to_truth)
    truth_ =
        std::make_unique<TruthRun>(*there.resources, *there.plan, *effects.front().effect, shaders, *there.bakes, options_);
  ReadyFrame& frame = ready(baseline());
  Frame counting(*there.resources, frame.graph, Build::counting);
  counting.run_once(Timing::off);
  for (size_t view = 0; view < there.scene->views.size(); ++view) {
    counting.run(view, Timing::off);
    Mask covered = counting.coverage(effects_.front().effect->name);
    for (const ChosenEffect& effect : effects_) covered = either(covered, counting.coverage(effect.effect->name));
    frame.frame.run(view, Timing::off);
    baselines_.push_back({frame.frame.picture(), std::move(covered)});
    if (const std::string why = why_not_finite(baselines_.back().picture); !why.empty())
      refuse_picture(there.scene->views[view], why);
  }
}

ChoiceRun::~ChoiceRun() = default;

Configuration ChoiceRun::configuration_of(const Choice& choice) const {
  std::map<std::string, const VariantManifest*, std::less<>> variants;
  for (size_t i = 0; i < effects_.size(); ++i) variants[effects_[i].effect->name] = effects_[i].options[choice[i]];
  return lamina::configuration_of(*there_.plan, variants);
}

ReadyFrame& ChoiceRun::ready(const Choice& choice) {
  if (const auto known = ready_.find(choice); known != ready_.end()) return *known->second;
  if (ready_.size() >= max_ready) std::erase_if(ready_, [&](const auto& entry) { return entry.first != baseline(); });
  return *(ready_[choice] = std::make_unique<ReadyFrame>(*there_.resources, *there_.plan, configuration_of(choice), shaders_));
}

Outcome ChoiceRun::errors_of(const Choice& choice) {
  Outcome outcome;
  ReadyFrame& frame = ready(choice);
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
    truth_->score(*effects_.front().options[choice.front()], view, picture, row, {},
                  [&](double fraction) { tell_(fraction, "casting rays for the truth of view " + seen.name); });
    if (row.error_truth) error = *row.error_truth;
  }
  return outcome;
}

std::vector<std::vector<PassRow>> ChoiceRun::counts_of(const Choice& choice) {
  Frame counting(*there_.resources, ready(choice).graph, Build::counting);
  counting.run_once(Timing::off);
  const std::vector<PassCounts> once = counting.once_counts();
  std::vector<std::vector<PassRow>> passes;
  for (size_t view = 0; view < baselines_.size(); ++view) {
    CellRow row;
    count_cell(row, counting, once, *effects_.front().options[choice.front()], view);
    passes.push_back(std::move(row.passes));
  }
  return passes;
}

std::vector<std::vector<std::vector<double>>> ChoiceRun::times_of(const std::vector<Choice>& choices,
                                                                  const RoundOptions& rounds) {
  std::vector<std::unique_ptr<ReadyFrame>> made;  // these at least live until the rounds have ended
  std::vector<Frame*> frames;
  for (const Choice& choice : choices) {
    made.push_back(std::make_unique<ReadyFrame>(*there_.resources, *there_.plan, configuration_of(choice), shaders_));
    frames.push_back(&made.back()->frame);
  }
  return timed(frames, baselines_.size(), rounds);
}

std::vector<std::vector<std::vector<double>>> ChoiceRun::times_without(const EffectManifest& effect,
                                                                       const RoundOptions& rounds) {
  Plan without = *there_.plan;
  for (EffectPlan& entry : without.effects)
    if (entry.effect == &effect) entry.called_for = false;
  ReadyFrame left(*there_.resources, without, lamina::configuration_of(without, {}), shaders_);
  return timed({&ready(baseline()).frame, &left.frame}, baselines_.size(), rounds);
}

}  // namespace lamina
