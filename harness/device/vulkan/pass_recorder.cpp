#include "device/vulkan/pass_recorder.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>

#include "device/format.h"
#include "device/vulkan/barriers.h"
#include "device/vulkan/descriptors.h"
#include "device/vulkan/image.h"

namespace ssrkit::vulkan {

namespace {

const VulkanImage& imageOf(const DeviceImage& image) {
  return static_cast<const VulkanImage&>(image);
}

VkClearValue clearValue(Format format, const std::array<double, 4>& value) {
  VkClearValue clear{};
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (format == Format::kRg16i) {
      clear.color.int32[i] = static_cast<std::int32_t>(std::llround(value[i]));
    } else if (formatInfo(format).is_integer) {
      clear.color.uint32[i] = static_cast<std::uint32_t>(std::llround(value[i]));
    } else {
      clear.color.float32[i] = static_cast<float>(value[i]);
    }
  }
  if (format == Format::kD32f) {
    clear.depthStencil = {static_cast<float>(value[0]), 0};
  }
  return clear;
}

VkRenderingAttachmentInfo attachmentInfo(const Attachment& attachment, VkImageView view,
                                         VkImageLayout layout) {
  VkRenderingAttachmentInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
  info.imageView = view;
  info.imageLayout = layout;
  info.loadOp = attachment.clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
  info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  if (attachment.clear) {
    info.clearValue = clearValue(attachment.image->desc().format, *attachment.clear);
  }
  return info;
}

void recordBarriers(const DeviceFunctions& functions, VkCommandBuffer commands, const PassDesc& pass,
                    const ProgramLayout& layout) {
  Barriers barriers;
  for (const Attachment& attachment : pass.colour) {
    barriers.use(imageOf(*attachment.image), attachment.mip, 1, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
  }
  if (pass.depth) {
    barriers.use(imageOf(*pass.depth->image), pass.depth->mip, 1,
                 VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL);
  }
  for (const DrawCall& draw : pass.draws) {
    for (const std::uint32_t binding : layout.sampler_bindings) {
      const SampledImage& sampled = *sampledAt(pass, draw, binding);
      barriers.use(imageOf(*sampled.image), sampled.base_mip, sampled.mip_count,
                   VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    }
  }
  barriers.record(functions, commands);
}

void beginRendering(const DeviceFunctions& functions, VkCommandBuffer commands, const PassDesc& pass,
                    std::span<const VkImageView> views) {
  std::vector<VkRenderingAttachmentInfo> colours;
  for (std::size_t i = 0; i < pass.colour.size(); ++i) {
    colours.push_back(attachmentInfo(pass.colour[i], views[i], VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL));
  }
  VkRenderingAttachmentInfo depth{};
  if (pass.depth) {
    depth = attachmentInfo(*pass.depth, views.back(), VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL);
  }
  const Attachment& any = pass.colour.empty() ? *pass.depth : pass.colour.front();
  const Size size = mipSize(any.image->desc(), any.mip);
  VkRenderingInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
  info.renderArea.extent = {static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height)};
  info.layerCount = 1;
  info.colorAttachmentCount = static_cast<std::uint32_t>(colours.size());
  info.pColorAttachments = colours.data();
  info.pDepthAttachment = pass.depth ? &depth : nullptr;
  functions.vkCmdBeginRendering(commands, &info);
}

void setViewport(const DeviceFunctions& functions, VkCommandBuffer commands, const Rect& rect,
                 const Rect& cut) {
  const VkViewport viewport{static_cast<float>(rect.x),
                            static_cast<float>(rect.y),
                            static_cast<float>(rect.width),
                            static_cast<float>(rect.height),
                            0.0F,
                            1.0F};
  const VkRect2D scissor{{cut.x, cut.y},
                         {static_cast<std::uint32_t>(cut.width), static_cast<std::uint32_t>(cut.height)}};
  functions.vkCmdSetViewport(commands, 0, 1, &viewport);
  functions.vkCmdSetScissor(commands, 0, 1, &scissor);
}

}  // namespace

Expected<std::unique_ptr<VulkanBuffer>> VulkanBuffer::create(const std::shared_ptr<const Gpu>& gpu,
                                                             std::span<const std::byte> bytes) {
  auto buffer = createMappedBuffer(*gpu, bytes.size(), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT,
                                   VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, "make a vertex buffer");
  if (!buffer) {
    return passOn(buffer);
  }
  std::memcpy(buffer->data, bytes.data(), bytes.size());
  return std::unique_ptr<VulkanBuffer>(new VulkanBuffer(gpu, std::move(*buffer)));
}

Expected<std::vector<VkImageView>> attachmentViews(const PassDesc& pass) {
  std::vector<VkImageView> views;
  const auto add = [&](const Attachment& attachment) -> Expected<void> {
    const auto view = imageOf(*attachment.image).view(attachment.mip, 1);
    if (!view) {
      return tl::make_unexpected(view.error());
    }
    views.push_back(*view);
    return {};
  };
  Expected<void> added;
  for (std::size_t i = 0; added && i < pass.colour.size(); ++i) {
    added = add(pass.colour[i]);
  }
  if (added && pass.depth) {
    added = add(*pass.depth);
  }
  if (!added) {
    return passOn(added);
  }
  return views;
}

void recordPass(const DeviceFunctions& functions, VkCommandBuffer commands, const PassDesc& pass,
                const VulkanProgram& program, std::span<const VkImageView> views,
                std::span<const VkDescriptorSet> sets) {
  recordBarriers(functions, commands, pass, program.layout());
  beginRendering(functions, commands, pass, views);
  functions.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, program.pipeline());
  setViewport(functions, commands, pass.viewport, pass.scissor.value_or(pass.viewport));
  if (pass.vertices != nullptr) {
    const VkBuffer vertices = static_cast<const VulkanBuffer*>(pass.vertices)->get();
    const VkDeviceSize offset = 0;
    functions.vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &offset);
  }
  VkDescriptorSet bound = VK_NULL_HANDLE;
  for (std::size_t i = 0; i < pass.draws.size(); ++i) {
    if (sets[i] != bound) {
      functions.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, program.pipelineLayout(),
                                        0, 1, &sets[i], 0, nullptr);
      bound = sets[i];
    }
    functions.vkCmdDraw(commands, pass.draws[i].vertex_count, 1, pass.draws[i].first_vertex, 0);
  }
  functions.vkCmdEndRendering(commands);
}

}  // namespace ssrkit::vulkan
