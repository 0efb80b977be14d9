// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/gltf/gltf_json.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "harness/core/error.h"
#include "harness/scene/gltf/gltf_container.h"
#include "harness/scene/gltf/gltf_values.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

// Parsers read nested values by recursion; a hostile file must not end the process by exhausting its stack.
void refuse_deep_nesting(std::string_view json, const std::string& subject) {
  constexpr int max_depth = 200;  // glTF itself needs about ten levels
  int depth = 0;
  bool in_string = false;
  for (size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > max_depth) refuse_gltf(subject, fmt::format("its JSON is nested deeper than {} levels", max_depth));
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
}

Json parsed(std::string_view json, const std::string& subject) {
  try {
    Json root = Json::parse(json.begin(), json.end());
    if (!root.is_object()) refuse_gltf(subject, "is not a glTF 2.0 file: its JSON is not an object");
    return root;
  } catch (const Json::parse_error& error) {
    const auto before = json.substr(0, std::min(error.byte, json.size()));
    const auto lines = std::ranges::count(before, '\n');
    const size_t line_begin = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    refuse_gltf(subject, fmt::format("is not a glTF 2.0 file that can be read: its JSON breaks off or is damaged at line {}, "
                                     "column {}",
                                     lines + 1, std::max<size_t>(1, before.size() - line_begin)));
  } catch (const Json::exception&) {
    refuse_gltf(subject, "is not a glTF 2.0 file that can be read: its JSON holds text or a number that is none");
  }
}

// "2.1" as 2 and 1.
void check_version(const Json& root, const std::string& subject) {
  const auto asset = root.find("asset");
  if (asset == root.end() || !asset->is_object()) refuse_gltf(subject, "has no 'asset', which says its glTF version");
  const auto version = asset->find("version");
  if (version == asset->end() || !version->is_string())
    refuse_gltf(subject, "its 'asset' has no 'version' as text, such as \"2.0\"");
  const std::string text = version->get<std::string>();
  if (!(text == "2" || text.starts_with("2.")))
    refuse_gltf(subject, fmt::format("is glTF version '{}'; only version 2 is read", text.substr(0, 20)));
  const auto least = asset->find("minVersion");
  if (least == asset->end()) return;
  if (!least->is_string()) refuse_gltf(subject, "its 'asset' has a 'minVersion' that is not text");
  if (*least != "2.0")
    refuse_gltf(subject, fmt::format("needs a reader of glTF version '{}'; version 2.0 is read",
                                     least->get<std::string>().substr(0, 20)));
}

// Extensions that change what is drawn and are read, or are warned about where they stand.
constexpr std::array<std::string_view, 6> read_extensions = {"KHR_texture_transform",      "KHR_mesh_quantization",
                                                             "KHR_lights_punctual",        "EXT_texture_webp",
                                                             "KHR_draco_mesh_compression", "EXT_meshopt_compression"};
// Those that change no picture of the model at rest.
constexpr std::array<std::string_view, 8> unseen_extensions = {"KHR_xmp",
                                                               "KHR_xmp_json_ld",
                                                               "KHR_materials_variants",
                                                               "KHR_animation_pointer",
                                                               "KHR_node_selectability",
                                                               "KHR_node_hoverability",
                                                               "KHR_interactivity",
                                                               "AGI_articulations"};

void check_extensions(Json& root, const std::string& subject, std::vector<std::string>& warnings) {
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
    const auto found = root.find(list);
    if (found == root.end()) continue;
    if (!found->is_array() || !std::ranges::all_of(*found, [](const Json& name) { return name.is_string(); }))
      refuse_gltf(subject, fmt::format("'{}' is not a list of names", list));
  }
  const auto required = root.find("extensionsRequired");
  if (required == root.end()) return;
  for (const Json& entry : *required) {
    const std::string name = entry.get<std::string>();
    if (std::ranges::find(unseen_extensions, name) != unseen_extensions.end()) {
      warnings.push_back(fmt::format("{} requires {}, which changes no picture and is not read.", subject, name));
      continue;
    }
    // Other materials add to the look only.
    if (!name.starts_with("KHR_materials_") && std::ranges::find(read_extensions, name) == read_extensions.end())
      refuse_gltf(subject, fmt::format("requires the extension {}, which is not read; export the model without it", name));
  }
  root.erase(required);
}

std::vector<GltfSkin> take_skins(Json& root, const std::string& subject) {
  std::vector<GltfSkin> skins;
  if (Json* list = list_of(root, "skins", subject))
    for (const Json& from : *list) {
      const std::string about = fmt::format("{}: skin {}", subject, skins.size());
      GltfSkin& skin = skins.emplace_back();
      skin.inverse_bind = index_in(from, "inverseBindMatrices", about);
      const auto joints = from.find("joints");
      if (joints == from.end() || !joints->is_array()) refuse_gltf(about, "has no list of 'joints'");
      for (const Json& joint : *joints) {
        if (!joint.is_number_unsigned()) refuse_gltf(about, "'joints' are not numbers of nodes");
        skin.joints.push_back(joint.get<int>());
      }
    }
  root.erase("skins");
  return skins;
}

std::vector<int> take_node_skins(Json& root, const std::string& subject) {
  std::vector<int> skins;
  if (Json* nodes = list_of(root, "nodes", subject))
    for (Json& node : *nodes) {
      skins.push_back(index_in(node, "skin", fmt::format("{}: node {}", subject, skins.size())));
      node.erase("skin"), node.erase("camera"), node.erase("extensions");
    }
  return skins;
}

// What an exporter writes between "data:" and the comma differs ("data:;base64,", "application/gltf-buffer;charset=utf-8"); the
// bytes do not. RFC 2397; only base64 is used by glTF (section 3.6.1.1).
void make_plain_data_uri(Json& holder, const char* type, const std::string& about) {
  const auto uri = holder.find("uri");
  if (uri == holder.end() || !uri->is_string()) return;
  const std::string& text = uri->get_ref<const std::string&>();
  if (!text.starts_with("data:")) return;
  const size_t comma = text.find(',');
  if (comma == std::string::npos || comma > 200 || !text.substr(0, comma).ends_with(";base64"))
    refuse_gltf(about, "holds its bytes in a data URI that is not base64");
  *uri = fmt::format("data:{};base64,{}", type, std::string_view(text).substr(comma + 1));
}

std::string decoded_path(const std::string& uri) {
  std::string path;
  for (size_t i = 0; i < uri.size(); ++i) {
    unsigned value = 0;
    if (uri[i] == '%' && i + 2 < uri.size() && std::sscanf(uri.c_str() + i + 1, "%2x", &value) == 1) {
      path += static_cast<char>(value);
      i += 2;
    } else {
      path += uri[i];
    }
  }
  return path;
}

void refuse_folder(const std::filesystem::path& file, const std::string& uri, const std::string& about) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) refuse_gltf(about, fmt::format("its file '{}' is a folder", uri));
}

// A file beside the model that must be there to be read.
void check_file(const Json& holder, const std::filesystem::path& folder, const std::string& about) {
  const auto uri = holder.find("uri");
  if (uri == holder.end()) return;
  if (!uri->is_string()) refuse_gltf(about, "its 'uri' is not text");
  const std::string& text = uri->get_ref<const std::string&>();
  if (text.starts_with("data:")) return;
  std::error_code error;
  bool found = false;
  for (const std::string& name : {text, decoded_path(text)}) {
    const std::filesystem::path file = folder / name;
    refuse_folder(file, text, about);
    found = found || std::filesystem::exists(file, error);
  }
  if (!found) refuse_gltf(about, fmt::format("its file '{}' cannot be found beside the model", text));
}

void settle_uris(Json& root, const std::string& subject, const std::filesystem::path& folder, bool has_binary) {
  if (Json* buffers = list_of(root, "buffers", subject))
    for (size_t i = 0; i < buffers->size(); ++i) {
      Json& buffer = (*buffers)[i];
      const std::string about = fmt::format("{}: buffer {}", subject, i);
      const auto bytes = buffer.find("byteLength");
      if (bytes == buffer.end() || !bytes->is_number_unsigned()) refuse_gltf(about, "has no 'byteLength' as a whole number");
      make_plain_data_uri(buffer, "application/octet-stream", about);
      check_file(buffer, folder, about);
      // Without a uri it is the binary chunk, which must then hold it.
      if (!buffer.contains("uri") && (i > 0 || !has_binary))
        refuse_gltf(about, "has no 'uri', and the file has no binary chunk for it");
    }
  if (Json* images = list_of(root, "images", subject))
    for (size_t i = 0; i < images->size(); ++i) {
      const std::string about = fmt::format("{}: picture {}", subject, i);
      make_plain_data_uri((*images)[i], "image/png", about);
      const auto uri = (*images)[i].find("uri");
      if (uri != (*images)[i].end() && uri->is_string())
        refuse_folder(folder / uri->get<std::string>(), uri->get<std::string>(), about);
    }
  // EXT_texture_webp: the picture in WebP stands beside one in PNG or JPEG, or in its place.
  if (Json* textures = list_of(root, "textures", subject))
    for (Json& texture : *textures) {
      const auto extensions = texture.find("extensions");
      if (extensions != texture.end() && extensions->is_object() && extensions->contains("EXT_texture_webp") &&
          !texture.contains("source")) {
        const Json& webp = (*extensions)["EXT_texture_webp"];
        if (webp.is_object() && webp.contains("source")) texture["source"] = webp["source"];
      }
      texture.erase("extensions");
    }
}

// Of what a primitive's extensions say, that which is read. Its indices have no buffer view, which parsers want: their accessor
// goes to the extension.
void keep_draco(Json& primitive) {
  const char* name = "KHR_draco_mesh_compression";
  const auto extensions = primitive.find("extensions");
  if (extensions == primitive.end()) return;
  Json said = extensions->is_object() && extensions->contains(name) ? (*extensions)[name] : Json();
  primitive.erase("extensions");
  if (!said.is_object()) return;
  if (primitive.contains("indices")) said["indices"] = primitive["indices"], primitive.erase("indices");
  primitive["extensions"] = Json{{name, said}};
}

// Primitives without POSITION draw nothing (section 3.7.2.1), and parsers need not know them.
void drop_unused(Json& root, const std::string& subject, std::vector<std::string>& warnings) {
  if (root.contains("animations"))
    warnings.push_back(fmt::format(
        "{}: its animations are not played; the model stands as its nodes place it. Give a time to play the first.", subject));
  for (const char* unused : {"animations", "cameras", "extensions", "extensionsUsed", "extras"}) root.erase(unused);
  if (Json* meshes = list_of(root, "meshes", subject))
    for (size_t i = 0; i < meshes->size(); ++i) {
      const auto primitives = (*meshes)[i].find("primitives");
      if (primitives == (*meshes)[i].end() || !primitives->is_array()) continue;
      for (Json& primitive : *primitives)
        if (primitive.is_object()) keep_draco(primitive);
    }
}

}  // namespace

void refuse_gltf(const std::string& subject, const std::string& message) {
  throw Error(ErrorKind::bad_input, "gltf", subject, message);
}

GltfSource prepared_gltf(const std::string& bytes, const std::string& subject, const std::filesystem::path& folder, bool plays,
                         std::vector<std::string>& warnings) {
  const GltfContainer container = container_of(bytes, subject);
  refuse_deep_nesting(container.json, subject);
  Json root = parsed(container.json, subject);
  check_version(root, subject);
  check_extensions(root, subject, warnings);
  GltfSource source;
  source.skins = take_skins(root, subject);
  source.node_skins = take_node_skins(root, subject);
  source.compressed_views = take_compressed_views(root, subject, !container.binary.empty());
  settle_uris(root, subject, folder, !container.binary.empty());
  if (plays) source.animation = take_first_animation(root, subject);
  drop_unused(root, subject, warnings);

  const std::string json = root.dump(-1, ' ', false, Json::error_handler_t::replace);
  source.text = container.binary.empty() ? json : as_glb(json, container.binary);
  return source;
}

}  // namespace lamina
