// SPDX-License-Identifier: Apache-2.0
// What `lamina choose` chooses from: the variants of the effects that a scene calls for, at their defaults and at the values
// that their manifests say to try, each drawn once alone.
#pragma once

#include <list>
#include <optional>
#include <string>
#include <vector>

#include "harness/choose/search.h"
#include "harness/cli/choice_run.h"
#include "harness/cli/progress.h"
#include "harness/cost/cost_model.h"

namespace lamina {

// The space that is searched, and what its options are.
struct DrawnOptions {
  std::vector<const EffectManifest*> effects;
  std::vector<std::vector<const VariantManifest*>> options;  // by effect, beside the space's
  std::list<VariantManifest> derived;                        // of these: with other parameters than the library's
  ChoiceSpace space;
  double doubt = 0;                   // by what share of its time a prediction may be wrong
  std::vector<std::string> left_out;  // variants that cannot be chosen, with the reason

  Choice baseline() const { return Choice(effects.size(), 0); }
  const VariantManifest& variant(const Choice& choice, size_t effect) const { return *options[effect][choice[effect]]; }
  const std::string& name(const Choice& choice, size_t effect) const {
    return space.effects[effect].options[choice[effect]].name;
  }
  Configuration chosen(const Choice& choice) const {
    Configuration variants;
    for (size_t e = 0; e < effects.size(); ++e) variants.push_back(&variant(choice, e));
    return variants;
  }
  Configuration configuration(const Plan& plan, const Choice& choice) const {
    std::map<std::string, const VariantManifest*, std::less<>> variants;
    for (size_t e = 0; e < effects.size(); ++e) variants[effects[e]->name] = &variant(choice, e);
    return configuration_of(plan, variants);
  }
};

// Draws each option alone, and tells its time: by the model from its counts, or without a model by the fewest rounds. Options
// that do not run, or leave no picture, are left out.
DrawnOptions draw_options(const std::vector<const EffectManifest*>& effects, const Plan& plan, ChoiceRun& run,
                          const std::optional<CostModel>& model, const RoundOptions& rounds, const Tell& tell);

// Medians of the rounds, in units of one time of the baselines, so that batches that ran at another speed agree.
void set_times(Outcome& outcome, const ChoiceRun::Times& times, const ChoiceRun::Times& baselines, const Outcome& of_baselines);

}  // namespace lamina
