// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/gltf/gltf_file.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <new>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/scene/gltf/gltf_draco.h"
#include "harness/scene/gltf/gltf_json.h"

namespace lamina {
namespace {

constexpr size_t max_gltf_bytes = std::numeric_limits<uint32_t>::max();  // what a .glb's header can say

std::string trimmed(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

// Keeps what came from a file or a data URI encoded. Pictures in buffer views stay there: see encoded_picture().
bool keep_encoded(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes, int size,
                  void*) {
  if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
  image->as_is = true;
  return true;
}

template <class Integer>
double integer_component(const std::byte* at, bool normalized) {
  Integer value;
  std::memcpy(&value, at, sizeof value);
  // glTF 2.0, section 3.6.2.2: signed values are clamped, so that -128 and -127 are both -1.
  return normalized ? std::max(double(value) / std::numeric_limits<Integer>::max(), -1.0) : double(value);
}

double component(const std::byte* at, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return integer_component<int8_t>(at, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return integer_component<uint8_t>(at, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return integer_component<int16_t>(at, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return integer_component<uint16_t>(at, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return integer_component<uint32_t>(at, normalized);
    default:
      break;
  }
  float value;
  std::memcpy(&value, at, sizeof value);
  return double(value);
}

// Bytes of one component of a type that glTF 2.0 allows, section 3.6.2.2.
size_t component_bytes(int type, const std::string& subject) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      refuse_gltf(subject, fmt::format("has component type {}, which glTF 2.0 does not have", type));
  }
}

// `count` elements of `components` numbers from `bytes`, `stride` apart (0: tightly packed).
std::vector<double> read_elements(std::span<const std::byte> bytes, size_t count, size_t components, int type, bool normalized,
                                  size_t stride, const std::string& subject) {
  const size_t size = component_bytes(type, subject);
  if (stride == 0) stride = size * components;
  if (count == 0) return {};
  if (size * components > bytes.size() || (count - 1) > (bytes.size() - size * components) / stride)
    refuse_gltf(subject, fmt::format("has {} elements, {} bytes apart, but only {} bytes", count, stride, bytes.size()));
  std::vector<double> values(count * components);
  for (size_t i = 0; i < count; ++i)
    for (size_t c = 0; c < components; ++c)
      values[i * components + c] = component(&bytes[i * stride + c * size], type, normalized);
  return values;
}

}  // namespace

GltfFile read_gltf_file(const std::filesystem::path& file, std::optional<double> time_s, std::vector<std::string>& warnings) {
  const std::string subject = file.string();
  const std::string bytes = read_file(file, "gltf");
  if (bytes.size() > max_gltf_bytes) refuse_gltf(subject, "is larger than 4 GiB");
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const GltfSource source = prepared_gltf(bytes, subject, folder, time_s.has_value(), warnings);
  if (source.text.size() > max_gltf_bytes) refuse_gltf(subject, "is larger than 4 GiB");

  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(keep_encoded, nullptr);
  GltfFile result;
  tinygltf::Model& model = result.model;
  std::string error, warning;
  bool read = false;
  try {
    const auto length = static_cast<unsigned>(source.text.size());
    read =
        source.text.starts_with("glTF")
            ? reader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<const unsigned char*>(source.text.data()),
                                          length, folder.string())
            : reader.LoadASCIIFromString(&model, &error, &warning, source.text.data(), length, folder.string());
  } catch (const std::bad_alloc&) {
    error = "a part of it asks for more memory than there is";
  } catch (const std::exception&) {  // an empty buffer, and what else tinygltf's at() and resize() find
    error = "a length, an index or a type in it does not fit the rest";
  }
  if (!read || !error.empty()) refuse_gltf(subject, "is not a glTF 2.0 file that can be read: " + trimmed(error));
  for (const GltfSkin& skin : source.skins) {
    tinygltf::Skin& to = model.skins.emplace_back();
    to.inverseBindMatrices = skin.inverse_bind;
    to.joints = skin.joints;
  }
  for (size_t node = 0; node < std::min(model.nodes.size(), source.node_skins.size()); ++node)
    model.nodes[node].skin = source.node_skins[node];
  decompress_views(model, source.compressed_views, subject);
  decompress_meshes(model);
  if (source.animation) {
    result.animated = play(model, *source.animation, *time_s);
    const std::string which = source.animation->of > 1 ? fmt::format(", the first of {},", source.animation->of) : "";
    warnings.push_back(fmt::format("{}: {}{} is played to {:.6g} s.", subject, source.animation->name, which, *time_s));
  }
  return result;
}

// tinygltf leaves all of these indices and lengths unchecked.
std::span<const std::byte> view_bytes(const tinygltf::Model& model, int view_index, size_t offset, const std::string& subject) {
  if (view_index < 0 || size_t(view_index) >= model.bufferViews.size())
    refuse_gltf(subject, fmt::format("refers to buffer view {}; the file has {}", view_index, model.bufferViews.size()));
  const tinygltf::BufferView& view = model.bufferViews[size_t(view_index)];
  if (view.buffer < 0 || size_t(view.buffer) >= model.buffers.size())
    refuse_gltf(subject, fmt::format("buffer view {} refers to buffer {}; the file has {}", view_index, view.buffer,
                                     model.buffers.size()));
  const std::vector<unsigned char>& data = model.buffers[size_t(view.buffer)].data;
  if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
    refuse_gltf(subject, fmt::format("buffer view {} ({} bytes from {}) leaves its buffer of {} bytes", view_index,
                                     view.byteLength, view.byteOffset, data.size()));
  if (offset > view.byteLength)
    refuse_gltf(subject, fmt::format("starts at byte {} of buffer view {}, which has {}", offset, view_index, view.byteLength));
  return std::as_bytes(std::span(data)).subspan(view.byteOffset, view.byteLength).subspan(offset);
}

std::vector<double> read_accessor(const tinygltf::Model& model, int accessor, int components, const std::string& subject) {
  if (accessor < 0 || size_t(accessor) >= model.accessors.size())
    refuse_gltf(subject, fmt::format("refers to accessor {}; the file has {}", accessor, model.accessors.size()));
  const tinygltf::Accessor& from = model.accessors[size_t(accessor)];
  const int has = tinygltf::GetNumComponentsInType(uint32_t(from.type));
  if (has != components) refuse_gltf(subject, fmt::format("has {} components where {} are needed", has, components));
  const auto width = static_cast<size_t>(components);

  std::vector<double> values;
  if (from.bufferView >= 0) {
    const auto bytes = view_bytes(model, from.bufferView, from.byteOffset, subject);
    const size_t stride = model.bufferViews[size_t(from.bufferView)].byteStride;
    values = read_elements(bytes, from.count, width, from.componentType, from.normalized, stride, subject);
  } else {
    // All zeros by definition; only sparse accessors have a use for that, and only memory bounds their count.
    constexpr size_t max_zeros = size_t{1} << 24;
    if (from.count > max_zeros) refuse_gltf(subject, fmt::format("has {} elements but no buffer view", from.count));
    values.assign(from.count * width, 0.0);
  }
  if (!from.sparse.isSparse) return values;

  const auto& sparse = from.sparse;
  if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0)
    refuse_gltf(subject, "its sparse part has a negative count or offset");
  const auto count = static_cast<size_t>(sparse.count);
  const std::vector<double> places =
      read_elements(view_bytes(model, sparse.indices.bufferView, size_t(sparse.indices.byteOffset), subject), count, 1,
                    sparse.indices.componentType, false, 0, subject);
  const std::vector<double> replaced =
      read_elements(view_bytes(model, sparse.values.bufferView, size_t(sparse.values.byteOffset), subject), count, width,
                    from.componentType, from.normalized, 0, subject);
  for (size_t i = 0; i < count; ++i) {
    if (!(places[i] >= 0 && places[i] < double(from.count)))
      refuse_gltf(subject, fmt::format("its sparse part replaces element {} of {}", places[i], from.count));
    std::copy_n(&replaced[i * width], width, &values[size_t(places[i]) * width]);
  }
  return values;
}

std::span<const std::byte> encoded_picture(const tinygltf::Model& model, int image, const std::string& subject) {
  if (image < 0 || size_t(image) >= model.images.size())
    refuse_gltf(subject, fmt::format("refers to picture {}; the file has {}", image, model.images.size()));
  const tinygltf::Image& picture = model.images[size_t(image)];
  if (picture.bufferView >= 0) return view_bytes(model, picture.bufferView, 0, subject);
  if (picture.image.empty())
    refuse_gltf(subject, fmt::format("its picture '{}' cannot be found beside the model", picture.uri));
  return std::as_bytes(std::span(picture.image));
}

}  // namespace lamina
