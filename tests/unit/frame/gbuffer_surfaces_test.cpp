// Which surfaces the G-buffer shows: by the side that they are seen from, and by what their materials cut
// out.
#include <gtest/gtest.h>

#include <cmath>

#include "frame_device.h"
#include "shadow_scene_test.h"

namespace ssrkit {
namespace {

class GbufferSurfacesTest : public ShadowTest {};

TEST_P(GbufferSurfacesTest, AreThoseThatTheirSidesAndMaterialsShow) {
  const Quad facing{{-2, -2, -4}, {2, -2, -4}, {2, 2, -4}, {-2, 2, -4}};
  const Quad turned_away{{2, -2, -4}, {-2, -2, -4}, {-2, 2, -4}, {2, 2, -4}};
  const Quad wall{{-9, -9, -8}, {9, -9, -8}, {9, 9, -8}, {-9, 9, -8}};
  Material cut{.alpha_mode = AlphaMode::kMask};
  cut.base_colour.a = 0.25F;
  const Material cut_by_texture{.alpha_mode = AlphaMode::kMask, .base_colour_texture = 0};
  struct Case {
    Quad quad;
    Material material;
    float dist_view;  // of what is seen in the middle
  };
  for (const Case& given :
       {Case{facing, {}, 4.0F}, Case{turned_away, {}, 8.0F}, Case{turned_away, {.double_sided = true}, 4.0F},
        Case{facing, cut, 8.0F}, Case{facing, cut_by_texture, 8.0F}}) {
    PlaneScene planes(lightFrom(60, 20));
    planes.quad(given.quad, given.material).quad(wall);
    planes.scene().textures = {{.name = "hole", .size = {1, 1}, .rgba = {255, 255, 255, 0}}};
    giveScene(planes.scene(), shadowCamera({0, 0, 0}, 0.0, {33, 17}));
    EXPECT_NEAR(dist_view_.at(16, 8), given.dist_view, 1e-5F);
    // Turned with the face: whatever is seen faces the camera, and its ray leaves it.
    EXPECT_NEAR(normal_view_.at(16, 8, 2), 1.0F, 1e-6F);
    EXPECT_GT(normal_view_.at(16, 8, 3), 0.0F);
  }
}

// The tracers' first pass tells background by alpha, and the pyramid is built over the range.
TEST_P(GbufferSurfacesTest, AlphaAndRangeTellThemFromBackground) {
  PlaneScene planes(lightFrom(60, 20));
  planes.quad({{-1, -2, -4}, {1, -2, -7}, {1, 2, -7}, {-1, 2, -4}}, {.double_sided = true});
  giveScene(planes.scene(), shadowCamera({0, 0, 0}, 0.0, {33, 17}));
  int surface_count = 0;
  for (int y = 0; y < dist_view_.size.height; ++y) {
    for (int x = 0; x < dist_view_.size.width; ++x) {
      const float dist = dist_view_.at(x, y);
      const bool is_surface = !std::isinf(dist);
      surface_count += is_surface ? 1 : 0;
      ASSERT_EQ(material_.at(x, y, 3), is_surface ? 1.0F : 0.0F) << x << ", " << y;
      ASSERT_EQ(dist_range_.at(x, y, 0), dist) << x << ", " << y;
      ASSERT_EQ(dist_range_.at(x, y, 1), is_surface ? dist : 0.0F) << x << ", " << y;
    }
  }
  EXPECT_GT(surface_count, 20);
  EXPECT_LT(surface_count, 33 * 17 - 20);
}

INSTANTIATE_TEST_SUITE_P(Each, GbufferSurfacesTest, testing::Values("gl-osmesa", "vk-lavapipe"),
                         deviceTestName);

}  // namespace
}  // namespace ssrkit
