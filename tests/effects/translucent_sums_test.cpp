// SPDX-License-Identifier: Apache-2.0
// Thickness by sums of faces in the light's view, over whole pictures of the built-in scenes, against lengths by rays.
#include <gtest/gtest.h>

#include <algorithm>

#include "harness/truth/view_rays.h"
#include "tests/effects/translucent_scenes.h"
#include "tests/graph/each_backend.h"

namespace lamina {
namespace {

// The objects of a built-in scene as one medium without a boundary, under its first light alone, as that light casts. An
// optical depth of 3 is as long as the scene is wide.
struct SummedScene {
  Scene scene;
  double size_m = 0;
};
SummedScene in_one_medium(const std::string& name) {
  SummedScene made{load_scene(name, builtin_library()), 0};
  made.size_m = 2 * double(bounding_sphere(made.scene.objects).radius);
  const auto extinction = static_cast<float>(3 / made.size_m);
  for (Object& object : made.scene.objects) {
    Object medium = translucent(std::move(object.mesh), {.extinction = glm::vec3(extinction), .wrap = 0.25});
    medium.name = object.name, medium.world_from_object = object.world_from_object;
    object = std::move(medium);
  }
  made.scene.effects.clear();
  made.scene.lights.resize(1);
  made.scene.lights[0].casts = true, made.scene.lights[0].radiance = glm::vec3(1);
  made.scene.ambient = glm::vec3(0);
  return made;
}

// What is solid between the light and a point of a surface, and the smallest cosine of a surface on the way.
struct SummedLength {
  double metres = 0, min_cosine = 1;
  bool operator<(const SummedLength& other) const { return metres < other.metres; }
};
SummedLength length_before(const Solids& solids, glm::dvec3 point, glm::dvec3 to_light) {
  const double away = 4 * solids.radius_m();
  SummedLength length;
  double inside = 0;
  for (const SurfaceCrossing& crossing :
       solids.crossings(point + away * to_light, -to_light, away - 1e-5 * solids.radius_m())) {
    inside += crossing.entering ? 1 : -1;
    length.metres += crossing.entering ? -crossing.distance : crossing.distance;
    length.min_cosine = std::min(length.min_cosine, std::abs(glm::dot(crossing.normal, to_light)));
  }
  length.metres += inside * away;
  return length;
}

struct SummedErrors {
  double worst = 0, mean = 0;  // of the scene's size
  size_t compared = 0, silhouettes = 0;
};

class TranslucentSums : public EachBackend {
 protected:
  static constexpr uint32_t size_px = 64;

  SummedErrors errors(const SummedScene& made) {
    const Scene& scene = made.scene;
    const Image image = picture(scene, "light_sums", size_px);
    const Solids solids(scene);
    const View& view = scene.views[0];
    const glm::dvec3 eye(view.eye), to_light = -glm::normalize(glm::dvec3(scene.lights[0].direction));
    const double texel = made.size_m / 512, extinction = 3 / made.size_m;
    const glm::dvec3 across = glm::normalize(glm::cross(to_light, glm::dvec3(0.3, 0.5, 0.8))),
                     up = glm::cross(to_light, across);
    SummedErrors found;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const glm::dvec3 along = ViewRays(view, size_px, size_px).direction(x, y);
        const std::vector<SurfaceCrossing> seen = solids.crossings(eye, along);
        if (seen.empty()) continue;
        const glm::dvec3 point = eye + seen[0].distance * along, normal = seen[0].normal;
        const double cosine = glm::dot(normal, to_light);
        // Edges that the eye sees: beside the pixel's middle it meets another surface, or none.
        bool edge = std::abs(glm::dot(normal, along)) < 0.2;
        for (const auto& [dx, dy] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
          const glm::dvec3 other = ViewRays(view, 8 * size_px, 8 * size_px).direction(8 * x + 4 + dx, 8 * y + 4 + dy);
          const std::vector<SurfaceCrossing> beside = solids.crossings(eye, other);
          edge = edge || beside.empty() || glm::dot(beside[0].normal, normal) < 0.9 || beside[0].object != seen[0].object;
        }
        const SummedLength length = length_before(solids, point, to_light);
        // A texel and a half to all sides, in the surface.
        double least = length.metres, most = least, min_cosine = std::min(length.min_cosine, std::abs(cosine));
        for (const glm::dvec3 step : {across, -across, up, -up}) {
          const glm::dvec3 beside = 1.5 * texel * step - normal * (0.01 * texel);
          const glm::dvec3 in_plane = point + beside - to_light * (1.5 * texel * glm::dot(step, normal) / cosine);
          const SummedLength other = length_before(solids, in_plane, to_light);
          least = std::min(least, other.metres), most = std::max(most, other.metres);
          min_cosine = std::min(min_cosine, other.min_cosine);
        }
        if (edge || min_cosine < 0.3 || most - least > 0.02 * made.size_m) {
          ++found.silhouettes;
          continue;
        }
        const double both_sides = std::max(cosine, 0.0) + std::max(0.25 - cosine, 0.0) / (1.25 * 1.25);
        const double colour = diffuse_reflectance(stored_albedo(scene.objects[seen[0].object]).g, 1) * both_sides;
        const double drawn = -std::log(double(pixel(image, x, y).g) / colour) / extinction;
        const double error = std::abs(drawn - length.metres) / made.size_m;
        found.worst = std::max(found.worst, error), found.mean += error;
        ++found.compared;
      }
    found.mean /= double(found.compared);
    return found;
  }
};

TEST_P(TranslucentSums, AreRightToAHundredthOfTheSizeButAtSilhouettes) {
  for (const std::string name : {"hollow_shell", "wax_block", "ear", "leaf_pair"}) {
    SCOPED_TRACE(name);
    SummedScene made = in_one_medium(name);
    for (const View& view : std::vector<View>(made.scene.views)) {
      made.scene.views[0] = view;
      const SummedErrors found = errors(made);
      EXPECT_LT(found.worst, 0.01) << view.name;
      EXPECT_LT(found.mean, 0.003) << view.name;
      EXPECT_GT(found.compared, 500u) << view.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, TranslucentSums, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
