// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/object_overrides.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/core/text.h"
#include "harness/scene/aperture_keys.h"
#include "harness/scene/default_layers.h"
#include "harness/scene/textures.h"
#include "harness/scene/toml_values.h"

namespace lamina {
namespace {

// The file that a key names, which must be there.
std::filesystem::path named_file(const TomlTable& table, const char* key, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / table.string(key);
  if (!std::filesystem::is_regular_file(file))
    throw table.error(key, fmt::format("'{}': there is no file {}", key, file.string()));
  return file;
}

// FILE or [r, g, b], one texel.
Texels picture_or_colour(const TomlTable& table, const char* key, const std::filesystem::path& folder) {
  if (table.is_string(key)) return load_texels(named_file(table, key, folder), true);
  if (!table.is_list(key)) throw table.error(key, fmt::format("'{}' must be a file's name or a colour [r, g, b]", key));
  return {1, 1, {glm::vec4(*colour(table, key, 1), 1)}};
}

// FILE's red channel or a number, one texel; in every channel.
Texels picture_or_number(const TomlTable& table, const char* key, const std::filesystem::path& folder) {
  if (!table.is_string(key)) return {1, 1, {glm::vec4(float(*table.optional_number(key, 0, 1)))}};
  Texels texels = load_texels(named_file(table, key, folder), false);
  for (glm::vec4& texel : texels.rgba) texel = glm::vec4(texel.r);
  return texels;
}

// `colour`'s colour and `transparency`'s alpha, at the larger of their sizes.
Texels with_transparency(const Texels& colour, const Texels& transparency) {
  const uint32_t width = std::max(colour.width, transparency.width), height = std::max(colour.height, transparency.height);
  Texels result = resized(colour, width, height);
  const Texels alpha = resized(transparency, width, height);
  for (size_t i = 0; i < result.rgba.size(); ++i) result.rgba[i].a = alpha.rgba[i].a;
  return result;
}

std::shared_ptr<const TextureImage> normal_map(const std::string& name, const std::filesystem::path& file) {
  Texels texels = load_texels(file, false);
  for (glm::vec4& texel : texels.rgba) texel.y = 1 - texel.y;
  return make_texture(name, texels, TexelMeaning::normal);
}

// One object's entry. Everything is read through the tables, so their unknown keys are refused before anything is loaded.
class Override {
 public:
  Override(const TomlTable& table, const std::filesystem::path& folder)
      : table_(table), outer_(table.table("outer")), inner_(table.table("inner")), folder_(folder) {
    expect_keys(table_, {"layers", "apertures", "aperture", "albedo", "outer", "inner", "thickness", "scattering", "position",
                         "rotation_degrees", "scale"});
    expect_keys(outer_, {"albedo", "normal", "transparency"});
    expect_keys(inner_, {"albedo"});
    if (without_layers() && speaks_of_layers())
      throw table_.error("layers", "'layers = false' takes the layers away; leave out outer, inner, thickness and scattering");
    if (without_apertures() && table_.has("aperture"))
      throw table_.error("apertures", "'apertures = false' takes the apertures away; leave out aperture");
    if (table_.has("aperture") && speaks_of_layers())
      throw table_.error("aperture",
                         "an object has apertures or layers; leave out aperture, or outer, inner, thickness and scattering");
    read_aperture(table_.table("aperture"), {});  // refused even where no object takes it
  }

  bool speaks_of_layers() const {
    return table_.has("outer") || table_.has("inner") || table_.has("thickness") || table_.has("scattering");
  }

  void place(Object& object) const {
    const glm::vec3 position = vec3(table_, "position").value_or(glm::vec3(0));
    const glm::vec3 angles = glm::radians(vec3(table_, "rotation_degrees").value_or(glm::vec3(0)));
    glm::mat4 world = glm::translate(glm::mat4(1), position);
    for (int axis = 2; axis >= 0; --axis) {
      glm::vec3 about(0);
      about[axis] = 1;
      world = glm::rotate(world, angles[axis], about);
    }
    object.world_from_object = glm::scale(world, scale()) * object.world_from_object;
  }

  void change_look(Object& object) const {
    if (without_layers()) object.layers.reset();
    if (without_apertures()) object.apertures.reset();
    if (table_.has("aperture")) {
      object.apertures = read_aperture(table_.table("aperture"), object.apertures.value_or(ApertureBake{}));
      object.layers.reset();
    }
    if (table_.has("albedo"))
      object.albedo = make_texture(object.name + " albedo", picture_or_colour(table_, "albedo", folder_), TexelMeaning::colour);
    if (!speaks_of_layers()) return;
    if (!object.layers) object.layers = new_layers(object.name);
    object.apertures.reset();
    change_layers(*object.layers, object.name);
  }

 private:
  bool without_layers() const { return !table_.optional_bool("layers").value_or(true); }

  bool without_apertures() const { return !table_.optional_bool("apertures").value_or(true); }

  glm::vec3 scale() const {
    if (!table_.has("scale")) return glm::vec3(1);
    const glm::vec3 scale =
        table_.is_list("scale") ? *vec3(table_, "scale") : glm::vec3(float(*table_.optional_number("scale", 1e-6, 1e6)));
    if (!(scale.x > 0 && scale.y > 0 && scale.z > 0)) throw table_.error("scale", "'scale' must be above 0 along every axis");
    return scale;
  }

  LayeredMaterial new_layers(const std::string& name) const {
    if (!outer_.has("albedo"))
      throw table_.error({}, fmt::format("object '{}' has no layers to change; give outer.albedo to make them", name));
    const Texels transparency{1, 1, {glm::vec4(default_transparency)}};
    return default_layers(name, with_transparency(picture_or_colour(outer_, "albedo", folder_), transparency), nullptr);
  }

  void change_layers(LayeredMaterial& layers, const std::string& name) const {
    if (outer_.has("albedo") || outer_.has("transparency")) {
      const Texels old = base_texels(*layers.outer_albedo);
      const Texels colour = outer_.has("albedo") ? picture_or_colour(outer_, "albedo", folder_) : old;
      const Texels transparency = outer_.has("transparency") ? picture_or_number(outer_, "transparency", folder_) : old;
      layers.outer_albedo = make_texture(name + " outer albedo", with_transparency(colour, transparency), TexelMeaning::colour);
    }
    if (outer_.has("normal")) layers.outer_normal = normal_map(name + " outer normal", named_file(outer_, "normal", folder_));
    if (inner_.has("albedo")) {
      const uint32_t width = layers.inner_albedo->width, height = layers.inner_albedo->height;
      Texels texels = picture_or_colour(inner_, "albedo", folder_);
      // Thickness is in texels of this layer, so one colour needs a size too.
      if (texels.width == 1 && texels.height == 1) texels = resized(texels, width, height);
      layers.inner_albedo = make_texture(name + " inner albedo", texels, TexelMeaning::colour);
      layers.thickness_texels *= float(texels.width) / float(width);
    }
    // Far beyond any texture; larger numbers are mistakes of unit.
    if (const auto thickness = table_.optional_number("thickness", 0, 65536)) layers.thickness_texels = float(*thickness);
    if (const auto scattering = table_.optional_number("scattering", 0, 1000)) layers.scattering = float(*scattering);
  }

  TomlTable table_, outer_, inner_;
  std::filesystem::path folder_;
};

}  // namespace

void override_objects(std::vector<Object>& objects, const TomlTable& root, const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const Object& object : objects) names.push_back(object.name);
  std::vector<std::pair<std::string, TomlTable>> entries = root.tables("objects");
  std::stable_partition(entries.begin(), entries.end(), [](const auto& entry) { return entry.first == "*"; });

  for (const auto& [name, table] : entries) {
    const Override change(table, folder);
    const bool all = name == "*";
    if (!all && std::find(names.begin(), names.end(), name) == names.end())
      throw table.error({}, unknown_name("object", name, names));
    for (Object& object : objects) {
      if (!all && object.name != name) continue;
      change.place(object);
      if (!all || object.layers || !change.speaks_of_layers()) change.change_look(object);
    }
  }
}

}  // namespace lamina
