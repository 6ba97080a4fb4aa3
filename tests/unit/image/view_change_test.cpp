#include "image/view_change.h"

#include <gtest/gtest.h>

namespace ssrkit {
namespace {

constexpr Size kWhole{40, 18};  // its crop: 5 columns off the left and 4 off the right, 3 rows and 2

RayRecord oneHit(int x, int y, int texel_x, int texel_y) {
  RayRecord record{kWhole, std::vector<RayHit>(std::size_t{40} * 18)};
  RayHit& ray = record.rays[static_cast<std::size_t>(y) * 40 + static_cast<std::size_t>(x)];
  ray = {.texel_x = texel_x,
         .texel_y = texel_y,
         .px_x = static_cast<float>(texel_x) + 0.25F,
         .px_y = static_cast<float>(texel_y) + 0.5F,
         .t_m = 1.5F,
         .ray_class = RayClass::kHit,
         .lookups = 7,
         .steps = 6};
  return record;
}

TEST(ViewChange, AMirrorTurnsColumnsAndTheXOfDirections) {
  const ViewChange mirror{.is_mirrored = true};
  Image normals(kWhole, {"X", "Y", "Z"});
  normals.at(3, 2, 0) = 0.5F;
  normals.at(3, 2, 1) = 0.25F;
  const Image seen = imageIn(mirror, "normal_view", normals);
  EXPECT_EQ(seen.at(36, 2, 0), -0.5F);
  EXPECT_EQ(seen.at(36, 2, 1), 0.25F);
  EXPECT_EQ(imageIn(mirror, "albedo", normals).at(36, 2, 0), 0.5F);
  EXPECT_EQ(imageIn(mirror, "normal_view", seen).data, normals.data);
  const RayHit ray = recordIn(mirror, oneHit(3, 2, 10, 4)).at(36, 2);
  EXPECT_EQ(ray.texel_x, 29);
  EXPECT_EQ(ray.texel_y, 4);
  EXPECT_EQ(ray.px_x, 29.75F);
  EXPECT_EQ(ray.lookups, 7U);
}

TEST(ViewChange, AScaleIsOfDistancesAlone) {
  const ViewChange scale{.scale = 8.0};
  Image image(kWhole, {"Z"});
  image.at(1, 1) = 2.5F;
  EXPECT_EQ(imageIn(scale, "dist_view", image).at(1, 1), 20.0F);
  EXPECT_EQ(imageIn(scale, "depth_window", image).at(1, 1), 2.5F);
  const RayRecord record = recordIn(scale, oneHit(3, 2, 10, 4));
  EXPECT_EQ(record.at(3, 2).t_m, 12.0F);
  EXPECT_EQ(record.at(3, 2).px_x, 10.25F);
  EXPECT_EQ(record.at(0, 0).t_m, -1.0F);  // no hit, no distance
}

TEST(ViewChange, ACropMovesTexelsAndEndsRaysThatHitOutside) {
  const ViewChange view{.is_cropped = true};
  const Crop crop = cropOf(kWhole);
  EXPECT_EQ(crop.x, 5);
  EXPECT_EQ(crop.y, 3);
  EXPECT_EQ(crop.size, (Size{31, 13}));
  EXPECT_EQ(sizeIn(view, kWhole), crop.size);
  const RayHit inside = recordIn(view, oneHit(20, 10, 35, 15)).at(15, 7);
  EXPECT_EQ(inside.texel_x, 30);
  EXPECT_EQ(inside.texel_y, 12);
  EXPECT_EQ(inside.px_x, 30.25F);
  for (const auto& [x, y] : {std::pair{36, 15}, {35, 16}, {4, 15}, {35, 2}}) {
    const RayHit outside = recordIn(view, oneHit(20, 10, x, y)).at(15, 7);
    EXPECT_EQ(outside.ray_class, RayClass::kOffscreen);
    EXPECT_EQ(outside.texel_x, -1);
    EXPECT_EQ(outside.t_m, -1.0F);
  }
}

}  // namespace
}  // namespace ssrkit
