// SPDX-License-Identifier: Apache-2.0
// What objects have for the built-in effects.
#pragma once

#include "harness/scene/declare.h"
#include "harness/scene/textures.h"
#include "tests/builtin_library.h"

namespace lamina {

inline bool has_layers(const Object& object) { return object.effects.contains("layered_material"); }
inline const EffectValues& layers_of(const Object& object) { return object.effects.at("layered_material"); }
inline double transparency_of(const Object& object) { return layers_of(object).facts.at("transparency"); }
inline double thickness_of(const Object& object) { return layers_of(object).numbers.at("thickness"); }
inline const TextureImage& layer(const Object& object, const std::string& name) { return *layers_of(object).textures.at(name); }

inline bool has_apertures(const Object& object) { return object.effects.contains("aperture_lighting"); }
inline const EffectValues& apertures_of(const Object& object) { return object.effects.at("aperture_lighting"); }

inline const Texture& albedo_of(const Object& object) { return object.effects.at("surface").textures.at("albedo"); }

}  // namespace lamina
