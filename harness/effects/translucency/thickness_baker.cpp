// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/translucency/thickness_baker.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <span>

#include "harness/bake/directions.h"
#include "harness/bake/surface_points.h"
#include "harness/core/bytes.h"
#include "harness/core/error.h"
#include "harness/core/stopwatch.h"
#include "harness/core/text.h"
#include "harness/effects/translucency/solids.h"
#include "harness/scene/mesh/hull_check.h"

namespace lamina {
namespace {

constexpr int thickness_version = 1;  // changes when the same input no longer gives the same bits

double bake_option(const BakeOptions& options, const std::string& name, double otherwise) {
  const auto found = options.find(name);
  return found == options.end() ? otherwise : found->second;
}

class ThicknessBaker : public Baker {
 public:
  ThicknessBaker(const Scene& scene, BakeTools& tools) : scene_(scene), tools_(tools) {}

  Baked bake(size_t object, const EffectValues& values, const BakeOptions& options) override {
    const Object& of = scene_.objects[object];
    if (const auto problem = hull_problem(of.mesh))
      throw Error(ErrorKind::failed, "bake", fmt::format("object '{}'", of.name),
                  fmt::format("has no thickness: it needs a closed hull, and its mesh {}", *problem));
    const auto texels = static_cast<uint32_t>(values.numbers.at("thickness_texels"));
    const SurfacePoints surface = texels > 0 ? map_points(of, texels) : vertex_points(of);
    const std::vector<float> lengths = thickness(object, surface, options);
    Baked baked;
    if (texels == 0) {
      const auto bytes = std::as_bytes(std::span(lengths));
      baked.buffers["Thickness"] = {bytes.begin(), bytes.end()};
      return baked;
    }
    TextureImage map;
    map.name = fmt::format("{} thickness", of.name);
    map.format = Format::r32_float;
    map.width = map.height = texels;
    std::vector<std::byte>& level = map.levels.emplace_back(surface.point_of_texel.size() * sizeof(float));
    for (size_t i = 0; i < surface.point_of_texel.size(); ++i)
      std::memcpy(level.data() + i * sizeof(float), &lengths[surface.point_of_texel[i]], sizeof(float));
    baked.textures["baked_thickness"] = std::make_shared<const TextureImage>(std::move(map));
    return baked;
  }

 private:
  std::vector<float> thickness(size_t object, const SurfacePoints& surface, const BakeOptions& options) {
    const auto rays = static_cast<size_t>(bake_option(options, "rays", 64));
    const double cone = bake_option(options, "cone_degrees", 60);
    const std::string key = "thickness-" + hash_hex(fmt::format("{} {} {} {} {}", thickness_version, tools_.occluders().hash(),
                                                                hash_hex(bytes_of(surface.points)), rays, cone));
    std::vector<float> lengths(surface.points.size());
    const Stopwatch watch;
    BakeStats stats;
    stats.points = lengths.size(), stats.rays = rays;
    if (const auto kept = tools_.cache().find(key); kept && kept->size() == bytes_of(lengths).size()) {
      std::memcpy(lengths.data(), kept->data(), kept->size());
      stats.from_cache = true;
    } else {
      if (!solids_) solids_ = std::make_unique<Solids>(scene_);
      const DirectionSet directions = uniform_cap(rays, std::cos(cone * M_PI / 180));
      tbb::parallel_for(size_t{0}, lengths.size(),
                        [&](size_t i) { lengths[i] = mean_length(object, surface.points[i], directions, i); });
      tools_.progress(1);
      tools_.cache().keep(key, bytes_of(lengths));
    }
    stats.seconds = watch.elapsed_s();
    tools_.add_stats(stats);
    return lengths;
  }

  float mean_length(size_t object, const SurfacePoint& point, const DirectionSet& directions, size_t index) const {
    if (point.normal == glm::vec3(0)) return 0;
    const glm::mat3 frame = turned_frame(-point.normal, 1, index);
    const glm::dvec3 start = glm::dvec3(point.position) - glm::dvec3(point.normal) * (1e-5 * solids_->radius_m());
    double sum = 0;
    for (size_t ray = 0; ray < directions.size(); ++ray)
      if (const auto out = solids_->way_out(start, glm::dvec3(glm::normalize(frame * directions[ray])), object))
        sum += out->distance;
    return static_cast<float>(sum / static_cast<double>(directions.size()));
  }

  const Scene& scene_;
  BakeTools& tools_;
  std::unique_ptr<Solids> solids_;
};

std::string bake_problem(const BakeOptions& options) {
  static const std::vector<std::string> known = {"rays", "cone_degrees"};
  for (const auto& [name, value] : options)
    if (name != known[0] && name != known[1]) return unknown_name("key of [bake]", name, known);
  const double rays = bake_option(options, "rays", 64), cone = bake_option(options, "cone_degrees", 60);
  if (rays != std::floor(rays) || rays < 1 || rays > 4096) return "'rays' of [bake] must be a whole number from 1 to 4096";
  return cone >= 0 && cone <= 90 ? "" : "'cone_degrees' of [bake] must lie from 0 to 90";
}

std::vector<BakedName> baked_names(const BakeOptions&) {
  return {{"Thickness", true}, {"baked_thickness", false, {Filter::nearest, Wrap::clamp}}};
}

std::map<std::string, std::string> bake_defines(const BakeOptions&) { return {}; }

std::unique_ptr<Baker> start_thickness(const Scene& scene, BakeTools& tools) {
  return std::make_unique<ThicknessBaker>(scene, tools);
}

}  // namespace

const BakerCode thickness_baker = {bake_problem, baked_names, bake_defines, start_thickness};

}  // namespace lamina
