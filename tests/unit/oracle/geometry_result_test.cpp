#include "oracle/geometry_result.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace ssrkit::testing {

namespace {

TrueRay rayAfter(double t_m) {
  return {.true_class = TrueClass::kVisible, .t_m = t_m, .dist_view = 2.0 * t_m};
}

}  // namespace

TEST(GeometryResult, HasNoRaysBeforeARowIsSet) {
  const GeometryResult result({3, 2});
  EXPECT_EQ(result.size(), (Size{3, 2}));
  ASSERT_EQ(result.pixelCount(), 6U);
  for (std::size_t pixel = 0; pixel < result.pixelCount(); ++pixel) {
    EXPECT_EQ(result.at(pixel).true_class, TrueClass::kNone);
    EXPECT_EQ(result.at(pixel).t_m, -1.0);
  }
}

TEST(GeometryResult, GivesEachPixelItsOwnRayByPlaceAndByNumber) {
  GeometryResult result({3, 2});
  result.setRow(1, std::array{rayAfter(4.0), TrueRay{}, rayAfter(6.0)});
  result.setRow(0, std::array{TrueRay{}, rayAfter(2.0), TrueRay{}});
  const std::array<double, 6> t_m = {-1.0, 2.0, -1.0, 4.0, -1.0, 6.0};
  std::size_t pixel = 0;
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x, ++pixel) {
      EXPECT_EQ(result.at(x, y).t_m, t_m.at(pixel)) << x << " " << y;
      EXPECT_EQ(&result.at(pixel), &result.at(x, y)) << x << " " << y;
    }
  }
  EXPECT_EQ(result.at(2, 1).dist_view, 12.0);
}

TEST(GeometryResult, ARowThatIsSetAgainForgetsItsRays) {
  GeometryResult result({2, 1});
  result.setRow(0, std::array{rayAfter(1.0), rayAfter(2.0)});
  result.setRow(0, std::array{TrueRay{}, rayAfter(3.0)});
  EXPECT_EQ(result.at(0, 0).true_class, TrueClass::kNone);
  EXPECT_EQ(result.at(1, 0).t_m, 3.0);
}

TEST(GeometryResult, HoldsARowOfRaysAlone) {
  constexpr int kWidth = std::numeric_limits<std::uint16_t>::max();
  std::vector<TrueRay> row(kWidth);
  for (std::size_t x = 0; x < row.size(); ++x) {
    row[x] = rayAfter(static_cast<double>(x));
  }
  GeometryResult result({kWidth, 1});
  result.setRow(0, row);
  for (int x = 0; x < kWidth; ++x) {
    ASSERT_EQ(result.at(x, 0).t_m, x);
  }
}

TEST(GeometryResultDeathTest, RefusesARowOfAnotherWidthAndImagesTooWide) {
  GeometryResult result({2, 1});
  EXPECT_DEATH(result.setRow(0, std::array{rayAfter(1.0)}), "rays.size");
  EXPECT_DEATH(GeometryResult({65536, 1}), "width");
}

}  // namespace ssrkit::testing
