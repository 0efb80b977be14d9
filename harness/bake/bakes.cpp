// SPDX-License-Identifier: Apache-2.0
#include "harness/bake/bakes.h"

#include <chrono>
#include <cstring>

#include "harness/core/error.h"
#include "harness/core/text.h"

namespace lamina {
namespace {

// Changes when the same input no longer gives the same bits.
constexpr int cache_version = 1;

std::string key_of(const Occluders& occluders, const SurfacePoints& surface, const ApertureBake& bake, float bias_m) {
  const std::string_view points(reinterpret_cast<const char*>(surface.points.data()),
                                surface.points.size() * sizeof(SurfacePoint));
  return "visibility-" + hash_hex(fmt::format("{} {} {} {} {} {}", cache_version, occluders.hash(), hash_hex(points), bake.rays,
                                              bake.seed, bias_m));
}

}  // namespace

Bakes::Bakes(const Scene& scene, DiskCache cache, Progress progress)
    : scene_(scene), cache_(std::move(cache)), progress_(std::move(progress)) {}

const Occluders& Bakes::occluders() {
  if (!occluders_) occluders_ = std::make_unique<Occluders>(scene_);
  return *occluders_;
}

const SurfacePoints& Bakes::surface(size_t object) { return baked(object).surface; }

Bakes::Baked& Bakes::baked(size_t object) {
  if (const auto found = baked_.find(object); found != baked_.end()) return found->second;
  const Object& of = scene_.objects[object];
  const ApertureBake bake = of.apertures.value_or(ApertureBake{});
  Baked made;
  made.surface = bake.map_texels > 0 ? map_points(of, bake.map_texels) : vertex_points(of);
  made.visibility = std::make_unique<Visibility>(made.surface.points, bake.rays, bake.seed);
  const float bias_m = bake.bias_m.value_or(occluders().default_bias_m());
  const std::string key = key_of(occluders(), made.surface, bake, bias_m);
  const std::span<uint64_t> bits = made.visibility->all_bits();
  const auto start = std::chrono::steady_clock::now();
  BakeStats stats{object, made.surface.points.size(), bake.rays, 0, false};
  if (const auto kept = cache_.find(key); kept && kept->size() == bits.size_bytes()) {
    std::memcpy(bits.data(), kept->data(), kept->size());
    stats.from_cache = true;
  } else {
    made.visibility->cast(occluders(), bias_m, [&](double fraction) { progress_(fraction, of.name); });
    cache_.keep(key, {reinterpret_cast<const char*>(bits.data()), bits.size_bytes()});
  }
  stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  stats_.push_back(stats);
  return baked_.emplace(object, std::move(made)).first->second;
}

const std::vector<Aperture>& Bakes::apertures(size_t object, ApertureKind kind) {
  Baked& of = baked(object);
  if (const auto found = of.apertures.find(kind); found != of.apertures.end()) return found->second;
  const bool harmonics = scene_.objects[object].apertures->baker == ApertureBake::Baker::spherical_harmonics;
  std::vector<Aperture> made = kind.anti        ? anti_apertures(*of.visibility)
                               : kind.count > 1 ? region_apertures(*of.visibility, of.surface, kind.count)
                               : harmonics      ? harmonic_apertures(*of.visibility)
                                                : single_apertures(*of.visibility);
  return of.apertures.emplace(kind, std::move(made)).first->second;
}

std::vector<Aperture> Bakes::map(size_t object, ApertureKind kind, uint32_t i) {
  const std::vector<Aperture>& all = apertures(object, kind);
  std::vector<Aperture> texels;
  for (const uint32_t point : surface(object).point_of_texel) texels.push_back(all[size_t{point} * kind.count + i]);
  return texels;
}

}  // namespace lamina
