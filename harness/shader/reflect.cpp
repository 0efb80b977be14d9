// SPDX-License-Identifier: Apache-2.0
// Reads a module's interface back through SPIRV-Cross.
#include <spirv_cross/spirv_cross_c.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <type_traits>

#include "harness/shader/shader.h"

namespace lamina {
namespace {

// std140 pads a block to a multiple of a vec4 (OpenGL 4.5 core profile, 7.6.2.2, rule 9); SPIRV-Cross leaves the padding out.
constexpr uint32_t block_alignment_bytes = 16;

struct ContextDeleter {
  void operator()(spvc_context context) const { spvc_context_destroy(context); }
};
using Context = std::unique_ptr<std::remove_pointer_t<spvc_context>, ContextDeleter>;

void check(spvc_result result, spvc_context context) {
  if (result != SPVC_SUCCESS)
    throw Error(ErrorKind::failed, "shader", "SPIR-V",
                fmt::format("cannot be reflected: {}", spvc_context_get_last_error_string(context)));
}

class Reflector {
 public:
  explicit Reflector(const std::vector<uint32_t>& spirv) {
    spvc_context context = nullptr;
    if (spvc_context_create(&context) != SPVC_SUCCESS) throw std::bad_alloc();
    context_.reset(context);
    spvc_parsed_ir ir = nullptr;
    check(spvc_context_parse_spirv(context, spirv.data(), spirv.size(), &ir), context);
    check(spvc_context_create_compiler(context, SPVC_BACKEND_NONE, ir, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler_), context);
    spvc_set reached = nullptr;
    check(spvc_compiler_get_active_interface_variables(compiler_, &reached), context);
    check(spvc_compiler_create_shader_resources_for_active_variables(compiler_, &reached_, reached), context);
    check(spvc_compiler_create_shader_resources(compiler_, &declared_), context);
  }

  Reflection reflection() {
    Reflection result;
    for (const auto& r : list(reached_, SPVC_RESOURCE_TYPE_SAMPLED_IMAGE))
      result.resources.push_back(image(r, BindingKind::texture));
    for (const auto& r : list(reached_, SPVC_RESOURCE_TYPE_STORAGE_IMAGE))
      result.resources.push_back(image(r, BindingKind::storage_image));
    for (const auto& r : list(reached_, SPVC_RESOURCE_TYPE_UNIFORM_BUFFER))
      result.resources.push_back(block(r, BindingKind::uniform_buffer));
    for (const auto& r : list(reached_, SPVC_RESOURCE_TYPE_STORAGE_BUFFER))
      result.resources.push_back(block(r, BindingKind::storage_buffer));
    std::ranges::sort(result.resources, {}, &ShaderResource::binding);
    result.constants = constants();
    result.input_locations = locations(SPVC_RESOURCE_TYPE_STAGE_INPUT);
    result.output_locations = locations(SPVC_RESOURCE_TYPE_STAGE_OUTPUT);
    return result;
  }

 private:
  std::span<const spvc_reflected_resource> list(spvc_resources resources, spvc_resource_type type) {
    const spvc_reflected_resource* first = nullptr;
    size_t count = 0;
    check(spvc_resources_get_resource_list_for_type(resources, type, &first, &count), context_.get());
    return {first, count};
  }

  ShaderResource image(const spvc_reflected_resource& r, BindingKind kind) {
    ShaderResource result;
    result.name = spvc_compiler_get_name(compiler_, r.id);
    result.binding = spvc_compiler_get_decoration(compiler_, r.id, SpvDecorationBinding);
    result.kind = kind;
    if (kind == BindingKind::texture)
      result.dimensions =
          spvc_type_get_image_dimension(spvc_compiler_get_type_handle(compiler_, r.type_id)) == SpvDim3D ? 3 : 2;
    return result;
  }

  ShaderResource block(const spvc_reflected_resource& r, BindingKind kind) {
    ShaderResource result = image(r, kind);
    result.name = spvc_compiler_get_name(compiler_, r.base_type_id);
    const spvc_type type = spvc_compiler_get_type_handle(compiler_, r.base_type_id);
    size_t size = 0;
    check(spvc_compiler_get_declared_struct_size(compiler_, type, &size), context_.get());
    const auto size_bytes = static_cast<uint32_t>(size);
    result.size_bytes = kind == BindingKind::uniform_buffer
                            ? (size_bytes + block_alignment_bytes - 1) / block_alignment_bytes * block_alignment_bytes
                            : size_bytes;
    for (unsigned m = 0; m < spvc_type_get_num_member_types(type); ++m)
      result.members.push_back(member(r.base_type_id, type, m));
    if (kind != BindingKind::uniform_buffer) return result;
    const spvc_buffer_range* first = nullptr;
    size_t count = 0;
    check(spvc_compiler_get_active_buffer_ranges(compiler_, r.id, &first, &count), context_.get());
    for (const spvc_buffer_range& range : std::span(first, count))
      result.read.push_back({static_cast<uint32_t>(range.offset), static_cast<uint32_t>(range.range)});
    std::ranges::sort(result.read, {}, &ByteRange::offset);
    return result;
  }

  BlockMember member(spvc_type_id block_id, spvc_type block, unsigned index) {
    BlockMember result;
    result.name = spvc_compiler_get_member_name(compiler_, block_id, index);
    size_t size = 0;
    check(spvc_compiler_type_struct_member_offset(compiler_, block, index, &result.offset_bytes), context_.get());
    check(spvc_compiler_get_declared_struct_member_size(compiler_, block, index, &size), context_.get());
    result.size_bytes = static_cast<uint32_t>(size);

    const spvc_type type = spvc_compiler_get_type_handle(compiler_, spvc_type_get_member_type(block, index));
    const std::optional<BlockMember::Scalar> scalar = scalar_of(spvc_type_get_basetype(type));
    const unsigned dimensions = spvc_type_get_num_array_dimensions(type);
    if (!scalar || dimensions > 1) return result;
    if (spvc_compiler_has_member_decoration(compiler_, block_id, index, SpvDecorationRowMajor)) return result;
    if (dimensions == 1) {
      // A length that a specialization constant gives is not known here, and a length of 0 is an array that the buffer ends.
      if (!spvc_type_array_dimension_is_literal(type, 0) || spvc_type_get_array_dimension(type, 0) == 0) return result;
      result.array_count = spvc_type_get_array_dimension(type, 0);
      check(spvc_compiler_type_struct_member_array_stride(compiler_, block, index, &result.array_stride_bytes), context_.get());
    }
    result.scalar = *scalar;
    result.rows = spvc_type_get_vector_size(type);
    result.columns = spvc_type_get_columns(type);
    if (result.columns > 1)
      check(spvc_compiler_type_struct_member_matrix_stride(compiler_, block, index, &result.matrix_stride_bytes),
            context_.get());
    result.supported = true;
    return result;
  }

  static std::optional<BlockMember::Scalar> scalar_of(spvc_basetype type) {
    switch (type) {
      case SPVC_BASETYPE_FP32:
        return BlockMember::Scalar::real;
      case SPVC_BASETYPE_INT32:
        return BlockMember::Scalar::integer;
      case SPVC_BASETYPE_UINT32:
        return BlockMember::Scalar::unsigned_integer;
      default:
        return std::nullopt;
    }
  }

  std::vector<SpecConstantInfo> constants() {
    const spvc_specialization_constant* first = nullptr;
    size_t count = 0;
    check(spvc_compiler_get_specialization_constants(compiler_, &first, &count), context_.get());
    std::vector<SpecConstantInfo> result;
    for (const spvc_specialization_constant& c : std::span(first, count)) {
      const spvc_constant constant = spvc_compiler_get_constant_handle(compiler_, c.id);
      const spvc_type type = spvc_compiler_get_type_handle(compiler_, spvc_constant_get_type(constant));
      result.push_back({.name = spvc_compiler_get_name(compiler_, c.id),
                        .id = c.constant_id,
                        .type = type_of(spvc_type_get_basetype(type)),
                        .default_bits = spvc_constant_get_scalar_u32(constant, 0, 0)});
    }
    std::ranges::sort(result, {}, &SpecConstantInfo::id);
    return result;
  }

  static SpecConstantInfo::Type type_of(spvc_basetype type) {
    switch (type) {
      case SPVC_BASETYPE_BOOLEAN:
        return SpecConstantInfo::Type::boolean;
      case SPVC_BASETYPE_INT32:
        return SpecConstantInfo::Type::integer;
      case SPVC_BASETYPE_UINT32:
        return SpecConstantInfo::Type::unsigned_integer;
      case SPVC_BASETYPE_FP32:
        return SpecConstantInfo::Type::real;
      default:
        throw Error(ErrorKind::failed, "shader", "SPIR-V", "a specialization constant is not 32 bits wide");
    }
  }

  // Of every declared variable, used or not: Vulkan matches a module's declared interface. A matrix takes a location a column,
  // an array as many as its elements do. Interface blocks, which neither end of a pipeline has, are left out.
  std::vector<uint32_t> locations(spvc_resource_type kind) {
    std::vector<uint32_t> result;
    for (const spvc_reflected_resource& r : list(declared_, kind)) {
      if (!spvc_compiler_has_decoration(compiler_, r.id, SpvDecorationLocation)) continue;
      const spvc_type type = spvc_compiler_get_type_handle(compiler_, r.type_id);
      uint32_t count = spvc_type_get_columns(type);
      for (unsigned d = 0; d < spvc_type_get_num_array_dimensions(type); ++d) count *= spvc_type_get_array_dimension(type, d);
      const uint32_t first = spvc_compiler_get_decoration(compiler_, r.id, SpvDecorationLocation);
      for (uint32_t i = 0; i < count; ++i) result.push_back(first + i);
    }
    std::ranges::sort(result);
    return result;
  }

  Context context_;
  spvc_compiler compiler_ = nullptr;
  spvc_resources reached_ = nullptr, declared_ = nullptr;
};

}  // namespace

Reflection reflect(const std::vector<uint32_t>& spirv) { return Reflector(spirv).reflection(); }

}  // namespace lamina
