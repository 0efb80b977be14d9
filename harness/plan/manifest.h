// SPDX-License-Identifier: Apache-2.0
// Effects and variants as data, read from TOML. Names are checked here, once, with file and line; after this they are known
// good.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/bake/bakes.h"

namespace lamina {

// How often a pass runs.
enum class Frequency : uint8_t {
  frame,                // every frame
  mesh_or_lights_move,  // every frame while a mesh or a light moves, else once
  once,                 // once for a scene
  truth,                // never in a frame: tells the offline truth what each pixel shows
};
enum class DrawKind : uint8_t {
  objects,     // the effect's objects on screen
  unwrapped,   // the effect's objects laid out by their texture coordinates
  fullscreen,  // one triangle over the target
  compute,
  mips,  // the mip chain of the written target
};
// One for the frame, or one for each object.
enum class Scope : uint8_t { frame, object };

struct SizeRule {
  enum class Kind : uint8_t { frame, texture, fixed } kind = Kind::frame;
  std::string texture;  // of the object, by name
  uint32_t width = 0, height = 0;
  double scale = 1;  // of the frame's size
};

struct TargetManifest {
  std::string name;
  Scope scope = Scope::frame;
  SizeRule size;
  Format format = Format::rgba16_float;
  bool mips = false;
  uint32_t buffers = 1;  // 2: ping-pong
  Sampler sampler;
};

// A storage buffer, bound to the shader's block of the same name.
struct BufferManifest {
  std::string name;
  Scope scope = Scope::frame;
  uint64_t bytes = 0, bytes_per_vertex = 0, bytes_per_pixel = 0;  // added up; per vertex: of the object
};

struct ReadManifest {
  std::string source;  // a target, a texture of the object, "frame" or "depth"
  std::optional<Filter> filter;
  std::optional<Wrap> wrap;
};

struct PassManifest {
  std::string name;
  std::string where;  // FILE:LINE, for messages
  DrawKind draw = DrawKind::objects;
  Frequency when = Frequency::frame;
  uint32_t repeat = 1;
  std::string repeat_log2_of;                       // a target: repeat ceil(log2(its longer side)) times
  std::filesystem::path vertex, fragment, compute;  // found: absolute
  std::map<std::string, std::string> defines;
  std::map<std::string, std::string> constants;  // specialization constants by name
  std::map<std::string, ReadManifest> reads;     // by sampler name, where it differs from the source's
  std::vector<std::string> writes;               // targets or "frame"; for compute: storage images by target name
  std::optional<std::array<float, 4>> clear;     // of the colour targets; absent: see graph/frame.cpp
  Blend blend = Blend::none;
  Depth depth = Depth::none;
  Cull cull = Cull::none;
  std::array<uint32_t, 3> groups = {1, 1, 1};   // compute
  std::string threads_over;                     // compute: one thread a texel of this target ...
  std::array<uint32_t, 2> local_size = {8, 8};  // ... in groups of this size, as the shader declares it
};

// A number of the variant that users may set: a specialization constant of the same name in its shaders.
struct ParameterManifest {
  std::string name, unit, title;
  double value = 0, low = 0, high = 0;
};

struct VariantManifest {
  std::string name, effect, title;
  bool baseline = false;
  std::filesystem::path file;
  std::vector<TargetManifest> targets;
  std::vector<BufferManifest> buffers;
  std::optional<ApertureKind> apertures;  // baked for each object: block Apertures, or samplers aperture_0 to aperture_3
  std::vector<ParameterManifest> parameters;
  std::vector<PassManifest> passes;

  const TargetManifest* target(std::string_view target_name) const;
};

// A definition that shaders of the effect get, per object, where a fact of the object is above 0.
struct FeatureManifest {
  std::string define, fact, because, not_because;
};

struct EffectManifest {
  std::string name, title, called_by, because, not_because;
  int order = 0;
  std::vector<FeatureManifest> features;
  std::vector<VariantManifest> variants;  // the baseline first, then by file name

  const VariantManifest& baseline() const { return variants.front(); }
};

struct Library {
  std::vector<EffectManifest> effects;  // in drawing order
  std::filesystem::path shaders;        // the folder of the built-in shaders

  // Throws Error(bad_input) with the nearest names.
  const EffectManifest& effect(std::string_view name) const;
};

// `home` holds variants/ and shaders/. Each of `user_dirs` holds variant manifests (which name their effect) and their shaders,
// or folders of whole effects with an effect.toml like the built-in ones. Throws Error(bad_input, "variants", "FILE:LINE",
// ...).
Library load_library(const std::filesystem::path& home, const std::vector<std::filesystem::path>& user_dirs = {});

}  // namespace lamina
