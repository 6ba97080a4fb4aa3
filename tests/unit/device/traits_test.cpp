#include "device/traits.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <string>

#include "device/pass_clock.h"
#include "device_fixture.h"

namespace ssrkit {
namespace {

class TraitsTest : public DeviceTest {};
SSRKIT_ON_EVERY_DEVICE(TraitsTest);

std::string lowerCase(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

// The driver's own words must name the rasteriser that the registry's row promises.
TEST_P(TraitsTest, TheIdentitySaysWhoDraws) {
  const DeviceIdentity& identity = device().identity();
  EXPECT_EQ(identity.id, GetParam());
  EXPECT_TRUE(identity.api.starts_with(target() == ShaderTarget::kOpenGl ? "OpenGL " : "Vulkan 1."))
      << identity.api;
  const std::string& rasteriser = entry().rasteriser;
  EXPECT_NE(lowerCase(identity.driver).find(rasteriser), std::string::npos) << identity.driver;
  EXPECT_EQ(identity.version.starts_with("Mesa "), rasteriser != "swiftshader") << identity.version;
  EXPECT_EQ(identity.driver.find("zink") != std::string::npos, entry().id == "gl-zink") << identity.driver;
  EXPECT_FALSE(identity.cpu.empty());
  EXPECT_FALSE(identity.cpu_features.empty());
}

// The cap of Mesa's llvmpipe is 65,535 turns of all loops together; the 512 outer turns take their share of
// it. A later Mesa may have none.
TEST_P(TraitsTest, TheProbeFindsTheLoopCap) {
  const auto traits = probeTraits(device(), target(), SSRKIT_SOURCE_DIR "/shaders");
  ASSERT_TRUE(traits) << sentence(traits.error());
  if (entry().rasteriser != "llvmpipe") {
    EXPECT_EQ(traits->loop_cap, 0U);
  } else if (traits->loop_cap != 0) {
    EXPECT_GE(traits->loop_cap, 65535U - 512U);
    EXPECT_LE(traits->loop_cap, 65535U);
  }
}

TEST_P(TraitsTest, TheProbeSaysWhatTheDriverIsGiven) {
  const auto traits = probeTraits(device(), target(), SSRKIT_SOURCE_DIR "/shaders");
  ASSERT_TRUE(traits) << sentence(traits.error());
  EXPECT_EQ(traits->shader_input, entry().id == "gl-softpipe" ? "GLSL 330"
                                  : entry().id == "gl-glsl"   ? "GLSL 450"
                                                              : "SPIR-V");
}

TEST_P(TraitsTest, AMissingShaderFolderIsAnErrorOfTheProbe) {
  EXPECT_FALSE(probeTraits(device(), target(), SSRKIT_SOURCE_DIR "/no such folder"));
}

TEST_P(TraitsTest, ALongerPassTakesMoreOfTheProcessorsTime) {
  const auto target_image = image(Format::kRgba32f, {128, 128});
  const auto work = screenProgram("work.frag", {Format::kRgba32f});
  PassDesc pass = passTo(*target_image, *work);
  const auto cpuNsOf = [&](std::uint32_t turn_count) {
    const std::array<std::uint32_t, 4> load{turn_count};
    pass.uniforms = bytesOf(load);
    return draw(pass).cpu_ns;
  };
  (void)cpuNsOf(1);  // compiles
  const std::int64_t before_ns = processCpuNs();
  const std::int64_t short_ns = cpuNsOf(500);
  const std::int64_t long_ns = cpuNsOf(10000);
  EXPECT_GT(short_ns, 0);
  EXPECT_GT(long_ns, 4 * short_ns);  // 20 times the turns, less what a pass costs at least
  EXPECT_GE(processCpuNs() - before_ns, long_ns);
}

TEST_P(TraitsTest, WallTimeIsWhatAStopwatchSays) {
  const auto target_image = image(Format::kRgba32f, {128, 128});
  const auto work = screenProgram("work.frag", {Format::kRgba32f});
  PassDesc pass = passTo(*target_image, *work);
  const std::array<std::uint32_t, 4> load{2000};
  pass.uniforms = bytesOf(load);
  (void)draw(pass);  // compiles
  const auto start = std::chrono::steady_clock::now();
  const PassTime time = draw(pass);
  const std::int64_t stopwatch_ns = (std::chrono::steady_clock::now() - start) / std::chrono::nanoseconds(1);
  EXPECT_LE(time.wall_ns, stopwatch_ns);
  EXPECT_GT(time.wall_ns, stopwatch_ns / 2);
}

}  // namespace
}  // namespace ssrkit
