#include "device/vulkan/pipeline.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "device/vulkan/image.h"

namespace ssrkit::vulkan {

namespace {

// A stage and what its create info points to; it must not move once `info` was taken.
class Stage {
 public:
  Stage(VkShaderStageFlagBits stage, Handle<VkShaderModule> module,
        const std::vector<SpecConstant>& constants, const std::vector<std::uint32_t>& declared_ids)
      : stage_(stage), module_(std::move(module)) {
    for (const SpecConstant& constant : constants) {
      if (std::ranges::find(declared_ids, constant.id) != declared_ids.end()) {
        entries_.push_back({constant.id, static_cast<std::uint32_t>(bits_.size() * sizeof(std::uint32_t)),
                            sizeof(std::uint32_t)});
        bits_.push_back(constant.bits);
      }
    }
    specialization_ = {static_cast<std::uint32_t>(entries_.size()), entries_.data(),
                       bits_.size() * sizeof(std::uint32_t), bits_.data()};
  }

  [[nodiscard]] VkPipelineShaderStageCreateInfo info() const {
    VkPipelineShaderStageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage = stage_;
    info.module = module_.get();
    info.pName = "main";
    info.pSpecializationInfo = entries_.empty() ? nullptr : &specialization_;
    return info;
  }

 private:
  VkShaderStageFlagBits stage_;
  Handle<VkShaderModule> module_;
  std::vector<VkSpecializationMapEntry> entries_;
  std::vector<std::uint32_t> bits_;
  VkSpecializationInfo specialization_{};
};

Expected<Handle<VkShaderModule>> makeModule(const Gpu& gpu, std::span<const std::uint32_t> words,
                                            const std::string& attempted) {
  const std::size_t errors_before = gpu.instance().messages().errorCount();
  VkShaderModuleCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  info.codeSize = words.size_bytes();
  info.pCode = words.data();
  auto module = makeHandle(gpu.get(), "vkCreateShaderModule", gpu.functions().vkCreateShaderModule,
                           gpu.functions().vkDestroyShaderModule, info, attempted);
  if (module && gpu.instance().messages().errorCount() != errors_before) {
    return inputError(attempted, "the validation layer refused its SPIR-V");
  }
  return module;
}

VkFormat vertexFormat(VertexFormat format) {
  switch (format) {
    case VertexFormat::kFloat1:
      return VK_FORMAT_R32_SFLOAT;
    case VertexFormat::kFloat2:
      return VK_FORMAT_R32G32_SFLOAT;
    case VertexFormat::kFloat3:
      return VK_FORMAT_R32G32B32_SFLOAT;
    case VertexFormat::kFloat4:
      break;
  }
  return VK_FORMAT_R32G32B32A32_SFLOAT;
}

struct VertexInput {
  VkVertexInputBindingDescription binding{};
  std::vector<VkVertexInputAttributeDescription> attributes;

  explicit VertexInput(const ProgramDesc& desc) {
    binding = {0, desc.vertex_stride_bytes, VK_VERTEX_INPUT_RATE_VERTEX};
    for (const VertexAttribute& attribute : desc.vertex_attributes) {
      attributes.push_back({attribute.location, 0, vertexFormat(attribute.format), attribute.offset_bytes});
    }
  }

  [[nodiscard]] VkPipelineVertexInputStateCreateInfo info() const {
    VkPipelineVertexInputStateCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    info.vertexBindingDescriptionCount = attributes.empty() ? 0 : 1;
    info.pVertexBindingDescriptions = &binding;
    info.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes.size());
    info.pVertexAttributeDescriptions = attributes.data();
    return info;
  }
};

// State that is the same in all of the kit's pipelines, but for whether depth is tested.
struct FixedState {
  VkPipelineInputAssemblyStateCreateInfo assembly{};
  VkPipelineViewportStateCreateInfo viewport{};
  VkPipelineRasterizationStateCreateInfo rasterization{};
  VkPipelineMultisampleStateCreateInfo multisample{};
  VkPipelineDepthStencilStateCreateInfo depth{};
  VkPipelineDynamicStateCreateInfo dynamic{};

  static constexpr std::array kDynamic{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};

  explicit FixedState(DepthTest test) {
    assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    viewport.viewportCount = 1;
    viewport.scissorCount = 1;
    rasterization.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    rasterization.polygonMode = VK_POLYGON_MODE_FILL;
    rasterization.cullMode = VK_CULL_MODE_NONE;
    rasterization.lineWidth = 1.0F;
    multisample.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    depth.depthTestEnable = test == DepthTest::kNone ? VK_FALSE : VK_TRUE;
    depth.depthWriteEnable = test == DepthTest::kNearer ? VK_TRUE : VK_FALSE;
    depth.depthCompareOp = test == DepthTest::kBehind ? VK_COMPARE_OP_GREATER : VK_COMPARE_OP_LESS;
    dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
    dynamic.dynamicStateCount = static_cast<std::uint32_t>(kDynamic.size());
    dynamic.pDynamicStates = kDynamic.data();
  }
};

struct Targets {
  std::vector<VkFormat> formats;
  std::vector<VkPipelineColorBlendAttachmentState> blend;
  VkPipelineColorBlendStateCreateInfo blend_info{};
  VkPipelineRenderingCreateInfo info{};

  explicit Targets(const ProgramDesc& desc) {
    for (const Format format : desc.colour_formats) {
      formats.push_back(vulkanFormat(format));
    }
    VkPipelineColorBlendAttachmentState replace{};
    replace.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT |
                             VK_COLOR_COMPONENT_A_BIT;
    blend.assign(formats.size(), replace);
    blend_info.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blend_info.attachmentCount = static_cast<std::uint32_t>(blend.size());
    blend_info.pAttachments = blend.data();
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
    info.colorAttachmentCount = static_cast<std::uint32_t>(formats.size());
    info.pColorAttachmentFormats = formats.data();
    info.depthAttachmentFormat =
        desc.depth_test == DepthTest::kNone ? VK_FORMAT_UNDEFINED : vulkanFormat(Format::kD32f);
  }
  Targets(const Targets&) = delete;
  Targets& operator=(const Targets&) = delete;
};

Expected<Handle<VkPipeline>> makeFromStages(const Gpu& gpu, const ProgramDesc& desc, VkPipelineLayout layout,
                                            std::span<const VkPipelineShaderStageCreateInfo> stages,
                                            const std::string& attempted) {
  const VertexInput vertices(desc);
  const VkPipelineVertexInputStateCreateInfo vertex_info = vertices.info();
  const FixedState fixed(desc.depth_test);
  const Targets targets(desc);
  VkGraphicsPipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
  info.pNext = &targets.info;
  info.stageCount = static_cast<std::uint32_t>(stages.size());
  info.pStages = stages.data();
  info.pVertexInputState = &vertex_info;
  info.pInputAssemblyState = &fixed.assembly;
  info.pViewportState = &fixed.viewport;
  info.pRasterizationState = &fixed.rasterization;
  info.pMultisampleState = &fixed.multisample;
  info.pDepthStencilState = &fixed.depth;
  info.pColorBlendState = &targets.blend_info;
  info.pDynamicState = &fixed.dynamic;
  info.layout = layout;
  VkPipeline pipeline = VK_NULL_HANDLE;
  const VkResult result =
      gpu.functions().vkCreateGraphicsPipelines(gpu.get(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
  if (result != VK_SUCCESS) {
    return resultError(attempted, "vkCreateGraphicsPipelines", result);
  }
  return Handle<VkPipeline>(gpu.get(), pipeline, gpu.functions().vkDestroyPipeline);
}

}  // namespace

Expected<Handle<VkPipeline>> makePipeline(const Gpu& gpu, const ProgramDesc& desc, VkPipelineLayout layout,
                                          const std::string& attempted) {
  auto vertex_module = makeModule(gpu, desc.vertex_spirv, attempted);
  if (!vertex_module) {
    return passOn(vertex_module);
  }
  auto fragment_module = makeModule(gpu, desc.fragment_spirv, attempted);
  if (!fragment_module) {
    return passOn(fragment_module);
  }
  const Stage vertex(VK_SHADER_STAGE_VERTEX_BIT, std::move(*vertex_module), desc.spec_constants,
                     desc.vertex_constant_ids);
  const Stage fragment(VK_SHADER_STAGE_FRAGMENT_BIT, std::move(*fragment_module), desc.spec_constants,
                       desc.fragment_constant_ids);
  const std::array stages{vertex.info(), fragment.info()};
  return makeFromStages(gpu, desc, layout, stages, attempted);
}

}  // namespace ssrkit::vulkan
