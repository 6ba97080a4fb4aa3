#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <new>
#include <string>

#include "shader/isolated.h"
#include "shader_folder.h"

namespace ssrkit {
namespace {

class Hostile : public ShaderFolder {};

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) {
    result += text;
  }
  return result;
}

TEST_F(Hostile, AnExpressionOfAHundredThousandTermsIsAnErrorAndNoCrash) {
  const Error error =
      errorOf("#version 450\nlayout(location = 0) out float y;\nvoid main() { float a = y; y = a" +
              repeated("+a", 300000) + "; }\n");
  EXPECT_NE(error.problem, "");
  EXPECT_EQ(error.kind, ErrorKind::kInput);
}

TEST_F(Hostile, ParenthesesNestedByTheHundredThousandAreAnErrorAndNoCrash) {
  const std::string nested = repeated("(", 400000) + "1" + repeated(")", 400000);
  EXPECT_EQ(errorOf("#version 450\nvoid main() { float a = " + nested + "; }\n").problem,
            "it is nested deeper than the compiler can follow");
  EXPECT_NE(errorOf("#version 450\n#if " + nested + "\n#endif\nvoid main() {}\n").problem, "");
}

TEST(Isolated, HandsTheResultBackWhole) {
  const std::string large(3 << 20, 'x');
  const IsolatedResult result = runIsolated([&large] { return large; });
  EXPECT_EQ(result.end, IsolationEnd::kDone);
  EXPECT_EQ(result.bytes, large);
}

TEST(Isolated, ReportsACrashAndAnException) {
  EXPECT_EQ(runIsolated([]() -> std::string { std::abort(); }).end, IsolationEnd::kCrashed);
  EXPECT_EQ(runIsolated([]() -> std::string { throw 1; }).end, IsolationEnd::kCrashed);
  EXPECT_EQ(runIsolated([]() -> std::string { _Exit(0); }).end, IsolationEnd::kCrashed);
  EXPECT_EQ(runIsolated([]() -> std::string { throw std::bad_alloc(); }).end, IsolationEnd::kOutOfMemory);
}

TEST(Isolated, StopsWorkThatNeverEnds) {
  const auto spin = []() -> std::string {
    for (volatile bool on = true; on;) {
    }
    return {};
  };
  EXPECT_EQ(runIsolated(spin, {.cpu_seconds = 1}).end, IsolationEnd::kOverTime);
}

TEST(Isolated, StopsWorkThatTakesAllMemory) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the address sanitizer reserves more addresses than any limit";
#endif
  const auto grow = []() -> std::string {
    std::string text(1 << 20, 'x');
    while (true) {
      text += text;
    }
  };
  EXPECT_EQ(runIsolated(grow, {.cpu_seconds = 10, .memory_bytes = 64 << 20}).end, IsolationEnd::kOutOfMemory);
}

}  // namespace
}  // namespace ssrkit
