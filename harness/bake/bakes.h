// SPDX-License-Identifier: Apache-2.0
// What effects bake for a scene's objects, each made when first asked for.
#pragma once

#include <memory>
#include <optional>
#include <tuple>

#include "harness/bake/baker.h"
#include "harness/manifest/library.h"
#include "harness/scene/scene.h"

namespace lamina {

class Bakes : private BakeTools {
 public:
  // The scene must outlive this. `progress` gets the fraction of an object's bake that is done, and what is baked: "BAKER of
  // OBJECT".
  using Progress = std::function<void(double fraction, const std::string& what)>;
  Bakes(
      const Scene& scene, const EffectCode& code, DiskCache cache, Progress progress = [](double, const std::string&) {});

  // Of an object that has the effect's values. Throws Error(failed) for an object that cannot be baked.
  const Baked& baked(const EffectManifest& effect, size_t object, const BakeOptions& options);

  const Occluders& occluders() override;
  DiskCache& cache() override { return cache_; }
  const std::vector<BakeStats>& stats() const { return stats_; }

 private:
  void progress(double fraction) override;
  void add_stats(const BakeStats& stats) override;

  const Scene& scene_;
  const EffectCode& code_;
  DiskCache cache_;
  Progress progress_;
  std::unique_ptr<Occluders> occluders_;
  std::map<std::string, std::unique_ptr<Baker>> bakers_;  // by effect
  std::map<std::tuple<std::string, size_t, BakeOptions>, Baked> baked_;
  std::vector<BakeStats> stats_;
  const EffectManifest* effect_ = nullptr;  // that is being baked, and the object
  size_t object_ = 0;
};

}  // namespace lamina
