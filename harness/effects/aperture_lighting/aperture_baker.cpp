// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/aperture_lighting/aperture_baker.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <span>

#include "harness/core/bytes.h"
#include "harness/core/error.h"
#include "harness/core/stopwatch.h"
#include "harness/core/text.h"

namespace lamina {
namespace {

// Changes when the same input no longer gives the same bits.
constexpr int cache_version = 1;

struct Rays {
  uint32_t count;
  uint64_t seed;
  float bias_m;  // how far they start above the surface
};

std::string visibility_key(const Occluders& occluders, const SurfacePoints& surface, const Rays& rays) {
  return "visibility-" + hash_hex(fmt::format("{} {} {} {} {} {}", cache_version, occluders.hash(),
                                              hash_hex(bytes_of(surface.points)), rays.count, rays.seed, rays.bias_m));
}

template <class T>
std::vector<std::byte> copied_bytes(const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {bytes.begin(), bytes.end()};
}

std::string map_name(uint32_t i) { return fmt::format("aperture_{}", i); }

class ApertureBaker : public Baker {
 public:
  ApertureBaker(const Scene& scene, BakeTools& tools) : scene_(scene), tools_(tools) {}

  Baked bake(size_t object, const EffectValues& values, const BakeOptions& options) override {
    const ApertureKind kind = aperture_kind(options);
    const Seen& of = seen(object, values);
    const bool harmonics = values.words.at("baker") == "spherical_harmonics";
    const std::vector<Aperture> all = kind.anti        ? anti_apertures(*of.visibility)
                                      : kind.soft      ? soft_apertures(*of.visibility)
                                      : kind.choice    ? chosen_apertures(*of.visibility)
                                      : kind.count > 1 ? region_apertures(*of.visibility, of.surface, kind.count)
                                      : harmonics      ? harmonic_apertures(*of.visibility)
                                                       : single_apertures(*of.visibility);
    Baked baked;
    if (of.surface.map_side == 0)
      baked.buffers["Apertures"] = copied_bytes(all);
    else
      for (uint32_t i = 0; i < kind.count; ++i) baked.textures[map_name(i)] = map_of(object, of.surface, all, kind, i);
    return baked;
  }

 private:
  // What an object's points see.
  struct Seen {
    SurfacePoints surface;
    std::unique_ptr<Visibility> visibility;
  };

  const Seen& seen(size_t object, const EffectValues& values) {
    if (const auto found = seen_.find(object); found != seen_.end()) return found->second;
    const Object& of = scene_.objects[object];
    const auto map_texels = static_cast<uint32_t>(values.numbers.at("map_texels"));
    const auto bias = values.numbers.find("bias");
    const Rays rays{static_cast<uint32_t>(values.numbers.at("rays")), static_cast<uint64_t>(values.numbers.at("seed")),
                    bias != values.numbers.end() ? static_cast<float>(bias->second) : tools_.occluders().default_bias_m()};
    Seen made;
    made.surface = map_texels > 0 ? map_points(of, map_texels) : vertex_points(of);
    made.visibility = std::make_unique<Visibility>(made.surface.points, rays.count, rays.seed);
    const std::string key = visibility_key(tools_.occluders(), made.surface, rays);
    const std::span<uint64_t> bits = made.visibility->all_bits();
    const Stopwatch watch;
    BakeStats stats;
    stats.points = made.surface.points.size(), stats.rays = rays.count;
    if (const auto kept = tools_.cache().find(key); kept && kept->size() == bits.size_bytes()) {
      std::memcpy(bits.data(), kept->data(), kept->size());
      stats.from_cache = true;
    } else {
      made.visibility->cast(tools_.occluders(), rays.bias_m, [&](double fraction) { tools_.progress(fraction); });
      tools_.cache().keep(key, bytes_of(bits));
    }
    stats.seconds = watch.elapsed_s();
    tools_.add_stats(stats);
    return seen_.emplace(object, std::move(made)).first->second;
  }

  Texture map_of(size_t object, const SurfacePoints& surface, const std::vector<Aperture>& all, ApertureKind kind,
                 uint32_t i) const {
    std::vector<uint64_t> halves;
    for (const uint32_t point : surface.point_of_texel)
      halves.push_back(glm::packHalf4x16(all[size_t{point} * kind.count + i]));
    const uint32_t side = surface.map_side;
    return std::make_shared<const TextureImage>(TextureImage{fmt::format("{} aperture {}", scene_.objects[object].name, i),
                                                             Format::rgba16_float,
                                                             side,
                                                             side,
                                                             {copied_bytes(halves)}});
  }

  const Scene& scene_;
  BakeTools& tools_;
  std::map<size_t, Seen> seen_;  // by object
};

double option(const BakeOptions& options, const std::string& name, double otherwise) {
  const auto found = options.find(name);
  return found == options.end() ? otherwise : found->second;
}

std::string problem(const BakeOptions& options) {
  static const std::vector<std::string> known = {"count", "anti", "soft", "choice"};
  for (const auto& [name, value] : options)
    if (std::ranges::find(known, name) == known.end()) return unknown_name("key of [bake]", name, known);
  const double count = option(options, "count", 1), anti = option(options, "anti", 0);
  if (count != std::floor(count) || count < 1 || count > double(max_apertures))
    return fmt::format("'count' of [bake] must be a whole number from 1 to {}", max_apertures);
  if (anti != 0 && anti != 1) return "'anti' of [bake] must be 0 or 1";
  const double soft = option(options, "soft", 0), choice = option(options, "choice", 0);
  if (soft != 0 && soft != 1) return "'soft' of [bake] must be 0 or 1";
  if (choice != 0 && choice != 1) return "'choice' of [bake] must be 0 or 1";
  if (anti + soft + choice > 1) return "'anti', 'soft' and 'choice' of [bake] cannot be had together; leave out all but one";
  if (soft + choice > 0 && count > 1)
    return fmt::format("'{}' of [bake] decides how many caps a point has; leave out 'count'", soft > 0 ? "soft" : "choice");
  return anti == 1 && count > 1 ? "an anti-aperture is one cap a point; leave out 'count' of [bake]" : "";
}

std::vector<BakedName> names(const BakeOptions& options) {
  std::vector<BakedName> all = {{"Apertures", true}};
  // Maps are of the unit tile, and radii must not be mixed with what lies across its border.
  for (uint32_t i = 0; i < aperture_kind(options).count; ++i)
    all.push_back({map_name(i), false, {Filter::linear, Wrap::clamp}});
  return all;
}

std::map<std::string, std::string> defines(const BakeOptions& options) {
  const ApertureKind kind = aperture_kind(options);
  std::map<std::string, std::string> made = {{"APERTURES", fmt::format("{}", kind.count)}};
  if (kind.anti) made["ANTI_APERTURE"] = "1";
  if (kind.soft) made["SOFT_APERTURE"] = "1";
  if (kind.choice) made["APERTURE_CHOICE"] = "1";
  return made;
}

std::unique_ptr<Baker> start(const Scene& scene, BakeTools& tools) { return std::make_unique<ApertureBaker>(scene, tools); }

}  // namespace

const BakerCode aperture_baker = {problem, names, defines, start};

ApertureKind aperture_kind(const BakeOptions& options) {
  const bool choice = option(options, "choice", 0) > 0;
  return {choice ? 2 : static_cast<uint32_t>(option(options, "count", 1)), option(options, "anti", 0) > 0,
          option(options, "soft", 0) > 0, choice};
}

}  // namespace lamina
