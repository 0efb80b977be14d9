// SPDX-License-Identifier: Apache-2.0
// Choices on one backend: drawn, held against the baseline or the truth, counted and timed.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/choose/choice.h"
#include "harness/cli/cell.h"
#include "harness/cli/ready_frame.h"
#include "harness/cli/scene_on_device.h"
#include "harness/cli/truth_run.h"
#include "harness/measure/rounds.h"

namespace lamina {

// The variants of an effect that may be chosen, the baseline first.
struct ChosenEffect {
  const EffectManifest* effect = nullptr;
  std::vector<const VariantManifest*> options;
};

class ChoiceRun {
 public:
  // Everything must outlive this. `to_truth`: errors are taken to the truth of the only effect. Draws the baselines. Throws
  // Error where they cannot be drawn, or are no picture.
  ChoiceRun(Backend& backend, const SceneOnDevice& there, const std::vector<ChosenEffect>& effects, ShaderCache& shaders,
            const CellOptions& options, bool to_truth, const Tell& tell);
  ~ChoiceRun();

  // The errors in every view; times are 0. Throws Error where a variant does not run or leaves no picture.
  Outcome errors_of(const Choice& choice);
  // By view, the passes with their counts. Throws likewise.
  std::vector<std::vector<PassRow>> counts_of(const Choice& choice);
  // Interleaved rounds of all of them in all views. [choice][view][round] ms, the rounds paired.
  std::vector<std::vector<std::vector<double>>> times_of(const std::vector<Choice>& choices, const RoundOptions& rounds);
  // The same of the baselines, and of these without one effect, whose objects are then not drawn at all.
  std::vector<std::vector<std::vector<double>>> times_without(const EffectManifest& effect, const RoundOptions& rounds);

 private:
  struct Drawn {
    Image picture;
    Mask covered;  // by any of the effects
  };
  Configuration configuration_of(const Choice& choice) const;
  ReadyFrame& ready(const Choice& choice);
  Choice baseline() const { return Choice(effects_.size(), 0); }

  Backend& backend_;
  const SceneOnDevice there_;
  const std::vector<ChosenEffect> effects_;
  ShaderCache& shaders_;
  const CellOptions options_;
  const Tell tell_;
  std::unique_ptr<TruthRun> truth_;  // null: errors are taken to the baseline
  std::map<Choice, std::unique_ptr<ReadyFrame>> ready_;
  std::vector<Drawn> baselines_;  // by view
};

}  // namespace lamina
