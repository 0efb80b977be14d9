// SPDX-License-Identifier: Apache-2.0
// One declared texture of an object or a scene, made of what its keys say, of its model, or of the declaration.
#pragma once

#include <string>

#include "harness/manifest/effect_manifest.h"
#include "harness/scene/keys.h"
#include "harness/scene/model_look.h"

namespace lamina {

struct TextureRequest {
  const TextureManifest& declared;
  const KeyValue *rgb, *alpha;  // what keys say; null where they do not
  const ModelLook* look;        // null without a model
  const EffectCode& code;
  const EffectValues& so_far;        // the effect's textures declared before
  const std::string &owner, &where;  // for messages
};

// Where no key speaks of it. Throws Error(bad_input) where nothing stands in for it.
Texture default_texture(const TextureRequest& request);

// With what keys say, on top of `before` (null: the default). A file's or a code's colours keep the transparency that was
// there, and the other way round. `keep_size`: one colour is spread over the size of `before`.
Texture made_texture(const TextureRequest& request, const Texture& before, bool keep_size);

}  // namespace lamina
