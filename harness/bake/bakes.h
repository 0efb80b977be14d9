// SPDX-License-Identifier: Apache-2.0
// The apertures of a scene's objects, each made when first asked for: rays are cast once for an object (or read from the disk
// cache), and every kind of aperture is made of the same rays.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/bake/apertures.h"
#include "harness/core/disk_cache.h"

namespace lamina {

// What a variant wants of every point.
struct ApertureKind {
  uint32_t count = 1;  // caps, 1 to most_apertures
  bool anti = false;   // of what is blocked, and then count is 1
  auto operator<=>(const ApertureKind&) const = default;
};

// What casting an object's rays took; kept in the record.
struct BakeStats {
  size_t object = 0, points = 0, rays = 0;  // rays: a point
  double seconds = 0;                       // wall clock
  bool from_cache = false;
};

class Bakes {
 public:
  // The scene must outlive this. `progress` is told the fraction of an object's rays that are cast, with the object's name.
  using Progress = std::function<void(double fraction, const std::string& object)>;
  Bakes(
      const Scene& scene, DiskCache cache, Progress progress = [](double, const std::string&) {});

  // Of an object that has ApertureBake, [point * count + i]; points as in surface(). Throws Error(failed) for an object whose
  // unwrap is no good for a map.
  const std::vector<Aperture>& apertures(size_t object, ApertureKind kind);
  // A map's i-th apertures, texel by texel, map_texels on a side.
  std::vector<Aperture> map(size_t object, ApertureKind kind, uint32_t i);
  const SurfacePoints& surface(size_t object);

  const Occluders& occluders();
  DiskCache& cache() { return cache_; }
  const std::vector<BakeStats>& stats() const { return stats_; }

 private:
  struct Baked {
    SurfacePoints surface;
    std::unique_ptr<Visibility> visibility;
    std::map<ApertureKind, std::vector<Aperture>> apertures;
  };
  Baked& baked(size_t object);

  const Scene& scene_;
  DiskCache cache_;
  Progress progress_;
  std::unique_ptr<Occluders> occluders_;
  std::map<size_t, Baked> baked_;
  std::vector<BakeStats> stats_;
};

}  // namespace lamina
