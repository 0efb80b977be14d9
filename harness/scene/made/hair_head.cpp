// SPDX-License-Identifier: Apache-2.0
// See hair_head.h.
#include "harness/scene/made/hair_head.h"

#include <cmath>
#include <functional>

#include "harness/scene/default_views.h"
#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/hair_cards.h"
#include "harness/scene/made/sphere_mesh.h"
#include "harness/scene/made/strand_texture.h"
#include "harness/scene/mesh/tangents.h"

namespace lamina {
namespace {

constexpr glm::vec3 skin{0.56f, 0.33f, 0.24f}, hair_colour{0.175f, 0.078f, 0.034f};

float bump(float x, float y) { return std::exp(-x * x - y * y); }

// A point of the head in a direction from its middle: an egg with a jaw, a nose, eye sockets and a chin.
glm::vec3 head_point(glm::vec3 direction) {
  glm::vec3 p = direction * hair_head_half_m;
  const float low = glm::smoothstep(0.02f, -0.105f, p.y);
  p.x *= 1 - 0.30f * low;
  p.z *= p.z < 0 ? 1 - 0.36f * low : 1 - 0.06f * low;
  if (p.z <= 0) return p;
  const float x = p.x, y = p.y, front = glm::smoothstep(0.0f, 0.05f, p.z);
  p.z += front * (0.021f * bump(x / 0.011f, (y + 0.024f) / 0.019f) + 0.008f * bump(x / 0.010f, (y + 0.002f) / 0.025f) -
                  0.010f * bump((std::abs(x) - 0.030f) / 0.017f, (y - 0.004f) / 0.013f) +
                  0.007f * bump(x / 0.03f, (y + 0.088f) / 0.016f) + 0.004f * bump(x / 0.020f, (y + 0.058f) / 0.007f) -
                  0.004f * bump(x / 0.022f, (y + 0.067f) / 0.004f));
  return p;
}

// The skin under the hair, which is seen between its roots; below the hairline it lies in the head.
glm::vec3 scalp_point(glm::vec3 direction) {
  const float above = glm::smoothstep(-0.02f, 0.06f, direction.y - hairline(direction));
  return head_point(direction) * (0.94f + 0.066f * above);
}

// A sphere whose points go where `moved` says, with the normals of the new form.
Mesh formed_sphere(const std::function<glm::vec3(glm::vec3)>& moved) {
  Mesh mesh = sphere_mesh(57);
  for (Vertex& vertex : mesh.vertices) {
    const glm::vec3 out = glm::normalize(vertex.position), right = any_orthogonal(out), up = glm::cross(out, right);
    constexpr float turn = 0.004f;
    const auto slope = [&](glm::vec3 along) {
      return moved(glm::normalize(out + turn * along)) - moved(glm::normalize(out - turn * along));
    };
    vertex.position = moved(out);
    vertex.normal = glm::normalize(glm::cross(slope(right), slope(up)));
  }
  compute_tangents(mesh);
  return mesh;
}

Object hair_object() {
  const StrandTextures textures = strand_textures(hair_colour, hair_card_m);
  Object hair;
  hair.name = "hair";
  hair.mesh = hair_card_mesh(130);
  hair.said.calls.insert("hair");
  hair.said.values = {{"hair.albedo", {make_texture("strands", textures.albedo, TexelMeaning::colour)}},
                      {"hair.direction", {make_texture("strand directions", textures.direction, TexelMeaning::data)}}};
  return hair;
}

}  // namespace

Scene make_hair_head() {
  const auto ellipsoid = [](glm::vec3 middle, glm::vec3 half_m) {
    return formed_sphere([=](glm::vec3 direction) { return middle + direction * half_m; });
  };
  Scene scene;
  scene.objects.push_back(hair_object());
  scene.objects.push_back(coloured_object("head", formed_sphere(head_point), skin, false));
  scene.objects.push_back(coloured_object("scalp", formed_sphere(scalp_point), hair_colour * 0.6f, false));
  scene.objects.push_back(coloured_object("neck", ellipsoid({0, -0.14f, -0.018f}, {0.050f, 0.11f, 0.052f}), skin, false));
  scene.objects.push_back(
      coloured_object("shoulders", ellipsoid({0, -0.262f, -0.03f}, {0.20f, 0.065f, 0.085f}), {0.10f, 0.13f, 0.17f}, false));
  scene.lights.push_back(directional_light("key", glm::normalize(glm::vec3(-0.55f, 0.75f, 0.65f)), {1.5f, 1.4f, 1.25f}));
  scene.lights.push_back(directional_light("rim", glm::normalize(glm::vec3(0.65f, 0.65f, -0.8f)), {1.2f, 1.25f, 1.4f}));
  scene.lights.push_back(directional_light("fill", glm::normalize(glm::vec3(0.8f, 0.1f, 0.6f)), {0.20f, 0.24f, 0.32f}));
  scene.ambient = {0.13f, 0.135f, 0.15f};
  scene.background = {0.055f, 0.062f, 0.075f};
  scene.views = {{"three_quarter", {-0.38f, 0.10f, 0.52f}, {0, -0.035f, -0.005f}, {0, 1, 0}, 31},
                 {"behind", {0.30f, 0.14f, -0.55f}, {0, -0.04f, -0.01f}, {0, 1, 0}, 31},
                 {"close", {-0.26f, 0.10f, 0.12f}, {-0.03f, 0.02f, -0.01f}, {0, 1, 0}, 32}};
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) fit_depth(view, bounds);
  return scene;
}

}  // namespace lamina
