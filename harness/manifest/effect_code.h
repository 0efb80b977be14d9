// SPDX-License-Identifier: Apache-2.0
// The C++ that effects bring, by the names that their data files use. A folder harness/effects/NAME holds it, and its
// `void add_NAME(EffectCode&)` puts it here; CMake finds the folders, so nothing else names them.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "harness/core/format.h"

namespace lamina {

struct EffectValues;  // harness/scene/effect_values.h
struct TextureImage;  // harness/core/image.h
struct Scene;         // harness/scene/scene.h
class Baker;          // harness/bake/baker.h
class BakeTools;
class Truth;  // harness/truth/truth.h
struct TruthSetting;
class Oracle;  // harness/stress/oracle.h

// What a variant asks of its effect's baker: the numbers of its [bake] table.
using BakeOptions = std::map<std::string, double>;

// A texture or storage buffer that a baker gives for an object, by the name of the shader's sampler or block.
struct BakedName {
  std::string name;
  bool buffer = false;
  Sampler sampler{Filter::linear, Wrap::clamp};
};

struct BakerCode {
  // Why these options cannot be had; "" where they can.
  std::string (*problem)(const BakeOptions& options);
  // What there is to read, and the definitions that shaders get, with these options.
  std::vector<BakedName> (*names)(const BakeOptions& options);
  std::map<std::string, std::string> (*defines)(const BakeOptions& options);
  // Bakes a scene's objects, one after another.
  std::unique_ptr<Baker> (*start)(const Scene& scene, BakeTools& tools);
};

struct EffectCode {
  // Makes a texture for an object that brings none, from what the object's effect has so far: textures in the order in which
  // effect.toml declares them.
  using TextureMaker = std::shared_ptr<const TextureImage> (*)(const EffectValues& so_far);
  std::map<std::string, TextureMaker> makers;
  // Textures that any shader may read by name, made once.
  std::map<std::string, TextureImage (*)()> tables;
  std::map<std::string, const BakerCode*> bakers;
  std::map<std::string, std::unique_ptr<Truth> (*)(const TruthSetting& setting)> truths;
  std::map<std::string, const Oracle*> oracles;
};

// Everything that is built in.
const EffectCode& effect_code();

}  // namespace lamina
