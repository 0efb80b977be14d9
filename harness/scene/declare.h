// SPDX-License-Identifier: Apache-2.0
// From keys to what effects have: an object, or a scene, gets every number, word and texture that an effect declares, by what
// its keys say, else by its model, else by the declaration.
#pragma once

#include "harness/manifest/library.h"
#include "harness/scene/keys.h"
#include "harness/scene/scene.h"

namespace lamina {

// Puts one set of keys into effect, on top of what the object has. Where `all` says that they are for all objects, an effect
// that needs a texture that nothing stands in for goes only to the objects that have it. Throws Error(bad_input).
void apply_keys(Object& object, const Keys& keys, bool all, const Library& library);
// The same of one effect's keys about the whole scene.
void apply_scene_keys(Scene& scene, const EffectManifest& effect, const Keys& keys, const Library& library);

// What objects have before any file speaks of them: what a model gets, what the scene's code says, and what every object has.
// Gives up `said` of every object.
void declare_objects(std::vector<Object>& objects, const Library& library);
// What the scene's code says to effects of the whole scene. Gives up the scene's `said`.
void declare_said(Scene& scene, const Library& library);
// The scene's values of all effects that objects call for and that no key spoke of.
void declare_scene(Scene& scene, const Library& library);

// The object no longer calls for the effect.
void take_away(Object& object, const EffectManifest& effect);

// The effects whose objects this is one of, in drawing order: those that it calls for, or, where there is none, the one for
// what no other effect draws.
std::vector<const EffectManifest*> effects_of(const Object& object, const Library& library);

// Every number that effects declare and this scene has, by the path that sweeps set it by: "objects.NAME.KEY",
// "effects.EFFECT.KEY"; and every word.
std::map<std::string, double> declared_numbers(const Scene& scene, const Library& library);
std::map<std::string, std::string> declared_words(const Scene& scene, const Library& library);

// Sets the alpha of every texel, 0 to 1, as a sweep does. Facts are then to be settled anew.
void set_alpha(Texture& texture, TextureMeaning meaning, float alpha);

}  // namespace lamina
