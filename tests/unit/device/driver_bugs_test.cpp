// The drivers' faults that the kit works around, each shown where it stands (docs/driver-bugs.md). A test
// whose fault is gone is skipped and says so: then the work-around may go as well.
#include <dlfcn.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <spirv-tools/libspirv.hpp>
#include <string>
#include <vector>

#include "device/gl/gl_device.h"
#include "device/gl/gl_session.h"
#include "device/gl/gl_stage.h"
#include "device/gl/osmesa_context.h"
#include "device_fixture.h"
#include "driver_bugs.h"
#include "scoped_variable.h"

namespace ssrkit {
namespace {

class DriverBugs : public DeviceTest {
 protected:
  struct Sample {
    float width;
    float value;
  };

  // lane_levels.frag over two mips, 8 and 4 texels wide, that hold 10 and 20; levels alternate like a chess
  // board.
  [[nodiscard]] std::vector<Sample> sampleLevels() {
    const auto pyramid = image(Format::kR32f, {8, 8}, 2);
    upload(*pyramid, 0, std::vector<float>(64, 10.0F));
    upload(*pyramid, 1, std::vector<float>(16, 20.0F));
    const auto target = image(Format::kRg32f, {8, 8});
    const auto lanes = screenProgram("lane_levels.frag", {Format::kRg32f});
    PassDesc pass = passTo(*target, *lanes);
    pass.sampled = {{.binding = 0, .image = pyramid.get(), .base_mip = 0, .mip_count = 2}};
    draw(pass);
    return read<Sample>(*target);
  }
};
SSRKIT_ON_EVERY_DEVICE(DriverBugs);

int levelOf(std::size_t texel) {
  return static_cast<int>((texel % 8 + texel / 8) & 1U);
}

// Both of Mesa's rasterisers; the processor's vector, or the quad, asks once.
TEST_P(DriverBugs, TextureSizeOfALanesOwnLevelIsAnotherLanesOnMesa) {
  int wrong = 0;
  const std::vector<Sample> samples = sampleLevels();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    wrong += samples[i].width == (levelOf(i) == 0 ? 8.0F : 4.0F) ? 0 : 1;
  }
  if (entry().rasteriser == "swiftshader") {
    EXPECT_EQ(wrong, 0);
    return;
  }
  SSRKIT_SKIP_IF_MENDED(wrong > 0);
  EXPECT_EQ(wrong, 32);  // half of the lanes asked for the other level
}

TEST_P(DriverBugs, TexelFetchOfALanesOwnLevelIsTheQuadsOnSoftpipe) {
  int wrong = 0;
  const std::vector<Sample> samples = sampleLevels();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    wrong += samples[i].value == (levelOf(i) == 0 ? 10.0F : 20.0F) ? 0 : 1;
  }
  if (entry().rasteriser != "softpipe") {
    EXPECT_EQ(wrong, 0);
    return;
  }
  SSRKIT_SKIP_IF_MENDED(wrong > 0);
  EXPECT_EQ(wrong, 32);
}

TEST(GlDriverBugs, NoSpirvIsListedThoughItIsTaken) {
  const auto session = llvmpipeSession();
  SSRKIT_SKIP_IF_MENDED(session->integer(GL_NUM_SHADER_BINARY_FORMATS) == 0);
  EXPECT_NE(session->gl().ARB_gl_spirv, 0);
}

TEST(GlDriverBugs, OpenGl46IsRefusedByOsmesa) {
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  const auto context = createOsmesaContext({.major = 4, .minor = 6});
  SSRKIT_SKIP_IF_MENDED(!context.has_value());
  EXPECT_NE(sentence(context.error()).find("refused an OpenGL 4.6 core context"), std::string::npos);
}

// A fragment shader whose OpLine stands before its OpFunction, as glslang -g writes it.
std::vector<std::uint32_t> lineBeforeFunction(bool has_line) {
  const std::string text = std::string(R"(
    OpCapability Shader
    OpMemoryModel Logical GLSL450
    OpEntryPoint Fragment %main "main"
    OpExecutionMode %main OriginLowerLeft
    %file = OpString "a.frag"
    %void = OpTypeVoid
    %type = OpTypeFunction %void
  )") + (has_line ? "OpLine %file 1 1\n" : "") +
                           R"(
    %main = OpFunction %void None %type
    %label = OpLabel
    OpReturn
    OpFunctionEnd
  )";
  std::vector<std::uint32_t> words;
  EXPECT_TRUE(spvtools::SpirvTools(SPV_ENV_OPENGL_4_5).Assemble(text, &words));
  return words;
}

TEST(GlDriverBugs, SpirvWithLinesBeforeItsFunctionHasNoEntryPoint) {
  const auto session = llvmpipeSession();
  ProgramDesc desc;
  desc.name = "lines";
  const auto refusal = [&](bool has_line) {
    const std::vector<std::uint32_t> spirv = lineBeforeFunction(has_line);
    const auto stage = loadGlStage(session, desc, {.spirv = spirv, .constant_ids = {}});
    return stage ? std::string() : sentence(stage.error());
  };
  EXPECT_EQ(refusal(false), "");
  const std::string with_lines = refusal(true);
  SSRKIT_SKIP_IF_MENDED(!with_lines.empty());
  EXPECT_NE(with_lines.find("entry point"), std::string::npos) << with_lines;
}

// By hand: OSMesa's header and the generated loader of OpenGL cannot stand in one file.
void createRawOsmesaContext() {
  using Create = void* (*)(const int* attributes, void* shared);  // OSMesaCreateContextAttribs
  constexpr int kOsmesaFormat = 0x22;                             // OSMESA_FORMAT
  void* const library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  const auto create = reinterpret_cast<Create>(dlsym(library, "OSMesaCreateContextAttribs"));
  constexpr std::array<int, 3> kAttributes{kOsmesaFormat, GL_RGBA, 0};
  std::_Exit(create(kAttributes.data(), nullptr) == nullptr ? 1 : 0);
}

TEST(GlDriverBugsDeathTest, OsmesaFollowsANullPointerWhereItLacksTheDriver) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const ScopedVariable driver("GALLIUM_DRIVER", "zink");
#ifdef __SANITIZE_ADDRESS__
  EXPECT_EXIT(createRawOsmesaContext(), testing::ExitedWithCode(1), "SEGV");  // the sanitizer's way
#else
  EXPECT_EXIT(createRawOsmesaContext(), testing::KilledBySignal(SIGSEGV), "");
#endif
}

TEST(GlDriverBugsDeathTest, ZinkTakesNoProcessorUnlessToldTo) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto open = [] {
    unsetenv("LIBGL_ALWAYS_SOFTWARE");
    setenv("GALLIUM_DRIVER", "zink", 1);
    setenv("MESA_LOADER_DRIVER_OVERRIDE", "zink", 1);
    const auto device =
        createGlDevice({.id = "gl-zink", .platform = GlPlatform::kEglSurfaceless, .renderer_part = "zink"});
    std::fputs(device ? "it started" : sentence(device.error()).c_str(), stderr);
    std::_Exit(device ? 0 : 3);
  };
  EXPECT_EXIT(open(), testing::ExitedWithCode(3), "could not open");
}

}  // namespace
}  // namespace ssrkit
