#include "shader/glsl_translation.h"

#include <array>
#include <bit>

#include "shader_folder.h"

namespace ssrkit {
namespace {

class GlslTranslation : public ShaderFolder {
 protected:
  // The GLSL of a fragment shader with this text behind its version line.
  [[nodiscard]] std::string translated(std::string_view text, GlslVersion version,
                                       std::span<const GlslConstant> constants = {}) const {
    const Expected<ShaderModule> module = compileFragment("#version 450\n" + std::string(text));
    if (!module) {
      return sentence(module.error());
    }
    const Expected<std::string> glsl = translateToGlsl(module->spirv, version, constants);
    return glsl ? *glsl : sentence(glsl.error());
  }
};

void expectParts(const std::string& text, std::initializer_list<const char*> parts) {
  for (const char* const part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << "no '" << part << "' in\n" << text;
  }
}

constexpr const char* kSamplerAndBlock = R"(
layout(binding = 5) uniform sampler2D dist_view;
layout(std140, binding = 2) uniform Block { vec4 tint; };
layout(location = 3) in vec2 uv;
layout(location = 0) out vec4 colour;
void main() { colour = texture(dist_view, uv) * tint; }
)";

TEST_F(GlslTranslation, NamesSayTheBindingsAndLocationsThatOldGlslCannot) {
  const std::string glsl = translated(kSamplerAndBlock, GlslVersion::k330);
  expectParts(glsl, {"#version 330", "uniform sampler2D ssrkit_sampler_5", "uniform ssrkit_block_2",
                     "in vec2 ssrkit_varying_3", "layout(location = 0) out vec4 colour"});
  EXPECT_EQ(glsl.find("binding"), std::string::npos) << glsl;
  EXPECT_EQ(glsl.find("#extension"), std::string::npos) << glsl;
  EXPECT_EQ(glslSamplerName(5), "ssrkit_sampler_5");
  EXPECT_EQ(glslBlockName(2), "ssrkit_block_2");
}

TEST_F(GlslTranslation, NewerGlslKeepsItsBindings) {
  expectParts(translated(kSamplerAndBlock, GlslVersion::k450),
              {"#version 450", "layout(binding = 5) uniform sampler2D ssrkit_sampler_5",
               "layout(binding = 2, std140) uniform ssrkit_block_2"});
}

TEST_F(GlslTranslation, StagesTranslatedApartNameTheirVariablesAlike) {
  write("shaders/a.vert", R"(#version 450
layout(location = 3) out vec2 another_name;
void main() { another_name = vec2(1.0); gl_Position = vec4(0.0); }
)");
  const Expected<ShaderModule> vertex = compileShader({root(), "a.vert", ShaderStage::kVertex, {}},
                                                      ShaderTarget::kOpenGl, {.use_cache = false});
  ASSERT_TRUE(vertex) << sentence(vertex.error());
  const Expected<std::string> glsl = translateToGlsl(vertex->spirv, GlslVersion::k330, {});
  ASSERT_TRUE(glsl) << sentence(glsl.error());
  expectParts(*glsl, {"out vec2 ssrkit_varying_3"});
}

constexpr const char* kConstants = R"(
layout(constant_id = 3) const int count = 7;
layout(constant_id = 5) const float scale = 0.5;
layout(constant_id = 8) const bool on = false;
layout(constant_id = 9) const uint mask = 1u;
layout(location = 0) out vec4 colour;
void main() { colour = vec4(float(count), scale, on ? 1.0 : 0.0, float(mask)); }
)";

TEST_F(GlslTranslation, ConstantsHaveTheValuesGivenAndElseTheirDefaults) {
  const std::array<GlslConstant, 4> given{
      {{3, static_cast<std::uint32_t>(-1000)}, {8, 1}, {9, 4000000000U}, {77, 1}}};
  const std::string glsl = translated(kConstants, GlslVersion::k330, given);
  expectParts(glsl, {"SPIRV_CROSS_CONSTANT_ID_3 -1000", "SPIRV_CROSS_CONSTANT_ID_5 0.5",
                     "SPIRV_CROSS_CONSTANT_ID_8 true", "SPIRV_CROSS_CONSTANT_ID_9 4000000000u"});
  EXPECT_EQ(glsl.find("77"), std::string::npos) << glsl;
}

TEST_F(GlslTranslation, AFloatingConstantKeepsEveryBit) {
  constexpr float kValue = 0.1F;
  const std::array<GlslConstant, 1> given{{{5, std::bit_cast<std::uint32_t>(kValue)}}};
  const std::string glsl = translated(kConstants, GlslVersion::k330, given);
  constexpr std::string_view kName = "SPIRV_CROSS_CONSTANT_ID_5 ";
  const std::size_t at = glsl.find(kName);
  ASSERT_NE(at, std::string::npos) << glsl;
  EXPECT_EQ(std::stof(glsl.substr(at + kName.size())), kValue) << glsl;
}

TEST_F(GlslTranslation, AModuleForVulkanIsRefused) {
  const Expected<ShaderModule> module =
      compileFragment(std::string("#version 450\n") + kSamplerAndBlock, ShaderTarget::kVulkan);
  ASSERT_TRUE(module) << sentence(module.error());
  const Expected<std::string> glsl = translateToGlsl(module->spirv, GlslVersion::k330, {});
  ASSERT_FALSE(glsl);
  EXPECT_EQ(glsl.error().kind, ErrorKind::kInput);
  expectParts(sentence(glsl.error()), {"made for Vulkan", "compile it for OpenGL"});
}

TEST_F(GlslTranslation, WhatIsNoModuleIsAnErrorWithTheReason) {
  const std::array<std::uint32_t, 6> garbage{1, 2, 3, 4, 5, 6};
  const Expected<std::string> glsl = translateToGlsl(garbage, GlslVersion::k330, {});
  ASSERT_FALSE(glsl);
  expectParts(sentence(glsl.error()), {"could not translate SPIR-V to GLSL", "GLSL 330"});
  EXPECT_FALSE(translateToGlsl({}, GlslVersion::k450, {}));
}

// Whatever the kit draws must reach every device.
TEST_F(GlslTranslation, EveryShaderOfTheKitCanBeSaidInGlsl330) {
  const std::filesystem::path kit = std::filesystem::path(SSRKIT_SOURCE_DIR) / "shaders";
  for (const auto& entry : std::filesystem::directory_iterator(kit)) {
    const Expected<ShaderStage> stage = stageOfFile(entry.path());
    if (!stage) {
      continue;
    }
    const Expected<ShaderModule> module =
        compileShader({kit, entry.path().filename(), *stage, {}}, ShaderTarget::kOpenGl);
    ASSERT_TRUE(module) << sentence(module.error());
    const Expected<std::string> glsl = translateToGlsl(module->spirv, GlslVersion::k330, {});
    EXPECT_TRUE(glsl) << entry.path() << ": " << sentence(glsl.error());
  }
}

}  // namespace
}  // namespace ssrkit
