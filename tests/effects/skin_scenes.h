// SPDX-License-Identifier: Apache-2.0
// Scenes of skin whose light is known in closed form: a flat plate, lit evenly or up to a straight edge, and balls.
#pragma once

#include <map>
#include <string>

#include "harness/effects/skin/profile.h"
#include "harness/scene/declare.h"
#include "harness/scene/default_views.h"
#include "harness/scene/facts.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/skin_object.h"
#include "harness/scene/textures.h"
#include "harness/truth/view_rays.h"
#include "tests/builtin_library.h"

namespace lamina {

using SkinNumbers = std::map<std::string, double>;

// A square in the plane z = const that faces +z; metres.
inline Mesh skin_square(float left, float right, float bottom, float top, float z) {
  Mesh mesh;
  for (const glm::vec2 at : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)})
    mesh.vertices.push_back({{glm::mix(left, right, at.x), glm::mix(top, bottom, at.y), z}, {0, 0, 1}, {1, 0, 0, -1}, at});
  mesh.indices = {0, 2, 1, 0, 3, 2};
  return mesh;
}

inline constexpr float skin_plate_half_m = 0.03f;

// White and without highlights where `numbers` do not say otherwise.
inline Object skin_plate(SkinNumbers numbers = {}) {
  numbers.try_emplace("skin.specular", 0);
  return skin_object("plate", skin_square(-skin_plate_half_m, skin_plate_half_m, -skin_plate_half_m, skin_plate_half_m, 0),
                     glm::vec3(1), numbers);
}

// What the loader does for a scene that a test makes. Looked at from 0.2 m in front, somewhat from the right.
inline Scene skin_scene(std::vector<Object> objects, std::vector<Light> lights, glm::vec3 ambient) {
  Scene scene;
  scene.name = scene.source = "made";
  scene.objects = std::move(objects);
  scene.lights = std::move(lights);
  scene.ambient = ambient;
  scene.background = glm::vec3(0);
  declare_objects(scene.objects, builtin_library());
  declare_said(scene, builtin_library());
  declare_scene(scene, builtin_library());
  for (Object& object : scene.objects)
    if (object.effects.contains("skin")) settle_facts(object, builtin_library().effect("skin"));
  View view{"view", {0.05f, 0, 0.2f}, {0, 0, 0}, {0, 1, 0}, 8};
  fit_depth(view, bounding_sphere(scene.objects));
  scene.views = {view};
  return scene;
}

// Light of irradiance 1 on the plate from x = 0 to the right; on the left a hard shadow.
inline Scene edge_of_light_scene(SkinNumbers numbers = {}) {
  numbers.try_emplace("skin.penumbra", 0);
  Object blocker;
  blocker.name = "blocker";
  blocker.mesh = skin_square(-0.06f, -0.0075f, -0.06f, 0.06f, 0.01f);
  Light lamp = directional_light("lamp", {-0.6f, 0, 0.8f}, glm::vec3(1.25f));
  lamp.casts = true;
  std::vector<Object> objects;
  objects.push_back(skin_plate(std::move(numbers)));
  objects.push_back(std::move(blocker));
  return skin_scene(std::move(objects), {lamp}, glm::vec3(0));
}

inline DiffusionProfile default_profile() {
  std::vector<Object> objects;
  objects.push_back(skin_plate());
  return profile_of(skin_scene(std::move(objects), {}, glm::vec3(1)).objects[0].effects.at("skin"));
}

// Furthest from the closed form along the middle row, from 0.35 to 6 mm beside the edge: nearer, texels of 0.23 mm show.
inline glm::dvec3 edge_error(const Scene& scene, const Image& image) {
  const DiffusionProfile profile = default_profile();
  glm::dvec3 most(0);
  const glm::dvec3 eye(scene.views[0].eye);
  for (int x = 0; x < image.width; ++x) {
    const int y = image.height / 2;
    const glm::dvec3 d = ViewRays(scene.views[0], image.width, image.height).direction(x, y);
    const double dark_mm = -1000 * (eye.x - d.x * eye.z / d.z);
    if (std::abs(dark_mm) < 0.35 || std::abs(dark_mm) > 6) continue;
    const float* found = &image.rgba[4 * (size_t(y) * size_t(image.width) + size_t(x))];
    for (int c = 0; c < 3; ++c) most[c] = std::max(most[c], std::abs(double(found[c]) - profile.edge_of_light(dark_mm)[c]));
  }
  return most;
}

}  // namespace lamina
