// SPDX-License-Identifier: Apache-2.0
// All variants of one effect on one backend, at one point of a sweep after another. What a point does not touch stays as it is:
// textures, meshes, pipelines, work done once, counted coverage.
#pragma once

#include <functional>
#include <list>
#include <memory>

#include "harness/cli/cell.h"
#include "harness/cli/sweep.h"
#include "harness/cli/truth_run.h"
#include "harness/sweep/swept_scene.h"

namespace lamina {

// Where a sweep's time goes, ms by the host's clock.
struct Spent {
  double device = 0, read_back = 0, metrics = 0;
  double sum() const { return device + read_back + metrics; }
};

class PointRun {
 public:
  // Everything must outlive this.
  PointRun(Backend& backend, SweptScene& scenes, const Library& library, const EffectManifest& effect, ShaderCache& shaders,
           const SweepOptions& options, bool timer_ok);
  ~PointRun();

  // A finished cell with its pictures by file name, which are to be kept before the cell is. Returns whether to go on.
  struct Picture {
    std::string name;
    DisplayImage image;
  };
  using Done = std::function<bool(const CellRow& row, const std::vector<Picture>& pictures)>;
  // The point's cells that `wanted` asks for, by variant and view, in the order of views and then variants, the baseline first.
  // The baseline is rendered once a view. Returns false where `done` did.
  bool run(size_t point, const std::function<bool(const std::string& variant, const std::string& view)>& wanted,
           Progress& progress, const Done& done);

  const Spent& spent() const { return spent_; }

 private:
  // A variant's passes as the features and parameters of some point want them; kept, for points may share them.
  struct Prepared {
    std::string key;
    Graph graph;
    std::unique_ptr<Frame> frame, counting;
    std::string once, counted_once, coverage;  // what these were made from: harness/graph/inputs.h
    std::vector<PassCounts> once_counts;
    std::vector<Mask> covered;  // [view]
    bool early_tests = true;
  };
  struct Variant {
    const VariantManifest* manifest = nullptr;
    std::list<Prepared> prepared;  // the last used first
    std::vector<std::vector<double>> once_ms;
    std::vector<CellRow> rows;  // [view], of the point
    std::string failure;        // at the point
  };

  void go_to(size_t point);
  void start_rows(Variant& variant, size_t point);
  void prepare(Variant& variant, size_t point);
  void count(Variant& variant, bool fetches);
  void time(Progress& progress);
  Image render(Variant& variant, size_t view);
  CellRow score(Variant& variant, size_t view, const Image* baseline, bool keep, std::vector<Picture>& pictures,
                Progress& progress);
  std::string key_of(const VariantManifest& variant, size_t point) const;

  Backend& backend_;
  SweptScene& scenes_;
  const Library& library_;
  const EffectManifest& effect_;
  ShaderCache& shaders_;
  const SweepOptions& options_;
  bool timer_ok_;
  size_t point_ = 0;
  Scene scene_;  // at the point
  Plan plan_;
  std::string resources_key_, meshes_, plan_key_;
  std::unique_ptr<Bakes> bakes_;
  std::unique_ptr<SceneResources> resources_;
  std::unique_ptr<TruthRun> truth_;
  std::vector<Variant> variants_;  // the baseline first
  Spent spent_;
};

}  // namespace lamina
