// What a job keeps on its device once everything is drawn.
#include "frame/frame_read_back.h"

#include <gtest/gtest.h>

#include "frame_device.h"

namespace ssrkit {
namespace {

constexpr Size kSmall{64, 64};
constexpr Size kLarge{4097, 1024};

class FrameReadBackTest : public FrameDeviceTest {
 protected:
  // An image that leaves the device, one of the trace that is read, and one that nobody reads.
  void create(FrameImages& images) {
    for (const char* const name : {"ao", "ray_depth", "ray_work"}) {
      const auto image = images.get(name);
      ASSERT_TRUE(image.has_value()) << sentence(image.error());
    }
  }
};

TEST_P(FrameReadBackTest, ALargeFrameGivesUpWhatNobodyReads) {
  ASSERT_TRUE(isLargeFrame(kLarge));
  FrameImages images(*device_, kLarge);
  create(images);
  dropWhatStays(images, {"ray_work"});
  EXPECT_EQ(images.names(), (std::vector<std::string>{"ao", "ray_work"}));
}

TEST_P(FrameReadBackTest, ASmallFrameKeepsItsImagesForTheNextJob) {
  ASSERT_FALSE(isLargeFrame(kSmall));
  FrameImages images(*device_, kSmall);
  create(images);
  dropWhatStays(images, {});
  EXPECT_EQ(images.names(), (std::vector<std::string>{"ao", "ray_depth", "ray_work"}));
}

INSTANTIATE_TEST_SUITE_P(Each, FrameReadBackTest, testing::Values("gl-osmesa", "vk-lavapipe"),
                         deviceTestName);

}  // namespace

}  // namespace ssrkit
