#include <fmt/format.h>
#include <gtest/gtest.h>

#include "shader_folder.h"

namespace ssrkit {
namespace {

class EndlessLoop : public ShaderFolder {
 protected:
  // `body` starts on line 4.
  [[nodiscard]] Error errorOfBody(std::string_view body, ShaderTarget target = ShaderTarget::kVulkan) const {
    return errorOf(
        fmt::format("#version 450\nlayout(location = 0) out float y;\nvoid main() {{\n{}\n}}\n", body),
        target);
  }
  void expectEndless(std::string_view body, int line) const {
    for (const ShaderTarget target : kBothTargets) {
      const Error error = errorOfBody(body, target);
      EXPECT_EQ(error.problem, fmt::format("the loop at line {} never ends: no path leaves it", line))
          << body;
      EXPECT_EQ(error.where, fmt::format("{}:{}", (root() / "a.frag").string(), line));
    }
  }
};

TEST_F(EndlessLoop, IsFoundWithItsLineInEveryForm) {
  expectEndless("y = 0.0;\nwhile (true) {\n  y += 1.0;\n}", 5);
  expectEndless("for (;;) { y += 1.0; }", 4);
  expectEndless("\n\ndo { y += 1.0; } while (1 < 2);", 6);
  expectEndless("const bool ever = true;\nfor (int i = 0; ever; ++i) { if (y > 2.0) continue; y += 1.0; }",
                5);
}

TEST_F(EndlessLoop, InsideAnotherIsTheOneThatIsNamed) {
  expectEndless("for (int i = 0; i < 3; ++i) {\n  y += 1.0;\n  while (true) { y += 2.0; }\n}", 6);
  expectEndless("while (true) {\n  y += 1.0;\n  while (true) { y += 2.0; }\n}", 6);
  expectEndless("for (int i = 0; i < 3; ++i) { y += 1.0; }\nwhile (true) { y += 2.0; }", 5);
}

TEST_F(EndlessLoop, InAnIncludeIsNamedThere) {
  write("shaders/include/f.glsl", "float f(float x) {\n  while (true) { x += 1.0; }\n  return x;\n}\n");
  const Error error = errorOf(
      "#version 450\n#include \"f.glsl\"\nlayout(location = 0) out float y;\nvoid main() { y = f(1.0); }\n");
  EXPECT_EQ(error.where, (root() / "include/f.glsl").string() + ":2");
}

TEST_F(EndlessLoop, IsNoneThatHasAWayOut) {
  for (const char* const body : {
           "for (int i = 0; i < 4; ++i) { y += 1.0; }",
           "while (true) { y += 1.0; if (y > 5.0) break; }",
           "while (true) { y += 1.0; if (y > 5.0) return; }",
           "while (true) { y += 1.0; if (y > 5.0) discard; }",
           "do { y += 1.0; } while (y < 3.0);",
           "do { y += 1.0; } while (false);",
           "if (false) { while (true) { y += 1.0; } }",
           "for (int i = 0; i < 4; ++i) { switch (i) { case 1: y += 1.0; break; default: y -= 1.0; } }",
           "for (int i = 0; i < 4; ++i) { for (int j = 0; j < 4; ++j) { if (i == j) continue; y += 1.0; } }",
       }) {
    EXPECT_EQ(errorOfBody(body).problem, "") << body;
  }
}

TEST_F(EndlessLoop, IsNotSuspectedBehindASpecConstant) {
  EXPECT_TRUE(
      compileFragment("#version 450\nlayout(constant_id = 0) const bool kOn = true;\n"
                      "layout(location = 0) out float y;\nvoid main() { while (kOn) { y += 1.0; } }\n"));
}

}  // namespace
}  // namespace ssrkit
