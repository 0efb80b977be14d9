// SPDX-License-Identifier: Apache-2.0
// The truth of an effect on one backend: what each pixel shows is asked of the device, the light there is computed offline, and
// pictures are scored against it; and against it with one assumption of the effect at a time.
#pragma once

#include <functional>
#include <map>
#include <memory>

#include "harness/cli/cell.h"
#include "harness/graph/frame.h"
#include "harness/record/record.h"
#include "harness/truth/truth.h"

namespace lamina {

class TruthRun {
 public:
  // Everything must outlive this.
  TruthRun(SceneResources& resources, const Plan& plan, const EffectManifest& effect, ShaderCache& shaders, Bakes& bakes,
           const CellOptions& options);

  // The scene's numbers have changed: what was answered is another scene's.
  void forget();
  // Fills in the row's truth and assumptions, where the effect has a truth for variants like this one and this view shows any
  // of it. `picture`: the variant's, of this view, all finite.
  void score(const VariantManifest& variant, size_t view, const Image& picture, CellRow& row, const KeepPicture& keep,
             const std::function<void(double)>& progress);

 private:
  // What a view shows, as one variant's passes for the truth draw it.
  struct Answered {
    TruthAnswer answer;
    std::vector<AssumptionRow> shared;  // the assumptions of all variants with the same truth passes
    std::string image;
    bool has_shared = false;
  };
  const VariantManifest* teller(const VariantManifest& variant) const;
  Answered& answered(const VariantManifest& told, size_t view, const std::function<void(double)>& progress);

  SceneResources& resources_;
  const Plan& plan_;
  const EffectManifest& effect_;
  ShaderCache& shaders_;
  Bakes& bakes_;
  const CellOptions& options_;
  std::unique_ptr<Truth> truth_;  // started when it is first asked
  std::map<const VariantManifest*, std::unique_ptr<Graph>> graphs_;
  std::map<const VariantManifest*, std::unique_ptr<Frame>> frames_;
  size_t view_ = 0;  // that answers are kept of
  std::map<const VariantManifest*, Answered> answers_;
};

}  // namespace lamina
