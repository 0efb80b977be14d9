// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/truth_run.h"

#include <algorithm>
#include <cstring>

#include "harness/core/text.h"

namespace lamina {
namespace {

template <class T>
std::string_view bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

// All that light at the points follows from.
std::string key_of(const ShadingPoints& points, const Scene& scene, const Occluders& occluders, LightModel model,
                   const DirectLightOptions& options) {
  constexpr int version = 1;  // changes when the same input no longer gives the same light
  std::string text = fmt::format("{} {} {} {} {} {} {} {}", version, static_cast<int>(model), occluders.hash(),
                                 points.kind.count, points.kind.anti, options.light_rays, options.seed, options.bias_m);
  text += hash_hex(bytes_of(points.points)) + hash_hex(bytes_of(points.apertures));
  const auto add = [&](glm::vec3 v) { text += fmt::format(" {} {} {}", v.x, v.y, v.z); };
  add(scene.ambient);
  for (const Light& light : scene.lights) {
    text += fmt::format(" {} {} {}", static_cast<int>(light.kind), light.angular_radius, light.radius_m);
    add(light.direction), add(light.position), add(light.radiance);
  }
  return "light-" + hash_hex(text);
}

// `around` with the points' pixels lit.
Image with_light(const Image& around, const ShadingPoints& points, const std::vector<glm::vec3>& light) {
  Image image = around;
  for (size_t i = 0; i < points.points.size(); ++i)
    for (int c = 0; c < 3; ++c) image.rgba[4 * points.points[i].pixel + c] = light[i][c];
  return image;
}

Mask covered_by(const ShadingPoints& points) {
  Mask mask{points.width, points.height, {}};
  mask.on.assign(size_t(points.width) * size_t(points.height), 0);
  for (const ShadingPoint& point : points.points) mask.on[point.pixel] = 1;
  return mask;
}

}  // namespace

TruthRun::TruthRun(SceneResources& resources, const Plan& plan, const EffectManifest& effect, ShaderCache& shaders,
                   Bakes& bakes, const CompareOptions& options)
    : resources_(resources), plan_(plan), effect_(effect), shaders_(shaders), bakes_(bakes), options_(options) {}

// The variant whose passes for the truth tell of apertures like this one's.
const VariantManifest* TruthRun::teller(const VariantManifest& variant) const {
  for (const VariantManifest& candidate : effect_.variants)
    if (candidate.apertures && candidate.apertures == variant.apertures && has_truth_passes(candidate)) return &candidate;
  return nullptr;
}

std::vector<glm::vec3> TruthRun::light(const ShadingPoints& points, LightModel model,
                                       const std::function<void(double)>& progress) {
  DirectLightOptions direct;
  direct.light_rays = direct.sky_rays = options_.truth_rays;
  direct.bias_m = bakes_.occluders().default_bias_m();
  const Scene& scene = resources_.scene();
  const std::string key = key_of(points, scene, bakes_.occluders(), model, direct);
  std::vector<glm::vec3> light(points.points.size());
  if (const auto kept = bakes_.cache().find(key); kept && kept->size() == bytes_of(light).size()) {
    std::memcpy(light.data(), kept->data(), kept->size());
    return light;
  }
  light = direct_light(points, scene, bakes_.occluders(), model, direct, progress);
  bakes_.cache().keep(key, bytes_of(light));
  return light;
}

void TruthRun::forget() {
  lit_.clear();
  traced_.clear();
}

TruthRun::Lit& TruthRun::lit(const VariantManifest& told, size_t view, const std::function<void(double)>& progress) {
  if (view != view_) {
    view_ = view;
    forget();
  }
  const auto [entry, is_new] = lit_.try_emplace(&told);
  Lit& made = entry->second;
  if (!is_new) return made;
  if (!frames_[&told]) {
    graphs_[&told] = std::make_unique<Graph>(
        make_graph(plan_, configuration_with(plan_, told), resources_.scene(), shaders_, Purpose::truth));
    frames_[&told] = std::make_unique<Frame>(resources_, *graphs_[&told], Build::timed);
    frames_[&told]->run_once(Timing::off);
  }
  Frame& frame = *frames_[&told];
  frame.run(view, Timing::off);
  std::vector<Image> apertures;
  for (uint32_t i = 0; i < told.apertures->count; ++i) apertures.push_back(frame.target(fmt::format("seen_aperture_{}", i)));
  made.points = shading_points(frame.target("seen_point"), frame.target("seen_normal"), frame.target("seen_albedo"), apertures,
                               *told.apertures);
  made.exact = light(made.points, LightModel::exact_intersection, [](double) {});
  made.integrated = light(made.points, LightModel::integrated_cosine, [](double) {});
  if (traced_.size() != made.points.points.size()) {
    ShadingPoints without = made.points;  // rays do not ask for apertures
    without.apertures.clear();
    without.kind = {0, false};
    traced_ = light(without, LightModel::traced, progress);
  }
  return made;
}

void TruthRun::score(const VariantManifest& variant, size_t view, const Image& picture, CellRow& row, const Write& write,
                     const std::function<void(double)>& progress) {
  const VariantManifest* told = teller(variant);
  if (!told || options_.truth_rays == 0) return;
  Lit& with = lit(*told, view, progress);
  if (with.points.points.empty()) return;
  const Mask covered = covered_by(with.points);
  const auto lit_by = [&](const std::vector<glm::vec3>& light) { return with_light(picture, with.points, light); };
  const Image exact = lit_by(with.exact), traced = lit_by(traced_);
  const auto assumption = [&](const std::string& name, const std::string& title, const Image& made, const Image& without) {
    const DisplayImage difference = difference_picture(to_display(made), to_display(without), difference_gain);
    return AssumptionRow{name, title, measure_error(made, without, covered).covered, write("-" + name, difference)};
  };
  row.error_truth = measure_error(picture, traced, covered).covered;
  row.assumptions = {assumption("intersection", "this intersection against the exact one", picture, exact)};
  if (with.shared.empty()) {
    const Image integrated = lit_by(with.integrated);
    with.shared = {assumption("cosine", "the cosine at the middle against the cosine integrated", exact, integrated),
                   assumption("aperture", "circular apertures against traced visibility", integrated, traced)};
    with.image = write("-truth", to_display(traced));
  }
  row.assumptions.insert(row.assumptions.end(), with.shared.begin(), with.shared.end());
  row.truth_image = with.image;
}

}  // namespace lamina
