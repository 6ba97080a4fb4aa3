// The drivers' faults in telling time (docs/driver-bugs.md); see driver_bugs_test.cpp.
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "device/gl/egl_context.h"
#include "device/gl/gl_image.h"
#include "device/gl/gl_program.h"
#include "device/pass_clock.h"
#include "driver_bugs.h"

namespace ssrkit {
namespace {

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

}  // namespace
}  // namespace ssrkit
