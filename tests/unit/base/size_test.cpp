#include "base/size.h"

#include <gtest/gtest.h>

namespace ssrkit {
namespace {

TEST(Size, ReadsBackWhatItWrites) {
  for (const Size size : {Size{1, 1}, Size{640, 360}, Size{kMaxImageSide, 1}, Size{7, kMaxImageSide}}) {
    EXPECT_EQ(parseSize(sizeText(size)), size) << sizeText(size);
  }
  EXPECT_EQ(sizeText({640, 360}), "640x360");
}

TEST(Size, IsWrittenInOneWayOnly) {
  for (const char* text : {"",
                           "x",
                           "640",
                           "640x",
                           "x360",
                           "640x360x1",
                           "640X360",
                           " 640x360",
                           "640x360 ",
                           "640 x360",
                           "+640x360",
                           "-1x1",
                           "0640x360",
                           "640x0360",
                           "6.4e2x360",
                           "640.0x360",
                           "0x1",
                           "1x0",
                           "16385x1",
                           "1x16385",
                           "4294967297x1",
                           "99999999999999999999x1",
                           "0x10x10"}) {
    EXPECT_EQ(parseSize(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace ssrkit
