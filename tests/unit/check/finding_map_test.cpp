#include "check/finding_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace ssrkit {
namespace {

std::size_t litCount(const FindingMap& map) {
  return map.dots.size() - static_cast<std::size_t>(std::count(map.dots.begin(), map.dots.end(), 0));
}

TEST(FindingMap, SmallImagesHaveADotATexel) {
  const std::vector<Finding> findings = {{3, 1, 5.0}, {0, 0, 1.0}};
  const FindingMap map = findingMap({4, 2}, findings);
  EXPECT_EQ(map.size, (Size{4, 2}));
  EXPECT_EQ(map.dots[7], 255);
  EXPECT_GT(map.dots[0], 0);
  EXPECT_LT(map.dots[0], 255);
  EXPECT_EQ(litCount(map), 2U);
}

TEST(FindingMap, LargeImagesAreMadeSmallAndKeepEveryFinding) {
  const FindingMap map =
      findingMap({321, 90}, std::vector<Finding>{{320, 89, 1.0}, {3, 0, 1.0}, {4, 1, 2.0}});
  EXPECT_EQ(map.size, (Size{107, 30}));
  EXPECT_GT(map.dots.back(), 0);
  EXPECT_EQ(map.dots[1], 255);  // the worst of (3, 0) and (4, 1)
  EXPECT_EQ(litCount(map), 2U);
}

TEST(FindingMap, OneHugeErrorDoesNotHideTheOthers) {
  const double infinite = std::numeric_limits<double>::infinity();
  const FindingMap map = findingMap({3, 1}, std::vector<Finding>{{0, 0, 1.0}, {1, 0, 2.0}, {2, 0, infinite}});
  EXPECT_GT(map.dots[1], map.dots[0]);
  EXPECT_GT(map.dots[2], map.dots[1]);
  EXPECT_GE(map.dots[0], 64);
}

TEST(FindingMap, FindingsOutsideTheImageAreLeftOut) {
  EXPECT_EQ(litCount(findingMap({2, 2}, std::vector<Finding>{{2, 0, 1.0}, {-1, 1, 1.0}})), 0U);
}

}  // namespace
}  // namespace ssrkit
