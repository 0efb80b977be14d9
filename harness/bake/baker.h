// SPDX-License-Identifier: Apache-2.0
// A baker: from a scene and what an effect's keys say to textures and buffers for an object, before any frame. Effects bring
// bakers by name: see harness/manifest/effect_code.h.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "harness/bake/occluders.h"
#include "harness/core/disk_cache.h"
#include "harness/manifest/effect_code.h"
#include "harness/scene/effect_values.h"

namespace lamina {

struct Baked {
  std::map<std::string, Texture> textures;                // by the sampler's name
  std::map<std::string, std::vector<std::byte>> buffers;  // by the block's name
};

// What baking an object took; kept in the record.
struct BakeStats {
  std::string effect;
  size_t object = 0, points = 0, rays = 0;  // rays: a point
  double seconds = 0;                       // wall clock
  bool from_cache = false;
};

// What every baker may use.
class BakeTools {
 public:
  virtual ~BakeTools() = default;
  virtual const Occluders& occluders() = 0;
  virtual DiskCache& cache() = 0;
  // Of the object that is being baked, 0 to 1.
  virtual void progress(double fraction) = 0;
  virtual void add_stats(const BakeStats& stats) = 0;  // effect and object are filled in
};

class Baker {
 public:
  virtual ~Baker() = default;
  // What BakerCode::names() promises for these options. `values`: what the object has for the effect. Throws Error(failed) for
  // an object that cannot be baked, Error(bad_input) for one that the scene must say otherwise of: that ends the command.
  virtual Baked bake(size_t object, const EffectValues& values, const BakeOptions& options) = 0;
};

}  // namespace lamina
