// SPDX-License-Identifier: Apache-2.0
#include "harness/bake/bakes.h"

#include "harness/core/error.h"

namespace lamina {

Bakes::Bakes(const Scene& scene, const EffectCode& code, DiskCache cache, Progress progress)
    : scene_(scene), code_(code), cache_(std::move(cache)), progress_(std::move(progress)) {}

const Occluders& Bakes::occluders() {
  if (!occluders_) occluders_ = std::make_unique<Occluders>(scene_);
  return *occluders_;
}

void Bakes::progress(double fraction) { progress_(fraction, effect_->baker + " of " + scene_.objects[object_].name); }

void Bakes::add_stats(const BakeStats& stats) {
  stats_.push_back(stats);
  stats_.back().effect = effect_->name;
  stats_.back().object = object_;
}

const Baked& Bakes::baked(const EffectManifest& effect, size_t object, const BakeOptions& options) {
  const auto key = std::tuple(effect.name, object, options);
  if (const auto found = baked_.find(key); found != baked_.end()) return found->second;
  std::unique_ptr<Baker>& baker = bakers_[effect.name];
  if (!baker) baker = code_.bakers.at(effect.baker)->start(scene_, *this);
  effect_ = &effect, object_ = object;
  return baked_.emplace(key, baker->bake(object, scene_.objects[object].effects.at(effect.name), options)).first->second;
}

}  // namespace lamina
