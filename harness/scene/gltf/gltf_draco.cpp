// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/gltf/gltf_draco.h"

#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <optional>

#include "harness/scene/gltf/gltf_file.h"

namespace lamina {
namespace {

constexpr const char* draco_extension = "KHR_draco_mesh_compression";

// A flat grid of 2 million triangles, which predictions foretell whole, takes a byte for 520 of them; real meshes one or two
// bytes each. A stream of no length may claim what is allocated without a thought.
constexpr uint64_t faces_a_byte = 1024, faces_for_nothing = 1u << 16, max_faces = 1u << 26;

struct Claim {
  uint64_t faces = 0, vertices = 0;
};

// What the stream's head says that it holds (Draco Bitstream Specification 2.2, sections 3.1 to 3.4): nothing where it is no
// mesh of that version.
std::optional<Claim> claim_of(std::span<const std::byte> bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) return std::nullopt;
  if (header.version_major != 2 || header.version_minor != 2 || header.encoder_type != draco::TRIANGULAR_MESH)
    return std::nullopt;
  constexpr uint16_t version = DRACO_BITSTREAM_VERSION(2, 2);
  buffer.set_bitstream_version(version);
  draco::GeometryMetadata metadata;
  if ((header.flags & METADATA_FLAG_MASK) != 0 && !draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata))
    return std::nullopt;
  uint32_t first = 0, second = 0;
  if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING) {  // its traversal's kind, vertices, faces
    uint8_t traversal = 0;
    if (!buffer.Decode(&traversal) || !draco::DecodeVarint(&first, &buffer) || !draco::DecodeVarint(&second, &buffer))
      return std::nullopt;
    return Claim{second, first};
  }
  if (!draco::DecodeVarint(&first, &buffer) || !draco::DecodeVarint(&second, &buffer)) return std::nullopt;
  return Claim{first, second};
}

// Component type as glTF numbers it, and its bytes.
int component_type(draco::DataType type, const std::string& subject) {
  switch (type) {
    case draco::DT_INT8:
      return TINYGLTF_COMPONENT_TYPE_BYTE;
    case draco::DT_UINT8:
    case draco::DT_BOOL:
      return TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
    case draco::DT_INT16:
      return TINYGLTF_COMPONENT_TYPE_SHORT;
    case draco::DT_UINT16:
      return TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    case draco::DT_UINT32:
      return TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    case draco::DT_FLOAT32:
      return TINYGLTF_COMPONENT_TYPE_FLOAT;
    default:
      refuse_gltf(subject, "its stream has a type of numbers that glTF 2.0 does not have");
  }
}

// An accessor like `of` for `bytes` in a buffer of their own; its index.
int add_accessor(tinygltf::Model& model, tinygltf::Accessor of, std::vector<unsigned char> bytes) {
  tinygltf::BufferView view;
  view.buffer = static_cast<int>(model.buffers.size());
  view.byteLength = bytes.size();
  tinygltf::Buffer buffer;
  buffer.data = std::move(bytes);
  model.buffers.push_back(std::move(buffer));
  of.bufferView = static_cast<int>(model.bufferViews.size());
  of.byteOffset = 0;
  of.sparse = {};
  model.bufferViews.push_back(view);
  model.accessors.push_back(std::move(of));
  return static_cast<int>(model.accessors.size()) - 1;
}

const tinygltf::Accessor& accessor_of(const tinygltf::Model& model, int index, const std::string& subject) {
  if (index < 0 || size_t(index) >= model.accessors.size())
    refuse_gltf(subject, fmt::format("refers to accessor {}; the file has {}", index, model.accessors.size()));
  return model.accessors[size_t(index)];
}

// A whole number that the extension must have.
int number_of(const tinygltf::Value& value, const char* name, const std::string& subject) {
  if (!value.IsInt() || value.GetNumberAsInt() < 0) refuse_gltf(subject, fmt::format("has no number of its {}", name));
  return value.GetNumberAsInt();
}

std::unique_ptr<draco::Mesh> decoded(std::span<const std::byte> bytes, const std::string& subject) {
  const char* damaged = "its stream is damaged; export the model again";
  try {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::StatusOr<std::unique_ptr<draco::Mesh>> mesh = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    if (!mesh.ok()) refuse_gltf(subject, damaged);
    return std::move(mesh).value();
  } catch (const std::bad_alloc&) {
    refuse_gltf(subject, "its stream asks for more memory than there is");
  } catch (const std::length_error&) {
    refuse_gltf(subject, damaged);
  }
}

class Primitive {
 public:
  Primitive(tinygltf::Model& model, tinygltf::Primitive& primitive, const tinygltf::Value& said, std::string subject)
      : model_(model), primitive_(primitive), said_(said), subject_(std::move(subject)) {}

  void decompress() {
    if (!said_.IsObject() || !said_.Has("bufferView") || !said_.Has("attributes") || !said_.Get("attributes").IsObject())
      refuse_gltf(subject_, "is no object with 'bufferView' and 'attributes'");
    const auto bytes = view_bytes(model_, number_of(said_.Get("bufferView"), "bufferView", subject_), 0, subject_);
    check_claim(bytes);
    const std::unique_ptr<draco::Mesh> mesh = decoded(bytes, subject_);
    put_triangles(*mesh);
    const tinygltf::Value& attributes = said_.Get("attributes");
    for (const std::string& name : attributes.Keys())
      put_attribute(*mesh, name, number_of(attributes.Get(name), name.c_str(), subject_));
  }

 private:
  void check_claim(std::span<const std::byte> bytes) const {
    const std::optional<Claim> claim = claim_of(bytes);
    if (!claim) refuse_gltf(subject_, "its stream is damaged, or not a mesh in Draco's bitstream 2.2; export the model again");
    const uint64_t most = std::min(max_faces, faces_for_nothing + faces_a_byte * bytes.size());
    if (claim->faces > most || claim->vertices > 3 * most)
      refuse_gltf(subject_, fmt::format("its stream claims {} triangles of {} vertices; {} bytes cannot hold more than {}",
                                        claim->faces, claim->vertices, bytes.size(), most));
    if (!said_.Has("indices") || primitive_.mode != TINYGLTF_MODE_TRIANGLES) return;
    const int accessor = number_of(said_.Get("indices"), "indices", subject_);
    if (const size_t indices = accessor_of(model_, accessor, subject_).count; indices != 3 * claim->faces)
      refuse_gltf(subject_,
                  fmt::format("its stream has {} triangles, where its accessor has {} indices", claim->faces, indices));
  }

  // Strips are triangles too once they are decoded.
  void put_triangles(const draco::Mesh& mesh) {
    std::vector<unsigned char> bytes(size_t{mesh.num_faces()} * 3 * sizeof(uint32_t));
    size_t at = 0;
    for (uint32_t face = 0; face < mesh.num_faces(); ++face)
      for (int corner = 0; corner < 3; ++corner, at += sizeof(uint32_t)) {
        const uint32_t point = mesh.face(draco::FaceIndex(face))[size_t(corner)].value();
        std::memcpy(&bytes[at], &point, sizeof point);
      }
    tinygltf::Accessor of;
    of.type = TINYGLTF_TYPE_SCALAR;
    of.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    of.count = size_t{mesh.num_faces()} * 3;
    primitive_.indices = add_accessor(model_, of, std::move(bytes));
    primitive_.mode = TINYGLTF_MODE_TRIANGLES;
  }

  void put_attribute(const draco::Mesh& mesh, const std::string& name, int id) {
    const auto to = primitive_.attributes.find(name);
    if (to == primitive_.attributes.end()) refuse_gltf(subject_, fmt::format("has {}, which the primitive has not", name));
    const std::string about = fmt::format("{}, {}", subject_, name);
    const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(static_cast<uint32_t>(id));
    if (!attribute) refuse_gltf(about, fmt::format("its stream has no attribute {}", id));
    tinygltf::Accessor of = accessor_of(model_, to->second, about);
    if (of.count != mesh.num_points())
      refuse_gltf(about, fmt::format("its stream has {} vertices, where its accessor has {}", mesh.num_points(), of.count));
    if (tinygltf::GetNumComponentsInType(uint32_t(of.type)) != attribute->num_components())
      refuse_gltf(about, fmt::format("its stream has {} numbers a vertex, where its accessor has another type",
                                     attribute->num_components()));
    of.componentType = component_type(attribute->data_type(), about);
    const size_t bytes_each = size_t(attribute->num_components()) * size_t(draco::DataTypeLength(attribute->data_type()));
    std::vector<unsigned char> bytes(bytes_each * mesh.num_points());
    for (uint32_t point = 0; point < mesh.num_points(); ++point) {
      const draco::AttributeValueIndex value = attribute->mapped_index(draco::PointIndex(point));
      if (value.value() >= attribute->size()) refuse_gltf(about, "its stream is damaged; export the model again");
      attribute->GetValue(value, &bytes[point * bytes_each]);
    }
    to->second = add_accessor(model_, of, std::move(bytes));
  }

  tinygltf::Model& model_;
  tinygltf::Primitive& primitive_;
  const tinygltf::Value& said_;
  const std::string subject_;
};

}  // namespace

void decompress_meshes(tinygltf::Model& model) {
  for (size_t i = 0; i < model.meshes.size(); ++i)
    for (tinygltf::Primitive& primitive : model.meshes[i].primitives) {
      const auto said = primitive.extensions.find(draco_extension);
      if (said == primitive.extensions.end()) continue;
      const std::string& name = model.meshes[i].name;
      Primitive(model, primitive, said->second,
                fmt::format("mesh '{}', {}", name.empty() ? fmt::format("mesh {}", i) : name, draco_extension))
          .decompress();
    }
}

}  // namespace lamina
