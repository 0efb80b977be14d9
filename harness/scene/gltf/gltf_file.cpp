// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/gltf/gltf_file.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "harness/core/error.h"
#include "harness/core/text.h"

namespace lamina {
namespace {

std::string trimmed(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

uint32_t little_endian(const std::string& bytes, size_t offset) {
  uint32_t value = 0;
  for (size_t i = 0; i < 4; ++i) value |= uint32_t(uint8_t(bytes[offset + i])) << (8 * i);
  return value;
}

// glTF 2.0, section 4.4. tinygltf 2.7 checks most of this, but reads up to 8 bytes behind a binary chunk that is cut short, and
// says only "Invalid glTF binary". Returns the JSON chunk.
std::string_view checked_glb_json(const std::string& bytes, const std::string& subject) {
  constexpr size_t header_bytes = 12, chunk_header_bytes = 8;
  if (bytes.size() < header_bytes + chunk_header_bytes)
    refuse_gltf(subject, fmt::format("truncated: {} bytes are too few for a .glb's header", bytes.size()));
  if (const uint32_t version = little_endian(bytes, 4); version != 2)
    refuse_gltf(subject, fmt::format("is glTF version {}; only version 2 is read", version));
  const uint64_t promised = little_endian(bytes, 8);
  if (promised > bytes.size())
    refuse_gltf(subject, fmt::format("truncated: its header promises {} bytes, the file has {}", promised, bytes.size()));
  size_t offset = header_bytes;
  for (size_t chunk = 0; offset < promised; ++chunk) {
    if (offset + chunk_header_bytes > promised) refuse_gltf(subject, fmt::format("chunk {} is cut short", chunk));
    const uint64_t length = little_endian(bytes, offset);
    offset += chunk_header_bytes;
    if (offset + length > promised)
      refuse_gltf(subject, fmt::format("chunk {} promises {} bytes, {} are left", chunk, length, promised - offset));
    offset += length;
  }
  const uint32_t json_bytes = little_endian(bytes, header_bytes);
  return std::string_view(bytes).substr(header_bytes + chunk_header_bytes, json_bytes);
}

// tinygltf parses nested values by recursion; a hostile file must not end the process by exhausting its stack.
void refuse_deep_nesting(std::string_view json, const std::string& subject) {
  constexpr int deepest = 200;  // glTF itself needs about ten levels
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
      if (++depth > deepest) refuse_gltf(subject, fmt::format("its JSON is nested deeper than {} levels", deepest));
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
}

// Keeps what came from a file or a data URI encoded. Pictures in buffer views stay there: see encoded_picture().
bool keep_encoded(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes, int size,
                  void*) {
  if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
  image->as_is = true;
  return true;
}

// Extensions that add to the look only, or that this loader reads or warns about; any other that a file requires changes what
// its data means.
bool readable_without(const std::string& extension) {
  static constexpr std::array<std::string_view, 3> readable = {"KHR_texture_transform", "KHR_mesh_quantization",
                                                               "KHR_lights_punctual"};
  return extension.starts_with("KHR_materials_") || std::find(readable.begin(), readable.end(), extension) != readable.end();
}

// Bytes of a buffer view from `offset`. tinygltf leaves all of these indices and lengths unchecked.
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

void refuse_gltf(const std::string& subject, const std::string& message) {
  throw Error(ErrorKind::bad_input, "gltf", subject, message);
}

tinygltf::Model read_gltf_file(const std::filesystem::path& file, std::vector<std::string>& warnings) {
  const std::string subject = file.string();
  const std::string bytes = read_file(file, "gltf");
  const bool binary = bytes.starts_with("glTF");
  refuse_deep_nesting(binary ? checked_glb_json(bytes, subject) : std::string_view(bytes), subject);
  if (bytes.size() > std::numeric_limits<uint32_t>::max()) refuse_gltf(subject, "is larger than 4 GiB");

  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(keep_encoded, nullptr);
  tinygltf::Model model;
  std::string error, warning;
  const std::string folder = file.has_parent_path() ? file.parent_path().string() : ".";
  const auto length = static_cast<unsigned>(bytes.size());
  bool read = false;
  try {
    read = binary ? reader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
                                                length, folder)
                  : reader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), length, folder);
  } catch (const std::exception& thrown) {  // an empty buffer, and what else tinygltf's at() and resize() find
    error = thrown.what();
  }
  if (!read || !error.empty()) refuse_gltf(subject, "is not a glTF 2.0 file that can be read: " + trimmed(error));
  if (!warning.empty()) warnings.push_back(subject + ": " + trimmed(warning) + ".");
  for (const std::string& extension : model.extensionsRequired)
    if (!readable_without(extension))
      refuse_gltf(subject, fmt::format("requires the extension {}, which is not read; export the model without it", extension));
  return model;
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
