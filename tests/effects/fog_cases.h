// SPDX-License-Identifier: Apache-2.0
// Hulls of fog and solids whose thickness is a closed form, many in one scene, far enough apart not to see each other.
#pragma once

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/declare.h"
#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/fog_hull.h"
#include "harness/scene/made/sphere_mesh.h"
#include "tests/graph/each_backend.h"
#include "tests/graph/quad_scene.h"

namespace lamina {

// What loading a scene does for one that a test makes.
inline Scene settled(Scene scene) {
  declare_objects(scene.objects, builtin_library());
  declare_said(scene, builtin_library());
  declare_scene(scene, builtin_library());
  for (Object& object : scene.objects)
    for (const EffectManifest* effect : effects_of(object, builtin_library())) object.solid = object.solid && effect->solid;
  return scene;
}

// A sphere of radius 1 whose faces lie nowhere deeper than this below it.
inline constexpr uint32_t sphere_points = 33;
inline const double sphere_sagitta = std::pow(M_PI / 2 / (sphere_points - 1), 2) / 4;  // across a cell's diagonal
inline Object sphere_of_fog(float radius, glm::vec3 centre, float share = 1, bool hole = false) {
  static const Mesh mesh = sphere_mesh(sphere_points);
  return fog_hull("sphere", mesh, glm::scale(glm::translate(glm::mat4(1), centre), glm::vec3(radius)), share, hole);
}
// A square that faces +z.
inline Object wall(float z, float half = 4) {
  const glm::mat4 placed = glm::translate(glm::mat4(1), glm::vec3(0, 0, z));
  Object object = coloured_object("wall", unit_square(), {0.5f, 0.5f, 0.5f}, false);
  object.world_from_object = glm::scale(placed, glm::vec3(2 * half));
  return object;
}

struct FogCase {
  std::string name;
  double min_m, max_m;  // along the middle pixel's ray
  double distance_m;    // of what is furthest from the eye
};

// A view of each case.
class FogCases {
 public:
  void add(const std::string& name, std::vector<Object> objects, glm::vec3 eye, glm::vec3 target, double min_m, double max_m,
           float near_m = 0.1f) {
    const size_t at = cases_.size();
    const glm::vec3 place(30.0f * (float(at % 5) - 2), 30.0f * (float(at / 5) - 2), 0);
    for (Object& object : objects) {
      object.name += "_" + std::to_string(scene_.objects.size());
      object.world_from_object = glm::translate(glm::mat4(1), place) * object.world_from_object;
      scene_.objects.push_back(std::move(object));
    }
    scene_.views.push_back({name, eye + place, target + place, {0, 1, 0}, 60, near_m, 14});
    cases_.push_back({name, min_m, max_m, 9});
  }
  void add(const std::string& name, std::vector<Object> objects, glm::vec3 eye, glm::vec3 target, double metres) {
    add(name, std::move(objects), eye, target, metres, metres);
  }
  // After the last add().
  const Scene& scene() const {
    if (settled_.name.empty()) {
      settled_ = scene_;
      settled_.name = settled_.source = "fog cases";
      set_fog(settled_, 1, {0.5f, 0.5f, 0.5f});
      settled_ = settled(std::move(settled_));
    }
    return settled_;
  }
  const std::vector<FogCase>& cases() const { return cases_; }

 private:
  Scene scene_;
  mutable Scene settled_;
  std::vector<FogCase> cases_;
};

// Thickness that variants come to, in metres along rays.
class FogOnEachBackend : public EachBackend {
 protected:
  struct Thickness {
    uint32_t size;
    std::vector<double> own_m, exact_m;
    double middle_m() const { return own_m[(size / 2) * size + size / 2]; }
  };
  // Of every view.
  std::vector<Thickness> thickness(const Scene& scene, std::string_view name, uint32_t size = 33,
                                   const Parameters& parameters = {}) {
    const VariantManifest& told = variant(name);
    DrawnFrame drawn(*backend_, library(), scene,
                     {.variant = &told, .width = size, .height = size, .parameters = parameters, .told = &told});
    std::vector<Thickness> all;
    for (size_t view = 0; view < scene.views.size(); ++view) {
      drawn.frame.run(view, Timing::off);
      const Image depths = drawn.frame.target(told, "seen_depths");
      Thickness& made = all.emplace_back(Thickness{size, {}, {}});
      const double slope = std::tan(glm::radians(double(scene.views[view].fov_y_degrees)) / 2);
      for (size_t pixel = 0; pixel < size_t(size) * size; ++pixel) {
        const double x = (double(pixel % size) + 0.5) / size * 2 - 1, y = (double(pixel / size) + 0.5) / size * 2 - 1;
        const double stretch = std::sqrt(1 + slope * slope * (x * x + y * y));
        made.own_m.push_back(double(depths.rgba[4 * pixel]) * stretch);
        made.exact_m.push_back(double(depths.rgba[4 * pixel + 2]) * stretch);
      }
    }
    return all;
  }
};

}  // namespace lamina
