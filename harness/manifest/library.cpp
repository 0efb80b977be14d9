// SPDX-License-Identifier: Apache-2.0
#include "harness/manifest/library.h"

#include <algorithm>

#include "harness/core/text.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> sorted_entries(const fs::path& folder) {
  std::error_code failure;
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(folder, failure)) entries.push_back(entry.path());
  if (failure) throw Error(ErrorKind::bad_input, "variants", folder.string(), "is not a folder that can be read");
  std::sort(entries.begin(), entries.end());
  return entries;
}

void add_variant(Library& library, VariantManifest variant) {
  std::vector<std::string> names;
  for (EffectManifest& effect : library.effects) {
    names.push_back(effect.name);
    if (effect.name != variant.effect) continue;
    for (const VariantManifest& other : effect.variants) {
      if (other.name == variant.name)
        throw Error(ErrorKind::bad_input, "variants", variant.file.string(),
                    fmt::format("variant '{}' of {} is already defined in {}: choose another name", variant.name, effect.name,
                                other.file.string()));
      if (other.baseline && variant.baseline)
        throw Error(ErrorKind::bad_input, "variants", variant.file.string(),
                    fmt::format("{} already has the baseline '{}': remove 'baseline = true'", effect.name, other.name));
    }
    effect.variants.push_back(std::move(variant));
    return;
  }
  throw Error(ErrorKind::bad_input, "variants", variant.file.string(), unknown_name("effect", variant.effect, names));
}

void add_effect_folder(Library& library, const fs::path& folder) {
  library.effects.push_back(read_effect(folder / "effect.toml", *library.code));
  const std::string name = library.effects.back().name;
  for (const fs::path& file : sorted_entries(folder))
    if (file.extension() == ".toml" && file.filename() != "effect.toml")
      add_variant(library, read_variant(file, name, library.shaders));
}

// A key of objects means one thing; so does the beginning of a dotted one, which is a table of scene files.
class Keys {
 public:
  void claim(const EffectManifest& effect, const std::string& key) {
    if (key.empty()) return;
    for (const auto& [other_key, other] : owners_) {
      const bool clash = other != &effect && (other_key == key || key.starts_with(other_key + ".") ||
                                              other_key.starts_with(key + ".") || top(key) == top(other_key));
      if (clash)
        throw Error(ErrorKind::bad_input, "variants", effect.file.string(),
                    fmt::format("the key '{}' of objects is claimed by {} already ({}): choose another", key, other->name,
                                other->file.string()));
    }
    owners_.emplace_back(key, &effect);
  }

 private:
  static std::string top(const std::string& key) { return key.substr(0, key.find('.')); }
  std::vector<std::pair<std::string, const EffectManifest*>> owners_;
};

void check_keys(const Library& library) {
  Keys keys;
  for (const EffectManifest& effect : library.effects) {
    std::vector<std::string> claimed = {effect.key};
    for (const NumberManifest& number : effect.object.numbers) claimed.push_back(number.key);
    for (const WordManifest& word : effect.object.words) claimed.push_back(word.key);
    for (const TextureManifest& texture : effect.object.textures) claimed.insert(claimed.end(), {texture.rgb, texture.alpha});
    for (const std::string& key : claimed) {
      if (std::any_of(placement_keys.begin(), placement_keys.end(), [&](const TomlKey& own) { return own.name == key; }))
        throw Error(ErrorKind::bad_input, "variants", effect.file.string(),
                    fmt::format("the key '{}' says where an object is: choose another", key));
      keys.claim(effect, key);
    }
  }
}

void check_bake(const Library& library, const EffectManifest& effect, const VariantManifest& variant) {
  const std::string problem = !effect.baker.empty()  ? library.code->bakers.at(effect.baker)->problem(variant.bake)
                              : variant.bake.empty() ? ""
                                                     : fmt::format("{} bakes nothing; leave out [bake]", effect.name);
  if (!problem.empty()) throw Error(ErrorKind::bad_input, "variants", variant.file.string(), problem);
}

void check_effect(const Library& library, const EffectManifest& effect) {
  const auto refuse = [&](const std::string& message) {
    throw Error(ErrorKind::bad_input, "variants", effect.file.string(), message);
  };
  for (const EffectManifest& other : library.effects)
    if (&other != &effect && other.name == effect.name)
      refuse(fmt::format("effect '{}' is already defined in {}: choose another name", effect.name, other.file.string()));
  if (effect.variants.empty() || !effect.variants.front().baseline)
    refuse(fmt::format("{} has no baseline: one variant must say 'baseline = true'", effect.name));
  for (const std::string& name : effect.instead_of) library.effect(name);
  if (effect.otherwise && library.otherwise() != &effect)
    refuse(fmt::format("{} draws what no other effect does already: remove 'otherwise = true'", library.otherwise()->name));
  for (const VariantManifest& variant : effect.variants) check_bake(library, effect, variant);
  for (const VariantManifest& variant : effect.variants)
    for (const PassManifest& pass : variant.passes)
      if (effect.only_where_seen && pass.view != PassView::eye && pass.of == DrawnObjects::own)
        throw Error(
            ErrorKind::bad_input, "variants", pass.where,
            fmt::format("pass '{}' draws the effect's objects not from the eye: remove 'only_where_seen = true' from {}",
                        pass.name, effect.file.string()));
      else if (pass.view == PassView::mirror && !effect.mirror)
        throw Error(ErrorKind::bad_input, "variants", pass.where,
                    fmt::format("a view of kind mirror needs a plane: add [mirror] with normal and height to {}",
                                effect.file.string()));
}

}  // namespace

const EffectManifest& Library::effect(std::string_view name) const {
  std::vector<std::string> names;
  for (const EffectManifest& candidate : effects) {
    if (candidate.name == name) return candidate;
    names.push_back(candidate.name);
  }
  throw Error(ErrorKind::bad_input, "variants", std::string(name), unknown_name("effect", name, names));
}

std::string Library::declarations() const {
  std::string all;
  for (const EffectManifest& effect : effects) all += effect.name + " " + effect.digest + "\n";
  return all;
}

const EffectManifest* Library::otherwise() const {
  const auto found =
      std::find_if(effects.begin(), effects.end(), [](const EffectManifest& effect) { return effect.otherwise; });
  return found == effects.end() ? nullptr : &*found;
}

namespace {

// An effect that excludes another is excluded by it.
void exclude_each_other(Library& library) {
  for (const EffectManifest& effect : library.effects)
    for (EffectManifest& other : library.effects) {
      const auto names = [](const EffectManifest& of, const EffectManifest& one) {
        return std::find(of.instead_of.begin(), of.instead_of.end(), one.name) != of.instead_of.end();
      };
      if (names(effect, other) && !names(other, effect)) other.instead_of.push_back(effect.name);
    }
}

}  // namespace

Library load_library(const fs::path& home, const EffectCode& code, const std::vector<fs::path>& user_dirs) {
  Library library;
  library.shaders = fs::weakly_canonical(home / "shaders");
  library.code = &code;
  for (const fs::path& folder : sorted_entries(home / "variants"))
    if (fs::is_regular_file(folder / "effect.toml")) add_effect_folder(library, folder);
  for (const fs::path& dir : user_dirs) {
    size_t found = 0;
    for (const fs::path& entry : sorted_entries(dir)) {
      if (fs::is_regular_file(entry / "effect.toml"))
        add_effect_folder(library, entry), ++found;
      else if (entry.extension() == ".toml")
        add_variant(library, read_variant(entry, "", library.shaders)), ++found;
    }
    if (found == 0)
      throw Error(ErrorKind::bad_input, "variants", dir.string(), "holds no variant manifest (*.toml) and no effect folder");
  }
  for (EffectManifest& effect : library.effects)
    std::stable_partition(effect.variants.begin(), effect.variants.end(), [](const VariantManifest& v) { return v.baseline; });
  std::stable_sort(library.effects.begin(), library.effects.end(), [](const auto& a, const auto& b) {
    return std::pair(a.reads_frame, a.order) < std::pair(b.reads_frame, b.order);
  });
  for (const EffectManifest& effect : library.effects) check_effect(library, effect);
  exclude_each_other(library);
  check_keys(library);
  return library;
}

}  // namespace lamina
