// SPDX-License-Identifier: Apache-2.0
// Configurations on one backend: drawn, held against the baselines or the truth, counted and timed.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/choose/choice.h"
#include "harness/cli/cell.h"
#include "harness/cli/progress.h"
#include "harness/cli/ready_frame.h"
#include "harness/cli/scene_on_device.h"
#include "harness/cli/truth_run.h"
#include "harness/measure/rounds.h"

namespace lamina {

class ChoiceRun {
 public:
  static constexpr size_t max_ready = 8;  // frames that are kept: each holds its targets
  // By view and round, ms.
  using Times = std::vector<std::vector<double>>;

  // Everything must outlive this. Errors are taken over the pixels that any of `effects` covers; `to_truth`: to the truth of
  // the first, else to the baselines. Draws the baselines. Throws Error where they cannot be drawn, or are no picture.
  ChoiceRun(const SceneOnDevice& there, const std::vector<const EffectManifest*>& effects, ShaderCache& shaders,
            const CellOptions& options, bool to_truth, const Tell& tell);
  ~ChoiceRun();

  // The errors in every view; times are 0. Throws Error where a variant does not run or leaves no picture.
  Outcome errors_of(const Configuration& configuration);
  // By view, the passes with their counts. Throws likewise.
  std::vector<std::vector<PassRow>> counts_of(const Configuration& configuration);
  // Interleaved rounds of all of them, fewer than max_ready, in all views: rounds are paired.
  std::vector<Times> times_of(const std::vector<Configuration>& configurations, const RoundOptions& rounds);
  // The same of the baselines, and of these without one effect, whose objects are then not drawn at all.
  std::vector<Times> times_without(const EffectManifest& effect, const RoundOptions& rounds);

 private:
  struct Drawn {
    Image picture;
    Mask covered;  // by any of the effects
  };
  ReadyFrame& ready(const Configuration& configuration);
  Configuration baselines() const { return configuration_of(*there_.plan, {}); }

  const SceneOnDevice there_;
  ShaderCache& shaders_;
  const CellOptions options_;
  const Tell tell_;
  std::unique_ptr<TruthRun> truth_;  // null: errors are taken to the baselines
  const EffectManifest& first_;      // of the effects
  std::map<Configuration, std::unique_ptr<ReadyFrame>> ready_;
  std::vector<Drawn> baselines_;  // by view
};

}  // namespace lamina
