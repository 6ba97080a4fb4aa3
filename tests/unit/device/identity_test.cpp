#include "device/identity.h"

#include <gtest/gtest.h>

namespace ssrkit {
namespace {

TEST(Identity, TheProcessorsModelAndFeaturesComeFromItsFirstEntry) {
  const CpuIdentity cpu = parseCpuInfo(
      "processor\t: 0\nvendor_id\t: GenuineExample\nmodel name\t: Example 9000 @ 2.0GHz: fast\n"
      "flags\t\t: fpu sse2 avx512f avx avx2_not sse4_1 fma\n\n"
      "processor\t: 1\nmodel name\t: Another\nflags\t\t: avx2\n");
  EXPECT_EQ(cpu.model, "Example 9000 @ 2.0GHz: fast");
  EXPECT_EQ(cpu.features, (std::vector<std::string>{"sse4_1", "avx", "fma", "avx512f"}));
}

TEST(Identity, AnArmProcessorHasFeaturesAndNoModel) {
  const CpuIdentity cpu = parseCpuInfo("processor\t: 0\nFeatures\t: fp asimd crc32 asimddp\n");
  EXPECT_EQ(cpu.model, "unknown");
  EXPECT_EQ(cpu.features, (std::vector<std::string>{"asimd", "asimddp"}));
}

TEST(Identity, AnEmptyTextIsAnUnknownProcessor) {
  EXPECT_EQ(parseCpuInfo("").model, "unknown");
  EXPECT_TRUE(parseCpuInfo("no colon\n:\n : \n").features.empty());
}

}  // namespace
}  // namespace ssrkit
