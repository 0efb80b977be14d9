// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/read_keys.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "harness/core/text.h"
#include "harness/scene/toml_values.h"

namespace lamina {
namespace {

bool is_within(const std::string& key, const std::string& prefix) { return key.starts_with(prefix + "."); }

// A picture's file, which must be there.
KeyValue named_file(const TomlTable& table, const std::string& name, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / table.string(name);
  if (!std::filesystem::is_regular_file(file))
    throw table.error(name, fmt::format("'{}': there is no file {}", name, file.string()));
  return {file, table.where(name)};
}

KeyValue read_number(const TomlTable& table, const std::string& name, const NumberManifest& number) {
  const double value = *table.optional_number(name, number.or_zero ? std::min(0.0, number.min) : number.min, number.max);
  if (value < number.min && value != 0)
    throw table.error(name, fmt::format("'{}' must be 0, or a number from {} to {}", name, number.min, number.max));
  if (number.whole && value != std::floor(value))
    throw table.error(name, fmt::format("'{}' must be a whole number from {} to {}", name, number.min, number.max));
  return {value, table.where(name)};
}

KeyValue read_word(const TomlTable& table, const std::string& name, const WordManifest& word) {
  const std::string value = table.string(name);
  if (std::find(word.of.begin(), word.of.end(), value) == word.of.end())
    throw table.error(name, unknown_name(name, value, word.of));
  return {value, table.where(name)};
}

KeyValue read_texture(const TomlTable& table, const std::string& name, TextureMeaning meaning,
                      const std::filesystem::path& folder) {
  if (table.is_string(name)) return named_file(table, name, folder);
  if (meaning == TextureMeaning::number) return {*table.optional_number(name, 0, 1), table.where(name)};
  if (meaning == TextureMeaning::normal || meaning == TextureMeaning::normal_mean) return named_file(table, name, folder);
  if (!table.is_list(name)) throw table.error(name, fmt::format("'{}' must be a file's name or a colour [r, g, b]", name));
  return {*colour(table, name, 1), table.where(name)};
}

// One declared key: whose it is, and how its value is read from a table in which it has this name.
struct Declared {
  std::string key;
  const EffectManifest* effect = nullptr;
  std::function<KeyValue(const TomlTable& table, const std::string& name)> read;  // empty: the effect's own key
};

void add_declared(std::vector<Declared>& all, const EffectManifest& effect, const Declarations& declared,
                  const std::filesystem::path& folder) {
  for (const NumberManifest& number : declared.numbers)
    all.push_back(
        {number.key, &effect, [&number](const TomlTable& t, const std::string& n) { return read_number(t, n, number); }});
  for (const WordManifest& word : declared.words)
    all.push_back({word.key, &effect, [&word](const TomlTable& t, const std::string& n) { return read_word(t, n, word); }});
  for (const TextureManifest& texture : declared.textures) {
    all.push_back({texture.rgb, &effect, [&texture, folder](const TomlTable& t, const std::string& n) {
                     return read_texture(t, n, texture.meaning, folder);
                   }});
    if (!texture.alpha.empty())
      all.push_back({texture.alpha, &effect, [folder](const TomlTable& t, const std::string& n) {
                       return read_texture(t, n, TextureMeaning::number, folder);
                     }});
  }
}

class Reader {
 public:
  Reader(const std::vector<Declared>& declared, Keys& keys) : declared_(declared), keys_(keys) {}

  // The keys of `table` that begin with `prefix`, and those of the tables in it. Unknown ones are refused before any is read.
  void read(const TomlTable& table, const std::string& prefix, const std::vector<std::string>& own) {
    std::vector<std::string> known = own;
    for (const Declared& declared : declared_)
      if (prefix.empty() || is_within(declared.key, prefix)) known.push_back(next_part(declared.key, prefix));
    std::sort(known.begin(), known.end());
    known.erase(std::unique(known.begin(), known.end()), known.end());
    for (const std::string& name : table.keys())
      if (std::find(known.begin(), known.end(), name) == known.end()) throw table.error(name, unknown_name("key", name, known));
    for (const std::string& name : table.keys()) {
      if (std::find(own.begin(), own.end(), name) != own.end()) continue;
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
  static std::string next_part(const std::string& key, const std::string& prefix) {
    const size_t begin = prefix.empty() ? 0 : prefix.size() + 1;
    return key.substr(begin, key.find('.', begin) - begin);
  }
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

Keys read_object_keys(const TomlTable& table, const std::vector<std::string>& own, const Library& library,
                      const std::filesystem::path& folder) {
  std::vector<Declared> declared;
  for (const EffectManifest& effect : library.effects) {
    if (!effect.key.empty()) declared.push_back({effect.key, &effect, {}});
    add_declared(declared, effect, effect.object, folder);
  }
  Keys keys;
  keys.where = table.where();
  Reader(declared, keys).read(table, "", own);
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
  std::vector<Declared> declared;
  add_declared(declared, effect, effect.scene, folder);
  Keys keys;
  keys.where = table.where();
  Reader(declared, keys).read(table, "", {});
  keys.calls.insert(effect.name);
  return keys;
}

}  // namespace lamina
