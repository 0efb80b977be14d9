// SPDX-License-Identifier: Apache-2.0
// Where a texture or storage buffer that a shader names comes from. One chain, in this order: the variant's targets and
// buffers, the frame and its depth, the object's textures, what its effect bakes for it, the scene's textures, named tables.
#pragma once

#include <optional>
#include <string>

#include "harness/plan/plan.h"

namespace lamina {

struct Source {
  enum class Kind : uint8_t { target, buffer, frame, depth, object_texture, baked, scene_texture, table } kind = Kind::target;
  std::string name;                          // of the target, texture, baked thing or table
  const EffectManifest* effect = nullptr;    // whose texture it is
  const VariantManifest* variant = nullptr;  // whose target or bake it is
  std::optional<size_t> light;               // of the scene: a light's target
  Sampler sampler;
};

// What a draw may read.
struct SourceContext {
  const Plan& plan;
  const Scene& scene;
  const EffectManifest& effect;
  const VariantManifest& variant;
  const PassManifest& pass;
  std::optional<size_t> object, light;
};

// A sampler's texture. Throws Error(bad_input) naming the pass, with the nearest name.
Source texture_source(const SourceContext& context, const std::string& sampler);
// A storage block's buffer. Likewise.
Source buffer_source(const SourceContext& context, const std::string& block);

}  // namespace lamina
