#include <array>
#include <vector>

#include "device_fixture.h"

namespace ssrkit {
namespace {

struct Vertex {
  std::array<float, 3> position_ndc;
  float shade;
};

// A triangle over the whole viewport at one depth; `winding` swaps two corners.
std::vector<Vertex> cover(float depth, float shade, bool is_clockwise) {
  std::vector<Vertex> corners{{{-1, -1, depth}, shade}, {{3, -1, depth}, shade}, {{-1, 3, depth}, shade}};
  if (is_clockwise) {
    std::swap(corners[1], corners[2]);
  }
  return corners;
}

class MeshTest : public DeviceTest {
 protected:
  void SetUp() override {
    DeviceTest::SetUp();
    program_ = meshProgram("mesh.vert", "mesh.frag");
    colour_ = image(Format::kR32f, {2, 2});
    depth_ = image(Format::kD32f, {2, 2});
  }

  [[nodiscard]] std::unique_ptr<DeviceProgram> meshProgram(const std::string& vertex,
                                                           const std::string& fragment,
                                                           DepthTest test = DepthTest::kNearer) {
    ProgramSource source = compile(vertex, fragment);
    source.desc.vertex_attributes = {{0, VertexFormat::kFloat3, 0},
                                     {1, VertexFormat::kFloat1, sizeof(float) * 3}};
    source.desc.vertex_stride_bytes = sizeof(Vertex);
    source.desc.colour_formats = {Format::kR32f};
    source.desc.depth_test = test;
    return program(source.desc);
  }

  // Draws `vertices` as one range a draw call of three vertices.
  void drawMesh(const std::vector<Vertex>& vertices, std::optional<double> clear_depth) {
    const auto buffer = valueOf(device().createVertexBuffer(std::as_bytes(std::span(vertices))));
    PassDesc pass = passTo(*colour_, *program_);
    pass.vertices = buffer.get();
    pass.depth = Attachment{.image = depth_.get(), .mip = 0, .clear = {}};
    if (clear_depth) {
      pass.depth->clear = std::array{*clear_depth, 0.0, 0.0, 0.0};
    }
    pass.draws.clear();
    for (std::uint32_t first = 0; first < vertices.size(); first += 3) {
      pass.draws.push_back({.first_vertex = first, .vertex_count = 3, .sampled = {}});
    }
    draw(pass);
  }

  std::unique_ptr<DeviceProgram> program_;
  std::unique_ptr<DeviceImage> colour_;
  std::unique_ptr<DeviceImage> depth_;
};
SSRKIT_ON_EVERY_DEVICE(MeshTest);

TEST_P(MeshTest, TheNearerTriangleWinsInEitherOrder) {
  const std::vector<Vertex> near_first = [] {
    std::vector<Vertex> both = cover(0.25F, 5.0F, false);
    const std::vector<Vertex> far = cover(0.75F, 6.0F, true);
    both.insert(both.end(), far.begin(), far.end());
    return both;
  }();
  const std::vector<Vertex> far_first{near_first[3], near_first[4], near_first[5],
                                      near_first[0], near_first[1], near_first[2]};
  for (const std::vector<Vertex>& order : {near_first, far_first}) {
    drawMesh(order, 1.0);
    EXPECT_EQ(read<float>(*colour_), std::vector<float>(4, 5.0F));
    EXPECT_EQ(read<float>(*depth_), std::vector<float>(4, 0.25F)) << "NDC z is the stored depth";
  }
}

TEST_P(MeshTest, BothWindingsAreDrawn) {
  for (const bool is_clockwise : {false, true}) {
    drawMesh(cover(0.5F, is_clockwise ? 2.0F : 1.0F, is_clockwise), 1.0);
    EXPECT_EQ(read<float>(*colour_), std::vector<float>(4, is_clockwise ? 2.0F : 1.0F));
  }
}

TEST_P(MeshTest, DepthIsKeptBetweenPassesAndEqualDepthLoses) {
  drawMesh(cover(0.5F, 1.0F, false), 1.0);
  drawMesh(cover(0.5F, 2.0F, false), std::nullopt);
  EXPECT_EQ(read<float>(*colour_), std::vector<float>(4, 1.0F));
  drawMesh(cover(0.4375F, 3.0F, false), std::nullopt);
  EXPECT_EQ(read<float>(*colour_), std::vector<float>(4, 3.0F));
}

// The left half is drawn at 0.5; a plane of another program at 1, 0.75 and 0.25 follows over all.
TEST_P(MeshTest, BehindIsDrawnOverWhatIsNearerAndLeavesItsDepth) {
  auto behind = meshProgram("mesh.vert", "mesh.frag", DepthTest::kBehind);
  const std::vector<Vertex> left{{{-1, -1, 0.5F}, 1}, {{0, -1, 0.5F}, 1}, {{-1, 3, 0.5F}, 1},
                                 {{0, -1, 0.5F}, 1},  {{0, 3, 0.5F}, 1},  {{-1, 3, 0.5F}, 1}};
  for (const auto& [depth, is_drawn] : {std::pair{1.0F, true}, {0.75F, true}, {0.25F, false}}) {
    upload(*colour_, 0, std::vector<float>(4, 0.0F));
    drawMesh(left, 1.0);
    program_.swap(behind);
    drawMesh(cover(depth, 7.0F, false), std::nullopt);
    program_.swap(behind);
    const float over_left = is_drawn ? 7.0F : 1.0F;
    EXPECT_EQ(read<float>(*colour_), (std::vector<float>{over_left, 0, over_left, 0})) << "at " << depth;
    EXPECT_EQ(read<float>(*depth_), (std::vector<float>{0.5F, 1, 0.5F, 1})) << "at " << depth;
  }
}

TEST_P(MeshTest, NdcMinusOneIsTheFirstRow) {
  upload(*colour_, 0, std::vector<float>(4, 0.0F));
  // The half of the viewport with y < 0.
  drawMesh({{{-1, 0, 0.5F}, 7}, {{-1, -4, 0.5F}, 7}, {{7, 0, 0.5F}, 7}}, 1.0);
  EXPECT_EQ(read<float>(*colour_), (std::vector<float>{7, 7, 0, 0}));
}

TEST_P(MeshTest, WhatLiesBeforeTheNearPlaneIsClipped) {
  upload(*colour_, 0, std::vector<float>(4, 0.0F));
  drawMesh(cover(-0.125F, 1.0F, false), 1.0);
  EXPECT_EQ(read<float>(*colour_), std::vector<float>(4, 0.0F));
}

// OpenGL's own choice is the last one. The corner also decides the last bits of what is interpolated, so with
// it two APIs over one rasteriser agree (docs/precision.md).
TEST_P(MeshTest, FlatValuesComeFromTheFirstCorner) {
  program_ = meshProgram("mesh_flat.vert", "mesh_flat.frag");
  std::vector<Vertex> corners = cover(0.5F, 0.0F, false);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i].shade = static_cast<float>(i) + 1.0F;
  }
  drawMesh(corners, 1.0);
  EXPECT_EQ(read<float>(*colour_), std::vector<float>(4, 1.0F));
}

TEST_P(MeshTest, EachDrawCallHasImagesOfItsOwn) {
  const auto white = image(Format::kR32f, {1, 1});
  const auto black = image(Format::kR32f, {1, 1});
  upload(*white, 0, std::vector<float>{1.0F});
  upload(*black, 0, std::vector<float>{-1.0F});
  ProgramSource source = compile("mesh.vert", "textured.frag");
  source.desc.vertex_attributes = {{0, VertexFormat::kFloat3, 0},
                                   {1, VertexFormat::kFloat1, sizeof(float) * 3}};
  source.desc.vertex_stride_bytes = sizeof(Vertex);
  source.desc.colour_formats = {Format::kR32f};
  const auto textured = program(source.desc);
  const std::vector<Vertex> halves{{{-1, 0, 0}, 3}, {{-1, -4, 0}, 3}, {{7, 0, 0}, 3},
                                   {{-1, 0, 0}, 4}, {{-1, 4, 0}, 4},  {{7, 0, 0}, 4}};
  const auto buffer = valueOf(device().createVertexBuffer(std::as_bytes(std::span(halves))));
  PassDesc pass = passTo(*colour_, *textured);
  pass.vertices = buffer.get();
  pass.draws = {{0, 3, {{.binding = 4, .image = white.get()}}},
                {3, 3, {{.binding = 4, .image = black.get()}}}};
  draw(pass);
  EXPECT_EQ(read<float>(*colour_), (std::vector<float>{3, 3, -4, -4}));
}

}  // namespace
}  // namespace ssrkit
