// SPDX-License-Identifier: Apache-2.0
// A variant as data: targets, buffers, parameters and passes, read from TOML. Names are checked here, once, with file and line;
// after this they are known good. docs/manifest.md explains every key.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/core/toml_table.h"
#include "harness/manifest/effect_code.h"

namespace lamina {

// How often a pass runs.
enum class Frequency : uint8_t {
  frame,                // every frame
  mesh_or_lights_move,  // every frame while a mesh or a light moves, else once
  once,                 // once for a scene
  truth,                // never in a frame: draws for the offline truth what each pixel shows
  frame_and_truth,      // every frame, and before the passes for the truth, which read what it writes
};
enum class DrawKind : uint8_t {
  objects,     // objects on screen
  unwrapped,   // the effect's objects laid out by their texture coordinates
  fullscreen,  // one triangle over the target
  compute,
  mips,  // the mip chain of the written target
};
// Which objects a pass of objects draws.
enum class DrawnObjects : uint8_t {
  own,     // the effect's
  all,     // every solid one
  opaque,  // every solid one of effects that do not read the frame
};
// From where.
enum class PassView : uint8_t {
  eye,
  light,   // once for each light that casts
  mirror,  // the eye's, reflected in the effect's mirror
};
// One for the frame, one for each object, or one for each light that casts.
enum class Scope : uint8_t { frame, object, light };
// Whether a repeated pass walks down or up the mip chain of what it writes, one level at a time.
enum class LevelWalk : uint8_t { none, down, up };

// A number of a manifest, or the variant's parameter that gives it, written "$NAME".
struct Setting {
  double value = 0;
  std::string parameter;
};

struct SizeRule {
  enum class Kind : uint8_t { frame, texture, fixed } kind = Kind::frame;
  std::string texture;  // of the object, by name
  Setting width, height;
  Setting scale{1, {}};  // of the frame's or the texture's size
};

struct TargetManifest {
  std::string name;
  Scope scope = Scope::frame;
  SizeRule size;
  Format format = Format::rgba16_float;
  std::string format_parameter;  // a word, "" where the format is fixed
  bool mips = false;
  uint32_t buffers = 1;  // 2: ping-pong
  Sampler sampler;
  bool shared = false;  // one for all effects that declare it alike: the first pass that writes it serves all
};

// A storage buffer, bound to the shader's block of the same name.
struct BufferManifest {
  std::string name;
  Scope scope = Scope::frame;
  uint64_t bytes = 0, bytes_per_vertex = 0, bytes_per_pixel = 0;  // added up; per vertex: of the object
};

struct ReadManifest {
  std::string source;  // a target, a texture of the object or scene, a baked one, a table, "frame" or "depth"
  std::optional<Filter> filter;
  std::optional<Wrap> wrap;
};

struct PassManifest {
  std::string name;
  std::string where;  // FILE:LINE, for messages
  DrawKind draw = DrawKind::objects;
  DrawnObjects of = DrawnObjects::own;
  std::string with, without;  // features: only objects that have the one and lack the other; "": all
  PassView view = PassView::eye;
  Frequency when = Frequency::frame;
  Setting repeat{1, {}};
  std::string repeat_log2_of;                       // a target: repeat ceil(log2(its longer side)) times
  LevelWalk levels = LevelWalk::none;               // of the written target: repeat once for each level but the first
  bool needs_light = true;                          // false: left out, not an error, where it has a light's view and none casts
  bool until_empty = false;                         // stop repeating after a repetition that drew no sample
  std::filesystem::path vertex, fragment, compute;  // found: absolute
  std::map<std::string, std::string> defines;       // text, or "$PARAMETER"
  std::map<std::string, std::string> constants;     // specialization constants by name
  std::map<std::string, ReadManifest> reads;        // by sampler name, where it differs from the source's
  std::vector<std::string> writes;                  // targets or "frame"; for compute: storage images by target name
  std::optional<std::array<float, 4>> clear;        // of the colour targets; absent: see graph/frame_passes.h
  std::vector<Blend> blend;                         // beside `writes`
  Depth depth = Depth::none;
  DepthTest depth_test = DepthTest::less_equal;
  std::string depth_target;  // in place of the frame's depth
  float clear_depth = 1;
  bool clear_depth_again = false;  // before every repetition
  Cull cull = Cull::none;
  std::array<uint32_t, 3> groups = {1, 1, 1};   // compute
  std::string threads_over;                     // compute: one thread a texel of this target ...
  std::array<uint32_t, 2> local_size = {8, 8};  // ... in groups of this size, as the shader declares it

  // What the pass leaves something in: `writes`, and a depth target of its own.
  std::vector<std::string> written() const;
  // The texture that a sampler of the pass's shaders reads, where it says no other.
  ReadManifest read_of(const std::string& sampler) const;
};

// A number or a word of the variant that users may set. A specialization constant of the same name in its shaders takes it; so
// do a pass's definitions and repetitions, and a target's size and format, where they say "$NAME".
struct ParameterManifest {
  std::string name, unit, title;
  double value = 0, min = 0, max = 0;  // of a word: its place in `words`
  bool whole = false;
  std::vector<std::string> words;  // empty: a number
  std::vector<double> tries;       // what lamina choose tries beside `value`

  // As a definition's text: 2, 0.5, or the word.
  std::string text(double of) const;
};
// Values of variants' parameters by path, "VARIANT.PARAMETER"; those that are not there have their defaults.
using Parameters = std::map<std::string, double>;

struct VariantManifest {
  std::string name, effect, title;
  bool baseline = false;
  bool closed = false;  // fails, by name, on an object whose mesh is no closed hull
  std::filesystem::path file;
  std::vector<TargetManifest> targets;
  std::vector<BufferManifest> buffers;
  BakeOptions bake;  // what the effect's baker is asked for
  std::vector<ParameterManifest> parameters;
  std::vector<PassManifest> passes;

  const TargetManifest* target(std::string_view target_name) const;
  const ParameterManifest* parameter(std::string_view parameter_name) const;
  double value_of(const Setting& setting, const Parameters& parameters) const;
  double value_of(const ParameterManifest& parameter, const Parameters& parameters) const;
  Format format_of(const TargetManifest& target, const Parameters& parameters) const;
  // The same with these values, by the parameters' own names, as defaults.
  VariantManifest with_defaults(const std::map<std::string, double>& values) const;
};

// What a manifest may hold.
TomlFormPtr variant_form();
// `effect`: of the folder that the file lies in, or "" where the file itself must say. Shaders are looked for beside the file,
// then in `shaders`. Throws Error(bad_input, "variants", "FILE:LINE", ...).
VariantManifest read_variant(const std::filesystem::path& file, const std::string& effect,
                             const std::filesystem::path& shaders);

}  // namespace lamina
