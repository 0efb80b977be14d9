// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/vulkan/pipeline.h"

#include <algorithm>
#include <array>

#include "harness/backend/common/checks.h"
#include "harness/backend/vulkan/formats.h"

namespace lamina::vulkan {
namespace {

VkShaderStageFlagBits stage_bit(Stage stage) {
  switch (stage) {
    case Stage::vertex:
      return VK_SHADER_STAGE_VERTEX_BIT;
    case Stage::fragment:
      return VK_SHADER_STAGE_FRAGMENT_BIT;
    case Stage::compute:
      return VK_SHADER_STAGE_COMPUTE_BIT;
  }
  return VK_SHADER_STAGE_ALL;
}

// Throws Error(failed) where the device has too few colour targets, or cannot blend into them so.
void check_blending(const Device& device, const PipelineDesc& desc) {
  if (desc.colors.size() > device.limits().maxColorAttachments)
    throw_failed(desc.name, fmt::format("{} colour targets, {} takes {}", desc.colors.size(), device.info().device,
                                        device.limits().maxColorAttachments));
  for (size_t i = 0; i < desc.colors.size(); ++i) {
    const Format format = desc.colors[i];
    if (blend_of(desc, i) != Blend::none && !device.supports(vk_format(format), VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT))
      throw_failed(desc.name, fmt::format("{} cannot blend into {}", device.info().device, name_of(format)));
    if (blend_of(desc, i) != blend_of(desc, 0) && !device.features().independentBlend)
      throw_failed(desc.name, fmt::format("{} blends into all targets alike", device.info().device));
  }
}

DescriptorSetLayoutHandle make_set_layout(Device& device, const PipelineDesc& desc) {
  VkShaderStageFlags stages = 0;
  for (const ShaderStage& stage : desc.stages) stages |= stage_bit(stage.stage);
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (const BindingSlot& slot : desc.bindings)
    bindings.push_back({slot.binding, descriptor_type(slot.kind), 1, stages, nullptr});
  VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  info.bindingCount = static_cast<uint32_t>(bindings.size());
  info.pBindings = bindings.data();
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  check(vkCreateDescriptorSetLayout(device.get(), &info, nullptr, &layout), desc.name, "vkCreateDescriptorSetLayout");
  return device.own<DescriptorSetLayoutHandle>(layout, desc.name);
}

PipelineLayoutHandle make_layout(Device& device, const PipelineDesc& desc, VkDescriptorSetLayout set_layout) {
  VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = 1;
  info.pSetLayouts = &set_layout;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  check(vkCreatePipelineLayout(device.get(), &info, nullptr, &layout), desc.name, "vkCreatePipelineLayout");
  return device.own<PipelineLayoutHandle>(layout, desc.name);
}

// Shader modules with their stage descriptions, alive until the pipeline is made.
class Stages {
 public:
  Stages(Device& device, const PipelineDesc& desc) {
    for (const SpecConstant& constant : desc.constants) {
      entries_.push_back({constant.id, static_cast<uint32_t>(values_.size() * sizeof(uint32_t)), sizeof(uint32_t)});
      values_.push_back(constant.bits);
    }
    specialization_.mapEntryCount = static_cast<uint32_t>(entries_.size());
    specialization_.pMapEntries = entries_.data();
    specialization_.dataSize = values_.size() * sizeof(uint32_t);
    specialization_.pData = values_.data();
    for (const ShaderStage& stage : desc.stages) {
      VkShaderModuleCreateInfo module_info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
      module_info.codeSize = stage.spirv.size() * sizeof(uint32_t);
      module_info.pCode = stage.spirv.data();
      VkShaderModule module = VK_NULL_HANDLE;
      check(vkCreateShaderModule(device.get(), &module_info, nullptr, &module), desc.name, "vkCreateShaderModule");
      modules_.push_back(device.own<ShaderModuleHandle>(module, desc.name));
      VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
      info.stage = stage_bit(stage.stage);
      info.module = module;
      info.pName = "main";
      info.pSpecializationInfo = &specialization_;
      infos_.push_back(info);
    }
  }
  Stages(const Stages&) = delete;
  Stages& operator=(const Stages&) = delete;

  std::span<const VkPipelineShaderStageCreateInfo> infos() const { return infos_; }

 private:
  std::vector<VkSpecializationMapEntry> entries_;
  std::vector<uint32_t> values_;
  VkSpecializationInfo specialization_{};
  std::vector<ShaderModuleHandle> modules_;
  std::vector<VkPipelineShaderStageCreateInfo> infos_;
};

VkPipelineColorBlendAttachmentState blend_state(Blend blend) {
  VkPipelineColorBlendAttachmentState state{};
  state.colorWriteMask =
      VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  state.blendEnable = blend != Blend::none;
  state.colorBlendOp = state.alphaBlendOp = VK_BLEND_OP_ADD;
  if (blend == Blend::multiplied) {
    state.srcColorBlendFactor = state.srcAlphaBlendFactor = VK_BLEND_FACTOR_ZERO;
    state.dstColorBlendFactor = VK_BLEND_FACTOR_SRC_COLOR;
    state.dstAlphaBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
    return state;
  }
  state.srcColorBlendFactor = blend == Blend::alpha ? VK_BLEND_FACTOR_SRC_ALPHA : VK_BLEND_FACTOR_ONE;
  state.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
  state.dstColorBlendFactor = state.dstAlphaBlendFactor =
      blend == Blend::additive ? VK_BLEND_FACTOR_ONE : VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
  return state;
}

VkCompareOp compare_op(DepthTest test) {
  switch (test) {
    case DepthTest::less_equal:
      return VK_COMPARE_OP_LESS_OR_EQUAL;
    case DepthTest::equal:
      return VK_COMPARE_OP_EQUAL;
    case DepthTest::greater:
      return VK_COMPARE_OP_GREATER;
  }
  return VK_COMPARE_OP_LESS_OR_EQUAL;
}

VkCullModeFlags cull_mode(Cull cull) {
  switch (cull) {
    case Cull::none:
      return VK_CULL_MODE_NONE;
    case Cull::back:
      return VK_CULL_MODE_BACK_BIT;
    case Cull::front:
      return VK_CULL_MODE_FRONT_BIT;
  }
  return VK_CULL_MODE_NONE;
}

VkPipeline make_raster(Device& device, const PipelineDesc& desc, const Stages& stages, VkPipelineLayout layout) {
  constexpr std::array<VkFormat, 4> attribute_formats = {VK_FORMAT_R32G32B32_SFLOAT, VK_FORMAT_R32G32B32_SFLOAT,
                                                         VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_R32G32_SFLOAT};
  const VkVertexInputBindingDescription vertex_binding{0, vertex_stride_bytes, VK_VERTEX_INPUT_RATE_VERTEX};
  std::vector<VkVertexInputAttributeDescription> attributes;
  for (const uint32_t location : desc.vertex_locations)
    attributes.push_back({location, 0, attribute_formats[location], vertex_offset_bytes[location]});
  VkPipelineVertexInputStateCreateInfo input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  input.vertexBindingDescriptionCount = attributes.empty() ? 0 : 1;
  input.pVertexBindingDescriptions = &vertex_binding;
  input.vertexAttributeDescriptionCount = static_cast<uint32_t>(attributes.size());
  input.pVertexAttributeDescriptions = attributes.data();

  VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;

  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = viewport.scissorCount = 1;
  constexpr std::array<VkDynamicState, 2> dynamic_states = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.dynamicStateCount = static_cast<uint32_t>(dynamic_states.size());
  dynamic.pDynamicStates = dynamic_states.data();

  VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  raster.polygonMode = VK_POLYGON_MODE_FILL;
  raster.cullMode = cull_mode(desc.cull);
  raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
  raster.lineWidth = 1;

  VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;

  VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  depth.depthTestEnable = desc.depth != Depth::none;
  depth.depthWriteEnable = desc.depth == Depth::read_write;
  depth.depthCompareOp = compare_op(desc.depth_test);

  std::vector<VkPipelineColorBlendAttachmentState> blends;
  for (size_t i = 0; i < desc.colors.size(); ++i) blends.push_back(blend_state(blend_of(desc, i)));
  VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.attachmentCount = static_cast<uint32_t>(blends.size());
  blend.pAttachments = blends.data();

  std::vector<VkFormat> color_formats;
  for (const Format format : desc.colors) color_formats.push_back(vk_format(format));
  VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  rendering.colorAttachmentCount = static_cast<uint32_t>(color_formats.size());
  rendering.pColorAttachmentFormats = color_formats.data();
  rendering.depthAttachmentFormat = desc.depth_format ? vk_format(*desc.depth_format) : VK_FORMAT_UNDEFINED;

  VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, &rendering};
  info.stageCount = static_cast<uint32_t>(stages.infos().size());
  info.pStages = stages.infos().data();
  info.pVertexInputState = &input;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pDepthStencilState = &depth;
  info.pColorBlendState = &blend;
  info.pDynamicState = &dynamic;
  info.layout = layout;
  VkPipeline pipeline = VK_NULL_HANDLE;
  check(vkCreateGraphicsPipelines(device.get(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline), desc.name,
        "vkCreateGraphicsPipelines");
  return pipeline;
}

VkPipeline make_compute(Device& device, const PipelineDesc& desc, const Stages& stages, VkPipelineLayout layout) {
  VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  info.stage = stages.infos().front();
  info.layout = layout;
  VkPipeline pipeline = VK_NULL_HANDLE;
  check(vkCreateComputePipelines(device.get(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline), desc.name,
        "vkCreateComputePipelines");
  return pipeline;
}

}  // namespace

VkDescriptorType descriptor_type(BindingKind kind) {
  switch (kind) {
    case BindingKind::texture:
      return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    case BindingKind::uniform_buffer:
      return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    case BindingKind::storage_buffer:
      return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    case BindingKind::storage_image:
      return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
  }
  return VK_DESCRIPTOR_TYPE_MAX_ENUM;
}

Pipeline make_pipeline(Device& device, const PipelineDesc& desc) {
  check_pipeline(desc);
  check_blending(device, desc);
  Pipeline made;
  made.set_layout = make_set_layout(device, desc);
  made.layout = make_layout(device, desc, made.set_layout.get());
  const Stages stages(device, desc);
  const VkPipeline pipeline = is_compute(desc) ? make_compute(device, desc, stages, made.layout.get())
                                               : make_raster(device, desc, stages, made.layout.get());
  made.pipeline = device.own<PipelineHandle>(pipeline, desc.name);
  made.desc = desc;
  for (ShaderStage& stage : made.desc.stages) stage.spirv = {};
  return made;
}

}  // namespace lamina::vulkan
