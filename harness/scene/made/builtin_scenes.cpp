// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/made/builtin_scenes.h"

#include <algorithm>
#include <cmath>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/scene/made/beach.h"
#include "harness/scene/made/conical_pit.h"
#include "harness/scene/made/ear.h"
#include "harness/scene/made/far_ridges.h"
#include "harness/scene/made/fog_flight.h"
#include "harness/scene/made/fog_heart.h"
#include "harness/scene/made/fog_shaft.h"
#include "harness/scene/made/fog_valley.h"
#include "harness/scene/made/fog_xray.h"
#include "harness/scene/made/glass_drift.h"
#include "harness/scene/made/glass_stack.h"
#include "harness/scene/made/glossy_floor.h"
#include "harness/scene/made/hair_head.h"
#include "harness/scene/made/heart.h"
#include "harness/scene/made/heart_in_fog.h"
#include "harness/scene/made/hollow_shell.h"
#include "harness/scene/made/layered_scenes.h"
#include "harness/scene/made/leaf_pair.h"
#include "harness/scene/made/open_plane.h"
#include "harness/scene/made/open_sea.h"
#include "harness/scene/made/pool.h"
#include "harness/scene/made/portrait.h"
#include "harness/scene/made/rough_glass.h"
#include "harness/scene/made/skin_head.h"
#include "harness/scene/made/skin_plate.h"
#include "harness/scene/made/skin_spheres.h"
#include "harness/scene/made/sphere_over_plane.h"
#include "harness/scene/made/terrain.h"
#include "harness/scene/made/thin_glass.h"
#include "harness/scene/made/two_windows.h"
#include "harness/scene/made/valley.h"
#include "harness/scene/made/wax_block.h"

namespace lamina {
namespace {

struct Builtin {
  const char* name;
  Scene (*make)(float time_s);
};

constexpr Builtin builtins[] = {
    {"heart", [](float time_s) { return make_heart({.time_s = time_s}); }},
    {"terrain", make_terrain},
    {"sphere_over_plane", [](float) { return make_sphere_over_plane(); }},
    {"two_windows", [](float) { return make_two_windows(); }},
    {"open_plane", [](float) { return make_open_plane(); }},
    {"conical_pit", [](float) { return make_conical_pit(); }},
    {"fog_heart", make_fog_heart},
    {"fog_valley", make_fog_valley},
    {"fog_shaft", [](float) { return make_fog_shaft(); }},
    {"fog_xray", make_fog_xray},
    {"fog_flight", make_fog_flight},
    {"far_ridges", make_far_ridges},
    {"wax_block", [](float) { return make_wax_block(); }},
    {"ear", [](float) { return make_ear(); }},
    {"leaf_pair", [](float) { return make_leaf_pair(); }},
    {"hollow_shell", [](float) { return make_hollow_shell(); }},
    {"glass_stack", [](float) { return make_glass_stack(); }},
    {"thin_glass", [](float) { return make_thin_glass(); }},
    {"glass_drift", make_glass_drift},
    {"hair_head", [](float) { return make_hair_head(); }},
    {"skin_head", make_skin_head},
    {"skin_tones", make_skin_tones},
    {"skin_spheres", [](float) { return make_skin_spheres(); }},
    {"skin_plate", [](float) { return make_skin_plate(); }},
    {"rough_glass", [](float) { return make_rough_glass(); }},
    {"glossy_floor", [](float) { return make_glossy_floor(); }},
    {"pool", make_pool},
    {"open_sea", make_open_sea},
    {"beach", make_beach},
    {"three_layer_heart", make_three_layer_heart},
    {"marble_stack", [](float) { return make_marble_stack(); }},
    {"lattice_plate", [](float) { return make_lattice_plate(); }},
    {"heart_in_fog", make_heart_in_fog},
    {"portrait", make_portrait},
    {"valley", make_valley},
};

}  // namespace

std::vector<std::string> builtin_scenes() {
  std::vector<std::string> names;
  for (const Builtin& builtin : builtins) names.emplace_back(builtin.name);
  return names;
}

Scene read_builtin(const std::string& name, float time_s) {
  const auto found = std::find_if(std::begin(builtins), std::end(builtins), [&](const Builtin& b) { return b.name == name; });
  if (found == std::end(builtins))
    throw Error(ErrorKind::bad_input, "scene", name, unknown_name("built-in scene", name, builtin_scenes()));
  if (!std::isfinite(time_s)) throw Error(ErrorKind::bad_input, "scene", name, "time is not a finite number; give seconds");
  Scene scene = found->make(time_s);
  scene.name = scene.source = name;
  scene.time_s = time_s;
  scene.lights.front().casts = true;  // the key light, or the sun
  return scene;
}

}  // namespace lamina
