// Modules rewritten so that they compute the same: legal for both APIs, and as they are meant to be.
#include "shader/module_variants.h"

#include <algorithm>
#include <glslang/SPIRV/spirv.hpp>

#include "shader/spirv_instructions.h"
#include "shader_folder.h"

namespace ssrkit {
namespace {

class ModuleVariantsTest : public ShaderFolder {};

constexpr std::string_view kShader = R"(#version 450
layout(std140, binding = 0) uniform Block {
  float a;
  vec3 b;
  int c;
  mat4 d;
  vec4 e[3];
  vec2 f;
};
layout(location = 0) out vec4 colour;
float twice(float x) { return x * 2.0; }
void main() {
  bool both = a > 0.0 && b.y > twice(a);
  precise float sum = a + b.x * f.y;
  colour = d * e[c] + vec4(both ? sum : dot(b, b));
}
)";

const BlockMember& memberOf(const ShaderModule& module, std::string_view name) {
  const auto& members = module.interface.uniform_blocks.at(0).members;
  return *std::ranges::find(members, name, &BlockMember::name);
}

std::size_t countOf(const ShaderModule& module, std::uint32_t opcode) {
  std::size_t count = 0;
  forEachInstruction(module.spirv, [&](const Instruction& line) { count += line.opcode == opcode ? 1 : 0; });
  return count;
}

TEST_F(ModuleVariantsTest, ReversedUniformsLieWhereStd140HasThemInThatOrder) {
  write("shaders/a.frag", kShader);
  for (const ShaderTarget target : kBothTargets) {
    const auto module =
        compileEntry("a.frag", target, {.form = ModuleForm::kUniformsReversed, .use_cache = false});
    ASSERT_TRUE(module.has_value()) << sentence(module.error());
    EXPECT_EQ(module->interface.uniform_blocks.at(0).members.front().name, "f");
    EXPECT_EQ(memberOf(*module, "f").offset_bytes, 0U);
    EXPECT_EQ(memberOf(*module, "e").offset_bytes, 16U);
    EXPECT_EQ(memberOf(*module, "e").array_count, 3U);
    EXPECT_EQ(memberOf(*module, "d").offset_bytes, 64U);
    EXPECT_EQ(memberOf(*module, "d").matrix_stride_bytes, 16U);
    EXPECT_EQ(memberOf(*module, "c").offset_bytes, 128U);
    EXPECT_EQ(memberOf(*module, "b").offset_bytes, 144U);
    EXPECT_EQ(memberOf(*module, "a").offset_bytes, 156U);
    EXPECT_EQ(module->interface.uniform_blocks.at(0).size_bytes, 160U);
  }
}

TEST_F(ModuleVariantsTest, DeadCodeStandsAtTheStartAndBehindEverySum) {
  write("shaders/a.frag", kShader);
  for (const ShaderTarget target : kBothTargets) {
    const auto plain = compileEntry("a.frag", target, {.use_cache = false});
    const auto module = compileEntry("a.frag", target, {.form = ModuleForm::kDeadCode, .use_cache = false});
    ASSERT_TRUE(plain.has_value() && module.has_value()) << sentence(module.error());
    EXPECT_EQ(countOf(*module, spv::OpKill), 1U);
    const std::size_t sums = countOf(*plain, spv::OpFAdd) + countOf(*plain, spv::OpFMul) +
                             countOf(*plain, spv::OpDot) + countOf(*plain, spv::OpVectorTimesScalar);
    EXPECT_GE(sums, 5U);
    EXPECT_EQ(countOf(*module, spv::OpFAdd), countOf(*plain, spv::OpFAdd) + sums);
    EXPECT_EQ(memberOf(*module, kDeadCodeZero).offset_bytes, memberOf(*module, "f").offset_bytes + 8);
    EXPECT_EQ(memberOf(*module, "e").offset_bytes, memberOf(*plain, "e").offset_bytes);
  }
}

TEST_F(ModuleVariantsTest, LoopsAreCountedAndEveryOutputIsOverturned) {
  write("shaders/a.frag", R"(#version 450
layout(location = 0) out vec4 colour;
layout(location = 1) out int count;
layout(location = 2) out uvec2 pair;
layout(location = 3) out float one;
float sum(int turns) {
  float total = 0.0;
  for (int i = 0; i < turns; ++i) {
    for (int j = 0; j < i; ++j) {
      total += float(j);
    }
  }
  return total;
}
void main() {
  colour = vec4(0.0);
  count = 1;
  pair = uvec2(2);
  one = 1.0;
  if (gl_FragCoord.x > 3.0) {
    colour = vec4(sum(int(gl_FragCoord.y)));
    return;
  }
  while (one < gl_FragCoord.x) {
    one += 0.5;
  }
}
)");
  for (const ShaderTarget target : kBothTargets) {
    const auto plain = compileEntry("a.frag", target, {.use_cache = false});
    const auto module =
        compileEntry("a.frag", target, {.form = ModuleForm::kCountedLoops, .use_cache = false});
    ASSERT_TRUE(plain.has_value() && module.has_value()) << sentence(module.error());
    EXPECT_EQ(countOf(*module, spv::OpLoopMerge), 3U);
    EXPECT_EQ(countOf(*module, spv::OpIAdd), countOf(*plain, spv::OpIAdd) + 3);
    const std::size_t ends = 2;  // of main
    EXPECT_EQ(countOf(*module, spv::OpSelect), countOf(*plain, spv::OpSelect) + 2 * ends) << "colour, one";
    EXPECT_EQ(countOf(*module, spv::OpNot), 2 * ends) << "count, pair";
  }
}

TEST_F(ModuleVariantsTest, WithoutALoopNothingIsCounted) {
  write("shaders/a.frag", kShader);
  const auto plain = compileEntry("a.frag", ShaderTarget::kVulkan, {.use_cache = false});
  const auto module =
      compileEntry("a.frag", ShaderTarget::kVulkan, {.form = ModuleForm::kCountedLoops, .use_cache = false});
  ASSERT_TRUE(plain.has_value() && module.has_value());
  EXPECT_EQ(module->spirv, plain->spirv);
}

TEST_F(ModuleVariantsTest, ABlockWithoutAFloatTakesTheMemberToo) {
  write("shaders/a.frag", R"(#version 450
layout(std140, binding = 0) uniform Block { ivec3 texel; };
layout(location = 0) out ivec4 result;
void main() { result = ivec4(texel, 1); }
)");
  for (const ShaderTarget target : kBothTargets) {
    for (const ModuleForm form : {ModuleForm::kDeadCode, ModuleForm::kUniformsReversed}) {
      const auto module = compileEntry("a.frag", target, {.form = form, .use_cache = false});
      ASSERT_TRUE(module.has_value()) << sentence(module.error());
    }
  }
}

TEST_F(ModuleVariantsTest, WithoutABlockAModuleStaysAsItIs) {
  write("shaders/a.frag", R"(#version 450
layout(location = 0) out vec4 colour;
void main() { colour = gl_FragCoord * 2.0; }
)");
  const auto plain = compileEntry("a.frag", ShaderTarget::kOpenGl, {.use_cache = false});
  for (const ModuleForm form : {ModuleForm::kDeadCode, ModuleForm::kUniformsReversed}) {
    const auto module = compileEntry("a.frag", ShaderTarget::kOpenGl, {.form = form, .use_cache = false});
    ASSERT_TRUE(plain.has_value() && module.has_value());
    EXPECT_EQ(module->spirv, plain->spirv);
  }
}

}  // namespace
}  // namespace ssrkit
