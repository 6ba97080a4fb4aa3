#include "conform/cell.h"

#include <gtest/gtest.h>

#include "conform/shard.h"

namespace ssrkit {
namespace {

TEST(Cell, IdNamesTestSceneSizeAndDevice) {
  EXPECT_EQ("trace.bits/clutter/64x36/gl-osmesa", cellId({"trace.bits", "clutter", {64, 36}, "gl-osmesa"}));
}

TEST(Cell, IdIsSafeAsAPath) {
  EXPECT_EQ("t/-home-me-my-scene/1x1/d", cellId({"t", "/home/me/My scene", {1, 1}, "d"}));
  EXPECT_EQ("t/-../1x1/d", cellId({"t", "..", {1, 1}, "d"}));
}

TEST(Cell, GlobMatchesTheWholeIdOrItsBeginning) {
  const std::string id = "trace.bits/clutter/64x36/gl-osmesa";
  for (const char* glob :
       {"trace.bits", "trace.*", "trace.bits/clutter", "*/64x36", "*/gl-osmesa", "*", id.c_str()}) {
    EXPECT_TRUE(matchesCell(glob, id)) << glob;
  }
  for (const char* glob : {"trace", "trace.bit", "clutter", "trace.bits/clut", "*/gl-zink", ""}) {
    EXPECT_FALSE(matchesCell(glob, id)) << glob;
  }
}

TEST(Shard, IsReadStrictly) {
  EXPECT_EQ((Shard{2, 3}), parseShard("2/3"));
  for (const char* text : {"", "1", "0/3", "4/3", "1/0", "-1/3", "1/3/3", "a/b", "1/3x", "1/99999999"}) {
    const auto shard = parseShard(text);
    ASSERT_FALSE(shard.has_value()) << text;
    EXPECT_NE(std::string::npos, sentence(shard.error()).find("--shard")) << text;
  }
}

// The numbers are part of the contract: a shard that ran yesterday and one that runs today must fit together.
TEST(Shard, OfAnIdNeverChanges) {
  EXPECT_EQ(1, shardOf({"gbuffer", "m1", {64, 36}, "gl-osmesa"}, 1));
  const int shard = shardOf({"gbuffer", "m1", {64, 36}, "gl-osmesa"}, 5);
  EXPECT_EQ(shard, shardOf({"gbuffer", "m1", {64, 36}, "vk-lavapipe"}, 5)) << "a group keeps together";
  std::string all;
  for (const char* scene : {"m1", "m2", "m3", "m4", "clutter", "thin", "facing", "curved"}) {
    all += std::to_string(shardOf({"gbuffer", scene, {64, 36}, "gl-osmesa"}, 5));
  }
  EXPECT_EQ("23113324", all);
}

}  // namespace
}  // namespace ssrkit
