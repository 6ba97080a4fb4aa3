#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "shader_folder.h"

namespace ssrkit {
namespace {

namespace fs = std::filesystem;

class Include : public ShaderFolder {
 protected:
  [[nodiscard]] Error errorOfIncluding(const std::string& name) const {
    return errorOf(fmt::format("#version 450\n\n#include \"{}\"\nvoid main() {{}}\n", name));
  }
};

constexpr std::string_view kCallsF =
    "#version 450\n#include \"f.glsl\"\nlayout(location = 0) out float y;\nvoid main() { y = f(2.0); }\n";

TEST_F(Include, IsLookedUpBesideTheFileBeforeTheIncludeFolder) {
  write("shaders/include/f.glsl", "this is no GLSL\n");
  write("shaders/f.glsl", "float f(float x) { return x; }\n");
  EXPECT_TRUE(compileFragment(kCallsF));
}

TEST_F(Include, FallsBackToTheIncludeFolderForEveryTarget) {
  write("shaders/include/f.glsl", "float f(float x) { return x; }\n");
  for (const ShaderTarget target : kBothTargets) {
    EXPECT_TRUE(compileFragment(kCallsF, target));
  }
}

TEST_F(Include, MayItselfIncludeAndBeGuarded) {
  write("shaders/include/f.glsl",
        "#include \"g.glsl\"\n#include \"g.glsl\"\nfloat f(float x) { return g(x); }\n");
  write("shaders/include/g.glsl", "#ifndef G\n#define G\nfloat g(float x) { return x; }\n#endif");
  const Expected<ShaderModule> module = compileFragment(kCallsF);
  ASSERT_TRUE(module);
  const std::vector<fs::path> expected{root() / "a.frag", root() / "include/f.glsl",
                                       root() / "include/g.glsl"};
  EXPECT_EQ(module->dependencies, expected);
}

TEST_F(Include, OfAUsersOwnFileReachesItsFolderAndTheKits) {
  write("shaders/include/f.glsl", "#include \"g.glsl\"\nfloat f(float x) { return x; }\n");
  write("shaders/include/g.glsl", "\n");
  write("home/mine.glsl", "float mine(float x) { return x; }\n");
  const fs::path entry =
      write("home/a.frag",
            "#version 450\n#include \"mine.glsl\"\n#include <f.glsl>\nlayout(location = 0) out "
            "float y;\nvoid main() { y = f(mine(2.0)); }\n");
  EXPECT_TRUE(compileEntry(entry));
}

TEST_F(Include, OfAParentFolderIsRefusedWithTheLineOfTheDirective) {
  const Error error = errorOfIncluding("../../etc/passwd");
  EXPECT_EQ(error.where, (root() / "a.frag").string() + ":3:1");
  EXPECT_NE(error.problem.find("'../../etc/passwd' climbs out with '..'"), std::string::npos)
      << error.problem;
}

TEST_F(Include, OfAnAbsolutePathIsRefused) {
  EXPECT_NE(errorOfIncluding("/etc/passwd").problem.find("is an absolute path"), std::string::npos);
}

TEST_F(Include, ThroughALinkOutOfTheFolderIsRefused) {
  write("secret.glsl", "float secret;\n");
  fs::create_symlink(folder() / "secret.glsl", root() / "include" / "link.glsl");
  EXPECT_NE(errorOfIncluding("link.glsl").problem.find("is a symbolic link out of"), std::string::npos);
}

TEST_F(Include, ThroughALinkedFolderIsRefused) {
  write("elsewhere/secret.glsl", "float secret;\n");
  fs::create_directory_symlink(folder() / "elsewhere", root() / "linked");
  EXPECT_NE(errorOfIncluding("linked/secret.glsl").problem.find("is a symbolic link out of"),
            std::string::npos);
}

TEST_F(Include, ThroughALinkInsideTheFolderIsFine) {
  write("shaders/include/f.glsl", "float f(float x) { return x; }\n");
  fs::create_symlink("f.glsl", root() / "include" / "alias.glsl");
  EXPECT_EQ(errorOfIncluding("alias.glsl").problem, "");
}

TEST_F(Include, ThatIsMissingNamesItsNearestNeighbour) {
  write("shaders/include/ssr_spaces.glsl", "\n");
  const Error error = errorOfIncluding("ssr_space.glsl");
  EXPECT_EQ(error.where, (root() / "a.frag").string() + ":3:1");
  EXPECT_NE(error.problem.find("did you mean 'ssr_spaces.glsl'?"), std::string::npos) << error.problem;
}

TEST_F(Include, ThatIsMissingInsideAnIncludeIsReportedThere) {
  write("shaders/include/f.glsl", "float a;\n#include \"gone.glsl\"\n");
  EXPECT_EQ(errorOfIncluding("f.glsl").where, (root() / "include/f.glsl").string() + ":2:1");
}

TEST_F(Include, ThatIsMissingBehindAFalseConditionIsNoError) {
  EXPECT_TRUE(compileFragment("#version 450\n#if 0\n#include \"gone.glsl\"\n#endif\nvoid main() {}\n"));
}

TEST_F(Include, OfAFolderIsRefused) {
  EXPECT_NE(errorOfIncluding(".").problem.find("it is a folder"), std::string::npos);
}

TEST_F(Include, OfBinaryGarbageIsRefused) {
  write("shaders/include/f.glsl", std::string_view("ab\0cd", 5));
  EXPECT_NE(errorOfIncluding("f.glsl").problem.find("no GLSL text"), std::string::npos);
}

TEST_F(Include, OfItselfIsACycle) {
  EXPECT_NE(errorOfIncluding("a.frag").problem.find("includes itself"), std::string::npos);
}

TEST_F(Include, OfEachOtherIsACycleReportedWhereItCloses) {
  write("shaders/include/f.glsl", "#include \"g.glsl\"\n");
  write("shaders/include/g.glsl", "\n#include \"f.glsl\"\n");
  const Error error = errorOfIncluding("f.glsl");
  EXPECT_EQ(error.where, (root() / "include/g.glsl").string() + ":2:1");
  EXPECT_NE(error.problem.find("includes itself"), std::string::npos);
}

TEST_F(Include, MayBeSixteenDeepButNotSeventeen) {
  for (int i = 1; i <= 17; ++i) {
    write(fmt::format("shaders/include/{}.glsl", i), fmt::format("#include \"{}.glsl\"\n", i + 1));
  }
  write("shaders/include/17.glsl", "\n");
  EXPECT_EQ(errorOfIncluding("2.glsl").problem, "");
  EXPECT_NE(errorOfIncluding("1.glsl").problem.find("deeper than 16"), std::string::npos);
}

TEST_F(Include, ThatDoublesAtEveryLevelStopsAtTheByteLimit) {
  for (int i = 1; i <= 14; ++i) {
    const std::string next = fmt::format("#include \"{}.glsl\"\n", i + 1);
    write(fmt::format("shaders/include/{}.glsl", i), next + next);
  }
  write("shaders/include/15.glsl", std::string(200, '\n'));
  EXPECT_NE(errorOfIncluding("1.glsl").problem.find("more than 1048576 bytes"), std::string::npos);
}

TEST_F(Include, LinesByTheHundredThousandAreCutOff) {
  std::string text = "#version 450\n";
  for (int i = 0; i < 60000; ++i) {
    text += "#include \"x\"\n";
  }
  EXPECT_FALSE(compileFragment(text));
}

}  // namespace
}  // namespace ssrkit
