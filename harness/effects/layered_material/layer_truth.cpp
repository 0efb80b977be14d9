// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/layered_material/layer_truth.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <map>
#include <vector>

#include "harness/core/text.h"
#include "harness/effects/layered_material/layer_light.h"
#include "harness/effects/layered_material/layer_walk.h"
#include "harness/truth/for_each_on_all_cores.h"
#include "harness/truth/pixel_of.h"

namespace lamina {
namespace {

constexpr double min_cosine = 1.0 / 32;    // of the transmitted ray
constexpr double min_slant_cosine = 0.25;  // of a light's ray through the layers
constexpr size_t walks_a_sample = 4;       // one walk tells less of a pixel than one sample of the model
constexpr double golden_turn = 0.6180339887498949;

// n samples in the unit disc, evenly spread (Vogel 1979), in order and turned. From one to the next is the same rotation.
class InDisc {
 public:
  InDisc(size_t n, double turn) : n_(n), towards_(std::polar(1.0, 2 * M_PI * turn)) {}
  glm::dvec2 next() {
    static const std::complex<double> step = std::polar(1.0, 2 * M_PI * golden_turn);
    const double radius = std::sqrt((double(i_++) + 0.5) / double(n_));
    const glm::dvec2 at(radius * towards_.real(), radius * towards_.imag());
    towards_ = {towards_.real() * step.real() - towards_.imag() * step.imag(),
                towards_.real() * step.imag() + towards_.imag() * step.real()};
    return at;
  }

 private:
  size_t n_, i_ = 0;
  std::complex<double> towards_;
};

// Sample i in the square of side 1 around 0 (the additive sequence of the plastic number; M. Roberts 2018).
glm::dvec2 in_pixel(size_t i, double turn) {
  const glm::dvec2 at(turn + 0.7548776662466927 * double(i), turn + 0.5698402909980532 * double(i));
  return at - glm::floor(at) - 0.5;
}

}  // namespace

struct LayerModel::Parts {
  const Scene& scene;
  std::vector<FilteredTexture> layers;
  std::vector<std::optional<FilteredTexture>> normals;  // of layers with a map of their own, but the outer one
  std::vector<double> depth;                            // texels
  glm::dvec2 texel;
  double scattering, shadowing;
  LayerLight light;

  Parts(const Scene& in, const Object& object, const EffectValues& values)
      : scene(in),
        depth{0},
        texel(1.0 / values.textures.at("inner_albedo")->width, 1.0 / values.textures.at("inner_albedo")->height),
        scattering(fact_or_number(values, "scattering")),
        shadowing(fact_or_number(values, "shadowing")),
        light(in, object, *values.textures.at("outer_normal")) {
    layers.emplace_back(*values.textures.at("outer_albedo"));
    layers.emplace_back(*values.textures.at("inner_albedo"));
    depth.push_back(fact_or_number(values, "thickness"));
    const auto add_normals = [&](const std::string& name) {
      const auto map = values.textures.find(name + "_normal");
      normals.emplace_back();
      if (map != values.textures.end() && fact_or_number(values, name + "_bend") > 0) normals.back().emplace(*map->second);
    };
    normals.emplace_back();
    add_normals("inner");
    for (int n = 3; n <= static_cast<int>(std::lround(fact_or_number(values, "layer_count"))); ++n) {
      layers.emplace_back(*values.textures.at(fmt::format("layer_{}_albedo", n)));
      depth.push_back(depth.back() + fact_or_number(values, fmt::format("layer_{}_distance", n)));
      add_normals(fmt::format("layer_{}", n));
    }
  }

  double through(double transparency) const { return 1 - shadowing + shadowing * transparency; }

  // All light of a place by a normal: of the layer's own map, or the smooth one.
  glm::dvec3 lit(glm::dvec2 uv, const FilteredTexture* map) const {
    glm::dvec3 sum(scene.ambient), normal(0, 0, 1);
    if (map) normal = glm::dvec3(map->base(uv)) * 2.0 - 1.0;
    if (const std::optional<LayerPlace> place = light.place(uv))
      for (const glm::dvec3& one : light.lights(*place, glm::normalize(normal))) sum += one;
    return sum;
  }
  // What arrives without the map, as the map's normals take it.
  static glm::dvec3 bumped(glm::dvec3 arriving, glm::dvec3 of_map, glm::dvec3 smooth) {
    return of_map * glm::min(arriving / glm::max(smooth, glm::dvec3(1e-9)), glm::dvec3(1)) +
           glm::max(arriving - smooth, glm::dvec3(0));
  }

  // Light that falls on layer `k` at `uv` from a tap of the disc.
  glm::dvec3 falling(size_t k, glm::dvec2 uv, glm::dvec2 tap, const std::vector<glm::dvec2>& slants) const {
    const glm::dvec2 spread = tap * scattering;
    const auto arriving = [&](glm::dvec2 slant) {
      double share = 1;
      for (size_t j = 0; j < k && shadowing > 0; ++j)
        share *= through(layers[j].base(uv + (depth[k] - depth[j]) * (slant + spread) * texel).a);
      return share;
    };
    const LightsAt straight = shadowing > 0 ? LightsAt{} : light.at(uv + depth[k] * spread * texel);
    glm::dvec3 sum = glm::dvec3(scene.ambient) * (shadowing > 0 ? arriving(glm::dvec2(0)) : 1.0);
    for (size_t i = 0; i < slants.size(); ++i)
      sum += shadowing > 0 ? light.at(uv + depth[k] * (slants[i] + spread) * texel, i) * arriving(slants[i]) : straight[i];
    return sum;
  }
};

LayerModel::LayerModel(const Scene& scene, size_t object) {
  const Object& of = scene.objects[object];
  parts_ = std::make_unique<Parts>(scene, of, of.effects.at("layered_material"));
}
LayerModel::~LayerModel() = default;

LayeredLight LayerModel::light(const SeenLayers& seen, glm::dvec3 eye, size_t samples, double turn) const {
  const Parts& p = *parts_;
  const auto tangent = [&](glm::dvec3 world) {
    return glm::dvec3(glm::dot(world, seen.along), glm::dot(world, seen.across), glm::dot(world, seen.normal));
  };
  const auto jitter = [&](size_t i) {
    const glm::dvec2 at = in_pixel(i, turn);
    return seen.uv + at.x * seen.right + at.y * seen.down;
  };
  const glm::dvec3 view = tangent(glm::normalize(eye - seen.position));
  glm::dvec3 normal(0);
  for (size_t i = 0; i < samples && !seen.mapped && !seen.straight; ++i) normal += p.light.mapped_normal(jitter(i));
  normal = seen.straight ? glm::dvec3(0, 0, 1) : glm::normalize(seen.mapped.value_or(normal));
  const double facing = seen.straight ? 1 : std::clamp(glm::dot(normal, view), 0.0, 1.0);
  const glm::dvec3 reflected = 2 * glm::dot(normal, view) * normal - view;
  const glm::dvec2 along_ray = glm::dvec2(reflected) / std::max(std::abs(reflected.z), min_cosine);
  const double stretch = 1 / std::max(std::abs(reflected.z), min_cosine);

  std::vector<glm::dvec2> slants;
  for (size_t i = 0; i < std::min(p.scene.lights.size(), max_lights); ++i) {
    const Light& light = p.scene.lights[i];
    const glm::dvec3 to_light =
        tangent(light.kind == Light::Kind::point ? glm::normalize(glm::dvec3(light.position) - seen.position)
                                                 : -glm::dvec3(light.direction));
    slants.push_back(glm::dvec2(to_light) / std::max(to_light.z, min_slant_cosine));
  }

  // The outer layer: what a pixel's footprint shows of it, and how much of what is below it.
  glm::dvec3 outer_color(0), outer_light(0);
  glm::dvec4 outer_mean(0);
  for (size_t i = 0; i < samples; ++i) {
    const glm::dvec2 uv = jitter(i);
    const glm::dvec4 outer = p.layers[0].base(uv);
    glm::dvec3 light(p.scene.ambient);
    for (const glm::dvec3& one : p.light.at(uv)) light += one;
    outer_color += (1 - outer.a * facing) * glm::dvec3(outer) * light / double(samples);
    outer_light += light / double(samples);
    outer_mean += outer / double(samples);
  }
  // What lies below it, as seen where it is clear.
  glm::dvec3 below(0);
  double clear = 1;
  for (size_t k = 1; k < p.layers.size() && outer_mean.a > 0; ++k) {
    glm::dvec4 base(0);
    glm::dvec3 light(0), of_map(0), smooth(0);
    InDisc seen_disc(samples, turn), lit_disc(samples, 1 - turn);
    for (size_t i = 0; i < samples; ++i) {
      const glm::dvec2 uv = jitter(i) + p.depth[k] * along_ray * p.texel,
                       beside = uv + seen_disc.next() * (p.depth[k] * stretch) * p.texel;
      base += p.layers[k].base(beside) / double(samples);
      light += p.falling(k, uv, lit_disc.next(), slants) / double(samples);
      if (!p.normals[k]) continue;
      of_map += p.lit(beside, &*p.normals[k]) / double(samples);
      smooth += p.lit(uv, nullptr) / double(samples);
    }
    if (p.normals[k]) light = LayerModel::Parts::bumped(light, of_map, smooth);
    const double through = k + 1 == p.layers.size() ? 0 : base.a;
    below += clear * (1 - through) * glm::dvec3(base) * light;
    clear *= through;
  }
  const glm::dvec4 shown = seen.outer.value_or(outer_mean);
  return {(1 - shown.a * facing) * glm::dvec3(shown) * outer_light + shown.a * facing * below,
          outer_color + outer_mean.a * facing * below};
}

namespace {

class LayerTruth : public Truth {
 public:
  explicit LayerTruth(const TruthSetting& setting) : setting_(setting) {}

  TruthAnswer answer(const Told& told, const std::function<void(double)>& progress) override {
    const Image &point = told.target("seen_point", "layers"), &along = told.target("seen_along", "layers"),
                &normal = told.target("seen_normal", "layers"), &uv = told.target("seen_uv", "layers"),
                &steps = told.target("seen_steps", "layers"), &outer = told.target("seen_outer", "layers"),
                &mapped = told.target("seen_mapped", "layers");
    TruthAnswer answer;
    const bool walked = walks_asked();
    for (size_t i = 0; i < size_t(point.width) * size_t(point.height); ++i) {
      const long place = std::lround(pixel_of(point, i).a) - 1;
      if (place < 0 || size_t(place) >= setting_.scene.objects.size()) continue;
      answer.pixels.push_back(i);
      models_.try_emplace(size_t(place), setting_.scene, size_t(place));
      if (walked) walks_.try_emplace(size_t(place), setting_.scene, size_t(place), setting_.occluders);
    }
    if (answer.pixels.empty()) return {};
    std::vector<glm::vec3> first(answer.pixels.size()), all(first.size()), straight(first.size()), physical(first.size());
    for_each_on_all_cores(all.size(), progress, [&](size_t n) {
      const size_t i = answer.pixels[n];
      const glm::dvec4 at = pixel_of(point, i), tangent = pixel_of(along, i), step = pixel_of(steps, i);
      SeenLayers seen{glm::dvec3(at),
                      glm::dvec3(tangent),
                      {},
                      glm::dvec3(pixel_of(normal, i)),
                      glm::dvec2(pixel_of(uv, i)),
                      {step.x, step.y},
                      {step.z, step.w},
                      pixel_of(outer, i),
                      glm::dvec3(pixel_of(mapped, i))};
      seen.across = glm::cross(seen.normal, seen.along) * tangent.a;
      const double turn = double(n) * 0.7548776662466927;
      const size_t object = size_t(std::lround(at.a)) - 1, samples = std::max<size_t>(setting_.rays, 1);
      const LayerModel& model = models_.at(object);
      const glm::dvec3 eye(told.view.eye);
      const LayeredLight light = model.light(seen, eye, samples, turn - std::floor(turn));
      first[n] = glm::vec3(light.under_shown_outer), all[n] = glm::vec3(light.all);
      if (!walked) return;
      seen.straight = true;
      straight[n] = glm::vec3(model.light(seen, eye, samples, turn - std::floor(turn)).all);
      const glm::dvec3 to_eye = glm::normalize(eye - seen.position);
      const WalkStart start{seen.uv, seen.right, seen.down,
                            glm::transpose(glm::dmat3(seen.along, seen.across, seen.normal)) * to_eye};
      physical[n] = glm::vec3(walks_.at(object).light(start, walks_a_sample * samples, 1 + i).mean);
    });
    answer.steps = {
        {"filters", "this variant's light and layers below the outer one against discs of many samples and rays of light",
         std::move(first)},
        {"footprint", "the outer layer as mip levels show it against the mean over the pixel", std::move(all)}};
    if (!walked) return answer;
    answer.steps.push_back(
        {"bending", "the eye's ray bent by the mapped normal, and N.V, against a straight ray without", std::move(straight)});
    answer.steps.push_back({"walk", "discs and one bounce against a random walk of the light", std::move(physical)});
    return answer;
  }
  void scene_changed() override { models_.clear(), walks_.clear(); }

 private:
  bool walks_asked() const {
    const auto whole = setting_.scene.effects.find("layered_material");
    if (whole == setting_.scene.effects.end()) return false;
    const auto word = whole->second.words.find("truth");
    return word != whole->second.words.end() && word->second == "walk";
  }

  TruthSetting setting_;
  std::map<size_t, LayerModel> models_;  // by object
  std::map<size_t, LayerWalk> walks_;
};

}  // namespace

std::unique_ptr<Truth> layer_truth(const TruthSetting& setting) { return std::make_unique<LayerTruth>(setting); }

}  // namespace lamina
