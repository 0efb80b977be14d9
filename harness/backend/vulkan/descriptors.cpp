// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/vulkan/descriptors.h"

#include <algorithm>
#include <deque>

#include "harness/backend/vulkan/formats.h"

namespace lamina::vulkan {
namespace {

constexpr std::array<BindingKind, 4> all_kinds = {BindingKind::texture, BindingKind::uniform_buffer,
                                                  BindingKind::storage_buffer, BindingKind::storage_image};
VkSamplerAddressMode address_mode(Wrap wrap) {
  if (wrap == Wrap::mirror) return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
  return wrap == Wrap::clamp ? VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE : VK_SAMPLER_ADDRESS_MODE_REPEAT;
}

SamplerHandle make_sampler(Device& device, Sampler sampler) {
  const VkFilter filter = sampler.filter == Filter::nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR;
  const bool mips = sampler.filter == Filter::trilinear;
  VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  info.magFilter = info.minFilter = filter;
  info.mipmapMode = mips ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
  info.addressModeU = info.addressModeW = address_mode(sampler.wrap);
  info.addressModeV = address_mode(sampler.wrap_v);
  info.maxLod = mips ? VK_LOD_CLAMP_NONE : 0;  // 0 keeps nearest and linear to the base level
  VkSampler created = VK_NULL_HANDLE;
  const std::string name = name_of(sampler) + " sampler";
  check(vkCreateSampler(device.get(), &info, nullptr, &created), name, "vkCreateSampler");
  return device.own<SamplerHandle>(created, name);
}

// What one write points to; kept where it does not move until the writes are done.
struct Target {
  VkDescriptorImageInfo image{};
  VkDescriptorBufferInfo buffer{};
};

Target buffer_target(const Pipeline& pipeline, const BindingSlot& slot, const Draw& draw, Resources& resources) {
  const bool uniform = slot.kind == BindingKind::uniform_buffer;
  const BufferBinding& given = binding_at(slot, draw.buffers, pipeline.desc);
  const Buffer& buffer = resources.at(given.buffer, pipeline.desc.name);
  if (given.kind != slot.kind || buffer.use != (uniform ? BufferUse::uniform : BufferUse::storage))
    throw_bad_input(pipeline.desc.name, fmt::format("binding {} takes a {}, buffer '{}' is bound or made as another kind",
                                                    slot.binding, uniform ? "uniform buffer" : "storage buffer", buffer.name));
  Target target;
  target.buffer = {buffer.buffer.get(), 0, VK_WHOLE_SIZE};
  return target;
}

Target texture_target(Device& device, const Pipeline& pipeline, const BindingSlot& slot, const Draw& draw, Resources& resources,
                      const PassLayouts& layouts, std::span<const SamplerHandle> samplers) {
  const TextureBinding& given = binding_at(slot, draw.textures, pipeline.desc);
  const Texture& texture = resources.at(given.texture, pipeline.desc.name);
  check_dimensions(pipeline.desc, slot, texture.desc);
  const Format format = texture.desc.format;
  if (given.sampler.filter != Filter::nearest &&
      !device.supports(vk_format(format), VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT))
    throw_failed(pipeline.desc.name, fmt::format("{} cannot filter '{}' ({}); read it with the nearest filter",
                                                 device.info().device, texture.desc.name, name_of(format)));
  Target target;
  const VkImageView view = given.level ? texture.levels[*given.level].get() : texture.whole.get();
  target.image = {samplers[place_of(given.sampler)].get(), view, layouts.at(given.texture)[given.level.value_or(0)]};
  return target;
}

Target storage_image_target(const Pipeline& pipeline, const BindingSlot& slot, const Draw& draw, Resources& resources,
                            const PassLayouts& layouts) {
  const ImageBinding& given = binding_at(slot, draw.images, pipeline.desc);
  const Texture& texture = resources.at(given.texture, pipeline.desc.name);
  if (!texture.desc.storage)
    throw_bad_input(pipeline.desc.name,
                    fmt::format("binding {}: '{}' was not made for storage", slot.binding, texture.desc.name));
  Target target;
  target.image = {VK_NULL_HANDLE, texture.levels[given.level].get(), layouts.at(given.texture)[given.level]};
  return target;
}

}  // namespace

Descriptors::Descriptors(Device& device) : device_(device) {
  for (const Sampler sampler : all_samplers()) samplers_[place_of(sampler)] = make_sampler(device, sampler);
}

void Descriptors::start(std::span<const Pipeline* const> pipelines) {
  const uint32_t sets = static_cast<uint32_t>(pipelines.size());
  std::array<uint32_t, kinds> needed{};
  for (const Pipeline* pipeline : pipelines)
    for (const BindingSlot& slot : pipeline->desc.bindings) ++needed[static_cast<size_t>(slot.kind)];

  bool fits = static_cast<bool>(pool_) && sets <= set_capacity_;
  for (size_t kind = 0; kind < kinds; ++kind) fits = fits && needed[kind] <= capacity_[kind];
  if (fits) {
    check(vkResetDescriptorPool(device_.get(), pool_.get(), 0), "descriptors", "vkResetDescriptorPool");
    return;
  }
  std::vector<VkDescriptorPoolSize> sizes;
  for (const BindingKind kind : all_kinds) {
    uint32_t& capacity = capacity_[static_cast<size_t>(kind)];
    capacity = std::max({1u, capacity, needed[static_cast<size_t>(kind)]});
    sizes.push_back({descriptor_type(kind), capacity});
  }
  set_capacity_ = std::max({1u, set_capacity_, sets});
  VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  info.maxSets = set_capacity_;
  info.poolSizeCount = static_cast<uint32_t>(sizes.size());
  info.pPoolSizes = sizes.data();
  VkDescriptorPool pool = VK_NULL_HANDLE;
  check(vkCreateDescriptorPool(device_.get(), &info, nullptr, &pool), "descriptors", "vkCreateDescriptorPool");
  pool_ = device_.own<DescriptorPoolHandle>(pool, "lamina descriptors");
}

VkDescriptorSet Descriptors::make_set(const Pipeline& pipeline, const Draw& draw, Resources& resources,
                                      const PassLayouts& layouts) {
  const VkDescriptorSetLayout layout = pipeline.set_layout.get();
  VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  info.descriptorPool = pool_.get();
  info.descriptorSetCount = 1;
  info.pSetLayouts = &layout;
  VkDescriptorSet set = VK_NULL_HANDLE;
  check(vkAllocateDescriptorSets(device_.get(), &info, &set), pipeline.desc.name, "vkAllocateDescriptorSets");

  std::deque<Target> targets;
  std::vector<VkWriteDescriptorSet> writes;
  for (const BindingSlot& slot : pipeline.desc.bindings) {
    switch (slot.kind) {
      case BindingKind::texture:
        targets.push_back(texture_target(device_, pipeline, slot, draw, resources, layouts, samplers_));
        break;
      case BindingKind::storage_image:
        targets.push_back(storage_image_target(pipeline, slot, draw, resources, layouts));
        break;
      default:
        targets.push_back(buffer_target(pipeline, slot, draw, resources));
    }
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set;
    write.dstBinding = slot.binding;
    write.descriptorCount = 1;
    write.descriptorType = descriptor_type(slot.kind);
    write.pImageInfo = &targets.back().image;
    write.pBufferInfo = &targets.back().buffer;
    writes.push_back(write);
  }
  vkUpdateDescriptorSets(device_.get(), static_cast<uint32_t>(writes.size()), writes.data(), 0, nullptr);
  return set;
}

}  // namespace lamina::vulkan
