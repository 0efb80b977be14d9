// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/declare.h"

#include <algorithm>
#include <utility>

#include "harness/core/text.h"
#include "harness/scene/make_texture.h"
#include "harness/scene/mesh/hull_check.h"
#include "harness/scene/mesh/texel_density.h"

namespace lamina {
namespace {

double stored(double value, bool whole) { return whole ? value : decimal(static_cast<float>(value)); }

// What keys and a model say to one effect, put into `values`; `fresh` where the effect is new to the object or scene.
class Declaration {
 public:
  Declaration(const Declarations& declared, const Keys& keys, const std::string& owner, const Mesh* mesh, const ModelLook* look,
              const EffectCode& code, EffectValues& values)
      : declared_(declared), keys_(keys), owner_(owner), mesh_(mesh), look_(look), code_(code), values_(values) {}

  void apply(bool fresh) {
    for (const TextureManifest& texture : declared_.textures) settle_texture(texture, fresh);
    for (const NumberManifest& number : declared_.numbers) settle_number(number, fresh);
    for (const WordManifest& word : declared_.words) {
      if (fresh) values_.words[word.name] = word.value;
      if (const KeyValue* said = keys_.find(word.key)) values_.words[word.name] = std::get<std::string>(said->value);
    }
  }

 private:
  bool is_unit(const TextureManifest& texture) const {
    return std::any_of(declared_.numbers.begin(), declared_.numbers.end(),
                       [&](const NumberManifest& number) { return number.scales_with == texture.name; });
  }

  void settle_texture(const TextureManifest& texture, bool fresh) {
    const KeyValue *rgb = keys_.find(texture.rgb), *alpha = keys_.find(texture.alpha);
    if (!fresh && !rgb && !alpha) return;
    const TextureRequest request{texture, rgb, alpha, look_, code_, values_, owner_, keys_.where};
    Texture& now = values_.textures[texture.name];
    // A number is in texels of this one, so one colour needs the size of what it replaces.
    const bool keeps_size = is_unit(texture);
    Texture before = now;
    if (!before && keeps_size && rgb) before = default_texture(request);
    now = made_texture(request, before, keeps_size);
    if ((rgb || alpha) && now->width < texture.min_width)
      throw Error(
          ErrorKind::bad_input, "scene", rgb ? rgb->where : alpha->where,
          fmt::format("'{}' is {} texel{} wide and must be {} at least: give a picture that says along its width what a "
                      "single colour cannot",
                      rgb ? texture.rgb : texture.alpha, now->width, now->width == 1 ? "" : "s", texture.min_width));
    if (!fresh && before && before->width != now->width) {
      const float wider = static_cast<float>(now->width) / static_cast<float>(before->width);
      for (const NumberManifest& number : declared_.numbers)
        if (const auto known = values_.numbers.find(number.name);
            number.scales_with == texture.name && known != values_.numbers.end())
          known->second = stored(static_cast<float>(known->second) * wider, number.whole);
    }
  }

  void settle_number(const NumberManifest& number, bool fresh) {
    if (const KeyValue* said = keys_.find(number.key)) {
      values_.numbers[number.name] = stored(std::get<double>(said->value), number.whole);
      return;
    }
    if (!fresh) return;
    const TextureImage* unit = number.scales_with.empty() ? nullptr : values_.textures.at(number.scales_with).get();
    if (!number.otherwise.empty() && look_ && look_->thickness)
      values_.numbers[number.name] = stored(length_in_texels(*look_->thickness, *mesh_, *unit, owner_), false);
    else if (number.share > 0)
      values_.numbers[number.name] = stored(number.share * unit->width, number.whole);
    else if (number.value)
      values_.numbers[number.name] = stored(*number.value, number.whole);
  }

  const Declarations& declared_;
  const Keys& keys_;
  const std::string& owner_;
  const Mesh* mesh_;
  const ModelLook* look_;
  const EffectCode& code_;
  EffectValues& values_;
};

// Whether some texture must be given by whoever gives an object the effect.
bool needs_given(const EffectManifest& effect) {
  return std::any_of(effect.object.textures.begin(), effect.object.textures.end(),
                     [](const TextureManifest& texture) { return texture.required; });
}

void apply_effect(Object& object, const EffectManifest& effect, const Keys& keys, const EffectCode& code) {
  const auto [entry, fresh] = object.effects.try_emplace(effect.name);
  const std::string owner = fmt::format("object '{}'", object.name);
  Declaration(effect.object, keys, owner, &object.mesh, object.look.get(), code, entry->second).apply(fresh);
  if (!fresh || !effect.closed) return;
  if (const auto problem = hull_problem(object.mesh))
    throw Error(ErrorKind::bad_input, "scene", keys.where.empty() ? owner : keys.where,
                fmt::format("{}{} needs a closed hull, and its mesh {}", keys.where.empty() ? "" : owner + ": ", effect.name,
                            *problem));
}

}  // namespace

void take_away(Object& object, const EffectManifest& effect) { object.effects.erase(effect.name); }

void apply_keys(Object& object, const Keys& keys, bool all, const Library& library) {
  for (const EffectManifest& effect : library.effects) {
    if (keys.taken_away.contains(effect.name)) take_away(object, effect);
    const bool has = object.effects.contains(effect.name);
    if (effect.otherwise || !keys.calls.contains(effect.name) || (all && !has && needs_given(effect))) continue;
    for (const std::string& other : effect.instead_of) take_away(object, library.effect(other));
    apply_effect(object, effect, keys, *library.code);
  }
  // Last, as what it takes of a model's look may have been made for another.
  if (const EffectManifest* effect = library.otherwise()) apply_effect(object, *effect, keys, *library.code);
}

void apply_scene_keys(Scene& scene, const EffectManifest& effect, const Keys& keys, const Library& library) {
  const auto [entry, fresh] = scene.effects.try_emplace(effect.name);
  const std::string owner = "scene '" + scene.name + "'";
  Declaration(effect.scene, keys, owner, nullptr, nullptr, *library.code, entry->second).apply(fresh);
}

void declare_said(Scene& scene, const Library& library) {
  for (const auto& [name, keys] : std::exchange(scene.said, {})) apply_scene_keys(scene, library.effect(name), keys, library);
}

void declare_objects(std::vector<Object>& objects, const Library& library) {
  for (Object& object : objects) {
    Keys keys = std::move(object.said);
    object.said = {};
    if (object.look)
      for (const EffectManifest& effect : library.effects)
        if (effect.models) keys.calls.insert(effect.name);
    for (const EffectManifest& effect : library.effects) {
      const auto says = [&](const auto& declared) { return keys.find(declared.key) != nullptr; };
      const auto shows = [&](const TextureManifest& texture) { return keys.find(texture.rgb) || keys.find(texture.alpha); };
      if (std::any_of(effect.object.numbers.begin(), effect.object.numbers.end(), says) ||
          std::any_of(effect.object.words.begin(), effect.object.words.end(), says) ||
          std::any_of(effect.object.textures.begin(), effect.object.textures.end(), shows) || keys.find(effect.key))
        keys.calls.insert(effect.name);
    }
    apply_keys(object, keys, false, library);
  }
}

void declare_scene(Scene& scene, const Library& library) {
  for (const EffectManifest& effect : library.effects) {
    const bool called = std::any_of(scene.objects.begin(), scene.objects.end(),
                                    [&](const Object& object) { return object.effects.contains(effect.name); });
    if (called && !effect.scene.empty() && !scene.effects.contains(effect.name)) apply_scene_keys(scene, effect, {}, library);
  }
}

namespace {

// Calls `visit` with the path's beginning, the declarations and the values of everything that the scene has.
template <class Visit>
void for_each_declared(const Scene& scene, const Library& library, Visit&& visit) {
  for (const EffectManifest& effect : library.effects) {
    for (const Object& object : scene.objects)
      if (const auto values = object.effects.find(effect.name); values != object.effects.end())
        visit("objects." + object.name + ".", effect.object, values->second);
    if (const auto values = scene.effects.find(effect.name); values != scene.effects.end())
      visit("effects." + effect.name + ".", effect.scene, values->second);
  }
}

}  // namespace

std::map<std::string, double> declared_numbers(const Scene& scene, const Library& library) {
  std::map<std::string, double> numbers;
  for_each_declared(scene, library, [&](const std::string& prefix, const Declarations& declared, const EffectValues& values) {
    for (const NumberManifest& number : declared.numbers)
      if (const auto value = values.numbers.find(number.name); value != values.numbers.end())
        numbers[prefix + number.key] = value->second;
  });
  return numbers;
}

std::map<std::string, std::string> declared_words(const Scene& scene, const Library& library) {
  std::map<std::string, std::string> words;
  for_each_declared(scene, library, [&](const std::string& prefix, const Declarations& declared, const EffectValues& values) {
    for (const WordManifest& word : declared.words) words[prefix + word.key] = values.words.at(word.name);
  });
  return words;
}

std::vector<const EffectManifest*> effects_of(const Object& object, const Library& library) {
  std::vector<const EffectManifest*> own;
  for (const EffectManifest& effect : library.effects)
    if (!effect.otherwise && object.effects.contains(effect.name)) own.push_back(&effect);
  if (own.empty() && library.otherwise()) own.push_back(library.otherwise());
  return own;
}

}  // namespace lamina
