// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/gltf/gltf_material.h"

#include <cmath>

#include "harness/core/error.h"
#include "harness/scene/gltf/gltf_file.h"

namespace lamina {
namespace {

// Up to this many texels on a side, NEAREST is kept by repeating texels: then only 1 / repetition of a texel's width is
// blended.
constexpr uint32_t nearest_side = 1024;

Texels with_repeated_texels(const Texels& from, uint32_t times) {
  Texels to{from.width * times, from.height * times, {}, from.wraps};
  to.rgba.resize(size_t{to.width} * to.height);
  for (uint32_t y = 0; y < to.height; ++y)
    for (uint32_t x = 0; x < to.width; ++x)
      to.rgba[size_t{y} * to.width + x] = from.rgba[size_t{y / times} * from.width + x / times];
  return to;
}

void keep_nearest(Texels& texels, const tinygltf::Sampler& sampler, const std::string& subject,
                  std::vector<std::string>& warnings) {
  if (sampler.magFilter != TINYGLTF_TEXTURE_FILTER_NEAREST) return;
  const uint32_t times = nearest_side / std::max(texels.width, texels.height);
  if (times >= 4)
    texels = with_repeated_texels(texels, times);
  else
    warnings.push_back(fmt::format("The {} of {} x {} texels asks for the nearest texel; it is filtered linearly.", subject,
                                   texels.width, texels.height));
}

// glTF's numbers for what lies beyond a border (section 5.26.3).
Wrap wrap_of(int number, const std::string& subject) {
  switch (number) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return Wrap::clamp;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return Wrap::mirror;
    case TINYGLTF_TEXTURE_WRAP_REPEAT:
      return Wrap::repeat;
    default:
      refuse_gltf(subject, fmt::format("its sampler wraps by {}; glTF 2.0 has 33071, 33648 and 10497", number));
  }
}

// Where a texture reference reads its picture.
struct UvUse {
  int set = 0;
  glm::dmat3 texture_from_uv{1};
  bool operator==(const UvUse&) const = default;
};

double number_in(const tinygltf::Value& value, const std::string& subject) {
  const double number = value.IsNumber() ? value.GetNumberAsDouble() : std::nan("");
  if (!std::isfinite(number)) refuse_gltf(subject, "its KHR_texture_transform holds something that is not a finite number");
  return number;
}

glm::dvec2 pair_in(const tinygltf::Value& transform, const char* name, glm::dvec2 otherwise, const std::string& subject) {
  if (!transform.Has(name)) return otherwise;
  const tinygltf::Value& pair = transform.Get(name);
  if (!pair.IsArray() || pair.ArrayLen() != 2)
    refuse_gltf(subject, fmt::format("its KHR_texture_transform's {} is not two numbers", name));
  return {number_in(pair.Get(0), subject), number_in(pair.Get(1), subject)};
}

// KHR_texture_transform (Khronos Group): translation * rotation * scale, where the rotation runs counter-clockwise as the
// picture is seen, whose v runs down.
template <class TextureInfo>
UvUse uv_use(const TextureInfo& info, const std::string& subject) {
  UvUse use{.set = info.texCoord};
  const auto found = info.extensions.find("KHR_texture_transform");
  if (found == info.extensions.end()) return use;
  const tinygltf::Value& transform = found->second;
  if (!transform.IsObject()) refuse_gltf(subject, "its KHR_texture_transform is not an object");
  const glm::dvec2 offset = pair_in(transform, "offset", {0, 0}, subject), scale = pair_in(transform, "scale", {1, 1}, subject);
  const double angle = transform.Has("rotation") ? number_in(transform.Get("rotation"), subject) : 0;
  if (transform.Has("texCoord")) use.set = static_cast<int>(number_in(transform.Get("texCoord"), subject));
  const double c = std::cos(angle), s = std::sin(angle);
  use.texture_from_uv = glm::dmat3(1, 0, 0, 0, 1, 0, offset.x, offset.y, 1) * glm::dmat3(c, -s, 0, s, c, 0, 0, 0, 1) *
                        glm::dmat3(scale.x, 0, 0, 0, scale.y, 0, 0, 0, 1);
  return use;
}

// The picture that a texture reference names, decoded. Works for both kinds of reference that tinygltf has.
template <class TextureInfo>
Texels decode(const tinygltf::Model& model, const TextureInfo& info, bool srgb_colour, const std::string& subject,
              GltfMaterial& material, std::vector<std::string>& warnings) {
  if (size_t(info.index) >= model.textures.size())
    refuse_gltf(subject, fmt::format("refers to texture {}; the file has {}", info.index, model.textures.size()));
  const tinygltf::Texture& texture = model.textures[size_t(info.index)];
  if (texture.source < 0) refuse_gltf(subject, "its texture names no picture in PNG, JPEG or WebP; export it as one of these");
  Texels texels = decode_texels(encoded_picture(model, texture.source, subject), subject, srgb_colour);
  material.textured = true;
  if (texture.sampler >= 0 && size_t(texture.sampler) < model.samplers.size()) {
    const tinygltf::Sampler& sampler = model.samplers[size_t(texture.sampler)];
    keep_nearest(texels, sampler, subject, warnings);
    const TextureWraps wraps{wrap_of(sampler.wrapS, subject), wrap_of(sampler.wrapT, subject)};
    if (wraps.u != Wrap::repeat || wraps.v != Wrap::repeat) texels.wraps = wraps;
  }
  return texels;
}

glm::vec4 base_colour_factor(const tinygltf::Material& material, const std::string& subject,
                             std::vector<std::string>& warnings) {
  const std::vector<double>& factor = material.pbrMetallicRoughness.baseColorFactor;
  if (factor.size() != 4) refuse_gltf(subject, fmt::format("baseColorFactor has {} numbers; it needs 4", factor.size()));
  const glm::vec4 given(factor[0], factor[1], factor[2], factor[3]);
  const glm::vec4 clamped = glm::clamp(given, 0.0f, 1.0f);
  if (glm::distance(given, clamped) > 1e-3f)
    warnings.push_back(fmt::format("The {}'s baseColorFactor is clamped to 0 to 1.", subject));
  return clamped;
}

float opacity(const tinygltf::Material& material, float alpha) {
  if (material.alphaMode == "MASK") return double(alpha) >= material.alphaCutoff ? 1.0f : 0.0f;
  return alpha;
}

Texels base_colour(const tinygltf::Model& model, const tinygltf::Material& material, const std::string& subject,
                   GltfMaterial& to, std::vector<std::string>& warnings) {
  Texels texels{1, 1, {glm::vec4(1)}};
  const tinygltf::TextureInfo& reference = material.pbrMetallicRoughness.baseColorTexture;
  if (reference.index >= 0) texels = decode(model, reference, true, subject + ", base colour texture", to, warnings);
  const glm::vec4 factor = base_colour_factor(material, subject, warnings);
  const bool opaque = material.alphaMode == "OPAQUE";
  to.factor = glm::vec4(glm::vec3(factor), opaque ? 1 : opacity(material, factor.a));
  if (glm::vec3(factor) != glm::vec3(1) || (!opaque && factor.a != 1))
    for (glm::vec4& texel : texels.rgba) texel *= factor;
  if (opaque)
    texels.rgba.change(
        3, [](uint8_t) { return uint8_t{255}; }, [](float) { return 1.0f; });
  else if (material.alphaMode == "MASK")
    for (glm::vec4& texel : texels.rgba) texel.a = opacity(material, texel.a);
  return texels;
}

std::optional<Texels> normal_map(const tinygltf::Model& model, const tinygltf::Material& material, const std::string& subject,
                                 GltfMaterial& to, std::vector<std::string>& warnings) {
  const tinygltf::NormalTextureInfo& reference = material.normalTexture;
  if (reference.index < 0) return std::nullopt;
  Texels texels = decode(model, reference, false, subject + ", normal texture", to, warnings);
  const auto scale = static_cast<float>(reference.scale);
  if (!std::isfinite(scale)) refuse_gltf(subject, "the normal texture's scale is not a finite number");
  texels.rgba.change(
      1, [](uint8_t code) { return static_cast<uint8_t>(255 - code); }, [](float y) { return 1 - y; });
  if (scale == 1) return texels;
  for (glm::vec4& texel : texels.rgba) {
    glm::vec3 normal = (glm::vec3(texel) * 2.0f - 1.0f) * glm::vec3(scale, scale, 1.0f);
    // Unit again before it is stored in 0 to 1, where a scale above 1 would be cut off.
    if (const float length = glm::length(normal); length > 0) normal /= length;
    texel = glm::vec4(normal * 0.5f + 0.5f, texel.a);
  }
  return texels;
}

std::optional<float> volume_thickness(const tinygltf::Material& material, const std::string& subject,
                                      std::vector<std::string>& warnings) {
  const auto volume = material.extensions.find("KHR_materials_volume");
  if (volume == material.extensions.end()) return std::nullopt;
  if (volume->second.Has("thicknessTexture"))
    warnings.push_back(fmt::format("The {}'s thicknessTexture is not used; thicknessFactor holds everywhere.", subject));
  if (!volume->second.Has("thicknessFactor")) return std::nullopt;
  const tinygltf::Value& factor = volume->second.Get("thicknessFactor");
  const double thickness = factor.IsNumber() ? factor.GetNumberAsDouble() : std::nan("");
  if (!(thickness >= 0 && std::isfinite(thickness)))
    refuse_gltf(subject, "KHR_materials_volume's thicknessFactor must be a number of at least 0");
  // The extension's 0 is its default and means a surface without volume.
  if (thickness == 0) return std::nullopt;
  return static_cast<float>(thickness);
}

}  // namespace

GltfMaterial read_material(const tinygltf::Model& model, int material, std::vector<std::string>& warnings) {
  if (material >= 0 && size_t(material) >= model.materials.size())
    refuse_gltf(fmt::format("material {}", material), fmt::format("is referred to; the file has {}", model.materials.size()));
  const tinygltf::Material& from = material < 0 ? tinygltf::Material() : model.materials[size_t(material)];
  GltfMaterial result;
  ModelLook& look = result.look;
  look.name = fmt::format("material '{}'", !from.name.empty() ? from.name
                                           : material < 0     ? "default"
                                                              : std::to_string(material));
  if (from.alphaMode != "OPAQUE" && from.alphaMode != "BLEND" && from.alphaMode != "MASK")
    refuse_gltf(look.name, fmt::format("alphaMode '{}' is none of OPAQUE, BLEND, MASK", from.alphaMode));
  look.thickness = volume_thickness(from, look.name, warnings);
  look.opaque = from.alphaMode == "OPAQUE";
  result.masked = from.alphaMode == "MASK";
  result.double_sided = from.doubleSided;
  look.base_colour = base_colour(model, from, look.name, result, warnings);
  const bool has_picture = result.textured;
  UvUse use = uv_use(from.pbrMetallicRoughness.baseColorTexture, look.name);
  if (from.normalTexture.index >= 0) {
    const UvUse of_normal = uv_use(from.normalTexture, look.name);
    if (!has_picture) use = of_normal;
    if (use == of_normal)
      look.normal = normal_map(model, from, look.name, result, warnings);
    else
      warnings.push_back(
          fmt::format("The {}'s normal map has other texture coordinates than its base colour; it is left out.", look.name));
  }
  result.uv_set = use.set;
  result.texture_from_uv = use.texture_from_uv;
  return result;
}

}  // namespace lamina
