// What is OpenGL's alone: its messages and the context under it.
#include "device/gl/gl_session.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "device/gl/gl_device.h"
#include "device/gl/osmesa_context.h"

namespace ssrkit {
namespace {

std::shared_ptr<GlSession> createSession() {
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  auto context = createOsmesaContext();
  if (!context) {
    ADD_FAILURE() << sentence(context.error());
    return nullptr;
  }
  auto session = GlSession::create(std::move(*context));
  if (!session) {
    ADD_FAILURE() << sentence(session.error());
    return nullptr;
  }
  return *session;
}

TEST(GlSession, AGlErrorIsDrainedOnceAndNamed) {
  const auto session = createSession();
  ASSERT_NE(session, nullptr);
  EXPECT_TRUE(session->drainMessages().empty());
  session->gl().BindBufferBase(GL_UNIFORM_BUFFER, 100000, 0);
  std::string all;
  for (const std::string& message : session->drainMessages()) {
    all += message + "\n";
  }
  EXPECT_NE(all.find("glBindBufferBase"), std::string::npos) << all;  // from the debug callback
  EXPECT_NE(all.find("glGetError: GL_INVALID_VALUE (0x501)"), std::string::npos) << all;
  EXPECT_TRUE(session->drainMessages().empty());
}

TEST(GlSession, AMessageTurnsIntoASetUpErrorWithReasons) {
  const auto session = createSession();
  ASSERT_NE(session, nullptr);
  EXPECT_TRUE(session->failOnMessages("do nothing", ""));
  session->gl().Enable(0xffff);
  const auto failed = session->failOnMessages("enable the impossible", "do not");
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().kind, ErrorKind::kSetup);
  EXPECT_NE(sentence(failed.error()).find("GL_INVALID_ENUM"), std::string::npos);
}

TEST(GlSession, TwoContextsInOneProcessKeepTheirObjectsApart) {
  const auto first = createSession();
  const auto second = createSession();
  ASSERT_NE(first, nullptr);
  ASSERT_NE(second, nullptr);
  GLuint buffer = 0;
  first->gl().CreateBuffers(1, &buffer);
  EXPECT_EQ(first->gl().IsBuffer(buffer), GL_TRUE);
  EXPECT_EQ(second->gl().IsBuffer(buffer), GL_FALSE);
  EXPECT_EQ(first->gl().IsBuffer(buffer), GL_TRUE);
}

TEST(GlSession, ADriverThatOsmesaLacksIsASetUpErrorNotACrash) {
  setenv("GALLIUM_DRIVER", "zink", 1);
  const auto context = createOsmesaContext();
  ASSERT_FALSE(context);
  EXPECT_EQ(context.error().kind, ErrorKind::kSetup);
  EXPECT_NE(sentence(context.error()).find("GALLIUM_DRIVER is 'zink'"), std::string::npos);
}

// These in processes of their own: the first context chooses the driver for all that follow.
TEST(GlSessionDeathTest, ADriverWithoutOpenGl45IsASetUpError) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto refuse = [] {
    setenv("GALLIUM_DRIVER", "softpipe", 1);
    const auto context = createOsmesaContext();
    std::fputs(context ? "none" : sentence(context.error()).c_str(), stderr);
    std::_Exit(context ? 0 : exitCode(context.error()));
  };
  EXPECT_EXIT(refuse(), testing::ExitedWithCode(3), "refused an OpenGL 4.5 core context");
}

TEST(GlSessionDeathTest, AnOlderContextThanItsShadersNeedIsASetUpError) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto refuse = [] {
    setenv("GALLIUM_DRIVER", "softpipe", 1);
    auto context = createOsmesaContext({.major = 3, .minor = 3});
    const auto session = GlSession::create(std::move(*context), GlShaderInput::kSpirv);
    std::fputs(session ? "none" : sentence(session.error()).c_str(), stderr);
    std::_Exit(session ? 0 : exitCode(session.error()));
  };
  EXPECT_EXIT(refuse(), testing::ExitedWithCode(3), "offers OpenGL 3.3 and the kit needs 4.5");
}

// Mesa hands out softpipe here without a word; only the renderer's name tells.
TEST(GlSessionDeathTest, AnotherDriverThanTheDevicesIsASetUpErrorThatNamesIt) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto refuse = [] {
    setenv("GALLIUM_DRIVER", "softpipe", 1);
    const auto device = createGlDevice(
        {.id = "gl-glsl", .shader_input = GlShaderInput::kGlsl330, .renderer_part = "llvmpipe"});
    std::fputs(device ? "none" : sentence(device.error()).c_str(), stderr);
    std::_Exit(device ? 0 : exitCode(device.error()));
  };
  EXPECT_EXIT(refuse(), testing::ExitedWithCode(3), "answers is 'softpipe' and not 'llvmpipe'");
}

}  // namespace
}  // namespace ssrkit
