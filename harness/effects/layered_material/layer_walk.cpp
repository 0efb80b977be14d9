// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/layered_material/layer_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "harness/effects/layered_material/layer_light.h"
#include "harness/effects/translucency/random_walk.h"

namespace lamina {
namespace {

constexpr int max_events = 20000;
constexpr double walk_roulette_below = 0.05;
constexpr double min_eye_cosine = 1.0 / 64;  // of the eye's ray, whose surface is only just seen

// Henyey and Greenstein's density for a mean cosine g; its integral over all directions is 1.
double scattered_towards(double cosine, double g) {
  const double base = 1 + g * g - 2 * g * cosine;
  return (1 - g * g) / (4 * std::numbers::pi * base * std::sqrt(base));
}

}  // namespace

struct LayerWalk::Parts {
  struct Sheet {
    FilteredTexture base;
    double depth;
    bool last;
    double transparency(glm::dvec2 uv) const { return last ? 0 : base.base(uv).a; }
  };
  const Scene& scene;
  const Occluders& occluders;
  LayerLight surface;
  std::vector<Sheet> sheets;
  std::vector<std::unique_ptr<FilteredTexture>> normals;  // null: flat
  glm::dvec2 texel;
  double extinction = 0, albedo, forward;  // of the medium: a texel, a scattering, mean cosine

  Parts(const Scene& in, const Object& object, const EffectValues& values, const Occluders& blockers)
      : scene(in),
        occluders(blockers),
        surface(in, object, *values.textures.at("outer_normal")),
        texel(1.0 / values.textures.at("inner_albedo")->width, 1.0 / values.textures.at("inner_albedo")->height),
        albedo(fact_or_number(values, "medium_albedo")),
        forward(fact_or_number(values, "medium_g")) {
    const int count = static_cast<int>(std::lround(fact_or_number(values, "layer_count")));
    double depth = 0;
    for (int n = 1; n <= std::max(count, 2); ++n) {
      const std::string name = n == 1 ? "outer" : n == 2 ? "inner" : fmt::format("layer_{}", n);
      if (n == 2) depth += fact_or_number(values, "thickness");
      if (n > 2) depth += fact_or_number(values, name + "_distance");
      sheets.push_back({FilteredTexture(*values.textures.at(name + "_albedo")), depth, n == std::max(count, 2)});
      const auto map = values.textures.find(name + "_normal");
      const bool flat = map == values.textures.end() || (n > 1 && fact_or_number(values, name + "_bend") <= 0);
      normals.push_back(flat ? nullptr : std::make_unique<FilteredTexture>(*map->second));
    }
    const double thickness = fact_or_number(values, "thickness"), blur = fact_or_number(values, "scattering");
    if (thickness > 0) extinction = fact_or_number(values, "medium_depth") * blur * blur / thickness;
  }

  glm::dvec3 normal_of(size_t sheet, glm::dvec2 uv) const {
    if (!normals[sheet]) return {0, 0, 1};
    const glm::dvec3 n = glm::dvec3(normals[sheet]->base(uv)) * 2.0 - 1.0;
    const double squared = glm::dot(n, n);
    return squared > 1e-6 ? n / std::sqrt(squared) : glm::dvec3(0, 0, 1);
  }

  bool sees(const LayerPlace& place, glm::dvec3 direction, const Light& light) const {
    if (!light.casts) return true;
    Occluders::Packet rays;
    for (int axis = 0; axis < 3; ++axis) rays.direction[size_t(axis)][0] = float(direction[axis]);
    rays.distance_m[0] = light.kind == Light::Kind::point ? float(glm::length(glm::dvec3(light.position) - place.position))
                                                          : std::numeric_limits<float>::infinity();
    return occluders.free_rays(glm::vec3(place.position + place.normal * double(occluders.default_bias_m())), rays, 1) & 1;
  }

  // Of each light what comes straight to a place below `above` sheets, at a depth; `weigh(direction)` of it, the direction in
  // the tangent frame, counts.
  template <class Weigh>
  glm::dvec3 straight(glm::dvec2 uv, double depth, size_t above, const Weigh& weigh) const {
    glm::dvec3 sum(0);
    const std::optional<LayerPlace> place = surface.place(uv);
    if (!place) return sum;
    for (size_t i = 0; i < std::min(scene.lights.size(), max_lights); ++i) {
      const LightFrom light = surface.from(*place, i);
      const glm::dvec3 to(glm::dot(light.direction, place->along), glm::dot(light.direction, place->across),
                          glm::dot(light.direction, place->normal));
      const double weight = to.z > 1e-6 ? weigh(to) : 0;
      if (weight <= 0) continue;
      double share = weight * std::exp(-extinction * depth / to.z);
      for (size_t k = 0; k < above && share > 0; ++k)
        share *= sheets[k].transparency(uv + (depth - sheets[k].depth) / to.z * glm::dvec2(to) * texel);
      if (share > 1e-9 && sees(*place, light.direction, scene.lights[i])) sum += share * light.irradiance;
    }
    return sum;
  }

  glm::dvec3 walk(glm::dvec2 uv, glm::dvec3 direction, WalkRandom& random) const {
    glm::dvec3 light(0), weight(1);
    double depth = 0;
    size_t next = 0;  // the sheet that the path meets next
    for (int event = 0; event < max_events; ++event) {
      const bool down = direction.z < 0;
      const double free = extinction > 0 && (next > 0 || !down) ? -std::log(random.uniform()) / extinction : 1e300;
      const double distance = (sheets[next].depth - depth) / -direction.z;  // 1e300 and more where it runs along the sheets
      if (free < distance) {
        uv += free * glm::dvec2(direction) * texel;
        depth -= free * direction.z;
        weight *= albedo;
        light += weight * straight(uv, depth, down ? next : next + 1, [&](glm::dvec3 to) {
                   return std::numbers::pi * scattered_towards(glm::dot(to, direction), forward);
                 });
        direction = random.scattered(direction, forward);
        if (down && direction.z >= 0) --next;
        if (!down && direction.z < 0) ++next;
      } else {
        if (!std::isfinite(distance)) return light;
        uv += distance * glm::dvec2(direction) * texel;
        depth = sheets[next].depth;
        const Sheet& sheet = sheets[next];
        const glm::dvec4 base = sheet.base.base(uv);
        if (random.uniform() < (sheet.last ? 0 : base.a)) {
          if (!down && next == 0) return light + weight * glm::dvec3(scene.ambient);
          down ? ++next : --next;
          continue;
        }
        weight *= glm::dvec3(base);
        if (down) light += weight * straight(uv, depth, next, [&](glm::dvec3 to) { return glm::dot(to, normal_of(next, uv)); });
        const double z = std::sqrt(random.uniform()), across = std::sqrt(1 - z * z),
                     angle = 2 * std::numbers::pi * random.uniform();
        direction = {across * std::cos(angle), across * std::sin(angle), down ? z : -z};
        if (down && next == 0) return light + weight * glm::dvec3(scene.ambient);
        down ? --next : ++next;
      }
      const double left = std::max({weight.r, weight.g, weight.b});
      if (left <= 0) return light;
      if (left < walk_roulette_below) {
        if (random.uniform() * walk_roulette_below >= left) return light;
        weight *= walk_roulette_below / left;
      }
    }
    return light;
  }
};

LayerWalk::LayerWalk(const Scene& scene, size_t object, const Occluders& occluders) {
  const Object& of = scene.objects[object];
  parts_ = std::make_unique<Parts>(scene, of, of.effects.at("layered_material"), occluders);
}
LayerWalk::~LayerWalk() = default;

WalkedLight LayerWalk::light(const WalkStart& start, size_t paths, uint64_t seed) const {
  WalkRandom random(seed);
  glm::dvec3 ray = -start.to_eye;
  ray.z = std::min(ray.z, -min_eye_cosine);
  ray = glm::normalize(ray);
  glm::dvec3 sum(0), squares(0);
  for (size_t i = 0; i < paths; ++i) {
    const double across = random.uniform() - 0.5, down = random.uniform() - 0.5;
    const glm::dvec2 uv = start.uv + across * start.right + down * start.down;
    const glm::dvec3 light = parts_->walk(uv, ray, random);
    sum += light, squares += light * light;
  }
  const double n = double(std::max<size_t>(paths, 1));
  const glm::dvec3 mean = sum / n;
  return {mean, glm::sqrt(glm::max(squares / n - mean * mean, glm::dvec3(0)) / n)};
}

}  // namespace lamina
