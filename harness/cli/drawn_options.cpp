// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/drawn_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/measure/statistics.h"

namespace lamina {
namespace {

constexpr double doubt_without = 0.05;  // of times that were measured
constexpr double max_doubt = 0.5;

// A variant, and the same with each of the values that its manifest says to try, one parameter at a time.
std::vector<std::pair<std::string, const VariantManifest*>> tried(const VariantManifest& variant,
                                                                  std::list<VariantManifest>& derived) {
  std::vector<std::pair<std::string, const VariantManifest*>> all = {{variant.name, &variant}};
  for (const ParameterManifest& parameter : variant.parameters)
    for (const double value : parameter.tries) {
      if (value == parameter.value) continue;
      derived.push_back(variant.with_defaults({{parameter.name, value}}));
      all.emplace_back(fmt::format("{} ({} {})", variant.name, parameter.name,
                                   parameter.words.empty() ? fmt::format("{}", value) : parameter.text(value)),
                       &derived.back());
    }
  return all;
}

// One option drawn alone, and its time: by the model from its counts, or without a model by the fewest rounds.
class Singles {
 public:
  Singles(const Plan& plan, ChoiceRun& run, const std::optional<CostModel>& model, const RoundOptions& rounds)
      : plan_(plan), run_(run), model_(model), fewest_(rounds), baselines_(configuration_of(plan, {})) {
    fewest_.budget_s = 0;
    base_ = run.errors_of(baselines_);
    const ChoiceRun::Times times = run.times_of({baselines_}, rounds).front();
    for (size_t view = 0; view < base_.size(); ++view) base_[view].ms = median(times[view]);
    if (model) base_counts_ = run.counts_of(baselines_);
  }
  const Outcome& baseline() const { return base_; }

  // Throws Error where it does not run or leaves no picture.
  Outcome of(const VariantManifest& variant) {
    const Configuration alone = configuration_with(plan_, variant);
    Outcome single = run_.errors_of(alone);
    if (!model_) {
      const std::vector<ChoiceRun::Times> times = run_.times_of({baselines_, alone}, fewest_);
      set_times(single, times[1], times[0], base_);
      return single;
    }
    const auto counts = run_.counts_of(alone);
    for (size_t view = 0; view < single.size(); ++view) {
      const double before = predicted_ms(*model_, base_counts_[view]), after = predicted_ms(*model_, counts[view]);
      single[view].ms = base_[view].ms * (before > 0 ? after / before : 1);
    }
    return single;
  }

 private:
  const Plan& plan_;
  ChoiceRun& run_;
  const std::optional<CostModel>& model_;
  RoundOptions fewest_;
  const Configuration baselines_;
  Outcome base_;
  std::vector<std::vector<PassRow>> base_counts_;
};

}  // namespace

void set_times(Outcome& outcome, const ChoiceRun::Times& times, const ChoiceRun::Times& baselines,
               const Outcome& of_baselines) {
  for (size_t view = 0; view < outcome.size(); ++view)
    outcome[view].ms = of_baselines[view].ms * ratio_interval(times[view], baselines[view]).median;
}

DrawnOptions draw_options(const std::vector<const EffectManifest*>& effects, const Plan& plan, ChoiceRun& run,
                           const std::optional<CostModel>& model, const RoundOptions& rounds, const Tell& tell) {
  DrawnOptions search{.effects = effects};
  Singles singles(plan, run, model, rounds);
  search.space.baseline = singles.baseline();
  for (const EffectManifest* effect : effects) {
    std::vector<const VariantManifest*>& kept = search.options.emplace_back();
    kept.push_back(&effect->baseline());
    std::vector<ChoiceOption>& options = search.space.effects.emplace_back(ChoiceEffect{effect->name, {}}).options;
    options.push_back({effect->baseline().name, singles.baseline()});
    for (const VariantManifest& variant : effect->variants)
      for (const auto& [name, option] : tried(variant, search.derived)) {
        if (option == &effect->baseline()) continue;
        tell(static_cast<double>(search.options.size() - 1) / static_cast<double>(effects.size()), "drawing " + name);
        try {
          options.push_back({name, singles.of(*option)});
          kept.push_back(option);
        } catch (const Error& error) {
          search.left_out.push_back(fmt::format("{}: {}", name, error.what()));
        }
      }
  }
  search.doubt = model ? std::clamp(2 * model->judged.mean_error, doubt_without, max_doubt) : doubt_without;
  return search;
}

}  // namespace lamina
