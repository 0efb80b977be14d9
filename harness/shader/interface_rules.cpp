// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/interface_rules.h"

#include <map>

namespace lamina {
namespace {

// Words of an instruction, by the specification's section 3.32.
constexpr size_t pointee_word = 3;        // of OpTypePointer
constexpr size_t storage_class_word = 3;  // of OpVariable
constexpr size_t width_word = 2;          // of OpTypeInt and OpTypeFloat

class Rules {
 public:
  Rules(std::span<const uint32_t> spirv, const std::string& file) : module_(spirv), file_(file) {}

  void check() {
    for (const SpirvInstruction& i : module_.instructions()) {
      if (i.op() == spv::OpVariable) check_variable(i);
      if (i.op() == spv::OpSpecConstant) check_constant(i);
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& name, std::string_view what) const {
    throw Error(ErrorKind::bad_input, "shader", file_, fmt::format("'{}' {}", name, what));
  }

  void check_variable(const SpirvInstruction& variable) {
    const SpirvInstruction& type = module_.definition(module_.definition(variable.type).words[pointee_word]);
    std::string name = module_.name(variable.result);
    if (name.empty()) name = module_.name(type.result);  // a block without an instance name

    switch (variable.words[storage_class_word]) {
      case spv::StorageClassPushConstant:
        refuse(name, "is a push constant; put it into a uniform block, which OpenGL has too");
      case spv::StorageClassAtomicCounter:
        refuse(name, "is an atomic counter; use a storage buffer, which Vulkan has too");
      case spv::StorageClassUniformConstant:
      case spv::StorageClassUniform:
      case spv::StorageClassStorageBuffer:
        break;
      default:
        return;
    }
    check_type(name, type, variable.words[storage_class_word] == spv::StorageClassUniformConstant);
    if (module_.decoration(variable.result, spv::DecorationDescriptorSet).value_or(0) != 0)
      refuse(name, "asks for a descriptor set; leave out set=, all resources share one");
    const auto binding = module_.decoration(variable.result, spv::DecorationBinding);
    if (!binding) refuse(name, "has no binding; give it one with layout(binding = N)");
    const auto [other, fresh] = at_binding_.emplace(*binding, name);
    if (!fresh)
      refuse(name, fmt::format("shares binding {} with '{}'; bindings are unique across kinds", *binding, other->second));
  }

  void check_type(const std::string& name, const SpirvInstruction& type, bool outside_blocks) const {
    if (type.op() == spv::OpTypeStruct && !outside_blocks) return;
    switch (type.op()) {
      case spv::OpTypeArray:
      case spv::OpTypeRuntimeArray:
        refuse(name, "is an array of resources; declare each with a binding of its own");
      case spv::OpTypeSampler:
        refuse(name, "is a sampler without a texture; use a combined sampler2D");
      case spv::OpTypeSampledImage:
        return check_image(name, module_.definition(type.words[2]), true);
      case spv::OpTypeImage:
        return check_image(name, type, false);
      default:
        refuse(name, "is a plain uniform; put it into a uniform block");
    }
  }

  // OpTypeImage: result, sampled type, dim, depth, arrayed, multisampled, sampled, format.
  void check_image(const std::string& name, const SpirvInstruction& image, bool combined) const {
    if (image.words[3] == spv::DimSubpassData) refuse(name, "is a subpass input, which OpenGL lacks; use a sampler2D");
    if (!combined && image.words[7] != 2) refuse(name, "is a texture without a sampler; use a combined sampler2D");
    if (image.words[4] == 1) refuse(name, "compares depths, which the harness's samplers do not; use a sampler2D");
    if (image.words[3] == spv::Dim3D && !combined)
      refuse(name, "is a 3D image; a 3D texture is only sampled, with a sampler3D");
    if (image.words[3] == spv::Dim3D && module_.definition(image.words[2]).op() != spv::OpTypeFloat)
      refuse(name, "is a 3D texture of integers; a 3D texture holds floats, use a sampler3D");
    if ((image.words[3] != spv::Dim2D && image.words[3] != spv::Dim3D) || image.words[5] != 0 || image.words[6] != 0)
      refuse(name, "is no plain 2D or 3D texture or image, and the harness binds no others");
  }

  void check_constant(const SpirvInstruction& constant) const {
    const SpirvInstruction& type = module_.definition(constant.type);
    if (type.words[width_word] != 32)
      refuse(module_.name(constant.result), "is no 32-bit specialization constant; use a 32-bit type");
  }

  SpirvModule module_;
  const std::string& file_;
  std::map<uint32_t, std::string> at_binding_;
};

}  // namespace

void check_interface(std::span<const uint32_t> spirv, const std::string& file) { Rules(spirv, file).check(); }

}  // namespace lamina
