// SPDX-License-Identifier: Apache-2.0
// See heart.h.
#include "harness/scene/made/heart.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "harness/core/error.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/heart_mesh.h"
#include "harness/scene/made/heart_textures.h"

namespace lamina {
namespace {

// A resting adult's heart: 67 beats a minute.
constexpr double beat_period_s = 0.9;

// Thickness in texels at 1024, expanded and contracted, as Oat's figure 11 shows it: expanded, the layers lie far apart.
constexpr float thick_texels = 16, thin_texels = 5;

// 0 expanded .. 1 contracted. Systole takes about a third of a beat: a quick squeeze, a short hold, a slower release, then rest
// (after Wiggers' diagram of the cardiac cycle, 1915).
float contraction(double time_s) {
  const double beats = time_s / beat_period_s, phase = beats - std::floor(beats);
  return static_cast<float>(glm::smoothstep(0.10, 0.28, phase) - glm::smoothstep(0.40, 0.70, phase));
}

}  // namespace

Scene make_heart(const HeartOptions& options) {
  if (!std::isfinite(options.time_s))
    throw Error(ErrorKind::bad_input, "scene", "heart", "time is not a finite number; give seconds");
  if (!std::has_single_bit(options.texture_size) || options.texture_size < 64 || options.texture_size > 4096)
    throw Error(ErrorKind::bad_input, "scene", "heart",
                fmt::format("textures of {} texels on a side; take a power of two from 64 to 4096", options.texture_size));

  const float squeeze = contraction(options.time_s);
  const HeartTextures textures = heart_textures(options.texture_size);
  Object object;
  object.name = "heart";
  object.mesh = heart_mesh(squeeze);
  const float thickness =
      (thick_texels + squeeze * (thin_texels - thick_texels)) * static_cast<float>(options.texture_size) / 1024;
  object.said.values = {{"albedo", {textures.outer_albedo}},
                        {"outer.albedo", {textures.outer_albedo}},
                        {"outer.transparency", {textures.outer_albedo}},
                        {"outer.normal", {textures.outer_normal}},
                        {"inner.albedo", {textures.inner_albedo}},
                        {"inner.transparency", {textures.inner_albedo}},
                        {"thickness", {double(thickness)}}};

  Scene scene;
  scene.name = scene.source = "heart";
  scene.time_s = options.time_s;
  scene.objects.push_back(std::move(object));
  scene.lights.push_back(directional_light("key", glm::normalize(glm::vec3(-0.55f, 0.75f, 0.85f)), {1.55f, 1.42f, 1.28f}));
  scene.lights.push_back(directional_light("fill", glm::normalize(glm::vec3(0.95f, -0.10f, 0.55f)), {0.26f, 0.33f, 0.44f}));
  Light rim;
  rim.name = "rim";
  rim.kind = Light::Kind::point;
  rim.position = {1.5f, 1.3f, -1.7f};
  rim.radiance = {4.2f, 3.6f, 3.2f};
  scene.lights.push_back(rim);
  scene.ambient = {0.075f, 0.07f, 0.08f};
  scene.background = {0.018f, 0.019f, 0.022f};
  scene.views = {{"front", {0.15f, 0.36f, 4.6f}, {0.06f, 0.27f, 0}, {0, 1, 0}, 36, 0.05f, 20},
                 {"three_quarter", {-2.7f, 1.0f, 3.35f}, {0.0f, 0.34f, 0}, {0, 1, 0}, 36, 0.05f, 20},
                 {"grazing", {0.30f, -1.38f, 0.92f}, {-0.10f, -0.10f, 0.38f}, {0.25f, 0.6f, 1}, 42, 0.02f, 20}};
  scene.mesh_moves = true;
  return scene;
}

}  // namespace lamina
