// The Vulkan device under core and synchronization validation: DeviceTest fails on any message.
#include <algorithm>
#include <array>
#include <numeric>

#include "device/format.h"
#include "device_fixture.h"
#include "scoped_variable.h"

namespace ssrkit {
namespace {

class VulkanValidationTest : public DeviceTest {
 private:
  ScopedVariable validation_{"SSRKIT_VALIDATION", "1"};  // as long as the test, SetUp included
};
INSTANTIATE_TEST_SUITE_P(On, VulkanValidationTest, testing::Values("vk-lavapipe"), nameOfDevice);

struct LookUpPlace {  // std140 of look_up.frag
  std::array<float, 2> uv_per_px{};
  std::array<float, 2> uv_offset{};
  float level = 0;
  std::array<float, 3> padding{};
};

struct Vertex {
  std::array<float, 3> position_ndc;
  float shade;
};

void describeMesh(ProgramDesc& desc) {
  desc.vertex_attributes = {{0, VertexFormat::kFloat3, 0}, {1, VertexFormat::kFloat1, 12}};
  desc.vertex_stride_bytes = sizeof(Vertex);
}

// Two triangles over the columns x0..x1 of NDC, the whole height.
std::vector<Vertex> upright(float x0, float x1, float z, float shade) {
  const std::array<std::array<float, 2>, 6> corners{
      {{x0, -1}, {x1, -1}, {x0, 1}, {x0, 1}, {x1, -1}, {x1, 1}}};
  std::vector<Vertex> vertices;
  vertices.reserve(corners.size());
  for (const auto& [x, y] : corners) {
    vertices.push_back({{x, y, z}, shade});
  }
  return vertices;
}

std::vector<float> ramp(std::size_t count) {
  std::vector<float> values(count);
  std::iota(values.begin(), values.end(), 1.0F);
  return values;
}

TEST_P(VulkanValidationTest, EveryFormatTravelsThereAndBackAndSideways) {
  for (const Format format :
       {Format::kR8ui, Format::kRgba8, Format::kRgba8Srgb, Format::kRg16i, Format::kRgba16ui,
        Format::kRgba16f, Format::kR32f, Format::kRg32f, Format::kRgba32f, Format::kD32f}) {
    SCOPED_TRACE(formatName(format));
    const auto from = image(format, {6, 5}, 3);
    const auto to = image(format, {6, 5});
    for (int mip = 0; mip < 3; ++mip) {
      std::vector<std::byte> texels(mipByteCount(from->desc(), mip));
      std::ranges::generate(texels, [i = mip]() mutable { return static_cast<std::byte>(++i % 60); });
      upload(*from, mip, texels);
      EXPECT_EQ(readBytes(*from, mip), texels);
    }
    ASSERT_TRUE(device().copy(*from, 0, {6, 5}, *to, 0, 0));
    EXPECT_EQ(readBytes(*to, 0), readBytes(*from, 0));
  }
}

TEST_P(VulkanValidationTest, IntegerTargetsAreDrawnAndThenSampled) {
  const Size size{3, 2};
  const auto floats = image(Format::kRgba32f, size);
  const auto signed_integers = image(Format::kRg16i, size);
  const auto unsigned_integers = image(Format::kRgba16ui, size);
  const auto bytes = image(Format::kR8ui, size);
  const auto many = screenProgram("many_targets.frag",
                                  {Format::kRgba32f, Format::kRg16i, Format::kRgba16ui, Format::kR8ui});
  PassDesc fill = passTo(*floats, *many);
  for (DeviceImage* const target : {signed_integers.get(), unsigned_integers.get(), bytes.get()}) {
    fill.colour.push_back({.image = target, .mip = 0, .clear = std::array{1.0, 2.0, 3.0, 4.0}});
  }
  draw(fill);
  draw(fill);  // again, over what is there
  const auto result = image(Format::kRgba32f, size);
  const auto look_up = screenProgram("look_up_integers.frag", {Format::kRgba32f});
  PassDesc pass = passTo(*result, *look_up);
  pass.sampled = {{.binding = 0, .image = signed_integers.get()},
                  {.binding = 1, .image = unsigned_integers.get()}};
  draw(pass);
  std::vector<float> expected;
  for (int i = 0; i < 6; ++i) {
    expected.insert(expected.end(), {static_cast<float>(i % 3) - 32768.0F, 32767.0F, 0.0F, 65535.0F});
  }
  EXPECT_EQ(read<float>(*result), expected);
  EXPECT_EQ(read<std::uint8_t>(*bytes), (std::vector<std::uint8_t>{200, 200, 200, 201, 201, 201}));
}

TEST_P(VulkanValidationTest, TheNearerSurfaceStaysAndItsDepthCanBeSampled) {
  ProgramSource source = compile("mesh.vert", "mesh.frag");
  describeMesh(source.desc);
  source.desc.colour_formats = {Format::kR32f};
  source.desc.depth_test = DepthTest::kNearer;
  const auto mesh = program(source.desc);
  std::vector<Vertex> vertices = upright(-1, 1, 0.75F, 5.0F);
  std::ranges::copy(upright(-1, 0, 0.25F, 6.0F), std::back_inserter(vertices));
  std::ranges::copy(upright(-1, 1, 0.5F, 7.0F), std::back_inserter(vertices));
  const auto buffer = valueOf(device().createVertexBuffer(std::as_bytes(std::span(vertices))));
  const auto colour = image(Format::kR32f, {4, 1});
  const auto depth = image(Format::kD32f, {4, 1});
  PassDesc pass = passTo(*colour, *mesh);
  pass.vertices = buffer.get();
  pass.depth = Attachment{depth.get(), 0, std::array{1.0, 0.0, 0.0, 0.0}};
  pass.draws = {{0, 6, {}}, {6, 6, {}}, {12, 6, {}}};
  draw(pass);
  EXPECT_EQ(read<float>(*colour), (std::vector<float>{6, 6, 7, 7}));

  const auto seen = image(Format::kRgba32f, {4, 1});
  const auto look_up = screenProgram("look_up.frag", {Format::kRgba32f});
  PassDesc look = passTo(*seen, *look_up);
  const LookUpPlace place{{0.25F, 1.0F}, {0, 0}, 0, {}};
  look.uniform_binding = 1;
  look.uniforms = bytesOf(place);
  look.sampled = {{.binding = 0, .image = depth.get()}};
  draw(look);
  const std::vector<float> texels = read<float>(*seen);
  EXPECT_EQ((std::vector<float>{texels[0], texels[4], texels[8], texels[12]}),
            (std::vector<float>{0.25F, 0.25F, 0.5F, 0.5F}));
}

TEST_P(VulkanValidationTest, ACopiedRectangleIsSampledWhereItLanded) {
  const auto patch = image(Format::kR32f, {2, 2});
  const auto atlas = image(Format::kR32f, {4, 4});
  upload(*patch, 0, std::vector<float>{1, 2, 3, 4});
  upload(*atlas, 0, std::vector<float>(16, 9.0F));
  ASSERT_TRUE(device().copy(*patch, 0, {2, 2}, *atlas, 2, 1));
  const auto seen = image(Format::kRgba32f, {4, 4});
  const auto look_up = screenProgram("look_up.frag", {Format::kRgba32f});
  PassDesc look = passTo(*seen, *look_up);
  const LookUpPlace place{{0.25F, 0.25F}, {0, 0}, 0, {}};
  look.uniform_binding = 1;
  look.uniforms = bytesOf(place);
  look.sampled = {{.binding = 0, .image = atlas.get()}};
  draw(look);
  const std::vector<float> texels = read<float>(*seen);
  std::vector<float> reds;
  for (std::size_t i = 0; i < texels.size(); i += 4) {
    reds.push_back(texels[i]);
  }
  EXPECT_EQ(reds, (std::vector<float>{9, 9, 9, 9,  //
                                      9, 9, 1, 2,  //
                                      9, 9, 3, 4,  //
                                      9, 9, 9, 9}));
}

TEST_P(VulkanValidationTest, APyramidIsBuiltInsideOneImage) {
  const auto pyramid = image(Format::kR32f, {8, 8}, 4);
  std::vector<float> finest = ramp(64);
  std::ranges::reverse(finest);
  upload(*pyramid, 0, finest);
  const auto reduce = screenProgram("reduce.frag", {Format::kR32f});
  for (int round = 0; round < 2; ++round) {
    for (int mip = 1; mip < 4; ++mip) {
      PassDesc pass = passTo(*pyramid, *reduce, mip);
      pass.sampled = {{.binding = 0, .image = pyramid.get(), .base_mip = mip - 1}};
      draw(pass);
    }
  }
  // Values fall along the rows and down them, so the least of a block stands in its lower right corner.
  for (int mip = 1; mip < 4; ++mip) {
    std::vector<float> expected;
    for (int y = 0; y < 8 >> mip; ++y) {
      for (int x = 0; x < 8 >> mip; ++x) {
        expected.push_back(static_cast<float>(64 - (((y + 1) << mip) - 1) * 8 - (((x + 1) << mip) - 1)));
      }
    }
    EXPECT_EQ(read<float>(*pyramid, mip), expected) << "mip " << mip;
  }
}

TEST_P(VulkanValidationTest, EachDrawSeesItsOwnTexture) {
  ProgramSource source = compile("mesh.vert", "look_up.frag");
  describeMesh(source.desc);
  source.desc.colour_formats = {Format::kRgba32f};
  const auto textured = program(source.desc);
  std::vector<Vertex> vertices = upright(-1, 0, 0.5F, 0);
  std::ranges::copy(upright(0, 1, 0.5F, 0), std::back_inserter(vertices));
  const auto buffer = valueOf(device().createVertexBuffer(std::as_bytes(std::span(vertices))));
  const auto one = image(Format::kRgba32f, {1, 1});
  const auto two = image(Format::kRgba32f, {1, 1});
  upload(*one, 0, std::vector<float>{1, 2, 3, 4});
  upload(*two, 0, std::vector<float>{5, 6, 7, 8});
  const auto target = image(Format::kRgba32f, {2, 1});
  const LookUpPlace place{};
  PassDesc pass = passTo(*target, *textured);
  pass.uniform_binding = 1;
  pass.uniforms = bytesOf(place);
  pass.vertices = buffer.get();
  pass.draws = {{0, 6, {{.binding = 0, .image = one.get()}}}, {6, 6, {{.binding = 0, .image = two.get()}}}};
  draw(pass);
  EXPECT_EQ(read<float>(*target), (std::vector<float>{1, 2, 3, 1, 5, 6, 7, 1}));
  std::ranges::reverse(pass.draws);  // the pass's own image serves the draw that has none
  pass.draws[0].sampled.clear();
  pass.sampled = {{.binding = 0, .image = one.get()}};
  pass.draws[1].sampled[0].image = two.get();
  draw(pass);
  EXPECT_EQ(read<float>(*target), (std::vector<float>{5, 6, 7, 1, 1, 2, 3, 1}));
}

TEST_P(VulkanValidationTest, APassWithoutDrawsOnlyClears) {
  const auto target = image(Format::kR32f, {2, 1});
  const auto constant = screenProgram("coordinate.frag", {Format::kR32f});
  PassDesc pass = passTo(*target, *constant);
  pass.colour[0].clear = std::array{3.5, 0.0, 0.0, 0.0};
  pass.draws.clear();
  draw(pass);
  EXPECT_EQ(read<float>(*target), (std::vector<float>{3.5F, 3.5F}));
}

}  // namespace
}  // namespace ssrkit
