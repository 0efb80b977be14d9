// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/truth_run.h"

#include <algorithm>

namespace lamina {
namespace {

// `around` with the answer's pixels lit.
Image with_light(const Image& around, const TruthAnswer& answer, const std::vector<glm::vec3>& light) {
  Image image = around;
  for (size_t i = 0; i < answer.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) image.rgba[4 * answer.pixels[i] + c] = light[i][c];
  return image;
}

Mask covered_by(const TruthAnswer& answer, const Image& picture) {
  Mask mask{picture.width, picture.height, {}};
  mask.on.assign(size_t(picture.width) * size_t(picture.height), 0);
  for (const size_t pixel : answer.pixels) mask.on[pixel] = 1;
  return mask;
}

}  // namespace

TruthRun::TruthRun(SceneResources& resources, const Plan& plan, const EffectManifest& effect, ShaderCache& shaders,
                   Bakes& bakes, const CellOptions& options)
    : resources_(resources), plan_(plan), effect_(effect), shaders_(shaders), bakes_(bakes), options_(options) {}

// The variant itself where it has passes for the truth, else the one that has them and the same bake options.
const VariantManifest* TruthRun::teller(const VariantManifest& variant) const {
  if (effect_.truth.empty() || !plan_.of(effect_.name)->called_for) return nullptr;
  if (has_truth_passes(variant)) return &variant;
  for (const VariantManifest& candidate : effect_.variants)
    if (candidate.bake == variant.bake && has_truth_passes(candidate)) return &candidate;
  return nullptr;
}

void TruthRun::forget() {
  answers_.clear();
  if (truth_) truth_->scene_changed();
}

TruthRun::Answered& TruthRun::answered(const VariantManifest& told, size_t view, const std::function<void(double)>& progress) {
  if (view != view_) {
    view_ = view;
    answers_.clear();
    if (truth_) truth_->view_changed();
  }
  const auto [entry, is_new] = answers_.try_emplace(&told);
  Answered& made = entry->second;
  if (!is_new) return made;
  if (!truth_)
    truth_ = plan_.library->code->truths.at(effect_.truth)(
        {resources_.scene(), bakes_.occluders(), bakes_.cache(), options_.truth_rays});
  if (!frames_[&told]) {
    graphs_[&told] =
        std::make_unique<Graph>(make_graph(plan_, configuration_with(plan_, told), resources_.scene(), shaders_, &told));
    frames_[&told] = std::make_unique<Frame>(resources_, *graphs_[&told], Build::timed, TargetSharing::off);
    frames_[&told]->run_once(Timing::off);
  }
  Frame& frame = *frames_[&told];
  frame.run(view, Timing::off);
  const std::map<std::string, Image> targets = frame.targets_of(told);
  made.answer = truth_->answer({targets, resources_.scene().views[view], told.bake}, progress);
  return made;
}

void TruthRun::score(const VariantManifest& variant, size_t view, const Image& picture, CellRow& row, const KeepPicture& keep,
                     const std::function<void(double)>& progress) {
  const VariantManifest* told = teller(variant);
  if (!told || options_.truth_rays == 0) return;
  Answered& with = answered(*told, view, progress);
  const std::vector<TruthStep>& steps = with.answer.steps;
  if (with.answer.pixels.empty() || steps.empty()) return;
  const Mask covered = covered_by(with.answer, picture);
  const auto lit_by = [&](const TruthStep& step) { return with_light(picture, with.answer, step.light); };
  const auto assumption = [&](const TruthStep& step, const Image& made, const Image& without) {
    AssumptionRow found{step.name, step.title, measure_error(made, without, covered).covered, ""};
    if (keep) found.image = keep("-" + step.name, difference_picture(to_display(made), to_display(without), difference_gain));
    return found;
  };
  const Image first = lit_by(steps.front()), truth = lit_by(steps.back());
  row.error_truth = measure_error(picture, truth, covered).covered;
  row.assumptions = {assumption(steps.front(), picture, first)};
  if (!with.has_shared) {
    with.has_shared = true;
    for (size_t i = 1; i < steps.size(); ++i)
      with.shared.push_back(assumption(steps[i], lit_by(steps[i - 1]), lit_by(steps[i])));
    if (keep) with.image = keep("-truth", to_display(truth));
  }
  row.assumptions.insert(row.assumptions.end(), with.shared.begin(), with.shared.end());
  row.truth_image = with.image;
}

}  // namespace lamina
