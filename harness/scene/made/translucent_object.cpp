// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/made/translucent_object.h"

#include "harness/scene/textures.h"

namespace lamina {
namespace {

constexpr uint32_t ramp_texels = 256;
constexpr double painted = 0.25;  // the grey of the thickness map: rather thin

// What an artist might paint who keeps to the medium: exp(-extinction s), s from 0 (the first texel's centre) to `length_m`
// (the last's).
Texture exponential_ramp(glm::vec3 extinction, float length_m) {
  Texels ramp{ramp_texels, 1, {}};
  for (uint32_t i = 0; i < ramp_texels; ++i)
    ramp.rgba.emplace_back(glm::exp(-extinction * (length_m * static_cast<float>(i) / (ramp_texels - 1))), 1);
  return make_texture("ramp", ramp, TexelMeaning::colour);
}

}  // namespace

Object translucent_object(std::string name, Mesh mesh, const TranslucentMedium& medium) {
  const double ramp_m = 4 * medium.thickness_m;
  Object object;
  object.name = std::move(name);
  object.mesh = std::move(mesh);
  object.said.calls.insert("translucency");
  object.said.values = {{"albedo", {medium.albedo}},
                        {"translucency.albedo", {medium.albedo}},
                        {"translucency.extinction_red", {double(medium.extinction.r)}},
                        {"translucency.extinction_green", {double(medium.extinction.g)}},
                        {"translucency.extinction_blue", {double(medium.extinction.b)}},
                        {"translucency.refraction_index", {medium.refraction_index}},
                        {"translucency.thickness", {painted}},
                        {"translucency.thickness_scale", {medium.thickness_m / painted}},
                        {"translucency.ramp_length", {ramp_m}},
                        {"translucency.ramp", {exponential_ramp(medium.extinction, static_cast<float>(ramp_m))}}};
  return object;
}

}  // namespace lamina
