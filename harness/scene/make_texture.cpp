// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/make_texture.h"

#include <algorithm>
#include <cmath>

#include "harness/core/error.h"
#include "harness/scene/declare.h"

namespace lamina {
namespace {

TexelMeaning stored_as(TextureMeaning meaning) {
  switch (meaning) {
    case TextureMeaning::colour:
      return TexelMeaning::colour;
    case TextureMeaning::normal:
      return TexelMeaning::normal;
    case TextureMeaning::normal_mean:
      return TexelMeaning::normal_mean;
    default:
      return TexelMeaning::data;
  }
}

// A file's red channel in every channel.
Texels red_of(const std::filesystem::path& file) {
  Texels texels = load_texels(file, false);
  texels.rgba.spread_red();
  return texels;
}

Texels file_texels(const std::filesystem::path& file, TextureMeaning meaning) {
  if (meaning == TextureMeaning::number) return red_of(file);
  Texels texels = load_texels(file, meaning == TextureMeaning::colour);
  if (meaning == TextureMeaning::normal || meaning == TextureMeaning::normal_mean)
    // Green up the image in files, as glTF's.
    texels.rgba.change(
        1, [](uint8_t code) { return static_cast<uint8_t>(255 - code); }, [](float y) { return 1 - y; });
  return texels;
}

Texels said_texels(const KeyValue& said, TextureMeaning meaning) {
  if (const auto* file = std::get_if<std::filesystem::path>(&said.value)) return file_texels(*file, meaning);
  if (const auto* texture = std::get_if<Texture>(&said.value)) return base_texels(**texture);
  if (const auto* number = std::get_if<double>(&said.value)) return {1, 1, {glm::vec4(static_cast<float>(*number))}};
  return {1, 1, {glm::vec4(std::get<glm::vec3>(said.value), 1)}};
}

// `colour`'s colour and `transparency`'s alpha, at the larger of their sizes. It wraps as the colour does, or where that is the
// same everywhere as the alpha does.
Texels with_alpha(const Texels& colour, const Texels& transparency) {
  const uint32_t width = std::max(colour.width, transparency.width), height = std::max(colour.height, transparency.height);
  Texels result = resized(colour, width, height);
  if (transparency.rgba.size() == 1) {
    const float all = transparency.rgba[0].a;
    result.rgba.change(
        3, [&](uint8_t) { return static_cast<uint8_t>(std::lround(255 * std::clamp(all, 0.0f, 1.0f))); },
        [&](float) { return all; });
    return result;
  }
  const Texels alpha = resized(transparency, width, height);
  if (colour.rgba.size() == 1) result.wraps = transparency.wraps;
  if (result.rgba.take_alpha_codes(alpha.rgba)) return result;
  for (size_t i = 0; i < result.rgba.size(); ++i) result.rgba[i].a = alpha.rgba[i].a;
  return result;
}

// Where all texels have one alpha, a single texel of it: it gives no size to what takes it over.
Texels alpha_of(const Texels& texels) {
  const float first = texels.rgba[0].a;
  for (size_t i = 1; i < texels.rgba.size(); ++i)
    if (texels.rgba[i].a != first) return texels;
  return {1, 1, {glm::vec4(first)}};
}

Texels constant_texels(const TextureManifest& declared) {
  const std::vector<double>& v = declared.value;
  if (v.size() == 1) return {1, 1, {glm::vec4(static_cast<float>(v[0]))}};
  if (v.size() == 3) return {1, 1, {glm::vec4(v[0], v[1], v[2], 1)}};
  const bool normal = declared.meaning == TextureMeaning::normal || declared.meaning == TextureMeaning::normal_mean;
  return {1, 1, {normal ? glm::vec4(0.5f, 0.5f, 1, 1) : glm::vec4(1)}};
}

// What the model's material gives for this texture, or nothing.
const Texels* model_texels(const TextureRequest& request) {
  if (!request.look) return nullptr;
  if (request.declared.otherwise == "model.base_colour") return &request.look->base_colour;
  if (request.declared.otherwise == "model.normal" && request.look->normal) return &*request.look->normal;
  return nullptr;
}

Texels default_alpha(const TextureRequest& request) {
  if (!request.declared.alpha_otherwise.empty() && request.look && !request.look->opaque) {
    Texels alpha = request.look->base_colour;
    alpha.rgba.change(
        3, [](uint8_t code) { return static_cast<uint8_t>(255 - code); }, [](float a) { return 1 - a; });
    return alpha;
  }
  return {1, 1, {glm::vec4(static_cast<float>(request.declared.alpha_value))}};
}

std::string label(const TextureRequest& request, const std::string& owner) { return owner + " " + request.declared.name; }

// Of the model's look, made once for all that ask alike. A texture that need not be given and has no alpha of its own takes any
// that has the colours; one that must be given is the model's with the model's alpha.
Texture texture_of_look(const TextureRequest& request, const Texels& texels) {
  const TextureManifest& declared = request.declared;
  const std::string colours =
      fmt::format("{} {}|", model_texels(request) ? declared.otherwise : declared.name, static_cast<int>(declared.meaning));
  const std::string asked =
      declared.alpha.empty() ? colours : fmt::format("{}{} {}", colours, declared.alpha_otherwise, declared.alpha_value);
  for (const ModelLook::Made& made : request.look->made)
    if (made.of == asked || (declared.alpha.empty() && !declared.required && made.of.starts_with(colours))) return made.texture;
  const std::string name = label(request, request.look->name);
  const auto made_of = [&]() -> Texture {
    if (declared.alpha.empty()) return make_texture(name, texels, stored_as(declared.meaning));
    const Texels alpha = default_alpha(request);
    if (alpha.rgba.size() == 1) return make_texture(name, texels, stored_as(declared.meaning), alpha.rgba[0].a);
    return make_texture(name, with_alpha(texels, alpha), stored_as(declared.meaning));
  };
  const Texture made = made_of();
  request.look->made.push_back({asked, made});
  return made;
}

}  // namespace

Texture default_texture(const TextureRequest& request) {
  const TextureManifest& declared = request.declared;
  if (const Texels* texels = model_texels(request)) return texture_of_look(request, *texels);
  if (declared.required)
    throw Error(ErrorKind::bad_input, "scene", request.where.empty() ? request.owner : request.where,
                fmt::format("{} has no {}; give {}", request.owner, declared.name, declared.rgb));
  if (const auto maker = request.code.makers.find(declared.otherwise); maker != request.code.makers.end())
    return maker->second(request.so_far);
  const Texels texels = constant_texels(declared);
  if (request.look) return texture_of_look(request, texels);
  return make_texture(label(request, request.owner),
                      declared.alpha.empty() ? texels : with_alpha(texels, default_alpha(request)),
                      stored_as(declared.meaning));
}

Texture made_texture(const TextureRequest& request, const Texture& before, bool keep_size) {
  const TextureManifest& declared = request.declared;
  if (!request.rgb && !request.alpha) return before ? before : default_texture(request);
  if (request.rgb)
    if (const auto* finished = std::get_if<Texture>(&request.rgb->value)) {
      const auto* alpha = request.alpha ? std::get_if<Texture>(&request.alpha->value) : nullptr;
      // Levels of means are made from the base: what is finished may have been made of unit normals.
      if (declared.meaning != TextureMeaning::normal_mean && (declared.alpha.empty() || (alpha && *alpha == *finished)))
        return *finished;
    }
  Texture old = before;
  if (!old && !request.rgb) old = default_texture(request);
  Texels texels = request.rgb ? said_texels(*request.rgb, declared.meaning) : base_texels(*old);
  if (keep_size && before && texels.width == 1 && texels.height == 1) texels = resized(texels, before->width, before->height);
  if (!declared.alpha.empty())
    texels = with_alpha(texels, request.alpha ? said_texels(*request.alpha, TextureMeaning::number)
                                : old         ? alpha_of(base_texels(*old))
                                              : default_alpha(request));
  return make_texture(label(request, request.owner), texels, stored_as(declared.meaning));
}

void set_alpha(Texture& texture, TextureMeaning meaning, float alpha) {
  texture = make_texture(texture->name, base_texels(*texture), stored_as(meaning), alpha);
}

}  // namespace lamina
