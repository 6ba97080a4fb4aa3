#include "device/tolerance_class.h"

#include <gtest/gtest.h>

#include <string>

namespace ssrkit {
namespace {

std::string classOf(std::string_view a, std::string_view b) {
  const auto first = findDevice(a);
  const auto second = findDevice(b);
  if (!first || !second) {
    return "an unknown device";
  }
  return std::string(letterOf(toleranceClass(**first, **second)));
}

DeviceEntry drawnBy(std::string pipeline, std::string rasteriser) {
  DeviceEntry entry;
  entry.pipeline = std::move(pipeline);
  entry.rasteriser = std::move(rasteriser);
  return entry;
}

TEST(ToleranceClass, ComesFromPipelineThenRasteriser) {
  const DeviceEntry one = drawnBy("a", "r");
  EXPECT_EQ(toleranceClass(one, drawnBy("a", "r")), ToleranceClass::kSamePipeline);
  EXPECT_EQ(toleranceClass(one, drawnBy("b", "r")), ToleranceClass::kSameRasteriser);
  EXPECT_EQ(toleranceClass(one, drawnBy("b", "s")), ToleranceClass::kOther);
}

TEST(ToleranceClass, LlvmpipeUnderTwoApisIsOneRasteriser) {
  EXPECT_EQ(classOf("gl-osmesa", "vk-lavapipe"), "R");
  EXPECT_EQ(classOf("vk-lavapipe", "gl-osmesa"), "R");
}

TEST(ToleranceClass, TheSameDriverByAnotherDoorIsOnePipeline) {
  EXPECT_EQ(classOf("gl-osmesa", "gl-egl"), "P");
  EXPECT_EQ(classOf("vk-lavapipe", "gl-zink"), "P");
}

TEST(ToleranceClass, SoftpipeAndSwiftshaderAreRasterisersOfTheirOwn) {
  for (const char* const other : {"gl-osmesa", "vk-lavapipe", "gl-zink", "gl-glsl"}) {
    EXPECT_EQ(classOf("gl-softpipe", other), "X");
    EXPECT_EQ(classOf("vk-swiftshader", other), "X");
  }
  EXPECT_EQ(classOf("gl-softpipe", "vk-swiftshader"), "X");
}

TEST(ToleranceClass, EveryRowIsItsOwnPipelineAndOnePipelineHasOneRasteriser) {
  for (const DeviceEntry& a : deviceEntries()) {
    EXPECT_FALSE(a.pipeline.empty()) << a.id;
    EXPECT_FALSE(a.rasteriser.empty()) << a.id;
    EXPECT_EQ(classOf(a.id, a.id), "P");
    for (const DeviceEntry& b : deviceEntries()) {
      EXPECT_EQ(classOf(a.id, b.id), classOf(b.id, a.id));
      EXPECT_TRUE(a.pipeline != b.pipeline || a.rasteriser == b.rasteriser) << a.id << " and " << b.id;
    }
  }
}

}  // namespace
}  // namespace ssrkit
