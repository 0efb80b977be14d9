// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/gltf/gltf_material.h"

#include <cmath>

#include "harness/core/error.h"
#include "harness/scene/gltf/gltf_file.h"

namespace lamina {
namespace {

// The picture that a texture reference names, decoded. Works for both kinds of reference that tinygltf has.
template <class TextureInfo>
Texels decode(const tinygltf::Model& model, const TextureInfo& info, bool srgb_colour, const std::string& subject,
              std::vector<std::string>& warnings) {
  if (size_t(info.index) >= model.textures.size())
    refuse_gltf(subject, fmt::format("refers to texture {}; the file has {}", info.index, model.textures.size()));
  if (info.texCoord != 0)
    warnings.push_back(fmt::format("The {} uses texture coordinates {}; set 0 is used instead.", subject, info.texCoord));
  if (info.extensions.contains("KHR_texture_transform"))
    warnings.push_back(fmt::format("The {} has a KHR_texture_transform, which is not applied.", subject));
  const int image = model.textures[size_t(info.index)].source;
  if (image < 0)
    refuse_gltf(subject, "its texture names no picture in a format of glTF 2.0 (PNG or JPEG); export it as one of these");
  return decode_texels(encoded_picture(model, image, subject), subject, srgb_colour);
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
                   std::vector<std::string>& warnings) {
  Texels texels{1, 1, {glm::vec4(1)}};
  const tinygltf::TextureInfo& reference = material.pbrMetallicRoughness.baseColorTexture;
  if (reference.index >= 0) texels = decode(model, reference, true, subject + ", base colour texture", warnings);
  const glm::vec4 factor = base_colour_factor(material, subject, warnings);
  const bool opaque = material.alphaMode == "OPAQUE";
  for (glm::vec4& texel : texels.rgba) {
    texel *= factor;
    texel.a = opaque ? 1 : opacity(material, texel.a);
  }
  return texels;
}

std::optional<Texels> normal_map(const tinygltf::Model& model, const tinygltf::Material& material, const std::string& subject,
                                 std::vector<std::string>& warnings) {
  const tinygltf::NormalTextureInfo& reference = material.normalTexture;
  if (reference.index < 0) return std::nullopt;
  Texels texels = decode(model, reference, false, subject + ", normal texture", warnings);
  const auto scale = static_cast<float>(reference.scale);
  if (!std::isfinite(scale)) refuse_gltf(subject, "the normal texture's scale is not a finite number");
  for (glm::vec4& texel : texels.rgba) {
    texel.y = 1 - texel.y;
    glm::vec3 normal = (glm::vec3(texel) * 2.0f - 1.0f) * glm::vec3(scale, scale, 1.0f);
    // Unit again before it is stored in 0 to 1, where a scale above 1 would be cut off.
    if (const float length = glm::length(normal); scale != 1 && length > 0) normal /= length;
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

ModelLook read_material(const tinygltf::Model& model, int material, std::vector<std::string>& warnings) {
  if (material >= 0 && size_t(material) >= model.materials.size())
    refuse_gltf(fmt::format("material {}", material), fmt::format("is referred to; the file has {}", model.materials.size()));
  const tinygltf::Material& from = material < 0 ? tinygltf::Material() : model.materials[size_t(material)];
  ModelLook look;
  look.name = fmt::format("material '{}'", !from.name.empty() ? from.name
                                           : material < 0     ? "default"
                                                              : std::to_string(material));
  if (from.alphaMode != "OPAQUE" && from.alphaMode != "BLEND" && from.alphaMode != "MASK")
    refuse_gltf(look.name, fmt::format("alphaMode '{}' is none of OPAQUE, BLEND, MASK", from.alphaMode));
  look.thickness = volume_thickness(from, look.name, warnings);
  look.opaque = from.alphaMode == "OPAQUE";
  look.base_colour = base_colour(model, from, look.name, warnings);
  look.normal = normal_map(model, from, look.name, warnings);
  return look;
}

}  // namespace lamina
