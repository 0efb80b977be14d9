// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/translucency/scattering_truth.h"

#include <cstring>

#include "harness/core/bytes.h"
#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/effects/translucency/scattered_light.h"
#include "harness/truth/for_each_on_all_cores.h"
#include "harness/truth/pixel_of.h"

namespace lamina {
namespace {

class ScatteringTruth : public Truth {
 public:
  explicit ScatteringTruth(const TruthSetting& setting) : setting_(setting), solids_(setting.scene) {}

  TruthAnswer answer(const Told& told, const std::function<void(double)>& progress) override {
    TruthAnswer answer;
    const std::vector<LitPoint> points = lit_points(told, answer.pixels);
    if (points.empty()) return {};
    // By model: path lengths, refraction, random walk.
    std::vector<std::vector<glm::vec3>> light(3, std::vector<glm::vec3>(points.size()));
    const std::string kept_as = key(points);
    const size_t bytes = points.size() * sizeof(glm::vec3);
    if (const auto kept = setting_.cache.find(kept_as); kept && kept->size() == 3 * bytes) {
      for (size_t i = 0; i < 3; ++i) std::memcpy(light[i].data(), kept->data() + i * bytes, bytes);
    } else {
      compute(points, light, progress);
      std::vector<glm::vec3> all;
      for (const auto& model : light) all.insert(all.end(), model.begin(), model.end());
      setting_.cache.keep(kept_as, bytes_of(all));
    }
    answer.steps = {{"thickness", "this variant's thickness and light against path lengths by rays", std::move(light[0])},
                    {"refraction", "refraction at flat entries against the ray that meets the point", std::move(light[1])},
                    {"multiple_scattering", "diffusion through a slab against a random walk", std::move(light[2])}};
    return answer;
  }

 private:
  std::vector<LitPoint> lit_points(const Told& told, std::vector<size_t>& pixels) const {
    const Image &point = told.target("seen_point", "translucency"), &normal = told.target("seen_normal", "translucency"),
                &albedo = told.target("seen_albedo", "translucency");
    std::vector<LitPoint> points;
    const glm::dvec3 eye(told.view.eye);
    for (size_t i = 0; i < size_t(point.width) * size_t(point.height); ++i) {
      const glm::dvec4 seen = pixel_of(point, i);
      if (seen.a <= 0) continue;
      LitPoint lit{0, glm::dvec3(seen), glm::dvec3(pixel_of(normal, i)), glm::normalize(eye - glm::dvec3(seen)),
                   glm::dvec3(pixel_of(albedo, i))};
      // Whose surface it is: the first that the eye's ray meets just before the point.
      const double before = 1e-3 * solids_.radius_m();
      double nearest = 1e30;
      for (const SurfaceCrossing& crossing : solids_.crossings(lit.position + lit.to_eye * before, -lit.to_eye, 2 * before))
        if (solids_.medium(crossing.object) && crossing.entering && std::abs(crossing.distance - before) < nearest)
          nearest = std::abs(crossing.distance - before), lit.object = crossing.object;
      if (nearest > before) continue;  // an edge that only the device meets
      pixels.push_back(i);
      points.push_back(lit);
    }
    return points;
  }

  void compute(const std::vector<LitPoint>& points, std::vector<std::vector<glm::vec3>>& light,
               const std::function<void(double)>& progress) const {
    for_each_on_all_cores(points.size(), progress, [&](size_t i) {
      const LitPoint& point = points[i];
      const Scene& scene = setting_.scene;
      const glm::dvec3 rest = unshadowed_light(*solids_.medium(point.object), scene, point);
      const glm::dvec3 flat_slab = slab_scattering(solids_, scene, point, Refraction::flat);
      const glm::dvec3 once = single_scattering(solids_, scene, point, Refraction::solved);
      light[0][i] = rest + single_scattering(solids_, scene, point, Refraction::flat) + flat_slab;
      light[1][i] = rest + once + slab_scattering(solids_, scene, point, Refraction::solved);
      light[2][i] = rest + once + multiple_scattering(solids_, scene, point, setting_.rays, 1 + i);
    });
  }

  // All that the light follows from.
  std::string key(const std::vector<LitPoint>& points) const {
    constexpr int version = 1;  // changes when the same input no longer gives the same light
    const Scene& scene = setting_.scene;
    std::string text =
        fmt::format("{} {} {} {}", version, setting_.rays, setting_.occluders.hash(), hash_hex(bytes_of(points)));
    const auto add = [&](glm::dvec3 v) { text += fmt::format(" {} {} {}", v.x, v.y, v.z); };
    for (size_t i = 0; i < scene.objects.size(); ++i) {
      std::vector<glm::vec3> normals;
      for (const Vertex& vertex : scene.objects[i].mesh.vertices) normals.push_back(vertex.normal);
      text += hash_hex(bytes_of(normals));
      if (const std::optional<Medium>& medium = solids_.medium(i)) {
        add(medium->extinction);
        text += fmt::format(" {} {} {}", medium->refraction_index, medium->multiple_scattering, medium->wrap);
      }
    }
    add(scene.ambient);
    for (const Light& light : scene.lights) {
      text += fmt::format(" {} {}", static_cast<int>(light.kind), light.casts);
      add(light.direction), add(light.position), add(light.radiance);
    }
    return "translucency-" + hash_hex(text);
  }

  TruthSetting setting_;
  Solids solids_;
};

}  // namespace

std::unique_ptr<Truth> scattering_truth(const TruthSetting& setting) { return std::make_unique<ScatteringTruth>(setting); }

}  // namespace lamina
