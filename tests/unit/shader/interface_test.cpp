#include <gtest/gtest.h>

#include <bit>

#include "shader_folder.h"

namespace ssrkit {
namespace {

class Interface : public ShaderFolder {
 protected:
  [[nodiscard]] ShaderInterface interfaceOf(std::string_view text, ShaderTarget target) const {
    const Expected<ShaderModule> module = compileFragment(text, target);
    EXPECT_TRUE(module) << sentence(module.error());
    return module ? module->interface : ShaderInterface {};
  }
};

TEST_F(Interface, ListsSamplersByBindingWithTheirKind) {
  for (const ShaderTarget target : kBothTargets) {
    const ShaderInterface interface = interfaceOf(
        "#version 450\nlayout(binding = 4) uniform usampler2D ids;\nlayout(binding = 1) uniform sampler2D "
        "dist_view;\n"
        "layout(binding = 2) uniform isampler2D texels;\nvoid main() {}\n",
        target);
    ASSERT_EQ(interface.samplers.size(), 3U);
    EXPECT_EQ(interface.samplers[0].name, "dist_view");
    EXPECT_EQ(interface.samplers[0].binding, 1U);
    EXPECT_EQ(interface.samplers[0].kind, SamplerKind::kFloat);
    EXPECT_EQ(interface.samplers[1].kind, SamplerKind::kInt);
    EXPECT_EQ(interface.samplers[2].kind, SamplerKind::kUint);
    EXPECT_EQ(interface.samplers[2].binding, 4U);
  }
}

struct ExpectedMember {
  const char* name;
  ScalarType type;
  std::uint32_t offset_bytes;
  std::uint32_t rows;
  std::uint32_t columns;
  std::uint32_t matrix_stride_bytes;
  std::uint32_t array_count;
  std::uint32_t array_stride_bytes;
};

// Offsets by the rules of std140 (OpenGL 4.5, section 7.6.2.2), worked out by hand.
constexpr ExpectedMember kMembers[] = {
    {"clip_from_view", ScalarType::kFloat, 0, 4, 4, 16, 0, 0},
    {"near_m", ScalarType::kFloat, 64, 1, 1, 0, 0, 0},
    {"size_px", ScalarType::kInt, 72, 2, 1, 0, 0, 0},
    {"light_view", ScalarType::kFloat, 80, 3, 1, 0, 0, 0},
    {"flags", ScalarType::kUint, 92, 1, 1, 0, 0, 0},
    {"weights", ScalarType::kFloat, 96, 1, 1, 0, 3, 16},
    {"turn", ScalarType::kFloat, 144, 3, 3, 16, 0, 0},
    {"lights[0].colour", ScalarType::kFloat, 192, 3, 1, 0, 0, 0},
    {"lights[0].on", ScalarType::kUint, 204, 1, 1, 0, 0, 0},
    {"lights[1].colour", ScalarType::kFloat, 208, 3, 1, 0, 0, 0},
    {"lights[1].on", ScalarType::kUint, 220, 1, 1, 0, 0, 0},
    {"sun.colour", ScalarType::kFloat, 224, 3, 1, 0, 0, 0},
    {"sun.on", ScalarType::kUint, 236, 1, 1, 0, 0, 0},
    {"last", ScalarType::kFloat, 240, 1, 1, 0, 0, 0},
};

TEST_F(Interface, LaysOutABlockByTheRulesOfStd140) {
  for (const ShaderTarget target : kBothTargets) {
    const ShaderInterface interface = interfaceOf(
        "#version 450\nstruct Light { vec3 colour; bool on; };\n"
        "layout(std140, binding = 3) uniform Frame { mat4 clip_from_view; float near_m; ivec2 size_px; vec3 "
        "light_view;\n"
        "uint flags; float weights[3]; mat3 turn; Light lights[2]; Light sun; float last; } frame;\n"
        "layout(location = 0) out float y;\nvoid main() { y = frame.last; }\n",
        target);
    ASSERT_EQ(interface.uniform_blocks.size(), 1U);
    const UniformBlock& block = interface.uniform_blocks.front();
    EXPECT_EQ(block.name, "Frame");
    EXPECT_EQ(block.binding, 3U);
    EXPECT_EQ(block.size_bytes, 256U);
    ASSERT_EQ(block.members.size(), std::size(kMembers));
    for (std::size_t i = 0; i < block.members.size(); ++i) {
      const BlockMember& actual = block.members[i];
      const ExpectedMember& expected = kMembers[i];
      EXPECT_EQ(actual.name, expected.name);
      EXPECT_EQ(actual.type, expected.type) << actual.name;
      EXPECT_EQ(actual.offset_bytes, expected.offset_bytes) << actual.name;
      EXPECT_EQ(actual.rows, expected.rows) << actual.name;
      EXPECT_EQ(actual.columns, expected.columns) << actual.name;
      EXPECT_EQ(actual.matrix_stride_bytes, expected.matrix_stride_bytes) << actual.name;
      EXPECT_EQ(actual.array_count, expected.array_count) << actual.name;
      EXPECT_EQ(actual.array_stride_bytes, expected.array_stride_bytes) << actual.name;
    }
  }
}

TEST_F(Interface, ListsInputsAndOutputsByLocationAndLeavesBuiltInsOut) {
  const ShaderInterface interface = interfaceOf(
      "#version 450\nlayout(location = 2) in vec3 normal_view;\nlayout(location = 0) flat in ivec2 cell;\n"
      "layout(location = 1) out uint outcome;\nlayout(location = 0) out vec4 colour;\n"
      "void main() { colour = gl_FragCoord * normal_view.x; outcome = uint(cell.x); }\n",
      ShaderTarget::kVulkan);
  ASSERT_EQ(interface.inputs.size(), 2U);
  EXPECT_EQ(interface.inputs[0].name, "cell");
  EXPECT_EQ(interface.inputs[0].type, ScalarType::kInt);
  EXPECT_EQ(interface.inputs[0].components, 2U);
  EXPECT_EQ(interface.inputs[1].location, 2U);
  ASSERT_EQ(interface.outputs.size(), 2U);
  EXPECT_EQ(interface.outputs[0].name, "colour");
  EXPECT_EQ(interface.outputs[1].type, ScalarType::kUint);
  EXPECT_EQ(interface.outputs[1].components, 1U);
}

TEST_F(Interface, GivesEachLocationOfAnArrayOrMatrixItsEntry) {
  const ShaderInterface interface = interfaceOf(
      "#version 450\nlayout(location = 1) in mat3 turn;\nlayout(location = 4) in vec2 uv[2];\n"
      "layout(location = 0) out vec4 c;\nvoid main() { c = vec4(turn[0] + turn[2], uv[1].x); }\n",
      ShaderTarget::kOpenGl);
  ASSERT_EQ(interface.inputs.size(), 5U);
  EXPECT_EQ(interface.inputs[2].name, "turn[2]");
  EXPECT_EQ(interface.inputs[2].location, 3U);
  EXPECT_EQ(interface.inputs[4].name, "uv[1]");
  EXPECT_EQ(interface.inputs[4].location, 5U);
}

TEST_F(Interface, KeepsSpecConstantsWithTheirDefaultsEvenOptimised) {
  write("shaders/a.frag",
        "#version 450\nlayout(constant_id = 7) const float kScale = 0.5;\nlayout(constant_id = 3) const int "
        "kBias = -4;\n"
        "layout(constant_id = 5) const bool kTuned = true;\nlayout(location = 0) out float y;\n"
        "void main() { y = kTuned ? kScale : float(kBias); }\n");
  for (const ShaderTarget target : kBothTargets) {
    for (const ModuleForm form :
         {ModuleForm::kPlain, ModuleForm::kOptimised, ModuleForm::kOptimisedSize, ModuleForm::kRobust}) {
      const auto module = compileEntry("a.frag", target, {.form = form, .use_cache = false});
      ASSERT_TRUE(module);
      const std::vector<SpecConstantInfo>& constants = module->interface.spec_constants;
      ASSERT_EQ(constants.size(), 3U);
      EXPECT_EQ(constants[0].name, "kBias");
      EXPECT_EQ(constants[0].id, 3U);
      EXPECT_EQ(static_cast<std::int32_t>(constants[0].default_bits), -4);
      EXPECT_EQ(constants[1].default_bits, 1U);
      EXPECT_EQ(constants[2].type, ScalarType::kFloat);
      EXPECT_EQ(std::bit_cast<float>(constants[2].default_bits), 0.5F);
    }
  }
}

struct Unbindable {
  const char* declaration;
  const char* reason;
  ShaderTarget target;
};

TEST_F(Interface, RefusesWhatAPassCannotBind) {
  const Unbindable cases[] = {
      {"layout(binding = 0, rgba8) uniform image2D i;", "storage image", ShaderTarget::kOpenGl},
      {"layout(binding = 0) buffer B { float x; } b;", "storage buffer", ShaderTarget::kVulkan},
      {"layout(push_constant) uniform P { float x; } p;", "push constant", ShaderTarget::kVulkan},
      {"layout(binding = 0) uniform texture2D t;", "without its sampler", ShaderTarget::kVulkan},
      {"layout(location = 0) uniform float loose;", "'loose' is a uniform outside a block",
       ShaderTarget::kOpenGl},
      {"layout(set = 1, binding = 0) uniform sampler2D s;", "another set", ShaderTarget::kVulkan},
      {"layout(binding = 0) uniform sampler2D s[2];", "array of samplers", ShaderTarget::kVulkan},
      {"layout(binding = 0) uniform sampler2D s; layout(std140, binding = 0) uniform U { float x; };",
       "share binding 0", ShaderTarget::kOpenGl},
      {"layout(std140, row_major, binding = 0) uniform U { mat4 m; };", "row_major", ShaderTarget::kOpenGl},
      {"layout(std140, binding = 0) uniform U { double x; };", "neither float", ShaderTarget::kOpenGl},
  };
  for (const Unbindable& bad : cases) {
    const Error error =
        errorOf(std::string("#version 450\n") + bad.declaration + "\nvoid main() {}\n", bad.target);
    EXPECT_NE(error.problem.find(bad.reason), std::string::npos) << bad.declaration << ": " << error.problem;
  }
}

TEST_F(Interface, OfAVertexShaderHidesTheIndexBehindOneMacro) {
  write("shaders/a.vert", "#version 450\nvoid main() { gl_Position = vec4(float(SSR_VERTEX_INDEX)); }\n");
  for (const ShaderTarget target : kBothTargets) {
    const Expected<ShaderModule> module = compileEntry("a.vert", target);
    ASSERT_TRUE(module) << sentence(module.error());
    EXPECT_TRUE(module->interface.inputs.empty());
  }
}

TEST_F(Interface, TargetsHaveTheirOwnVersionOfSpirv) {
  const std::string_view text = "#version 450\nvoid main() {}\n";
  EXPECT_EQ(compileFragment(text, ShaderTarget::kOpenGl)->spirv[1], 0x00010000U);
  EXPECT_EQ(compileFragment(text, ShaderTarget::kVulkan)->spirv[1], 0x00010300U);
}

TEST_F(Interface, TargetsDefineTheirOwnMacro) {
  const std::string_view gl =
      "#version 450\n#if !defined(GL_SPIRV) || defined(VULKAN)\n#error\n#endif\nvoid main() {}\n";
  const std::string_view vk =
      "#version 450\n#if defined(GL_SPIRV) || !defined(VULKAN)\n#error\n#endif\nvoid main() {}\n";
  EXPECT_TRUE(compileFragment(gl, ShaderTarget::kOpenGl));
  EXPECT_TRUE(compileFragment(vk, ShaderTarget::kVulkan));
}

}  // namespace
}  // namespace ssrkit
