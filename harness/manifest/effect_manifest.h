// SPDX-License-Identifier: Apache-2.0
// What an effect declares in its effect.toml: the numbers, words and textures that a scene may give it, what follows from them,
// and which C++ it needs. docs/effects.md explains every key.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "harness/core/format.h"
#include "harness/core/toml_table.h"
#include "harness/manifest/effect_code.h"
#include "harness/manifest/variant_manifest.h"

namespace lamina {

// A number of an object, or of the whole scene. It is a member of the shaders' block Effect, a key of scene files, a path of
// sweeps, a parameter of cells, and part of every cache key.
struct NumberManifest {
  std::string name, key, unit, title;
  std::optional<double> value;  // where nothing else is said; absent: the number is then not known
  double min = 0, max = 0;
  bool or_zero = false;      // 0 is allowed beside the range
  bool whole = false;        // takes whole numbers alone
  bool over_unwrap = false;  // above 0, something is laid out over the object's unwrap
  std::string scales_with;   // a texture whose texels are the unit: another width of it scales the number
  double share = 0;          // of that texture's width, in place of `value`
  std::string otherwise;     // "model.thickness": what a model says, in its own units
};

// One of a few names.
struct WordManifest {
  std::string name, key, title;
  std::vector<std::string> of;
  std::string value;   // where nothing else is said
  std::string needed;  // "" or one of `of`: where no object says it, the effect is not called for
};

// What a texel means, and so how files are read and how levels are filtered and stored.
enum class TextureMeaning : uint8_t {
  colour,       // rgba8_srgb: box filter in linear light, then encoded; alpha linear
  number,       // rgba8_unorm: a file's red channel, or a number, in every channel; box filter
  normal,       // rgba8_unorm: vectors n = 2 t - 1 averaged and made unit again
  normal_mean,  // rgba8_unorm: the same vectors, averaged only: a mean's length shows how much they scatter
  data,         // rgba8_unorm: box filter
};

struct TextureManifest {
  std::string name;        // the sampler's
  std::string rgb, alpha;  // scene keys; alpha may have none
  std::string alpha_title;
  TextureMeaning meaning = TextureMeaning::colour;
  std::string otherwise;        // "model.base_colour", "model.normal", a maker, or "" for `value`
  std::vector<double> value;    // one texel, linear; for a colour or a number that neither scene nor model nor maker gives
  std::string alpha_otherwise;  // "model.transparency" or ""
  double alpha_value = 1;       // where nothing says another
  Sampler sampler{Filter::trilinear, Wrap::repeat};
  uint32_t min_width = 1;  // texels: what is read along its width needs two, if a scene gives it
  bool required = false;   // nothing stands in for it: an object without it cannot have the effect
};

// What is asked of an object's mesh and textures: see harness/scene/facts.h for the functions.
struct FactManifest {
  std::string name, function, texture;
};

// A number or fact that must be above 0, or, written "NAME >= NUMBER", at least that number.
struct NeedManifest {
  std::string name;
  std::optional<double> at_least;
};

// A definition that shaders get, per object, where all of `needs` are met.
struct FeatureManifest {
  std::string define;
  std::vector<NeedManifest> needs;
  std::string because, not_because;
  bool at_zero = false;  // shaders draw the same to the bit with the definition where its needs are 0
};

// The plane that views of kind mirror look into: dot(normal, p) = height.
struct MirrorManifest {
  glm::vec3 normal{0, 1, 0};  // unit
  double height = 0;          // metres
  std::string height_number;  // or the scene's number of this name
};

struct Declarations {
  std::vector<NumberManifest> numbers;
  std::vector<WordManifest> words;
  std::vector<TextureManifest> textures;

  const NumberManifest* number(std::string_view name) const;
  const WordManifest* word(std::string_view name) const;
  const TextureManifest* texture(std::string_view name) const;
  bool empty() const { return numbers.empty() && words.empty() && textures.empty(); }
};

struct EffectManifest {
  std::string name, title;
  std::filesystem::path file;
  std::string digest;          // of the file's bytes
  int order = 0;               // in the frame, among those that read the frame and among those that do not
  std::string key;             // objects.NAME.KEY = false takes it away, true gives it; "": objects have no say
  bool models = false;         // what a bare model gets
  bool otherwise = false;      // what no other effect draws; its textures and numbers are there for every object and effect
  bool solid = true;           // false: its objects are no surfaces, and not drawn where a pass draws all or the opaque ones
  bool blocks_light = true;    // false: rays pass through its objects
  bool closed = false;         // its objects must be closed hulls
  bool unique_unwrap = false;  // objects whose parts share texels are taken apart
  // An object that no view can see is left out, and the effect with its last one. Only for effects whose passes draw their
  // objects from the eye, and nowhere outside the meshes.
  bool only_where_seen = false;
  bool reads_frame = false;             // drawn after all effects that do not
  std::vector<std::string> instead_of;  // effects that an object with this one cannot have; load_library() makes it mutual
  std::vector<std::string> quick;       // variants of its own folder that a quick comparison looks at; empty: all
  std::vector<NeedManifest> needs;      // where one is not met, the effect is not called for
  bool vanishes = false;                // and the object is not there at all, in place of a plain surface
  std::string because, not_because;
  std::optional<MirrorManifest> mirror;
  Declarations object, scene;
  std::vector<FactManifest> facts;
  std::vector<FeatureManifest> features;
  std::string baker, truth;               // C++ by name; "": none
  std::vector<VariantManifest> variants;  // the baseline first, then by file name

  const VariantManifest& baseline() const { return variants.front(); }
  const VariantManifest* variant(std::string_view name) const;  // null where there is none
  // Whether objects can call for it; else the scene does, by a table [effects.NAME].
  bool of_objects() const { return !key.empty() || otherwise; }
};

// What an effect.toml may hold.
TomlFormPtr effect_form(const EffectCode& code);
// Reads an effect.toml, without variants. Names of C++ are held against `code`. Throws Error(bad_input, "variants",
// "FILE:LINE", ...).
EffectManifest read_effect(const std::filesystem::path& file, const EffectCode& code);

}  // namespace lamina
