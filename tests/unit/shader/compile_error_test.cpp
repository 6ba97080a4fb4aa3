#include <fmt/format.h>
#include <gtest/gtest.h>

#include "shader_folder.h"

namespace ssrkit {
namespace {

namespace fs = std::filesystem;

class CompileError : public ShaderFolder {
 protected:
  [[nodiscard]] std::string at(const std::string& place) const {
    return (root() / "a.frag").string() + place;
  }
};

TEST_F(CompileError, NamesFileLineColumnAndToken) {
  const Error error = errorOf("#version 450\nvoid main() {\n  float a = nope + 1.0;\n}\n");
  EXPECT_EQ(error.where, at(":3:13"));
  EXPECT_EQ(error.problem, "'nope': undeclared identifier");
  EXPECT_EQ(error.kind, ErrorKind::kInput);
}

TEST_F(CompileError, KeepsItsLineInAFileFromWindows) {
  EXPECT_EQ(errorOf("\xEF\xBB\xBF#version 450\r\nvoid main() {\r\n  float a = nope;\r\n}\r\n").where,
            at(":3:13"));
}

TEST_F(CompileError, KeepsItsLineAfterDefinesAndIncludes) {
  write("shaders/include/f.glsl", "float f;\nfloat g;\n");
  write("shaders/a.frag", "#version 450\n#include \"f.glsl\"\nvoid main() {\n  nope();\n}\n");
  const ShaderSource source{root(), "a.frag", ShaderStage::kFragment, {{"A", "1"}, {"B", "2"}}};
  const Expected<ShaderModule> module = compileShader(source, ShaderTarget::kVulkan, {.use_cache = false});
  ASSERT_FALSE(module);
  EXPECT_EQ(module.error().where, at(":4:3"));
}

TEST_F(CompileError, InsideAnIncludeNamesTheInclude) {
  write("shaders/include/f.glsl", "float f(float x) {\n  return bar * x;\n}\n");
  const Error error = errorOf("#version 450\n#include \"f.glsl\"\nvoid main() {}\n");
  EXPECT_EQ(error.where, (root() / "include/f.glsl").string() + ":2:10");
}

TEST_F(CompileError, ListsOnePerLineInOrder) {
  const Error error = errorOf("#version 450\nvoid main() {\n  vec3 b = foo;\n  bar(1);\n  int x = 1.5;\n}\n");
  const std::vector<std::string> expected{
      at(":3:12: 'foo': undeclared identifier"),
      at(":4:3: 'bar': no matching overloaded function found"),
      at(":5:9: '=': cannot convert from 'const float' to 'int'"),
  };
  EXPECT_EQ(error.reasons, expected);
}

TEST_F(CompileError, SpellsTheTokensOfTheGrammar) {
  const Error error = errorOf("#version 450\nvoid main() {\n  float x = 1.0\n}\n");
  EXPECT_EQ(error.where, at(":4:1"));
  EXPECT_EQ(error.problem, "syntax error, unexpected '}', expecting ',' or ';'");
}

TEST_F(CompileError, ShowsTypesAsTheAuthorWroteThem) {
  const std::string text =
      "#version 450\nlayout(location = 0) out vec4 c;\nvoid main() {\n  c = vec3(1.0);\n}\n";
  for (const ShaderTarget target : kBothTargets) {
    const Error error = errorOf(text, target);
    EXPECT_EQ(error.where, at(":4:5"));
    EXPECT_EQ(error.problem, "'=': cannot convert from 'const vec3' to 'out vec4'");
  }
}

TEST_F(CompileError, WithoutMainSaysSo) {
  EXPECT_EQ(errorOf("#version 450\nvoid helper() {}\n").problem, "there is no 'void main()' in it");
}

TEST_F(CompileError, FollowsTheAuthorsOwnLineDirective) {
  EXPECT_EQ(errorOf("#version 450\n#line 100 \"lesson.glsl\"\nvoid main() { nope; }\n").where,
            "lesson.glsl:100");
}

TEST_F(CompileError, OfAnEmptyFileSaysSo) {
  EXPECT_EQ(errorOf("").problem, "the file is empty");
  EXPECT_EQ(errorOf(" \r\n\t\n").problem, "the file is empty");
}

TEST_F(CompileError, OfBinaryGarbageNamesTheByte) {
  EXPECT_EQ(errorOf(std::string_view("\x7f"
                                     "ELF\x02\x01",
                                     6))
                .problem,
            "byte 0 is 0x7f, so it is no GLSL text");
  EXPECT_EQ(errorOf(std::string_view("#version 450\n\0", 14)).problem,
            "byte 13 is 0x00, so it is no GLSL text");
}

TEST_F(CompileError, OfAMissingFileOrAFolderOrAPipeSaysSo) {
  EXPECT_EQ(compileEntry("gone.frag").error().problem, "there is no such file");
  EXPECT_EQ(compileEntry(root() / "gone.frag").error().where, (root() / "gone.frag").string());
  fs::create_directory(root() / "folder.frag");
  EXPECT_EQ(compileEntry("folder.frag").error().problem, "it is a folder");
  EXPECT_EQ(compileEntry("/dev/zero").error().problem, "it is no regular file");
}

TEST_F(CompileError, OfAnEntryOutsideTheRootSaysSo) {
  EXPECT_NE(compileEntry("../a.frag").error().problem.find("no path inside the shader folder"),
            std::string::npos);
  fs::create_symlink("/etc/hostname", root() / "link.frag");
  EXPECT_EQ(compileEntry("link.frag").error().problem, "a symbolic link leads out of the shader folder");
}

TEST_F(CompileError, OfAMissingShaderFolderSaysSo) {
  const Expected<ShaderModule> module =
      compileShader({root() / "gone", "a.frag", ShaderStage::kFragment, {}}, ShaderTarget::kOpenGl);
  EXPECT_NE(module.error().problem.find("is not there"), std::string::npos);
}

TEST_F(CompileError, OfASourceOverOneMebibyteSaysSo) {
  const Error error = errorOf("#version 450\nvoid main() {}\n" + std::string(1 << 20, ' '));
  EXPECT_NE(error.problem.find("more than the 1048576"), std::string::npos) << error.problem;
}

TEST_F(CompileError, OfADefineThatIsNoNameSaysSo) {
  write("shaders/a.frag", "#version 450\nvoid main() {}\n");
  using Define = std::pair<std::string, std::string>;
  for (const Define& define :
       {Define{"1A", ""}, {"", "1"}, {"gl_A", "1"}, {"A", "1\n#error"}, {"A", "/*"}, {"A", "\\"}}) {
    const ShaderSource source{root(), "a.frag", ShaderStage::kFragment, {define}};
    EXPECT_FALSE(compileShader(source, ShaderTarget::kOpenGl, {.use_cache = false})) << define.first;
  }
}

TEST(StageOfFile, IsToldByTheExtension) {
  EXPECT_EQ(stageOfFile("a/b.vert").value(), ShaderStage::kVertex);
  EXPECT_EQ(stageOfFile("b.frag").value(), ShaderStage::kFragment);
  EXPECT_EQ(stageOfFile("b.frag.glsl").value(), ShaderStage::kFragment);
  EXPECT_EQ(stageOfFile("a/b.vert.glsl").value(), ShaderStage::kVertex);
  EXPECT_EQ(stageOfFile("b.glsl").value(), ShaderStage::kFragment) << "what --replace takes";
  EXPECT_FALSE(stageOfFile("b.comp.glsl"));
  EXPECT_FALSE(stageOfFile("b.comp"));
  EXPECT_FALSE(stageOfFile("frag"));
}

}  // namespace
}  // namespace ssrkit
