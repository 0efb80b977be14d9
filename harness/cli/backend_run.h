// SPDX-License-Identifier: Apache-2.0
// All variants of one effect on one backend: rendered, counted, scored against the baseline, timed. What fails becomes a failed
// row; the rest goes on.
#pragma once

#include <memory>

#include "harness/cli/cell.h"
#include "harness/cli/ready_frame.h"
#include "harness/cli/truth_run.h"

namespace lamina {

class BackendRun {
 public:
  // Everything but the options must outlive this. `images` is the folder of the pictures within options.out; their paths in
  // rows begin with it.
  BackendRun(Backend& backend, SceneResources& resources, const Plan& plan, const EffectManifest& effect, ShaderCache& shaders,
             Bakes& bakes, const CellOptions& options, const std::string& images);

  // A picture as it is scored, the baseline's before the others of its view.
  struct Scored {
    const VariantManifest& variant;
    size_t view;
    const Image& picture;
    const Mask& covered;
  };
  // Told of each; gives a row whose errors to the baseline are known to be this one's, or null.
  using Known = std::function<const CellRow*(const Scored&)>;

  void prepare(Progress& progress);                         // pipelines and targets, the first view; what is done once
  void count(Progress& progress);                           // by the counting build
  void score(Progress& progress, const Known& known = {});  // pictures, and their errors; before time()
  RoundsResult time(const RoundOptions& rounds, Progress& progress, bool timer_ok);

  // The variant's frame; null where it failed or is not compared.
  ReadyFrame* frame(std::string_view variant);

  // One row a variant and view, the baseline's first.
  std::vector<CellRow> rows() const;

 private:
  struct Variant {
    const VariantManifest* manifest = nullptr;
    std::string failure;
    std::unique_ptr<ReadyFrame> ready;
    std::vector<std::vector<double>> once_ms;  // [pass][repetition]
    std::vector<CellRow> rows;                 // [view]
    std::vector<Mask> covered;                 // [view]
  };
  void attempt(Variant& variant, const std::function<void()>& work);
  void score_view(Variant& variant, size_t view, const Image& picture, const Image* baseline, const CellRow* known,
                  Progress& progress);

  SceneResources& resources_;
  const Plan& plan_;
  ShaderCache& shaders_;
  const CellOptions options_;
  const std::string images_;
  TruthRun truth_;
  std::vector<Variant> variants_;  // the baseline first
};

// Failed rows for a backend that cannot run at all.
std::vector<CellRow> failed_rows(const std::string& backend, const Scene& scene, const Library& library,
                                 const EffectManifest& effect, const CellOptions& options, const std::string& reason);

}  // namespace lamina
