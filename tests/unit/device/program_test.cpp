#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "device_fixture.h"

namespace ssrkit {
namespace {

class ProgramTest : public DeviceTest {};
SSRKIT_ON_EVERY_DEVICE(ProgramTest);

TEST_P(ProgramTest, SpecialisationConstantsHaveTheirDefaultsUntilSet) {
  ProgramSource source = compile("specialised.vert", "specialised.frag");
  source.desc.colour_formats = {Format::kRgba32f};
  const auto target = image(Format::kRgba32f, {1, 1});
  const auto plain = program(source.desc);
  draw(passTo(*target, *plain));
  EXPECT_EQ(read<float>(*target), (std::vector<float>{-7.0F, 0.25F, 11.0F, 1.0F}));

  source.desc.spec_constants = {{3, static_cast<std::uint32_t>(-1000)},
                                {5, std::bit_cast<std::uint32_t>(0.1F)},
                                {8, 1},
                                {9, 4000000000U},
                                {4, std::bit_cast<std::uint32_t>(2.0F)},
                                {77, 1}};  // no stage has it: it is not passed on
  const auto set = program(source.desc);
  draw(passTo(*target, *set));
  EXPECT_EQ(read<float>(*target), (std::vector<float>{1000.0F, -0.1F, -4000000000.0F, -1.0F}));
}

TEST_P(ProgramTest, ASpecialisationConstantReachesTheVertexStage) {
  ProgramSource source = compile("specialised.vert", "specialised.frag");
  source.desc.colour_formats = {Format::kRgba32f};
  source.desc.spec_constants = {{4, std::bit_cast<std::uint32_t>(0.0F)}};  // no area
  const auto target = image(Format::kRgba32f, {1, 1});
  const auto nothing = program(source.desc);
  PassDesc pass = passTo(*target, *nothing);
  pass.colour[0].clear = std::array{5.0, 5.0, 5.0, 5.0};
  draw(pass);
  EXPECT_EQ(read<float>(*target), std::vector<float>(4, 5.0F));
}

TEST_P(ProgramTest, AUniformBlockArrivesMemberByMember) {
  struct alignas(16) Block {
    std::array<float, 3> first{1, 2, 3};
    float second = 4;
    std::array<std::int32_t, 2> third{5, -6};
    std::array<std::int32_t, 2> padding{};
    std::array<float, 16> matrix{0, 0, 0, 0, 0, 0, 0, 0, 10, 11, 12, 13, 0, 0, 0, 0};
    std::uint32_t last = 14;
    std::array<std::uint32_t, 3> end{};
  };
  static_assert(sizeof(Block) == 112);
  const auto firsts = image(Format::kRgba32f, {1, 1});
  const auto column = image(Format::kRgba32f, {1, 1});
  const auto program = screenProgram("block.frag", {Format::kRgba32f, Format::kRgba32f});
  PassDesc pass = passTo(*firsts, *program);
  pass.colour.push_back({column.get(), 0, {}});
  const Block block;
  pass.uniform_binding = 2;
  pass.uniforms = bytesOf(block);
  draw(pass);
  EXPECT_EQ(read<float>(*firsts), (std::vector<float>{3, 4, -6, 14}));
  EXPECT_EQ(read<float>(*column), (std::vector<float>{10, 11, 12, 13}));
}

TEST_P(ProgramTest, APassWithoutTheBlockThatItsShaderReadsIsAnError) {
  const auto target = image(Format::kRgba32f, {1, 1});
  const auto constant = screenProgram("constant.frag", {Format::kRgba32f});
  const auto refused = device().draw(passTo(*target, *constant));
  ASSERT_FALSE(refused);
  EXPECT_NE(sentence(refused.error()).find("uniform block at binding 0"), std::string::npos);
}

TEST_P(ProgramTest, BrokenSpirvIsAnErrorThatNamesTheStage) {
  const ProgramSource source = compile("screen.vert", "coordinate.frag");
  const auto refusal = [&](std::span<const std::uint32_t> fragment) {
    ProgramDesc desc = source.desc;
    desc.colour_formats = {Format::kRgba32f};
    desc.fragment_spirv = fragment;
    const auto made = device().createProgram(desc);
    return made ? std::string("none") : sentence(made.error());
  };
  const std::vector<std::uint32_t>& good = source.fragment.spirv;
  std::vector<std::uint32_t> truncated(good.begin(), good.end() - 2);
  std::vector<std::uint32_t> garbage(good.size(), 0xdeadbeefU);
  std::vector<std::uint32_t> headed = garbage;
  std::copy_n(good.begin(), 5, headed.begin());
  for (const auto& broken : {truncated, garbage, headed, std::vector<std::uint32_t>{}}) {
    EXPECT_NE(refusal(broken).find("fragment shader of 'coordinate.frag'"), std::string::npos)
        << refusal(broken);
  }
  EXPECT_EQ(refusal(good), "none");
}

TEST_P(ProgramTest, AModuleOfTheOtherStageIsAnError) {
  const ProgramSource source = compile("screen.vert", "coordinate.frag");
  ProgramDesc desc = source.desc;
  desc.colour_formats = {Format::kRgba32f};
  desc.fragment_spirv = source.vertex.spirv;
  EXPECT_FALSE(device().createProgram(desc));
}

}  // namespace
}  // namespace ssrkit
