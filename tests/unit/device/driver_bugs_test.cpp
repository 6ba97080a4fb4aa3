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

#include "device/gl/egl_context.h"
#include "device/gl/gl_device.h"
#include "device/gl/gl_image.h"
#include "device/gl/gl_program.h"
#include "device/gl/gl_session.h"
#include "device/gl/gl_stage.h"
#include "device/gl/osmesa_context.h"
#include "device/pass_clock.h"
#include "device_fixture.h"
#include "scoped_variable.h"

#define SSRKIT_SKIP_IF_MENDED(is_there)                    \
  if (!(is_there)) {                                       \
    GTEST_SKIP() << "this driver no longer has the fault"; \
  }

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

std::shared_ptr<GlSession> llvmpipeSession() {
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  return valueOf(GlSession::create(valueOf(createOsmesaContext())));
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

ShaderModule compiled(const std::string& name, ShaderStage stage) {
  return valueOf(compileShader({SSRKIT_SOURCE_DIR "/tests/unit/device/shaders", name, stage, {}},
                               ShaderTarget::kOpenGl, {.use_cache = false}));
}

// work.frag, bound and ready to be drawn to an image of 256 x 256 texels; it takes some 20 ms.
class BoundWork {
 public:
  explicit BoundWork(const std::shared_ptr<GlSession>& session)
      : gl_(session->gl()),
        vertex_(compiled("screen.vert", ShaderStage::kVertex)),
        fragment_(compiled("work.frag", ShaderStage::kFragment)),
        image_(valueOf(GlImage::create(session, {"target", Format::kRgba32f, {256, 256}, 1}))),
        framebuffer_(createFramebuffer(session)),
        uniforms_(createBuffer(session)) {
    ProgramDesc desc;
    desc.name = "work";
    desc.vertex_spirv = vertex_.spirv;
    desc.fragment_spirv = fragment_.spirv;
    program_ = valueOf(GlProgram::create(session, desc));
    constexpr std::array<std::uint32_t, 4> kTurns{4000};
    gl_.NamedBufferStorage(uniforms_.name(), sizeof(kTurns), kTurns.data(), 0);
    gl_.NamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, image_->texture(), 0);
    gl_.BindBufferBase(GL_UNIFORM_BUFFER, 0, uniforms_.name());
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl_.UseProgram(program_->program());
    gl_.BindVertexArray(program_->vertexArray());
    gl_.Viewport(0, 0, 256, 256);
  }
  void draw() const { gl_.DrawArrays(GL_TRIANGLES, 0, 3); }

 private:
  const GladGLContext& gl_;
  ShaderModule vertex_;
  ShaderModule fragment_;
  std::unique_ptr<GlImage> image_;
  GlObject framebuffer_;
  GlObject uniforms_;
  std::unique_ptr<GlProgram> program_;
};

TEST(GlDriverBugs, AStampWithoutFlushesIsThatOfAnotherTime) {
  const auto session = llvmpipeSession();
  const GladGLContext& gl = session->gl();
  const BoundWork work(session);
  work.draw();  // compiles
  gl.Finish();
  const std::array<GlObject, 2> stamps{createTimestamp(session), createTimestamp(session)};
  const PassClock clock;
  gl.QueryCounter(stamps[0].name(), GL_TIMESTAMP);
  work.draw();
  gl.QueryCounter(stamps[1].name(), GL_TIMESTAMP);
  gl.Finish();
  const std::int64_t wall_ns = clock.elapsed().wall_ns;
  std::array<GLint64, 2> at_ns{};
  gl.GetQueryObjecti64v(stamps[0].name(), GL_QUERY_RESULT, &at_ns[0]);
  gl.GetQueryObjecti64v(stamps[1].name(), GL_QUERY_RESULT, &at_ns[1]);
  SSRKIT_SKIP_IF_MENDED(at_ns[1] - at_ns[0] < wall_ns / 2);
  EXPECT_GT(wall_ns, 1000000);
  EXPECT_EQ(session->drainMessages(), std::vector<std::string>{});
}

TEST(GlDriverBugs, ZinkFinishesBeforeWhatWasFlushedIsDone) {
  for (const auto& [name, value] : valueOf(findDevice("gl-zink"))->environment) {
    setenv(name.c_str(), value.c_str(), 1);
  }
  const auto session = valueOf(GlSession::create(valueOf(createEglContext(EglDisplayKind::kSurfaceless))));
  const GladGLContext& gl = session->gl();
  const BoundWork work(session);
  const GlObject stamp = createTimestamp(session);
  GLint64 done_ns = 0;
  work.draw();  // compiles
  gl.QueryCounter(stamp.name(), GL_TIMESTAMP);
  gl.GetQueryObjecti64v(stamp.name(), GL_QUERY_RESULT, &done_ns);
  const PassClock clock;
  work.draw();
  gl.QueryCounter(stamp.name(), GL_TIMESTAMP);
  gl.Flush();
  gl.Finish();
  const std::int64_t finished_ns = clock.elapsed().wall_ns;
  gl.GetQueryObjecti64v(stamp.name(), GL_QUERY_RESULT, &done_ns);  // waits for the draw
  const std::int64_t drawn_ns = clock.elapsed().wall_ns;
  SSRKIT_SKIP_IF_MENDED(finished_ns < drawn_ns / 2);
  EXPECT_GT(drawn_ns, 1000000);
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
  EXPECT_EXIT(createRawOsmesaContext(), testing::KilledBySignal(SIGSEGV), "");
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
