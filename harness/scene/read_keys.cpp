// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/read_keys.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <map>

#include "harness/core/text.h"
#include "harness/scene/toml_values.h"

namespace lamina {
namespace {

bool is_within(std::string_view key, std::string_view prefix) {
  return key.size() > prefix.size() && key[prefix.size()] == '.' && key.starts_with(prefix);
}

// A picture's file, which must be there.
KeyValue named_file(const TomlTable& table, const std::string& name, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / table.string(name);
  if (!std::filesystem::is_regular_file(file))
    throw table.error(name, fmt::format("'{}': there is no file {}", name, file.string()));
  return {file, table.where(name)};
}

KeyValue read_number(const TomlTable& table, const std::string& name, const NumberManifest& number) {
  const double value = table.number(name);
  if (value < number.min && value != 0)
    throw table.error(name, fmt::format("'{}' must be 0, or a number from {} to {}", name, number.min, number.max));
  return {value, table.where(name)};
}

KeyValue read_texture(const TomlTable& table, const std::string& name, TextureMeaning meaning,
                      const std::filesystem::path& folder) {
  if (table.is_string(name)) return named_file(table, name, folder);
  if (meaning == TextureMeaning::number) return {table.number(name), table.where(name)};
  if (meaning == TextureMeaning::normal || meaning == TextureMeaning::normal_mean) return named_file(table, name, folder);
  if (!table.is_list(name)) throw table.error(name, fmt::format("'{}' must be a file's name or a colour [r, g, b]", name));
  return {table.vec3(name), table.where(name)};
}

// One declared key: whose it is, what it takes, and how its value is read from a table in which it has this name.
struct Declared {
  std::string key;
  const EffectManifest* effect = nullptr;
  std::string about;
  std::vector<TomlValue> values;
  std::function<KeyValue(const TomlTable& table, const std::string& name)> read;  // empty: the effect's own key
};

TomlValue value_of(const NumberManifest& number) {
  const double min = number.or_zero ? std::min(0.0, number.min) : number.min;
  return number.whole ? form::whole(min, number.max) : form::number(min, number.max);
}

std::vector<TomlValue> values_of(TextureMeaning meaning) {
  if (meaning == TextureMeaning::number) return {form::text(), form::number(0, 1)};
  if (meaning == TextureMeaning::normal || meaning == TextureMeaning::normal_mean) return {form::text()};
  return {form::text(), colour_value(1)};
}

void add_declared(std::vector<Declared>& all, const EffectManifest& effect, const Declarations& declared,
                  const std::filesystem::path& folder) {
  for (const NumberManifest& number : declared.numbers)
    all.push_back({number.key,
                   &effect,
                   number.unit.empty() ? number.title : fmt::format("{}, in {}", number.title, number.unit),
                   {value_of(number)},
                   [&number](const TomlTable& t, const std::string& n) { return read_number(t, n, number); }});
  for (const WordManifest& word : declared.words)
    all.push_back({word.key, &effect, word.title, {form::word(word.of)}, [](const TomlTable& t, const std::string& n) {
                     return KeyValue{t.string(n), t.where(n)};
                   }});
  for (const TextureManifest& texture : declared.textures) {
    const auto add = [&](const std::string& key, const std::string& title, TextureMeaning meaning) {
      all.push_back({key, &effect, title, values_of(meaning), [meaning, folder](const TomlTable& t, const std::string& n) {
                       return read_texture(t, n, meaning, folder);
                     }});
    };
    add(texture.rgb, effect.title, texture.meaning);
    if (!texture.alpha.empty()) add(texture.alpha, texture.alpha_title, TextureMeaning::number);
  }
}

std::vector<Declared> declared_of_objects(const Library& library, const std::filesystem::path& folder) {
  std::vector<Declared> declared;
  for (const EffectManifest& effect : library.effects) {
    if (!effect.key.empty()) declared.push_back({effect.key, &effect, effect.title + ": true or false", {form::flag()}, {}});
    add_declared(declared, effect, effect.object, folder);
  }
  return declared;
}

std::vector<Declared> declared_of_scene(const EffectManifest& effect, const std::filesystem::path& folder) {
  std::vector<Declared> declared;
  add_declared(declared, effect, effect.scene, folder);
  return declared;
}

// The keys of `declared` without their first `begin` characters, which all of them have: a dotted key is a table. `own` are
// further ones.
TomlFormPtr form_of(const std::vector<const Declared*>& declared, size_t begin, std::vector<TomlKey> own) {
  struct KeyPart {
    const Declared* itself = nullptr;  // the last that has this key
    std::vector<const Declared*> within;
  };
  std::map<std::string, KeyPart> parts;
  for (const Declared* one : declared) {
    const size_t end = one->key.find('.', begin);
    KeyPart& part = parts[one->key.substr(begin, end - begin)];
    if (end == std::string::npos)
      part.itself = one;
    else
      part.within.push_back(one);
  }
  for (const auto& [name, part] : parts) {
    TomlKey& made = own.emplace_back(TomlKey{name, "", {}});
    if (part.itself) made.about = part.itself->about, made.values = part.itself->values;
    if (!part.within.empty()) made.values.push_back(form::table(form_of(part.within, begin + name.size() + 1, {})));
  }
  return form::make(std::move(own));
}

TomlFormPtr form_of(const std::vector<Declared>& declared, std::vector<TomlKey> own) {
  std::vector<const Declared*> all;
  for (const Declared& one : declared) all.push_back(&one);
  return form_of(all, 0, std::move(own));
}

class Reader {
 public:
  Reader(const std::vector<Declared>& declared, Keys& keys) : declared_(declared), keys_(keys) {}

  // The keys of `table`, which begin with `prefix`, and those of the tables in it. Unknown ones are refused before any is read.
  void read(const TomlTable& table, const std::string& prefix, const std::vector<TomlKey>& own) {
    table.check_keys();
    for (const std::string& name : table.keys()) {
      if (std::any_of(own.begin(), own.end(), [&](const TomlKey& one) { return one.name == name; })) continue;
      const std::string key = prefix.empty() ? name : prefix + "." + name;
      const auto leaf = std::find_if(declared_.begin(), declared_.end(), [&](const Declared& d) { return d.key == key; });
      // An effect's own key may be the table of its others too.
      if (leaf == declared_.end() || (!leaf->read && table.is_table(name))) {
        for (const Declared& declared : declared_)
          if (is_within(declared.key, key)) speak(*declared.effect);
        read(table.table(name), key, {});
      } else if (leaf->read) {
        speak(*leaf->effect);
        keys_.values[key] = leaf->read(table, name);
      } else if (*table.optional_bool(name)) {
        keys_.calls.insert(leaf->effect->name);
      } else {
        keys_.taken_away.insert(leaf->effect->name);
      }
    }
  }

 private:
  // What every object has for every effect calls for none.
  void speak(const EffectManifest& effect) {
    if (!effect.otherwise) keys_.calls.insert(effect.name);
  }

  const std::vector<Declared>& declared_;
  Keys& keys_;
};

// The keys of an effect that the table says, the outermost names only: "outer, thickness".
std::string said_of(const TomlTable& table, const std::vector<Declared>& declared, const std::string& effect) {
  std::vector<std::string> said;
  for (const Declared& d : declared) {
    const std::string top = d.key.substr(0, d.key.find('.'));
    if (d.effect->name == effect && d.read && table.has(top) && std::find(said.begin(), said.end(), top) == said.end())
      said.push_back(top);
  }
  return fmt::format("{}", fmt::join(said, ", "));
}

}  // namespace

TomlFormPtr object_form(const Library& library) { return form_of(declared_of_objects(library, {}), placement_keys); }

TomlFormPtr effect_keys_form(const EffectManifest& effect) { return form_of(declared_of_scene(effect, {}), {}); }

Keys read_object_keys(const TomlTable& table, const Library& library, const std::filesystem::path& folder) {
  const std::vector<Declared> declared = declared_of_objects(library, folder);
  Keys keys;
  keys.where = table.where();
  Reader(declared, keys).read(table, "", placement_keys);
  for (const EffectManifest& effect : library.effects) {
    if (!keys.calls.contains(effect.name)) continue;
    if (keys.taken_away.contains(effect.name))
      throw table.error(effect.key, fmt::format("'{} = false' takes the object out of {}; leave out {}", effect.key,
                                                effect.name, said_of(table, declared, effect.name)));
    for (const std::string& other : effect.instead_of)
      if (keys.calls.contains(other))
        throw table.error({}, fmt::format("an object has {} or {}; leave out {}, or {}", effect.name, other,
                                          said_of(table, declared, effect.name), said_of(table, declared, other)));
  }
  return keys;
}

Keys read_scene_keys(const TomlTable& table, const EffectManifest& effect, const std::filesystem::path& folder) {
  const std::vector<Declared> declared = declared_of_scene(effect, folder);
  Keys keys;
  keys.where = table.where();
  Reader(declared, keys).read(table, "", {});
  keys.calls.insert(effect.name);
  return keys;
}

}  // namespace lamina
